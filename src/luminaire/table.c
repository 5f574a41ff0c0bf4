/* Unfolds the symmetries of a photometric table: lists the angle and the plane
 * of the file for every plane of the whole distribution. */
#include "luminaire/table.h"

#include <stdlib.h>

#include "base/log.h"

/* No symmetry makes more than four planes of one. */
#define COPIES_MAX 4

murk_status murk_luminaire_table_create(murk_luminaire_table *out,
                                        size_t verticals, size_t planes,
                                        const murk_luminaire_text *text,
                                        size_t line)
{
    if (verticals > MURK_INTENSITY_VALUES_MAX / COPIES_MAX / (planes + 1)) {
        return murk_luminaire_text_fail(
            text, line, "%zu times %zu angles, must be at most %d values",
            verticals, planes, MURK_INTENSITY_VALUES_MAX / COPIES_MAX);
    }
    *out = (murk_luminaire_table){.verticals = verticals, .planes = planes};
    out->vertical_deg = calloc(verticals + 1, sizeof *out->vertical_deg);
    out->plane_deg = calloc(planes + 1, sizeof *out->plane_deg);
    out->candela = calloc(verticals * planes + 1, sizeof *out->candela);
    return out->vertical_deg && out->plane_deg && out->candela
               ? MURK_OK
               : murk_no_memory(text->err, text->path, "for %zu intensities",
                                verticals * planes);
}

void murk_luminaire_table_release(murk_luminaire_table *table)
{
    free(table->vertical_deg);
    free(table->plane_deg);
    free(table->candela);
    *table = (murk_luminaire_table){0};
}

/* The planes of the whole distribution. */
typedef struct unfolded {
    size_t n;
    double *deg;
    size_t *plane;
} unfolded;

static void add(unfolded *u, double deg, size_t plane)
{
    u->deg[u->n] = deg;
    u->plane[u->n++] = plane;
}

/* Adds the mirror images of all planes about the last one. */
static void reflect(unfolded *u)
{
    const double mirror = u->deg[u->n - 1];
    for (size_t i = u->n - 1; i-- > 0;) {
        add(u, 2 * mirror - u->deg[i], u->plane[i]);
    }
}

static void list_planes(unfolded *u, const murk_luminaire_table *table,
                        murk_luminaire_symmetry symmetry)
{
    /* The mirror images before the first plane. */
    for (size_t i = table->planes;
         symmetry == MURK_SYMMETRY_LEFT_RIGHT && i-- > 1;) {
        add(u, -table->plane_deg[i], i);
    }
    for (size_t i = 0; i < table->planes; ++i) {
        add(u, table->plane_deg[i], i);
    }
    /* The mirror images behind the last plane. */
    switch (symmetry) {
    case MURK_SYMMETRY_AXIAL:
        add(u, u->deg[0] + 360, 0);
        break;
    case MURK_SYMMETRY_0_180:
    case MURK_SYMMETRY_90_270:
        reflect(u);
        break;
    case MURK_SYMMETRY_QUADRANT:
        reflect(u);
        reflect(u);
        break;
    case MURK_SYMMETRY_NONE:
    case MURK_SYMMETRY_LEFT_RIGHT:
        break;
    }
}

/* True if angles reach from one of the starts to one of the ends of whole
 * files: those of the poles and of the plane between them. */
static bool is_whole(const double *deg, size_t n, const double start[2],
                     const double end[2])
{
    return (deg[0] == start[0] || deg[0] == start[1]) &&
           (deg[n - 1] == end[0] || deg[n - 1] == end[1]);
}

/* Warns of angles that stop early: the luminaire is dark beyond them. */
static void warn_of_range(murk_goniometer type, const murk_intensity_grid *grid,
                          const char *where)
{
    static const double start[2] = {0, 90}, end[2] = {90, 180},
                        side_start[2] = {-90, 0}, side_end[2] = {0, 90};
    const bool is_c = type == MURK_GONIOMETER_C;
    const double *v = grid->vertical_deg, *h = grid->horizontal_deg;
    const size_t n = grid->verticals, m = grid->horizontals;
    if (!is_whole(v, n, is_c ? start : side_start, is_c ? end : side_end)) {
        murk_warn(where,
                  "vertical angles %g..%g, whole files have %s: the luminaire "
                  "is taken as dark beyond",
                  v[0], v[n - 1],
                  is_c ? "0..90, 0..180 or 90..180"
                       : "-90..90, -90..0 or 0..90");
    }
    if (!is_c && !is_whole(h, m, side_start, side_end)) {
        murk_warn(where,
                  "horizontal angles %g..%g, whole files have -90..90: the "
                  "luminaire is taken as dark beyond",
                  h[0], h[m - 1]);
    }
}

murk_status murk_luminaire_unfold(murk_luminaire *out,
                                  const murk_luminaire_table *table,
                                  double scale, const char *where,
                                  murk_error *err)
{
    const size_t max = COPIES_MAX * table->planes + 1;
    unfolded u = {.deg = calloc(max, sizeof *u.deg),
                  .plane = calloc(max, sizeof *u.plane)};
    murk_status status = MURK_OK;
    if (!u.deg || !u.plane) {
        status = murk_no_memory(err, where, "for %zu planes", max);
        goto done;
    }
    /* The whole distribution. */
    list_planes(&u, table, out->symmetry);
    const murk_intensity_grid grid = {.type = out->type,
                                      .verticals = table->verticals,
                                      .horizontals = u.n,
                                      .vertical_deg = table->vertical_deg,
                                      .horizontal_deg = u.deg,
                                      .plane = u.plane,
                                      .candela = table->candela,
                                      .scale = scale};
    status = murk_intensity_create(&out->intensity, &grid, where, err);
    if (!status) {
        warn_of_range(out->type, &grid, where);
    }
done:
    free(u.deg);
    free(u.plane);
    return status;
}
