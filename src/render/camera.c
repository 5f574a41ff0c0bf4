#include "render/camera.h"

murk_camera murk_camera_look(murk_vec3 from, murk_vec3 to, murk_vec3 up,
                             double vfov_rad, size_t width, size_t height)
{
    const murk_vec3 forward = murk_unit(murk_sub(to, from));
    const murk_vec3 right = murk_unit(murk_cross(forward, up));
    return (murk_camera){.from = from,
                         .forward = forward,
                         .right = right,
                         .up = murk_cross(right, forward),
                         .tangent = tan(vfov_rad / 2),
                         .width = width,
                         .height = height};
}

murk_vec3 murk_camera_sight(const murk_camera *c, double x, double y)
{
    const double per_pixel = 2 * c->tangent / (double)c->height;
    const double aside = (x - (double)c->width / 2) * per_pixel;
    const double above = ((double)c->height / 2 - y) * per_pixel;
    murk_vec3 d = murk_along(c->forward, aside, c->right);
    d = murk_along(d, above, c->up);
    return murk_unit(d);
}
