/* Stored when reflected, stored when hit, and photons that carry weights say
 * the same: irradiance on a wall and fluence rate in a medium, from the maps,
 * as the contract defines both.
 *
 * The events of one emitted photon are kept together: errors come from the
 * photons. Both settings share the photons' paths, so the difference is
 * compared with the error of the difference, photon by photon. The checks share
 * a 1e-6 false-alarm budget. Teeth: a diffuse coefficient or albedo off by 10 %
 * (25 % where paths differ) under one of the two settings must fail. */
#include "base/stats.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "stage_text.h"

#include <stdlib.h>

#define PHOTONS 20000
#define DIFFUSE 0.4
#define CHECKS  6

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry: [{box: {min_m: [0.01, 0.01, 0.01], max_m: [3.99, 3.99, 2.99]},"
    " material: wall}]\n"
    "materials: {wall: {diffuse: 0.4}}\n"
    "media: {fog: {extinction_per_m: 0.5, albedo: 0.7, phase: {hg: 0.6}}}\n"
    "regions: [{medium: fog, sphere: {center_m: [2, 2, 1.5], radius_m: 1.2}}]\n"
    "lights: [{type: point, position_m: [1, 1, 2.5], power_w: 8}]\n"
    "photons: {emit: 20000}\n";

/* Sums of each photon for the irradiance of the whole wall and the fluence
 * rate of the whole sphere: power on the wall over the diffuse reflectance,
 * power in the volume over the scattering coefficient; areas and volumes
 * cancel. */
static bool sums_by_photon(const char *store_when, const char *least_weight,
                           double *wall, double *fog)
{
    /* Trace the maps with this setting of the stored records. */
    const char *const overrides[] = {store_when, least_weight, NULL};
    murk_error err = {0};
    murk_traced *traced = NULL;
    murk_stage *stage = stage_text_create(scene_text, overrides);
    const bool is_traced =
        stage && !murk_lightmap_trace(&traced, stage, 0, 2, &err);
    if (!is_traced) {
        printf("%s: %s\n", err.where, err.text);
        goto done;
    }
    /* Add each record to the sum of the photon that was emitted. */
    const murk_photon_map *maps[2] = {traced->surface, traced->volume};
    for (int is_volume = 0; is_volume < 2; ++is_volume) {
        const murk_photon *p = murk_photon_map_photons(maps[is_volume]);
        for (size_t i = 0; i < murk_photon_map_count(maps[is_volume]); ++i) {
            const murk_vec3 at = {p[i].position_m[0], p[i].position_m[1],
                                  p[i].position_m[2]};
            if (is_volume) {
                fog[p[i].emitted] += p[i].power_w / murk_media_scattering(
                                                        stage->media, 0, 0, at);
            } else {
                wall[p[i].emitted] += p[i].power_w / DIFFUSE;
            }
        }
    }
done:
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return is_traced;
}

/* Sigmas between the two settings when the second is scaled by `wrong`. */
static double sigmas_between(const double *a, const double *b, double wrong)
{
    double *difference = calloc(PHOTONS, sizeof *difference);
    for (size_t i = 0; i < PHOTONS; ++i) {
        difference[i] = a[i] - wrong * b[i];
    }
    const murk_estimate e = murk_mean_estimate(difference, PHOTONS);
    free(difference);
    return sigmas_off(e.value, 0, e.standard_error);
}

int main(void)
{
    static const char *const settings[][2] = {
        {"photons.store_when=reflected", "photons.least_weight=1"},
        {"photons.store_when=hit", "photons.least_weight=1"},
        {"photons.store_when=reflected", "photons.least_weight=0.01"},
        {"photons.store_when=hit", "photons.least_weight=0.2"}};
    double *sum = calloc(8 * PHOTONS, sizeof *sum);
    double *wall[4], *fog[4];
    const double limit = murk_sidak_limit(1e-6, CHECKS);
    for (size_t i = 0; i < 4; ++i) {
        wall[i] = sum + 2 * i * PHOTONS;
        fog[i] = wall[i] + PHOTONS;
        CHECK(sums_by_photon(settings[i][0], settings[i][1], wall[i], fog[i]));
    }
    for (size_t i = 1; i < 4; ++i) {
        CHECK(sigmas_between(wall[0], wall[i], 1) < limit);
        CHECK(sigmas_between(fog[0], fog[i], 1) < limit);
        /* Settings that share no paths are compared less precisely. */
        const double wrong = i == 1 ? 1.1 : 1.25;
        CHECK(sigmas_between(wall[0], wall[i], wrong) > limit);
        CHECK(sigmas_between(fog[0], fog[i], wrong) > limit);
    }
    free(sum);
    return check_done();
}
