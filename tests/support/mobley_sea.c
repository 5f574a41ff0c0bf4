/* Writes the scene of a canonical problem, traces it, and converts the tallies
 * at the two depths into the three quantities that Mobley et al. (1993)
 * tabulate. */
#include "mobley_sea.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "lightmap/lightmap.h"
#include "stage_text.h"

#define TILE_M 0.5

const double mobley_tau[MOBLEY_DEPTHS] = {1, 5};

static const char SCENE[] =
    "murk: 1\n"
    "seed: %u\n"
    "bands_nm: [550]\n"
    "domain: {min_m: [0, 0, -60], max_m: [%g, %g, 1], sides: periodic}\n"
    "site: {latitude_deg: 40, longitude_deg: 0, time: %s}\n"
    "media: {sea: {preset: water/pure, extinction_per_m: 1, albedo: %g, phase: "
    "%s}}\n"
    "regions: [{medium: sea, below_z_m: 0, ior: %g, wind_m_per_s: 0}]\n"
    "lights: [{type: sun, irradiance_w_per_m2: [1]}]\n"
    "photons: {emit: %llu, maps: none}\n"
    "tallies:\n";

static const char TALLIES[] =
    "  - {name: d%d, type: plane, point_m: [0, 0, %g], normal: [0, 0, -1]}\n"
    "  - {name: u%d, type: sphere, center_m: [%g, %g, %g], radius_m: 0.1, "
    "hemispheres: true}\n";

/* The phase function as a scene says it; a table by its absolute path. */
static void print_phase(char *out, size_t size, int problem)
{
    char folder[1024];
    if (problem == 1 || !getcwd(folder, sizeof folder)) {
        snprintf(out, size, "rayleigh");
        return;
    }
    snprintf(out, size, "{table: \"%s/media/water/petzold.csv\"}", folder);
}

static murk_stage *make(const mobley_sea *sea, uint64_t photons, uint32_t seed)
{
    char text[4000], phase[1200];
    print_phase(phase, sizeof phase, sea->problem);
    size_t used = (size_t)snprintf(
        text, sizeof text, SCENE, seed, TILE_M, TILE_M,
        sea->time ? sea->time : "2026-06-21T07:23:00Z", sea->albedo, phase,
        sea->index, (unsigned long long)photons);
    for (int k = 0; k < MOBLEY_DEPTHS; ++k) {
        const double z = -mobley_tau[k], middle = TILE_M / 2;
        used += (size_t)snprintf(text + used, sizeof text - used, TALLIES, k, z,
                                 k, middle, middle, z);
    }
    return stage_text_create(text, NULL);
}

static murk_estimate read_tally(const murk_traced *traced, size_t tally,
                                double per)
{
    const murk_estimate e =
        murk_tallies_read(traced->tallies, tally, 0, 0, traced->ledger->emitted,
                          traced->packet_w);
    return (murk_estimate){e.value / per, e.standard_error / per};
}

mobley_light mobley_sea_lit(const mobley_sea *sea, uint64_t photons,
                            uint32_t seed)
{
    const murk_estimate none = {NAN, NAN};
    mobley_light out = {NAN, {none, none}, {none, none}};
    murk_stage *stage = make(sea, photons, seed);
    murk_traced *traced = NULL;
    murk_error err = {0};
    if (stage && murk_lightmap_trace(&traced, stage, 0, 2, &err)) {
        printf("%s: %s\n", err.where, err.text);
    }
    if (traced) {
        out.sun_deg = stage->sky[0].elevation_deg;
        for (size_t k = 0; k < MOBLEY_DEPTHS; ++k) { /* forward; up */
            out.ed[k] = read_tally(traced, 2 * k, TILE_M * TILE_M);
            out.eou[k] = read_tally(traced, 2 * k + 1, 1);
        }
    }
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return out;
}
