/* Straight segments between two points of the domain, cut at periodic sides:
 * see path/segment.h. */
#include "path/segment.h"

double murk_path_surface_tolerance_m(const murk_surfaces *surfaces,
                                     const murk_domain *domain)
{
    return fmax(0x1p-18 * murk_box_largest_coordinate(&domain->box),
                2 * murk_surfaces_leave_step_m(surfaces));
}

/* Most offsets are clearly less than half a period, or clearly nearer to one
 * period than to none or two. Rounding down then gives 0 or +-1 for certain,
 * and needs neither a division nor a call. */
static double nearest(double value, double to, double period)
{
    const double offset = value - to, size = fabs(offset);
    if (size < 0.499 * period) {
        return value;
    }
    if (size > 0.501 * period && size < 1.499 * period) {
        return value - copysign(period, offset);
    }
    return value - period * floor(offset / period + 0.5);
}

murk_vec3 murk_path_nearest_image(const murk_domain *domain, murk_vec3 point,
                                  murk_vec3 to)
{
    if (domain->is_periodic) {
        const murk_vec3 size = murk_sub(domain->box.max, domain->box.min);
        point.x = nearest(point.x, to.x, size.x);
        point.y = nearest(point.y, to.y, size.y);
    }
    return point;
}

typedef struct crossing {
    double t;        /* share of the line */
    murk_vec3 shift; /* moves the part of the line beyond the crossed side back
                      * into the domain */
} crossing;

/* The share of the line, 0..1, at which a coordinate leaves [min, max]; 1 if
 * the coordinate `to` lies within. */
static double leaves_at(double from, double to, double min, double max)
{
    const double side = to > max ? max : to < min ? min : to;
    return side == to ? 1 : fmax(0, (side - from) / (to - from));
}

int murk_path_cut(const murk_domain *domain, murk_vec3 from, murk_vec3 to,
                  double beyond_m, murk_path_segment *segment)
{
    if (!domain->is_periodic) {
        segment[0] = (murk_path_segment){from, to};
        return 1;
    }
    crossing cut[2];
    int cuts = 0;
    /* The sides that the line crosses, nearest first. */
    const murk_box *box = &domain->box;
    const double x = leaves_at(from.x, to.x, box->min.x, box->max.x);
    const double y = leaves_at(from.y, to.y, box->min.y, box->max.y);
    const murk_vec3 back_x = {copysign(box->max.x - box->min.x, from.x - to.x),
                              0, 0};
    const murk_vec3 back_y = {
        0, copysign(box->max.y - box->min.y, from.y - to.y), 0};
    if (x < 1) {
        cut[cuts++] = (crossing){x, back_x};
    }
    if (y < 1) {
        cut[cuts++] = (crossing){y, back_y};
    }
    if (cuts == 2 && cut[1].t < cut[0].t) {
        const crossing first = cut[1];
        cut[1] = cut[0];
        cut[0] = first;
    }
    /* The line is cut at each crossed side. The segments before and after a cut
     * both extend over the side by beyond_m along the line, at most to an end
     * of the line. Each segment after a cut is moved by whole periods, so that
     * the segment lies in the domain except for these extensions. */
    const murk_vec3 offset = murk_sub(to, from);
    const double length = murk_length(offset);
    const double beyond = length > 0 ? beyond_m / length : 0;
    murk_vec3 shift = {0, 0, 0};
    double begin = 0;
    for (int i = 0; i < cuts; ++i) {
        const double end = fmin(1, cut[i].t + beyond);
        segment[i].from = murk_add(murk_along(from, begin, offset), shift);
        segment[i].to = murk_add(murk_along(from, end, offset), shift);
        shift = murk_add(shift, cut[i].shift);
        begin = fmax(0, cut[i].t - beyond);
    }
    segment[cuts].from = murk_add(murk_along(from, begin, offset), shift);
    segment[cuts].to = murk_add(to, shift);
    return cuts + 1;
}

bool murk_path_blocked(const murk_surfaces *surfaces, const murk_domain *domain,
                       murk_vec3 from, murk_vec3 to, bool through_sheets)
{
    if (!domain->is_periodic) {
        return murk_surfaces_blocked(surfaces, from, to, through_sheets);
    }
    murk_path_segment segment[MURK_PATH_SEGMENTS_MAX];
    const int n =
        murk_path_cut(domain, from, to,
                      murk_path_surface_tolerance_m(surfaces, domain), segment);
    for (int i = 0; i < n; ++i) {
        if (murk_surfaces_blocked(surfaces, segment[i].from, segment[i].to,
                                  through_sheets)) {
            return true;
        }
    }
    return false;
}

/* At a periodic side a segment extends over the side by the surface tolerance,
 * so that a sheet in the plane of the side is not missed. The sheet counts
 * once, because the next segment begins near the opposite side. */
double murk_path_sheets(const murk_surfaces *surfaces,
                        const murk_domain *domain, murk_vec3 from, murk_vec3 to,
                        int band)
{
    if (!domain->is_periodic) {
        return murk_surfaces_sheet_transmittance(surfaces, from, to, band);
    }
    murk_path_segment segment[MURK_PATH_SEGMENTS_MAX];
    const int n =
        murk_path_cut(domain, from, to,
                      murk_path_surface_tolerance_m(surfaces, domain), segment);
    double through = 1;
    for (int i = 0; i < n; ++i) {
        through *= murk_surfaces_sheet_transmittance(surfaces, segment[i].from,
                                                     segment[i].to, band);
    }
    return through;
}
