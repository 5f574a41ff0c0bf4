/* Writes and reads positions in binary result files; see scene/places.h. */
#include "scene/places.h"

#include <string.h>

static bool is_far(const murk_scene_desc *scene)
{
    return scene && (scene->origin.x != 0 || scene->origin.y != 0 ||
                     scene->origin.z != 0);
}

size_t murk_place_bytes(const murk_scene_desc *scene)
{
    return 3 * (is_far(scene) ? sizeof(double) : sizeof(float));
}

const char *murk_place_ply(const murk_scene_desc *scene)
{
    return is_far(scene)
               ? "property double x\nproperty double y\nproperty double z\n"
               : "property float x\nproperty float y\nproperty float z\n";
}

const char *murk_place_vtk(const murk_scene_desc *scene)
{
    return is_far(scene) ? "Float64" : "Float32";
}

void murk_place_put(const murk_scene_desc *scene, murk_vec3 local, void *to)
{
    if (is_far(scene)) {
        const murk_vec3 p = murk_scene_user(scene, local);
        const double xyz[3] = {p.x, p.y, p.z};
        memcpy(to, xyz, sizeof xyz);
        return;
    }
    const float xyz[3] = {(float)local.x, (float)local.y, (float)local.z};
    memcpy(to, xyz, sizeof xyz);
}

murk_vec3 murk_place_take(const murk_scene_desc *scene, const void *from)
{
    if (is_far(scene)) {
        double xyz[3];
        memcpy(xyz, from, sizeof xyz);
        return murk_scene_local(scene, murk_vec(xyz[0], xyz[1], xyz[2]));
    }
    float xyz[3];
    memcpy(xyz, from, sizeof xyz);
    return murk_vec((double)xyz[0], (double)xyz[1], (double)xyz[2]);
}

int murk_coordinate_digits(const murk_scene_desc *scene, int asked)
{
    const int at_millimetres = 12; /* below 1e9 m */
    return is_far(scene) ? at_millimetres : asked;
}
