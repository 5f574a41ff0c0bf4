/* Looks through water's face and with an acceptance angle: what is seen, and
 * how clearly, against paths found by Fermat's principle alone. Deterministic.
 */
#include "base/rng.h"
#include "medium/rescaled.h"
#include "world.h"

#define SEED    3
#define PHOTONS 3000
#define WATER   1.34

static const murk_domain pool = {.box = {{-5, -5, -5}, {5, 5, 5}}};

/* Fog everywhere and water below z = 0. */
static murk_media *pond(double fog_per_m, double water_per_m)
{
    const murk_medium medium[2] = {
        {.extinction_per_m = {{fog_per_m, fog_per_m}},
         .albedo = murk_spectrum_flat(0.5, 2),
         .where = "fog"},
        {.extinction_per_m = {{water_per_m, 2 * water_per_m}},
         .albedo = murk_spectrum_flat(0.5, 2),
         .where = "water"}};
    const murk_region region[2] = {{.medium = 0,
                                    .shape = MURK_REGION_EVERYWHERE,
                                    .to_world = murk_affine_identity(),
                                    .where = "air"},
                                   {.medium = 1,
                                    .shape = MURK_REGION_BELOW,
                                    .to_world = murk_affine_identity(),
                                    .ior = WATER,
                                    .where = "sea"}};
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, medium, 2, region, 2, &pool.box, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return media;
}

/* A world to look at; its parts are owned. */
typedef struct scene {
    murk_surfaces *surfaces;
    murk_media *media;
    murk_photon_map *map[2];
    murk_sight *sight;
} scene;

static scene scene_of(murk_media *media, const murk_photon *photon, size_t n,
                      const murk_sensor_type *type, size_t types, bool refracts,
                      double power_radius_m)
{
    /* Sort the photons by map. */
    murk_photon *part[2] = {malloc(n * sizeof *photon + 1),
                            malloc(n * sizeof *photon + 1)};
    size_t count[2] = {0, 0};
    for (size_t i = 0; i < n; ++i) {
        const int k = murk_photon_is_volume(&photon[i]);
        part[k][count[k]++] = photon[i];
    }
    /* Both maps, without surfaces. */
    scene s = {.surfaces = surfaces_of(NULL, 0), .media = media};
    for (int k = 0; k < 2; ++k) {
        s.map[k] = map_of(part[k], count[k]);
        free(part[k]);
    }
    /* A sight that bends paths or not, with radiance if a radius is given. */
    const murk_sight_desc desc = {
        .surfaces = s.surfaces,
        .media = media,
        .domain = pool,
        .surface_map = s.map[0],
        .volume_map = s.map[1],
        .photons_emitted = PHOTONS,
        .type = type,
        .types = types,
        .through_sheets = true,
        .refracts = refracts,
        .weights = {.surface = 1, .volume = 1},
        .power = {.radius_m = power_radius_m, .band_nm = {500, 500}},
        .threads = 1};
    murk_error err = {0};
    CHECK(murk_sight_create(&s.sight, &desc, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return s;
}

static void leave(scene *s)
{
    murk_sight_destroy(s->sight);
    murk_photon_map_destroy(s->map[0]);
    murk_photon_map_destroy(s->map[1]);
    murk_surfaces_destroy(s->surfaces);
    murk_media_destroy(s->media);
}

static int seen_by(const scene *s, uint32_t type, murk_vec3 position,
                   double tilt_rad, uint32_t emitted)
{
    const murk_pose pose = {
        .type = type, .position = position, .tilt_rad = tilt_rad};
    murk_sparse_row row;
    murk_sight_row(s->sight, 0, &pose, &row);
    return clarity_of(s->sight, &row, emitted);
}

/* ---- the path through a level face, by golden section ---- */

typedef struct bent_path {
    double length_m[2]; /* above, below */
    double through;     /* 1 - Fresnel */
} bent_path;

static double optical(double x, double r, const double h[2], double n)
{
    return hypot(x, h[0]) + n * hypot(r - x, h[1]);
}

/* Fresnel's sines and tangents, as in his own formulas. */
static bent_path path_through(murk_vec3 above, murk_vec3 below, double n)
{
    const double r = hypot(above.x - below.x, above.y - below.y);
    const double h[2] = {above.z, -below.z}, golden = 0.6180339887498949;
    double a = 0, b = r;
    for (int i = 0; i < 100; ++i) {
        const double p = b - golden * (b - a), q = a + golden * (b - a);
        if (optical(p, r, h, n) < optical(q, r, h, n)) {
            b = q;
        } else {
            a = p;
        }
    }
    const double x = (a + b) / 2, i = atan2(x, h[0]), t = atan2(r - x, h[1]);
    const double s = sin(i - t) / sin(i + t), p = tan(i - t) / tan(i + t);
    return (bent_path){{hypot(x, h[0]), hypot(r - x, h[1])},
                       1 - (s * s + p * p) / 2};
}

static void test_clarity_is_fermats_path_times_fresnel(void)
{
    /* Random photons in two bands, above and below a water surface. */
    murk_photon photon[PHOTONS];
    murk_vec3 place[PHOTONS];
    for (uint32_t i = 0; i < PHOTONS; ++i) {
        const murk_random4 u = murk_random(SEED, MURK_SCATTER, i, 0, 0);
        photon[i] = a_photon(
            murk_vec(10 * u.u[0] - 5, 10 * u.u[1] - 5, 10 * u.u[2] - 5),
            murk_vec(0, 0, 0), i);
        photon[i].band = i % 2;
        const float *x = photon[i].position_m;
        place[i] = murk_vec((double)x[0], (double)x[1], (double)x[2]);
    }
    const murk_sensor_type all = {.range_m = INFINITY};
    scene s = scene_of(pond(0.05, 0.1), photon, PHOTONS, &all, 1, true, 0);
    /* A sensor in air and one in water see all photons. */
    const murk_vec3 eye[2] = {{1, -2, 0.75}, {-2, 1, -1.5}};
    size_t across = 0, noticed = 0;
    for (int e = 0; e < 2; ++e) {
        const murk_pose pose = {.position = eye[e]};
        murk_sparse_row row;
        murk_sight_row(s.sight, 0, &pose, &row);
        CHECK(row.seen == PHOTONS);
        for (size_t k = 0; k < row.seen; ++k) {
            CHECK(k == 0 || row.photon[k] > row.photon[k - 1]);
            const murk_photon *p =
                &murk_photon_map_photons(s.map[1])[row.photon[k]];
            const murk_vec3 at = place[p->emitted];
            const double water = 0.1 * (1 + p->band);
            /* On the side of the sensor, the path is straight. */
            if ((at.z < 0) == (eye[e].z < 0)) {
                const double d = murk_length(murk_sub(at, eye[e]));
                const double want = exp(-d * (at.z < 0 ? water : 0.05));
                CHECK_NEAR(row.clarity[k], want * MURK_CLEAR, 0.51);
                continue;
            }
            /* Across the surface, the reference is the path of least
             * optical length; another index would be noticed. */
            double want[2];
            for (int k2 = 0; k2 < 2; ++k2) {
                const bent_path w =
                    e == 0 ? path_through(eye[e], at, WATER + .01 * k2)
                           : path_through(at, eye[e], WATER + .01 * k2);
                want[k2] = w.through *
                           exp(-0.05 * w.length_m[0] - water * w.length_m[1]) *
                           MURK_CLEAR;
            }
            CHECK_NEAR(row.clarity[k], want[0], 0.51);
            ++across;
            noticed += fabs(row.clarity[k] - want[1]) > 0.51;
        }
    }
    CHECK(across > PHOTONS / 2);
    CHECK(noticed > across * 9 / 10);
    CHECK(murk_sight_work_of(s.sight).blocked_by_interfaces == 0);
    leave(&s);

    /* Without refraction, the surface of the water blocks all paths across. */
    s = scene_of(pond(0.05, 0.1), photon, PHOTONS, &all, 1, false, 0);
    const murk_pose pose = {.position = eye[0]};
    murk_sparse_row row;
    murk_sight_row(s.sight, 0, &pose, &row);
    CHECK(row.seen < PHOTONS);
    CHECK(murk_sight_work_of(s.sight).blocked_by_interfaces ==
          PHOTONS - row.seen);
    leave(&s);
}

/* ---- range, view, side, arrival: where things appear ---- */

static void test_range_is_apparent(void)
{
    const murk_vec3 none = {0, 0, 0};
    const murk_photon photon[] = {a_photon(murk_vec(0, 0, -2.65), none, 0),
                                  a_photon(murk_vec(0, 0, -2.71), none, 1),
                                  a_photon(murk_vec(1, 0, 1.48), none, 2),
                                  a_photon(murk_vec(1, 0, 1.50), none, 3),
                                  a_photon(murk_vec(0, 0, -0.6), none, 4),
                                  a_photon(murk_vec(0, 0, -0.7), none, 5)};
    const murk_sensor_type type[] = {{.range_m = 3},
                                     {.range_m = 3, .least_range_m = 1.5}};
    scene s = scene_of(pond(0, 0), photon, 6, type, 2, true, 0);
    const murk_vec3 above = {0, 0, 1}, below = {1, 0, -1};
    /* 1 + depth / 1.34 at most 3: depth 2.68, though 3.65 m away. */
    CHECK(seen_by(&s, 0, above, 0, 0) > 0);
    CHECK(seen_by(&s, 0, above, 0, 1) == 0);
    /* 1 + 1.34 height at most 3: height 1.4925, though 2.5 m away. */
    CHECK(seen_by(&s, 0, below, 0, 2) > 0);
    CHECK(seen_by(&s, 0, below, 0, 3) == 0);
    /* At least 1.5: depth .67. */
    CHECK(seen_by(&s, 0, above, 0, 4) > 0);
    CHECK(seen_by(&s, 1, above, 0, 4) == 0);
    CHECK(seen_by(&s, 1, above, 0, 5) > 0);
    leave(&s);
}

/* Seen from above, what lies at 45 degrees appears less steep. */
static void test_view_is_apparent(void)
{
    const murk_vec3 eye = {-1, 0, 1}, none = {0, 0, 0}, coin = {1, 0, -1};
    const murk_photon photon = a_photon(coin, none, 0);
    const bent_path w = path_through(eye, coin, WATER);
    const double angle = acos(eye.z / w.length_m[0]);
    CHECK(angle > MURK_PI / 4 + 0.05);
    const murk_sensor_type type[] = {
        {.range_m = 9, .view = MURK_VIEW_CONE, .cone_rad = 2 * angle - 0.01},
        {.range_m = 9, .view = MURK_VIEW_CONE, .cone_rad = 2 * angle + 0.01}};
    scene s = scene_of(pond(0, 0), &photon, 1, type, 2, true, 0);
    CHECK(seen_by(&s, 0, eye, -MURK_PI / 2, 0) == 0);
    CHECK(seen_by(&s, 1, eye, -MURK_PI / 2, 0) > 0);
    leave(&s);
}

/* The straight line to the sensor goes up at 27 degrees, light leaves at some
 * 40: what stands at an angle between sees it, or not, by the latter. */
static void test_side_and_arrival_are_those_of_the_segment(void)
{
    const murk_vec3 eye = {-2, 0, 1}, at = {2, 0, -1}, none = {0, 0, 0};
    const murk_vec3 away = {-1, 0, -1.7}, toward = {1, 0, 1.7};
    murk_photon photon[] = {a_photon(at, murk_unit(away), 0),
                            a_photon(at, murk_unit(toward), 1),
                            a_photon(at, none, 2), a_photon(at, none, 3)};
    photon[2].direction = murk_direction_pack(murk_unit(away));
    photon[3].direction = murk_direction_pack(murk_unit(toward));
    const murk_sensor_type type[] = {{.range_m = 9},
                                     {.range_m = 9, .toward = true}};
    scene s = scene_of(pond(0, 0), photon, 4, type, 2, true, 0);
    const murk_vec3 straight = murk_sub(eye, at);
    CHECK(murk_dot(away, straight) > 0 && murk_dot(toward, straight) < 0);
    CHECK(seen_by(&s, 0, eye, 0, 0) == 0);
    CHECK(seen_by(&s, 0, eye, 0, 1) > 0);
    CHECK(seen_by(&s, 1, eye, 0, 2) == 0);
    CHECK(seen_by(&s, 1, eye, 0, 3) > 0);
    leave(&s);
}

/* ---- acceptance ---- */

static void test_acceptance_is_of_the_type(void)
{
    /* Fog with another phase function in each band. */
    const double acceptance = 2 * MURK_PI / 180;
    murk_medium fog = {.extinction_per_m = {{0.3, 0.6}},
                       .albedo = {{0.9, 0.4}},
                       .where = "fog"};
    fog.phase[0] = murk_phase_hg(0.95);
    fog.phase[1] = murk_phase_hg(0.9);
    const murk_region region = {.shape = MURK_REGION_EVERYWHERE,
                                .to_world = murk_affine_identity(),
                                .where = "everywhere"};
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, &fog, 1, &region, 1, &pool.box, &err) ==
          MURK_OK);
    /* A photon in each band, and two types: one accepts scattered light
     * within 2 degrees. */
    const murk_vec3 eye = {-2, 0, 0}, at = {2, 0, 0}, none = {0, 0, 0};
    murk_photon photon[] = {a_photon(at, none, 0), a_photon(at, none, 1)};
    photon[1].band = 1;
    const murk_sensor_type type[] = {
        {.range_m = 9}, {.range_m = 9, .acceptance_rad = acceptance}};
    scene s = scene_of(media, photon, 2, type, 2, false, 0);
    for (uint32_t band = 0; band < 2; ++band) {
        /* Light that is scattered forward within this angle does not dim,
         * by the integral of the phase function. */
        const double extinction = fog.extinction_per_m.band[band];
        const double scattered = extinction * fog.albedo.band[band];
        const double g = band ? 0.9 : 0.95, c = cos(acceptance);
        const double share = (1 - g * g) / (2 * g) *
                             (1 / (1 - g) - 1 / sqrt(1 + g * g - 2 * g * c));
        CHECK_NEAR(seen_by(&s, 0, eye, 0, band),
                   MURK_CLEAR * exp(-4 * extinction), 0.51);
        CHECK_NEAR(seen_by(&s, 1, eye, 0, band),
                   MURK_CLEAR * exp(-4 * (extinction - scattered * share)),
                   0.51);
        CHECK(seen_by(&s, 1, eye, 0, band) >
              1.02 * seen_by(&s, 0, eye, 0, band));
    }
    leave(&s);
}

/* ---- power ---- */

/* A plate lit from above at the bottom of a pool, seen from right above. From
 * the water's side the eye is h 1.34 over the face, so an aperture A fills A /
 * (d + 1.34 h)^2 of the directions that light leaves the plate in. In the air
 * it is the same with d instead of what water makes of it. */
static void test_power_through_water_is_what_leaves_toward_the_eye(void)
{
    const double d = 2, h = 1.5, area = 1e-3;
    const murk_vec3 up = {0, 0, 1}, eye = {0, 0, h};
    const murk_photon photon[] = {a_photon(murk_vec(0, 0, -d), up, 0),
                                  a_photon(murk_vec(0, .1, -d), up, 1)};
    const double radiance = PHOTONS / (PHOTONS - 1.) / (MURK_PI * MURK_PI);
    const double through = 1 - pow((WATER - 1) / (WATER + 1), 2);
    const double signal = through * radiance * 0.02 * area /
                          (pow(d + WATER * h, 2) + area / MURK_PI);
    const double per_w = 0.5 * 500e-9 / 6.62607015e-34 / 299792458;
    const double exposure = 1 / (signal * per_w);
    const murk_sensor_type type = {.range_m = 9,
                                   .aperture_m2 = area,
                                   .quantum_efficiency = 0.5,
                                   .exposure_s = exposure,
                                   .target_m2 = 0.02,
                                   .target_m3 = 1};
    scene s = scene_of(pond(0, 0), photon, 2, &type, 1, true, 1);
    /* rounding, and A / pi, which is of the eye's side there: 1.6e-5 of s */
    CHECK_NEAR(seen_by(&s, 0, eye, 0, 0), MURK_CLEAR * (1 - exp(-1)), 1);
    leave(&s);
    /* Teeth: without (1 / 1.34)^2 nearly twice as much would come. */
    CHECK(1 - exp(-WATER * WATER) > 1.3 * (1 - exp(-1)));
}

int main(void)
{
    test_clarity_is_fermats_path_times_fresnel();
    test_range_is_apparent();
    test_view_is_apparent();
    test_side_and_arrival_are_those_of_the_segment();
    test_acceptance_is_of_the_type();
    test_power_through_water_is_what_leaves_toward_the_eye();
    return check_done();
}
