/* Places are seen as photons stored there would be, against a sight onto such
 * photons, and optical depths against worlds whose answer is known.
 *
 * Deterministic: never cries wolf. */
#include "sensing/places_seen.h"
#include "world.h"

static const murk_domain hall = {.box = {{0, 0, 0}, {10, 8, 4}}};
static const murk_vec3 none = {0, 0, 0};

#define MIST 0.3 /* 1/m */

/* Places on a lattice through the hall, more than one piece of them; every
 * third lies on the floor. */
#define ACROSS 30
#define PLACES (ACROSS * ACROSS * 20)

static murk_photon lattice(const void *context, size_t i)
{
    const size_t x = i % ACROSS, y = i / ACROSS % ACROSS,
                 z = i / ACROSS / ACROSS;
    const bool is_floor = i % 3 == 0;
    const murk_vec3 p =
        murk_vec(0.2 + 0.32 * (double)x, 0.15 + 0.26 * (double)y,
                 is_floor ? 0.1 : 0.11 + 0.19 * (double)z);
    (void)context;
    murk_photon photon = a_photon(p, is_floor ? murk_vec(0, 0, 1) : none, 0);
    photon.band = (uint8_t)(i % 2);
    return photon;
}

typedef struct scene {
    murk_surfaces *surfaces;
    murk_media *media;
    murk_photon_map *surface, *volume;
    murk_sight *sight;
} scene;

static const murk_sensor_type TYPES[2] = {{.range_m = 7},
                                          {.range_m = 9,
                                           .view = MURK_VIEW_CONE,
                                           .cone_rad = 2,
                                           .bands = 1,
                                           .toward = true}};

static const murk_pose POSES[3] = {
    {.position = {1.1, 1.2, 2.3}},
    {.type = 1, .position = {8.7, 1.3, 3.1}, .heading_rad = 5.5},
    {.position = {4.9, 7.1, 1.7}}};

static murk_sight_desc usual(void)
{
    return (murk_sight_desc){.domain = hall,
                             .photons_emitted = PLACES,
                             .type = TYPES,
                             .types = 2,
                             .through_sheets = true,
                             .weights = {.balanced = true},
                             .threads = 1};
}

/* A hall with a floor, a wall and a pane, and a sight of photons at the
 * places. Takes over media. */
static scene build(murk_media *media, murk_sight_desc desc)
{
    /* The hall. */
    const murk_surface_desc walls[3] = {
        a_rect(murk_vec(0, 0, 0.1), murk_vec(10, 0, 0), murk_vec(0, 8, 0),
               WALL),
        a_rect(murk_vec(3, 2, 0), murk_vec(0, 3, 0), murk_vec(0, 0, 3), WALL),
        a_rect(murk_vec(6, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 2), GLASS)};
    /* A photon at each place, in the map of surfaces or of volume. */
    murk_photon *split = malloc(2 * PLACES * sizeof *split);
    size_t on = 0, in = 0;
    for (size_t i = 0; i < PLACES; ++i) {
        murk_photon photon = lattice(NULL, i);
        photon.emitted = (uint32_t)i;
        split[photon.normal ? on++ : PLACES + in++] = photon;
    }
    scene s = {.surfaces = surfaces_of(walls, 3),
               .media = media,
               .surface = map_of(split, on),
               .volume = map_of(split + PLACES, in)};
    free(split);
    /* The sight of these photons. */
    desc.surfaces = s.surfaces;
    desc.media = media;
    desc.surface_map = s.surface;
    desc.volume_map = s.volume;
    murk_error err = {0};
    CHECK(murk_sight_create(&s.sight, &desc, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return s;
}

static void tear_down(scene *s)
{
    murk_sight_destroy(s->sight);
    murk_photon_map_destroy(s->surface);
    murk_photon_map_destroy(s->volume);
    murk_media_destroy(s->media);
    murk_surfaces_destroy(s->surfaces);
}

static void see(murk_place_seen *out, const scene *s, bool wants_depth)
{
    const murk_places places = {
        .n = PLACES, .record = lattice, .wants_depth = wants_depth};
    murk_error err = {0};
    CHECK(murk_places_see(out, &places, s->sight, POSES, 3, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
}

static double length_to(size_t place, const murk_pose *pose)
{
    const murk_photon p = lattice(NULL, place);
    return murk_length(
        murk_sub(pose->position,
                 murk_vec((double)p.position_m[0], (double)p.position_m[1],
                          (double)p.position_m[2])));
}

/* What each sensor's look shows of the photons there. The second type looks for
 * light that travels towards it, which places do not have. */
static void query_places(uint16_t *clarity, const scene *s)
{
    murk_sensor_type type[2] = {TYPES[0], TYPES[1]};
    type[1].toward = false;
    murk_sight_desc desc = *murk_sight_described(s->sight);
    desc.type = type;
    murk_sight *sight = NULL;
    murk_error err = {0};
    CHECK(murk_sight_create(&sight, &desc, &err) == MURK_OK);
    memset(clarity, 0, (size_t)3 * PLACES * sizeof *clarity);
    for (size_t k = 0; k < 3; ++k) {
        murk_sparse_row row;
        murk_sight_row(sight, 0, &POSES[k], &row);
        for (size_t i = 0; i < row.seen; ++i) {
            const uint32_t place =
                murk_sight_photon(sight, row.photon[i])->emitted;
            clarity[3 * place + k] = row.clarity ? row.clarity[i] : MURK_CLEAR;
        }
    }
    murk_sight_destroy(sight);
}

/* The k clearest of three, summed. */
static unsigned best(const uint16_t c[3], unsigned k)
{
    unsigned all = 0, min = UINT16_MAX, max = 0;
    for (int i = 0; i < 3; ++i) {
        all += c[i];
        min = c[i] < min ? c[i] : min;
        max = c[i] > max ? c[i] : max;
    }
    return k == 1 ? max : k == 2 ? all - min : all;
}

static void check_like_photons(murk_sight_desc desc)
{
    static uint16_t clarity[3 * PLACES];
    static murk_place_seen seen[PLACES];
    scene s = build(mist(&hall, MIST, 2 * MIST), desc);
    query_places(clarity, &s);
    see(seen, &s, false);
    size_t by[4] = {0};
    const unsigned k = desc.redundancy > 1 ? desc.redundancy : 1;
    for (size_t i = 0; i < PLACES; ++i) {
        const uint16_t *c = &clarity[3 * i];
        unsigned sensors = 0;
        double missed = 1;
        for (int j = 0; j < 3; ++j) {
            sensors += c[j] > 0;
            missed *= 1 - (double)c[j] / MURK_CLEAR;
        }
        ++by[sensors];
        CHECK(seen[i].sensors == sensors && seen[i].depth == 0);
        CHECK(seen[i].clarity == (float)best(c, 1) / MURK_CLEAR);
        if (desc.combining == MURK_COMBINE_INDEPENDENT) {
            /* rounded up by less than a whole clarity, placement/dose.h */
            CHECK(fabs((double)seen[i].worth - (1 - missed)) <
                  2.0 / MURK_CLEAR);
        } else {
            CHECK(seen[i].worth ==
                  (float)((double)best(c, k) / ((double)k * MURK_CLEAR)));
        }
    }
    for (int n = 0; n < 4; ++n) {
        CHECK(by[n] > PLACES / 100); /* all cases are met */
    }
    tear_down(&s);
}

static void test_places_are_seen_as_photons(void)
{
    murk_sight_desc desc = usual();
    check_like_photons(desc);
    desc.through_sheets = false;
    check_like_photons(desc);
    desc.redundancy = 2;
    check_like_photons(desc);
    desc.redundancy = 1;
    desc.detection = MURK_DETECTION_THRESHOLD;
    desc.threshold = 0.15;
    check_like_photons(desc);
    desc.detection = MURK_DETECTION_WEIGHTED;
    desc.combining = MURK_COMBINE_INDEPENDENT;
    check_like_photons(desc);
}

/* The least of the open sightlines' lengths times the extinction; a threshold
 * that hides all hides no sightline, nor does a pane. */
static void test_depth_is_that_of_the_shortest_open_path(void)
{
    static murk_place_seen seen[PLACES], dense[PLACES];
    murk_sight_desc desc = usual();
    desc.detection = MURK_DETECTION_THRESHOLD;
    desc.threshold = 0.9;
    scene s = build(mist(&hall, MIST, 2 * MIST), desc);
    see(seen, &s, true);
    size_t open = 0, hidden = 0;
    for (size_t i = 0; i < PLACES; ++i) {
        const murk_photon p = lattice(NULL, i);
        const murk_vec3 at =
            murk_vec((double)p.position_m[0], (double)p.position_m[1],
                     (double)p.position_m[2] + (p.normal ? 1e-5 : 0));
        double min = INFINITY;
        for (size_t k = 0; k < 3; k += 2) { /* those that see all round */
            if (length_to(i, &POSES[k]) <= TYPES[0].range_m &&
                !murk_surfaces_blocked(s.surfaces, at, POSES[k].position,
                                       true)) {
                min = fmin(min, (p.band + 1) * MIST * length_to(i, &POSES[k]));
            }
        }
        if (p.band == 1) { /* which the third does not see */
            CHECK(isfinite(min) == isfinite((double)seen[i].depth));
            if (isfinite(min)) {
                CHECK(fabs((double)seen[i].depth - min) < 1e-5);
                ++open;
            } else {
                ++hidden;
            }
        } else {
            CHECK((double)seen[i].depth < min + 1e-5 ||
                  isinf((double)seen[i].depth));
        }
    }
    CHECK(open > PLACES / 10 && hidden > PLACES / 100);
    tear_down(&s);

    /* where next to nothing comes through there is still a way */
    s = build(mist(&hall, 100 * MIST, 200 * MIST), usual());
    see(dense, &s, true);
    for (size_t i = 0; i < PLACES; ++i) {
        CHECK(isinf((double)dense[i].depth) == isinf((double)seen[i].depth));
        if (!isinf((double)seen[i].depth)) {
            CHECK(fabs((double)dense[i].depth / (double)seen[i].depth - 100) <
                  1e-3);
        }
    }
    tear_down(&s);
}

static void test_any_number_of_threads(void)
{
    static murk_place_seen one[PLACES], five[PLACES];
    murk_sight_desc desc = usual();
    desc.combining = MURK_COMBINE_INDEPENDENT;
    scene s = build(mist(&hall, MIST, 2 * MIST), desc);
    see(one, &s, true);
    tear_down(&s);
    desc.threads = 5;
    s = build(mist(&hall, MIST, 2 * MIST), desc);
    see(five, &s, true);
    tear_down(&s);
    CHECK(memcmp(one, five, sizeof one) == 0);
}

static void test_nothing_to_see_by_or_at(void)
{
    scene s = build(clear_air(&hall), usual());
    murk_place_seen seen[10];
    murk_error err = {0};
    const murk_places ten = {.n = 10, .record = lattice, .wants_depth = true};
    CHECK(!murk_places_see(seen, &ten, s.sight, NULL, 0, &err));
    for (int i = 0; i < 10; ++i) {
        CHECK(seen[i].sensors == 0 && seen[i].worth == 0 &&
              seen[i].clarity == 0 && isinf((double)seen[i].depth));
    }
    CHECK(!murk_places_see(seen, &ten, s.sight, POSES, 3, &err));
    for (int i = 0; i < 10; ++i) { /* clear air */
        CHECK(seen[i].depth == 0 || isinf((double)seen[i].depth));
    }
    const murk_places no_places = {.record = lattice};
    CHECK(!murk_places_see(NULL, &no_places, s.sight, POSES, 3, &err));
    tear_down(&s);
}

int main(void)
{
    test_places_are_seen_as_photons();
    test_depth_is_that_of_the_shortest_open_path();
    test_any_number_of_threads();
    test_nothing_to_see_by_or_at();
    return check_done();
}
