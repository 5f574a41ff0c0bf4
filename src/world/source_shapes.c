/* Prints the geometry of each light source of a scene, as the photon tracer
 * sees it, in hexadecimal floating point, so that equal texts mean equal bits.
 */
#include "world/source_shapes.h"

#include "world/sky.h"

#include <inttypes.h>
#include <stdlib.h>

static bool shines(const murk_source *light)
{
    for (int b = 0; b < MURK_BANDS_MAX; ++b) {
        if (light->power_w.band[b] > 0) {
            return true;
        }
    }
    return false;
}

static void put_vector(FILE *out, murk_vec3 v)
{
    fprintf(out, "%a %a %a\n", v.x, v.y, v.z);
}

/* Prints all properties of a source that photons depend on, except the power.
 * For distant light without power the text is one word: the position of a sun
 * below the horizon, for example, changes no photon. Parts of daylight have
 * their text all the same, so that hours share their light. */
static void put_light(FILE *out, const murk_source *l)
{
    if (murk_source_is_distant(l) && !shines(l) && !l->is_part) {
        fputs("dark\n", out);
        return;
    }
    fprintf(out, "%d %a %a\n", (int)l->type, l->radius_m, l->divergence_rad);
    put_vector(out, l->position);
    put_vector(out, l->edge1);
    put_vector(out, l->edge2);
    put_vector(out, l->direction);
    fprintf(out, "%a %a %a %a %a %a\n", l->angular_radius_rad, l->dome.a,
            l->dome.b, l->dome.c, l->dome.d, l->dome.e);
    if (l->dome.patch.high > 0) {
        fprintf(out, "%a %a %a %a\n", l->dome.patch.low, l->dome.patch.high,
                l->dome.patch.from_rad, l->dome.patch.to_rad);
    }
    if (l->intensity) {
        uint64_t sum[2];
        murk_intensity_checksum(l->intensity, sum);
        fprintf(out, "%" PRIx64 " %" PRIx64 "\n", sum[0], sum[1]);
        put_vector(out, l->c0);
        if (l->height_m > 0) {
            fprintf(out, "high %a\n", l->height_m);
        }
    }
    if (l->dome.c != 0 || l->dome.e != 0) { /* if both are 0, the direction of
                                             * sun or moon is not used */
        put_vector(out, l->dome.towards);
    }
    for (size_t i = 0; i < l->portals; ++i) {
        put_vector(out, l->portal[i].corner);
        put_vector(out, l->portal[i].edge1);
        put_vector(out, l->portal[i].edge2);
    }
}

murk_status murk_source_shapes_print(FILE *out, const murk_scene_desc *scene,
                                     murk_error *err)
{
    murk_source *light = NULL;
    const murk_status status = murk_sky_lights(&light, NULL, scene, err);
    for (size_t i = 0; i < scene->n_lights && !status; ++i) {
        put_light(out, &light[i]);
    }
    free(light);
    return status;
}
