/* The solids that contain a point of a ray: see path/solids.h. A solid encloses
 * a point if a ray from the point meets the solid's boundary an odd number of
 * times. */
#include "path/solids.h"

/* The largest number of boundaries of solids, and of surfaces of all kinds,
 * that are considered along the ray: far more than scenes are expected to have.
 * Further ones are ignored; only solids with a boundary among them may then be
 * listed or left out wrongly. */
#define BOUNDARIES_MAX 64
#define STEPS_MAX      1024

double murk_path_solids_index(const murk_path_solids *solids)
{
    return solids->n > 0 ? solids->ior[solids->n - 1] : 1;
}

static int find(const murk_path_solids *solids, uint16_t solid)
{
    for (int i = solids->n - 1; i >= 0; --i) {
        if (solids->solid[i] == solid) {
            return i;
        }
    }
    return -1;
}

bool murk_path_solids_cross(murk_path_solids *solids, uint16_t solid,
                            double ior)
{
    const int found = find(solids, solid);
    if (found >= 0) {
        --solids->n;
        for (int i = found; i < solids->n; ++i) {
            solids->solid[i] = solids->solid[i + 1];
            solids->ior[i] = solids->ior[i + 1];
        }
        return true;
    }
    if (solids->n == MURK_PATH_SOLIDS_MAX) {
        return false;
    }
    solids->solid[solids->n] = solid;
    solids->ior[solids->n++] = ior;
    return true;
}

/* Without a solid around the point (murk_surfaces_solid_at()) the list is
 * empty. Otherwise the function follows the ray outwards and notes each
 * boundary of a solid. From the far end back, each boundary adds its solid to
 * the list or removes it again. Solids with an odd number of boundaries remain,
 * in the order of their nearest boundaries, so that the solid that the ray
 * leaves first is the last of the list. A solid that finds the list full is not
 * added. */
murk_path_solids murk_path_solids_around(const murk_surfaces *surfaces,
                                         murk_vec3 point, murk_vec3 direction)
{
    murk_path_solids around = {0};
    if (murk_surfaces_solid_at(surfaces, point) == 0) {
        return around;
    }
    uint16_t solid[BOUNDARIES_MAX];
    double ior[BOUNDARIES_MAX];
    int n = 0;
    for (int step = 0; step < STEPS_MAX && n < BOUNDARIES_MAX; ++step) {
        murk_hit hit;
        if (!murk_surfaces_hit(surfaces, point, direction, INFINITY, &hit)) {
            break;
        }
        /* Note the boundary of a solid. */
        if (hit.solid) {
            solid[n] = hit.solid;
            ior[n++] = murk_surfaces_material(surfaces, hit.material)->ior;
        }
        point = murk_surfaces_leave(
            surfaces, murk_along(point, hit.distance_m, direction),
            murk_scale(-1, hit.normal));
    }
    /* From the far end back: out of or into each solid. */
    while (n-- > 0) {
        murk_path_solids_cross(&around, solid[n], ior[n]);
    }
    return around;
}
