/* Perspective, equirectangular and orthographic cameras: the ray of each place
 * of the picture, the place of each direction, and the solid angle of a pixel.
 */
#include "render/camera.h"

murk_camera murk_camera_aimed(murk_vec3 from, murk_vec3 to, murk_vec3 up,
                              double vfov_rad, size_t width, size_t height)
{
    const murk_vec3 forward = murk_unit(murk_sub(to, from));
    const murk_vec3 right = murk_unit(murk_cross(forward, up));
    murk_camera camera =
        murk_camera_view(from, forward, right, 0, vfov_rad, width, height);
    camera.step[0] = camera.step[1];
    return camera;
}

murk_camera murk_camera_view(murk_vec3 from, murk_vec3 forward, murk_vec3 right,
                             double hfov_rad, double vfov_rad, size_t width,
                             size_t height)
{
    return (murk_camera){.projection = MURK_PERSPECTIVE,
                         .from = from,
                         .forward = forward,
                         .right = right,
                         .up = murk_cross(right, forward),
                         .step = {2 * tan(hfov_rad / 2) / (double)width,
                                  2 * tan(vfov_rad / 2) / (double)height},
                         .width = width,
                         .height = height};
}

murk_camera murk_camera_around(murk_vec3 from, murk_vec3 toward, size_t width,
                               size_t height)
{
    const murk_vec3 up = {0, 0, 1};
    const murk_vec3 forward = murk_unit(murk_vec(toward.x, toward.y, 0));
    return (murk_camera){.projection = MURK_EQUIRECTANGULAR,
                         .from = from,
                         .forward = forward,
                         .right = murk_cross(forward, up),
                         .up = up,
                         .width = width,
                         .height = height};
}

murk_camera murk_camera_parallel(murk_vec3 from, murk_vec3 to, murk_vec3 up,
                                 double width_m, size_t width, size_t height)
{
    /* The angle of view does not matter, because the size of a pixel is set
     * below. */
    murk_camera camera =
        murk_camera_aimed(from, to, up, MURK_PI / 2, width, height);
    camera.projection = MURK_ORTHOGRAPHIC;
    camera.step[0] = camera.step[1] = width_m / (double)width;
    return camera;
}

const char *murk_projection_name(murk_projection projection)
{
    static const char *const names[] = {[MURK_PERSPECTIVE] = "perspective",
                                        [MURK_EQUIRECTANGULAR] =
                                            "equirectangular",
                                        [MURK_ORTHOGRAPHIC] = "orthographic"};
    return names[projection];
}

/* Distances to the right of the middle of the picture, and above it: in a plane
 * at distance 1, or in metres. */
static void offsets_at(const murk_camera *c, double x, double y, double out[2])
{
    out[0] = (x - (double)c->width / 2) * c->step[0];
    out[1] = ((double)c->height / 2 - y) * c->step[1];
}

bool murk_camera_begin(murk_camera_ray *out, const murk_camera *c, double x,
                       double y, murk_vec3 direction, const murk_box *domain,
                       double margin_m)
{
    *out = (murk_camera_ray){.origin = c->from, .direction = direction};
    const bool is_parallel = c->projection == MURK_ORTHOGRAPHIC;
    if (is_parallel) {
        double offset[2];
        offsets_at(c, x, y, offset);
        out->origin = murk_along(out->origin, offset[0], c->right);
        out->origin = murk_along(out->origin, offset[1], c->up);
    }
    if (!is_parallel && !c->clip.is_set) {
        return true; /* the camera stands in the domain */
    }
    /* The part of the ray behind the clip plane. */
    double from_m = 0, to_m = INFINITY;
    if (c->clip.is_set) {
        const double ahead_m =
            murk_dot(murk_sub(c->clip.point, out->origin), c->clip.normal);
        const double slope = murk_dot(direction, c->clip.normal);
        from_m = ahead_m / slope + margin_m / fabs(slope);
        if (!(ahead_m / slope >= 0 && isfinite(from_m))) {
            return false;
        }
    }
    /* The part in the domain; rounding must not put the origin outside. */
    if (!murk_box_clip(domain, out->origin, direction, &from_m, &to_m)) {
        return false;
    }
    const murk_vec3 at = murk_along(out->origin, from_m, direction);
    out->skipped_m = from_m;
    out->origin = murk_vec(fmin(fmax(at.x, domain->min.x), domain->max.x),
                           fmin(fmax(at.y, domain->min.y), domain->max.y),
                           fmin(fmax(at.z, domain->min.z), domain->max.z));
    return true;
}

/* The direction at a longitude from forward to the right, and at a latitude
 * given by sine and cosine. */
static murk_vec3 on_sphere(const murk_camera *c, double longitude, double sine,
                           double cosine)
{
    const murk_vec3 level = murk_along(murk_scale(cos(longitude), c->forward),
                                       sin(longitude), c->right);
    return murk_unit(murk_along(murk_scale(cosine, level), sine, c->up));
}

static double longitude_at(const murk_camera *c, double x)
{
    return (x / (double)c->width - 0.5) * (2 * MURK_PI);
}

static double latitude_at(const murk_camera *c, double y)
{
    return (0.5 - y / (double)c->height) * MURK_PI;
}

murk_vec3 murk_camera_sight(const murk_camera *c, double x, double y)
{
    if (c->projection == MURK_EQUIRECTANGULAR) {
        const double latitude = latitude_at(c, y);
        return on_sphere(c, longitude_at(c, x), sin(latitude), cos(latitude));
    }
    if (c->projection == MURK_ORTHOGRAPHIC) {
        return c->forward;
    }
    double offset[2];
    offsets_at(c, x, y, offset);
    murk_vec3 d = murk_along(c->forward, offset[0], c->right);
    d = murk_along(d, offset[1], c->up);
    return murk_unit(d);
}

/* The area of a zone of a sphere is proportional to the height (Archimedes), so
 * the sine of the latitude is uniform over the solid angle of a pixel. */
murk_vec3 murk_camera_draw(const murk_camera *c, size_t column, size_t row,
                           double u, double v)
{
    const double x = (double)column + u, y = (double)row;
    if (c->projection != MURK_EQUIRECTANGULAR) {
        return murk_camera_sight(c, x, y + v);
    }
    const double top = sin(latitude_at(c, y)),
                 bottom = sin(latitude_at(c, y + 1));
    const double sine = top + v * (bottom - top);
    return on_sphere(c, longitude_at(c, x), sine,
                     sqrt(fmax(0, 1 - sine * sine)));
}

bool murk_camera_find(const murk_camera *c, murk_vec3 direction, double *x,
                      double *y)
{
    const double ahead = murk_dot(direction, c->forward);
    const double aside = murk_dot(direction, c->right);
    const double above = murk_dot(direction, c->up);
    const double width = (double)c->width, height = (double)c->height;
    if (c->projection == MURK_EQUIRECTANGULAR) {
        const double level = sqrt(ahead * ahead + aside * aside);
        *x = (0.5 + atan2(aside, ahead) / (2 * MURK_PI)) * width;
        *y = (0.5 - atan2(above, level) / MURK_PI) * height;
        return level > 0 || above != 0;
    }
    const double distance = c->projection == MURK_ORTHOGRAPHIC ? 1 : ahead;
    *x = width / 2 + aside / distance / c->step[0];
    *y = height / 2 - above / distance / c->step[1];
    return ahead > 0 && *x >= 0 && *x <= width && *y >= 0 && *y <= height;
}

/* The signed solid angle of the rectangle from the axis to (a, b) in the plane
 * at distance 1. */
static double corner_angle(double a, double b)
{
    return atan(a * b / sqrt(1 + a * a + b * b));
}

double murk_camera_solid_angle(const murk_camera *c, size_t column, size_t row)
{
    const double x = (double)column, y = (double)row;
    if (c->projection == MURK_ORTHOGRAPHIC) {
        return 0;
    }
    if (c->projection == MURK_EQUIRECTANGULAR) {
        const double middle = latitude_at(c, y + 0.5);
        const double height =
            2 * cos(middle) * sin(MURK_PI / 2 / (double)c->height);
        return 2 * MURK_PI / (double)c->width * height;
    }
    const double left = (x - (double)c->width / 2) * c->step[0];
    const double low = ((double)c->height / 2 - y - 1) * c->step[1];
    const double right = left + c->step[0], high = low + c->step[1];
    return corner_angle(right, high) - corner_angle(left, high) -
           corner_angle(right, low) + corner_angle(left, low);
}
