/* Light that only scales: shares of channels by hand, and a map whose records
 * follow their channels' powers. Seeds are fixed, and what is said of maps
 * holds for any. */
#include "lightmap/scaled_light.h"

#include "base/log.h"
#include "check.h"
#include "stage_text.h"

#include <stdlib.h>

#define CHANNELS 6

/* Two lamps, and a beam from above, of 5 W/m2 on 3 x 2 m2; two bands. */
static const char text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [3, 2, 1]}\n"
    "bands_nm: [500, 600]\n"
    "geometry: [{rect: {corner_m: [0.1, 0.1, 0.1], edge1_m: [2.8, 0, 0],"
    " edge2_m: [0, 1.8, 0]}, material: wall}]\n"
    "materials: {wall: {diffuse: 0.5}}\n"
    "media: {fog: {extinction_per_m: 1, albedo: 0.9}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [1, 1, 0.5], power_w: [6, 2]}\n"
    "  - {type: point, position_m: [2, 1, 0.5], power_w: [0, 2]}\n"
    "  - {type: directional, direction: [0, 0, -1],"
    " irradiance_w_per_m2: [0, 5]}\n"
    "photons: {emit: 2000}\n"
    "seed: 3\n";

static const char *const other[] = {
    "lights.0.power_w=[0, 10]", "lights.1.power_w=[0, 5]",
    "lights.2.irradiance_w_per_m2=[0, 2.5]", NULL};
static const char *const none[] = {"lights.0.power_w=0", "lights.1.power_w=0",
                                   "lights.2.irradiance_w_per_m2=0", NULL};

static double *powers_of(const murk_scene_desc *scene,
                         const murk_domain *domain)
{
    double *power_w = NULL;
    murk_error err = {0};
    CHECK(murk_scaled_light_powers(&power_w, scene, domain, &err) == MURK_OK);
    return power_w;
}

/* The sources for n scenes. */
static murk_sources *sources_for(double *grow,
                                 const murk_scene_desc *const *scene,
                                 double *const *power_w, size_t n,
                                 const murk_domain *domain)
{
    murk_scaled_shares *shares = NULL;
    murk_sources *lights = NULL;
    murk_error err = {0};
    CHECK(murk_scaled_shares_create(&shares, scene[0], &err) == MURK_OK);
    for (size_t k = 0; shares && k < n; ++k) {
        CHECK(murk_scaled_shares_add(shares, scene[k], power_w[k], &err) ==
              MURK_OK);
    }
    if (shares) {
        CHECK(murk_scaled_shares_shine(shares));
        CHECK(murk_scaled_shares_differ(shares) == (n > 1));
        CHECK(murk_scaled_shares_sources(&lights, grow, shares, domain, &err) ==
              MURK_OK);
    }
    murk_scaled_shares_destroy(shares);
    return lights;
}

/* 6 + 2, 0 + 2 and 5 * 6 W make 40; 10, 5 and 15 W make 30. The largest shares
 * are 6/40, 10/30, none, 5/30, none and 30/40, together 1.4. */
static void test_every_channel_has_its_largest_share(void)
{
    static const double first[] = {6, 2, 0, 2, 0, 30},
                        second[] = {0, 10, 0, 5, 0, 15},
                        share[] = {.15, 1. / 3, 0, 1. / 6, 0, .75};
    murk_stage *stage = stage_text_create(text, NULL);
    murk_scene_desc *b = scene_text_create(text, other),
                    *dark = scene_text_create(text, none);
    if (!stage || !b || !dark) {
        CHECK(false);
        return;
    }
    const murk_domain *domain = &stage->world.domain;
    double *power_w[3] = {powers_of(stage->scene, domain), powers_of(b, domain),
                          powers_of(dark, domain)};
    const murk_scene_desc *const scene[] = {stage->scene, b, dark};
    for (size_t c = 0; c < CHANNELS; ++c) {
        CHECK_NEAR(power_w[0][c], first[c], 1e-12);
        CHECK_NEAR(power_w[1][c], second[c], 1e-12);
        CHECK(power_w[2][c] == 0);
    }
    double grow = 0;
    murk_sources *lights = sources_for(&grow, scene, power_w, 3, domain);
    CHECK_NEAR(grow, 1.4, 1e-12);
    for (size_t c = 0; lights && c < CHANNELS; ++c) {
        CHECK_NEAR(murk_sources_channel_power_w(lights, c), share[c], 1e-12);
    }
    CHECK(lights && murk_sources_get(lights, 1)->position.x == 2);
    murk_sources_destroy(lights);
    /* one scene alone, and no other behind it */
    const murk_scene_desc *const alone[] = {b, NULL};
    lights = sources_for(&grow, alone, &power_w[1], 1, domain);
    CHECK_NEAR(grow, 1, 1e-12);
    for (size_t c = 0; lights && c < CHANNELS; ++c) {
        CHECK_NEAR(murk_sources_channel_power_w(lights, c), second[c] / 30,
                   1e-12);
    }
    murk_sources_destroy(lights);
    for (int k = 0; k < 3; ++k) {
        free(power_w[k]);
    }
    murk_scene_desc_destroy(dark);
    murk_scene_desc_destroy(b);
    stage_text_destroy(stage);
}

/* A lamp that shines in no scene stays where it is, without power. */
static void test_a_lamp_without_power_stays(void)
{
    static const char *const off[] = {"lights.1.power_w=0", NULL};
    murk_stage *stage = stage_text_create(text, off);
    if (!stage) {
        CHECK(false);
        return;
    }
    double *power_w = powers_of(stage->scene, &stage->world.domain), grow;
    const murk_scene_desc *const alone[] = {stage->scene, NULL};
    murk_sources *lights =
        sources_for(&grow, alone, &power_w, 1, &stage->world.domain);
    if (lights) {
        CHECK(murk_sources_get(lights, 1)->position.x == 2);
        CHECK(murk_sources_channel_power_w(lights, 3) == 0);
        CHECK_NEAR(murk_sources_channel_power_w(lights, 0), 6. / 38, 1e-12);
    }
    murk_sources_destroy(lights);
    free(power_w);
    stage_text_destroy(stage);
}

/* A beam through a portal of 2 x 0.5 m2 has the power that falls on the portal,
 * and the sources that are traced have the portal. */
static void test_portals_count(void)
{
    static const char *const aim[] = {
        "lights.2.aim=[{corner_m: [0.5, 0.5, 0.9], edge1_m: [0, 0.5, 0],"
        " edge2_m: [2, 0, 0]}]",
        NULL};
    murk_stage *stage = stage_text_create(text, aim);
    if (!stage) {
        CHECK(false);
        return;
    }
    double *power_w = powers_of(stage->scene, &stage->world.domain), grow;
    const murk_scene_desc *const alone[] = {stage->scene, NULL};
    /* The power of the beam, then the sources. */
    CHECK_NEAR(power_w[5], 5 * 2 * 0.5, 1e-9);
    murk_sources *lights =
        sources_for(&grow, alone, &power_w, 1, &stage->world.domain);
    if (lights) {
        CHECK(murk_sources_get(lights, 2)->portals == 1);
        CHECK(murk_sources_get(lights, 2)->portal[0].corner.z == 0.9);
        CHECK_NEAR(murk_sources_channel_power_w(lights, 5), 5. / 15, 1e-9);
    }
    murk_sources_destroy(lights);
    free(power_w);
    stage_text_destroy(stage);
}

/* Sums of power and counts of a map's records by channel. */
static void add_up(const murk_photon_map *map, double *power_w, size_t *count)
{
    for (size_t c = 0; c < CHANNELS; ++c) {
        power_w[c] = 0;
        count[c] = 0;
    }
    for (size_t i = 0; i < murk_photon_map_count(map); ++i) {
        const murk_photon *p = &murk_photon_map_photons(map)[i];
        power_w[p->light * 2 + p->band] += p->power_w;
        ++count[p->light * 2 + p->band];
    }
}

/* Records of a channel have the power of another scene's channel, and go where
 * that has none. What is stored as float keeps 2^-24 of it. */
static void check_map(const murk_photon_map *from, const murk_photon_map *to,
                      const double *factor)
{
    double before[CHANNELS], after[CHANNELS];
    size_t were[CHANNELS], are[CHANNELS];
    add_up(from, before, were);
    add_up(to, after, are);
    for (size_t c = 0; c < CHANNELS; ++c) {
        CHECK(are[c] == (factor[c] > 0 ? were[c] : 0));
        CHECK_NEAR(after[c], before[c] * factor[c],
                   1e-6 * before[c] * factor[c]);
    }
    CHECK(were[0] > 10 && were[1] > 10 && were[3] > 10 && were[5] > 10);
}

static void test_records_follow_their_channels(void)
{
    static const double factor[] = {0, 5, 0, 2.5, 0, .5};
    murk_stage *stage = stage_text_create(text, NULL);
    murk_scene_desc *b = scene_text_create(text, other);
    murk_traced *traced = NULL, *made = NULL;
    murk_error err = {0};
    if (!stage || !b ||
        murk_lightmap_trace(&traced, stage, 0, 2, &err) != MURK_OK) {
        CHECK(false);
        return;
    }
    double *power_w = powers_of(b, &stage->world.domain);
    CHECK(murk_scaled_light_make(&made, traced, stage->lights, power_w, 2, 2,
                                 &err) == MURK_OK);
    if (made) {
        check_map(traced->surface, made->surface, factor);
        check_map(traced->volume, made->volume, factor);
        CHECK(made->emitted == traced->emitted && made->seed == 3 &&
              made->stream == 0 && made->channels == CHANNELS);
        for (size_t c = 0; c < CHANNELS; ++c) {
            CHECK_NEAR(made->packet_w[c], traced->packet_w[c] * factor[c],
                       1e-12 * traced->packet_w[c]);
        }
    }
    murk_traced_destroy(made);
    made = NULL;
    for (size_t c = 0; c < CHANNELS; ++c) { /* all dark */
        power_w[c] = 0;
    }
    CHECK(murk_scaled_light_make(&made, traced, stage->lights, power_w, 2, 1,
                                 &err) == MURK_OK);
    CHECK(made && murk_photon_map_count(made->surface) == 0);
    murk_traced_destroy(made);
    murk_traced_destroy(traced);
    free(power_w);
    murk_scene_desc_destroy(b);
    stage_text_destroy(stage);
}

int main(void)
{
    murk_warn_to(NULL);
    test_every_channel_has_its_largest_share();
    test_a_lamp_without_power_stays();
    test_portals_count();
    test_records_follow_their_channels();
    return check_done();
}
