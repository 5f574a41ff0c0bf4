/* The scene from above and from the side: photons as dots, sensors as numbered
 * discs, their ranges as dashed rings. */
#include "report/html.h"
#include "report/scene.h"

#include <math.h>

#define WIDTH     640.0
#define TALLEST   800.0
#define MARGIN    24.0
#define SCALE_BAR 26.0 /* under the picture */
#define DOTS_MAX  4000
#define MIN_M     1.0 /* that a picture shows */
#define NUMBERED  99  /* more sensors are discs alone */

typedef struct projection {
    const char *name;
    int across, up; /* axes: 0 x, 1 y, 2 z */
    double low[2], scale, height;
} projection;

static double along(murk_vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static double place_x(const projection *p, double value)
{
    return MARGIN + (value - p->low[0]) * p->scale;
}

static double place_y(const projection *p, double value)
{
    return p->height - MARGIN - (value - p->low[1]) * p->scale;
}

/* Of all photons, sensors and the domain, where it is known; false where
 * there is nothing to draw. */
static bool fit(projection *p, const murk_report_scene *s)
{
    const int axis[2] = {p->across, p->up};
    if (s->points.n + s->sensors == 0) {
        return false;
    }
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < 2; ++k) {
        for (size_t i = 0; i < s->points.n; ++i) {
            const double v = s->points.point[i].place_m[axis[k]];
            low[k] = fmin(low[k], v);
            high[k] = fmax(high[k], v);
        }
        for (size_t i = 0; i < s->sensors; ++i) {
            const double v = along(s->sensor[i].place, axis[k]);
            low[k] = fmin(low[k], v);
            high[k] = fmax(high[k], v);
        }
        if (s->stage) {
            const murk_box *box = &s->stage->world.domain.box;
            low[k] = fmin(low[k], along(box->min, axis[k]));
            high[k] = fmax(high[k], along(box->max, axis[k]));
        }
    }
    const double wide = high[0] - low[0], tall = high[1] - low[1];
    if (!(wide >= 0 && wide < INFINITY && tall < INFINITY)) {
        return false;
    }
    const double room = fmax(fmax(wide, tall), MIN_M);
    p->scale = fmin((WIDTH - 2 * MARGIN) / fmax(wide, 1e-3 * room),
                    (TALLEST - 2 * MARGIN) / fmax(tall, 1e-3 * room));
    p->scale = fmin(p->scale, WIDTH / room);
    p->low[0] = low[0] - ((WIDTH - 2 * MARGIN) / p->scale - wide) / 2;
    p->low[1] = low[1];
    p->height = 2 * MARGIN + tall * p->scale;
    return true;
}

static void draw_photons(FILE *to, const projection *p,
                         const murk_report_scene *s)
{
    const murk_plan_points *points = &s->points;
    const unsigned first = s->sensors > 0 ? 0 : 1; /* nobody looked */
    const size_t step = points->n / DOTS_MAX + 1;
    fputs("<g class=\"photons\">\n", to);
    for (unsigned seen = 0; seen < 3; ++seen) {
        fprintf(to, "<path class=\"seen%u\" d=\"", seen);
        for (size_t i = 0; i < points->n; i += step) {
            const murk_plan_point *photon = &points->point[i];
            if ((photon->seen_by > 2 ? 2 : photon->seen_by + first) == seen) {
                fprintf(to, "M%.1f %.1fh0",
                        place_x(p, photon->place_m[p->across]),
                        place_y(p, photon->place_m[p->up]));
            }
        }
        fputs("\"/>\n", to);
    }
    fputs("</g>\n", to);
}

static void draw_domain(FILE *to, const projection *p,
                        const murk_report_scene *s)
{
    if (!s->stage) {
        return;
    }
    const murk_box *box = &s->stage->world.domain.box;
    const double left = place_x(p, along(box->min, p->across));
    const double top = place_y(p, along(box->max, p->up));
    fprintf(to,
            "<rect class=\"domain\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" "
            "height=\"%.1f\"/>\n",
            left, top, place_x(p, along(box->max, p->across)) - left,
            place_y(p, along(box->min, p->up)) - top);
}

static void draw_sensors(FILE *to, const projection *p,
                         const murk_report_scene *s)
{
    for (size_t i = 0; i < s->sensors; ++i) {
        const murk_shown_sensor *sensor = &s->sensor[i];
        const double x = place_x(p, along(sensor->place, p->across));
        const double y = place_y(p, along(sensor->place, p->up));
        const double range = sensor->of ? sensor->of->range_m * p->scale : NAN;
        if (s->sensors <= NUMBERED && range > 0 && range < 4 * WIDTH) {
            fprintf(to,
                    "<circle class=\"range\" cx=\"%.1f\" cy=\"%.1f\" "
                    "r=\"%.1f\"/>\n",
                    x, y, range);
        }
    }
    for (size_t i = 0; i < s->sensors; ++i) {
        const double x = place_x(p, along(s->sensor[i].place, p->across));
        const double y = place_y(p, along(s->sensor[i].place, p->up));
        fprintf(to,
                "<circle class=\"sensor\" cx=\"%.1f\" cy=\"%.1f\" "
                "r=\"%d\"/>",
                x, y, s->sensors <= NUMBERED ? 10 : 4);
        if (s->sensors <= NUMBERED) {
            fprintf(to,
                    "<text class=\"number\" x=\"%.1f\" y=\"%.1f\" "
                    "text-anchor=\"middle\">%zu</text>",
                    x, y + 4.5, i + 1);
        }
        fputc('\n', to);
    }
}

/* 1, 2 or 5 times a power of ten metres, about a fifth of the picture. */
static void draw_scale(FILE *to, const projection *p)
{
    const double rough = WIDTH / 5 / p->scale;
    const double ten = pow(10, floor(log10(rough)));
    const double m = rough / ten;
    const double length = ten * (m < 2 ? 1 : m < 5 ? 2 : 5);
    fprintf(to,
            "<path class=\"axis\" d=\"M%.1f %.1fv6h%.1fv-6\"/>"
            "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\">%g m</text>\n",
            MARGIN, p->height + 4, length * p->scale,
            MARGIN + length * p->scale + 8, p->height + 12, length);
}

static void draw(FILE *to, projection *p, const murk_report_scene *s)
{
    if (!fit(p, s)) {
        return;
    }
    fprintf(to,
            "<figure>\n<svg viewBox=\"0 0 %.0f %.0f\" role=\"img\" "
            "aria-label=\"%s\">\n",
            WIDTH, p->height + SCALE_BAR, p->name);
    draw_domain(to, p, s);
    draw_photons(to, p, s);
    draw_sensors(to, p, s);
    draw_scale(to, p);
    fprintf(to, "</svg>\n<figcaption>%s</figcaption>\n</figure>\n", p->name);
}

/* Of the drawings alone: the view in space has its own, for its dark ground. */
static void write_key(FILE *to, const murk_report_scene *scene)
{
    if (scene->sensors + scene->points.n == 0) {
        return;
    }
    fputs("<p class=\"key\">", to);
    if (scene->sensors > 0) {
        fputs("<span class=\"place\"></span>sensor, range dashed", to);
    } else if (scene->points.n > 0) {
        fprintf(to, "<span class=\"one\"></span>%s",
                murk_report_point_name(scene));
    }
    if (scene->sensors > 0 && scene->points.n > 0) {
        fprintf(to,
                "<span class=\"unseen\"></span>%s that none sees"
                "<span class=\"one\"></span>seen by one"
                "<span class=\"more\"></span>by more",
                murk_report_point_name(scene));
    }
    fputs("</p>\n", to);
}

murk_status murk_report_plans(FILE *to, const murk_report_scene *scene,
                              murk_error *err)
{
    projection above = {
        .name = "From above: x to the right, y up", .across = 0, .up = 1};
    projection side = {
        .name = "From the side: x to the right, z up", .across = 0, .up = 2};
    if (!murk_report_has_view(scene) && !scene->note[0]) {
        return MURK_OK;
    }
    murk_page_section_begin(to, "where", "Where they are");
    if (scene->note[0]) {
        fputs("<p class=\"note\">", to);
        murk_page_text(to, scene->note);
        fputs("</p>\n", to);
    }
    const murk_status status = murk_report_view(to, scene, err);
    if (scene->points.n > 0) {
        const size_t step = scene->points.n / DOTS_MAX + 1;
        fprintf(to,
                "<p class=\"note\">%zu of the %llu %ss are "
                "drawn below, evenly chosen.</p>\n",
                (scene->points.n + step - 1) / step,
                (unsigned long long)scene->points.photons,
                murk_report_point_name(scene));
    }
    write_key(to, scene);
    fputs("<div class=\"plans\">\n", to);
    draw(to, &above, scene);
    draw(to, &side, scene);
    fputs("</div>\n", to);
    murk_page_section_end(to);
    return status;
}
