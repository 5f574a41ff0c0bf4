/* The tracer's books and the story its events tell: classes, wraps, caps,
 * nested glass, positions. Few photons; nothing here depends on luck. */
#include "check.h"
#include "worlds.h"

#define NOTED 64

typedef struct story {
    size_t n;
    murk_event event[NOTED];
} story;

static void note(void *context, uint64_t batch, const murk_event *event)
{
    story *s = context;
    CHECK(event->photon / MURK_BATCH_PHOTONS == batch);
    if (s->n < NOTED) {
        s->event[s->n++] = *event;
    }
}

static story story_of(const test_setup *setup, uint64_t photons)
{
    test_world w = test_world_made(setup);
    story s = {0};
    test_world_trace(&w, photons, 1, note, &s);
    test_world_unmade(&w);
    return s;
}

static const murk_domain cell = {{{0, 0, 0}, {1, 1, 1}}, false};
static const murk_domain tile = {{{0, 0, 0}, {1, 1, 1}}, true};

/* A beam meets a sheet, a mirror, the sheet again, and a black wall. */
static void test_events_and_classes_in_order(void)
{
    /* The wall at 0, the sheet at 0.4 and the mirror at 0.9. */
    const murk_source beam =
        test_beam(murk_vec(0.1, 0.5, 0.5), murk_vec(1, 0, 0));
    const murk_material materials[3] = {test_material(0, 0, 0, 0),
                                        test_material(0, 1, 0, 0),
                                        test_material(0, 0, 1, 0)};
    const murk_vec3 y = {0, 1, 0}, z = {0, 0, 1};
    const murk_surface_desc surfaces[3] = {
        test_rect(murk_vec(0, 0, 0), y, z, 0),
        test_rect(murk_vec(0.9, 0, 0), y, z, 1),
        test_rect(murk_vec(0.4, 0, 0), y, z, 2)};
    const story s = story_of(&(test_setup){.domain = cell,
                                           .lights = &beam,
                                           .n_lights = 1,
                                           .surfaces = surfaces,
                                           .n_surfaces = 3,
                                           .materials = materials,
                                           .n_materials = 3},
                             1);
    /* Expected outcome, place, path length and normal of each event. */
    CHECK(s.n == 5);
    const murk_outcome outcomes[5] = {0, MURK_TRANSMITTED, MURK_MIRRORED,
                                      MURK_TRANSMITTED, MURK_ABSORBED};
    const double x[5] = {0.1, 0.4, 0.9, 0.4, 0}, path[5] = {0, .3, .5, .5, .4};
    const double facing[5] = {0, -1, -1, 1, 1};
    for (uint32_t i = 0; i < 5; ++i) {
        const murk_event *e = &s.event[i];
        CHECK(e->number == i);
        CHECK(e->kind == (i ? MURK_EVENT_SURFACE : MURK_EVENT_EMITTED));
        CHECK(i == 0 || e->outcome == outcomes[i]);
        CHECK(e->event_class ==
              (i <= 1 ? MURK_CLASS_FIRST : MURK_CLASS_SPECULAR));
        CHECK_NEAR(e->position.x, x[i], 1e-6);
        CHECK_NEAR(e->path_m, path[i], 2e-6);
        CHECK_NEAR(e->normal.x, facing[i], 1e-12);
    }
    /* An emission has no incoming direction, and an absorption no outgoing
     * one. */
    CHECK(murk_length(s.event[0].direction_in) == 0);
    CHECK(murk_length(s.event[4].direction_out) == 0);
}

static void test_scattering_makes_later(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.5, 0.5, 0), murk_vec(0, 0, 1));
    const murk_medium media[2] = {test_medium(1e-9, 0, 0),
                                  test_medium(1e4, 1, 0.9)};
    const murk_region regions[2] = {test_everywhere(0), test_everywhere(1)};
    const story s = story_of(&(test_setup){.domain = cell,
                                           .lights = &beam,
                                           .n_lights = 1,
                                           .media = media,
                                           .n_media = 2,
                                           .regions = regions,
                                           .n_regions = 2},
                             1);
    CHECK(s.n > 3);
    CHECK(s.event[1].kind == MURK_EVENT_MEDIUM);
    CHECK(s.event[1].event_class == MURK_CLASS_FIRST);
    CHECK(s.event[1].material_or_medium == 1);
    CHECK(s.event[1].reflectance == 1);
    CHECK_NEAR(s.event[1].scattering_per_m, 1e4, 1e-3);
    CHECK(s.event[2].event_class == MURK_CLASS_LATER);
}

/* Slanted light through a periodic tile without anything in it: it wraps at
 * the sides and keeps its line. */
static void test_wraps(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.5, 0.3, 0), murk_vec(4, 2, 1));
    const story s = story_of(
        &(test_setup){.domain = tile, .lights = &beam, .n_lights = 1}, 1);
    int across_x = 0, across_y = 0;
    for (size_t i = 1; i + 1 < s.n; ++i) {
        CHECK(s.event[i].kind == MURK_EVENT_WRAPPED);
        CHECK(s.event[i].event_class == MURK_CLASS_FIRST);
        across_x += s.event[i].position.x == 1;
        across_y += s.event[i].position.y == 1;
    }
    CHECK(across_x == 4 && across_y == 2);
    const murk_event *end = &s.event[s.n - 1];
    CHECK(end->kind == MURK_EVENT_ESCAPED);
    CHECK(end->position.z == 1);
    CHECK_NEAR(end->position.x, 0.5, 1e-14);
    CHECK_NEAR(end->position.y, 0.3, 1e-14);
}

static void test_level_light_wraps_until_the_cap(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.5, 0.25, 0.5), murk_vec(1, 0, 0));
    test_world w = test_world_made(
        &(test_setup){.domain = tile, .lights = &beam, .n_lights = 1});
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.last = 3;
    trace.wraps_max = 7;
    story s = {0};
    trace.sink = note;
    trace.context = &s;
    murk_trace_run(&trace, w.ledger);
    CHECK(s.n == 3 * (1 + 7 + 1));
    CHECK(s.event[8].kind == MURK_EVENT_LOST);
    CHECK(s.event[8].loss == MURK_LOSS_WRAPS);
    CHECK(murk_tally_read(&w.ledger->lost_photons[MURK_LOSS_WRAPS]) == 3);
    CHECK(test_photons(&w, w.ledger->lost) == 3);
    CHECK(murk_ledger_imbalance(w.ledger) == 0);
    test_world_unmade(&w);
}

/* Between mirrors for ever. */
static void test_events_cap(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.5, 0.5, 0.5), murk_vec(1, 0, 0));
    const murk_material mirror = test_material(0, 1, 0, 0);
    const murk_surface_desc box =
        test_box(murk_vec(0, 0, 0), murk_vec(1, 1, 1), 0);
    test_world w = test_world_made(&(test_setup){.domain = cell,
                                                 .lights = &beam,
                                                 .n_lights = 1,
                                                 .surfaces = &box,
                                                 .n_surfaces = 1,
                                                 .materials = &mirror,
                                                 .n_materials = 1});
    test_world_trace(&w, 2, 1, NULL, NULL); /* the default cap ends it too */
    CHECK(murk_tally_read(&w.ledger->lost_photons[MURK_LOSS_EVENTS]) == 2);
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.last = 1;
    trace.events_max = 10;
    story s = {0};
    trace.sink = note;
    trace.context = &s;
    murk_trace_run(&trace, w.ledger);
    CHECK(s.n == 12);
    CHECK(s.event[11].kind == MURK_EVENT_LOST);
    CHECK(s.event[11].loss == MURK_LOSS_EVENTS);
    CHECK(s.event[11].number == 11);
    test_world_unmade(&w);
}

/* Glass in water in air, and a lamp in the glass: straight through the faces
 * it meets n = 1.5 to 1.33 to 1 on its way out. */
static void test_lamp_in_nested_solids(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.5, 0.5, 0.5), murk_vec(0.3, 0, 1));
    const murk_material materials[2] = {test_material(0, 0, 1, 1.33),
                                        test_material(0, 0, 1, 1.5)};
    const murk_surface_desc surfaces[2] = {
        test_box(murk_vec(.1, .1, .1), murk_vec(.9, .9, .9), 0),
        test_box(murk_vec(.3, .3, .3), murk_vec(.7, .7, .7), 1)};
    const test_setup setup = {.domain = cell,
                              .lights = &beam,
                              .n_lights = 1,
                              .surfaces = surfaces,
                              .n_surfaces = 2,
                              .materials = materials,
                              .n_materials = 2};
    const story s = story_of(&setup, 1);
    const double sine = 0.3 / sqrt(1.09);
    CHECK(s.n >= 4);
    CHECK(s.event[1].outcome == MURK_TRANSMITTED);
    CHECK_NEAR(s.event[1].direction_out.x, sine * 1.5 / 1.33, 1e-14);
    CHECK(s.event[2].outcome == MURK_TRANSMITTED);
    CHECK_NEAR(s.event[2].direction_out.x, sine * 1.5, 1e-14);
}

/* No fog inside glass: the beam meets only the box's two faces. */
static void test_no_medium_inside_solids(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.5, 0.5, 0), murk_vec(0, 0, 1));
    const murk_material air = test_material(0, 0, 1, 1);
    const murk_surface_desc box =
        test_box(murk_vec(0, 0, 0.001), murk_vec(1, 1, 0.999), 0);
    const murk_medium soot = test_medium(20, 0, 0);
    const murk_region region = test_everywhere(0);
    test_world w = test_world_made(&(test_setup){.domain = cell,
                                                 .lights = &beam,
                                                 .n_lights = 1,
                                                 .surfaces = &box,
                                                 .n_surfaces = 1,
                                                 .materials = &air,
                                                 .n_materials = 1,
                                                 .media = &soot,
                                                 .n_media = 1,
                                                 .regions = &region,
                                                 .n_regions = 1});
    test_world_trace(&w, 100, 1, NULL, NULL);
    CHECK(test_photons(&w, w.ledger->escaped) > 85); /* not exp(-20) */
    test_world_unmade(&w);
}

/* A black roof in the top of the domain stops light that enters there; a
 * wall in a periodic side is met from both sides. */
static void test_surfaces_in_the_sides_count(void)
{
    /* A sun above the roof. */
    murk_source sun = test_beam(murk_vec(0, 0, 0), murk_vec(0.2, 0.1, -1));
    sun.type = MURK_SOURCE_DIRECTIONAL;
    const murk_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    const murk_surface_desc roof = test_rect(murk_vec(0, 0, 1), x, y, 0);
    test_world w = test_world_made(&(test_setup){.domain = tile,
                                                 .lights = &sun,
                                                 .n_lights = 1,
                                                 .surfaces = &roof,
                                                 .n_surfaces = 1});
    test_world_trace(&w, 500, 1, NULL, NULL);
    CHECK(test_photons(&w, w.ledger->absorbed_surfaces) == 500);
    test_world_unmade(&w);

    /* A wall in one side, and beams both ways. */
    const murk_surface_desc wall = test_rect(murk_vec(0, 0, 0), y, z, 0);
    for (int sign = -1; sign <= 1; sign += 2) {
        const murk_source beam =
            test_beam(murk_vec(0.5, 0.5, 0.5), murk_vec(sign, 0.1, 0.1));
        const story s = story_of(&(test_setup){.domain = tile,
                                               .lights = &beam,
                                               .n_lights = 1,
                                               .surfaces = &wall,
                                               .n_surfaces = 1},
                                 1);
        CHECK(s.event[s.n - 1].kind == MURK_EVENT_SURFACE);
        CHECK(s.event[s.n - 1].outcome == MURK_ABSORBED);
    }
}

/* A beam that starts in the domain's side and points out of it. */
static void test_light_that_leaves_at_once(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.5, 0.5, 1), murk_vec(0, 0, 1));
    const story s = story_of(
        &(test_setup){.domain = cell, .lights = &beam, .n_lights = 1}, 1);
    CHECK(s.n == 2);
    CHECK(s.event[1].kind == MURK_EVENT_ESCAPED);
    CHECK(s.event[1].path_m == 0);
}

static bool same_event(const murk_event *a, const murk_event *b)
{
    return a->kind == b->kind && a->outcome == b->outcome &&
           memcmp(&a->position, &b->position, sizeof a->position) == 0 &&
           memcmp(&a->direction_out, &b->direction_out,
                  sizeof a->direction_out) == 0;
}

/* Fog of extinction 0 does not change any bit of a path. */
static void test_no_extinction_is_clear_air(void)
{
    /* A room with and without such a medium. */
    const murk_source lamp = test_point(murk_vec(0.4, 0.5, 0.6));
    const murk_material white = test_material(0.6, 0.2, 0.1, 0);
    const murk_surface_desc walls =
        test_box(murk_vec(0.1, 0.1, 0.1), murk_vec(0.9, 0.9, 0.9), 0);
    const murk_medium nothing = test_medium(0, 1, 0.8);
    const murk_region region = test_everywhere(0);
    test_setup setup = {.domain = tile,
                        .lights = &lamp,
                        .n_lights = 1,
                        .surfaces = &walls,
                        .n_surfaces = 1,
                        .materials = &white,
                        .n_materials = 1};
    const story clear = story_of(&setup, 20);
    setup.media = &nothing;
    setup.n_media = setup.n_regions = 1;
    setup.regions = &region;
    const story foggy = story_of(&setup, 20);
    /* All noted events are equal. */
    CHECK(clear.n == NOTED && foggy.n == NOTED);
    bool same = true;
    for (size_t i = 0; i < clear.n; ++i) {
        same = same && same_event(&clear.event[i], &foggy.event[i]);
    }
    CHECK(same);
}

/* Keeps the events of one photon. */
typedef struct path_of_one {
    uint64_t photon;
    story path;
} path_of_one;

static void note_one(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    path_of_one *one = context;
    if (event->photon == one->photon && one->path.n < NOTED) {
        one->path.event[one->path.n++] = *event;
    }
}

/* The events of one photon, if photons [first, last) of a stream are traced. */
static story path_among(const test_world *w, uint64_t photon, uint64_t first,
                        uint64_t last, uint32_t stream)
{
    path_of_one one = {.photon = photon};
    murk_trace trace = murk_trace_defaults();
    trace.world = &w->world;
    trace.sink = note_one;
    trace.context = &one;
    trace.first = first;
    trace.last = last;
    trace.stream = stream;
    murk_trace_run(&trace, w->ledger);
    return one.path;
}

static bool same_path(const story *a, const story *b)
{
    bool same = a->n == b->n;
    for (size_t i = 0; same && i < a->n; ++i) {
        same = same_event(&a->event[i], &b->event[i]);
    }
    return same;
}

/* The path of a photon depends on its index and stream alone: it is the same
 * among few, among many and in another batch. */
static void test_photons_are_addressed(void)
{
    const murk_source lamp = test_point(murk_vec(0.4, 0.5, 0.6));
    test_world w = test_world_made(
        &(test_setup){.domain = cell, .lights = &lamp, .n_lights = 1});
    const uint64_t photons[] = {3, MURK_BATCH_PHOTONS + 2};
    for (size_t i = 0; i < sizeof photons / sizeof *photons; ++i) {
        const uint64_t k = photons[i], all = MURK_BATCH_PHOTONS + 8;
        const story alone = path_among(&w, k, k, k + 1, 0);
        const story among = path_among(&w, k, 0, all, 0);
        CHECK(alone.n == 2); /* emitted, escaped */
        CHECK(same_path(&alone, &among));
        /* Another stream and another photon have another path. */
        const story other = path_among(&w, k, k, k + 1, 1);
        const story next = path_among(&w, k + 1, 0, all, 0);
        CHECK(other.n == 2 && !same_event(&alone.event[1], &other.event[1]));
        CHECK(next.n == 2 &&
              murk_length(murk_sub(next.event[1].position,
                                   alone.event[1].position)) > 0);
    }
    test_world_unmade(&w);
}

static void test_nothing_to_trace(void)
{
    const murk_source lamp = test_point(murk_vec(0.4, 0.5, 0.6));
    test_world w = test_world_made(
        &(test_setup){.domain = cell, .lights = &lamp, .n_lights = 1});
    test_world_trace(&w, 0, 1, NULL, NULL);
    test_world_unmade(&w);
}

int main(void)
{
    test_events_and_classes_in_order();
    test_scattering_makes_later();
    test_wraps();
    test_level_light_wraps_until_the_cap();
    test_events_cap();
    test_lamp_in_nested_solids();
    test_no_medium_inside_solids();
    test_surfaces_in_the_sides_count();
    test_light_that_leaves_at_once();
    test_no_extinction_is_clear_air();
    test_photons_are_addressed();
    test_nothing_to_trace();
    return check_done();
}
