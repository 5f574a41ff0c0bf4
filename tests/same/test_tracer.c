/* The tracer tells the same events, bit for bit, on 1, 2 and 5 threads, and
 * keeps the same books. Each batch's events are hashed in the order told. */
#include "check.h"
#include "closed_mesh.h"
#include "worlds.h"

#define BATCHES 12
#define PHOTONS (BATCHES * MURK_BATCH_PHOTONS - 100)

static uint64_t mixed(uint64_t hash, const void *bytes, size_t n)
{
    const unsigned char *b = bytes; /* FNV-1a */
    for (size_t i = 0; i < n; ++i) {
        hash = (hash ^ b[i]) * UINT64_C(0x100000001b3);
    }
    return hash;
}

static void hash_event(void *context, uint64_t batch, const murk_event *e)
{
    uint64_t *hash = (uint64_t *)context + batch;
    const uint64_t words[8] = {
        e->kind,   e->outcome, e->event_class, e->photon,
        e->number, e->light,   e->band,        e->material_or_medium};
    *hash = mixed(*hash, words, sizeof words);
    *hash = mixed(*hash, &e->position, sizeof e->position);
    *hash = mixed(*hash, &e->direction_in, sizeof e->direction_in);
    *hash = mixed(*hash, &e->direction_out, sizeof e->direction_out);
    *hash = mixed(*hash, &e->normal, sizeof e->normal);
    *hash = mixed(*hash, &e->path_m, sizeof e->path_m);
}

typedef struct books {
    uint64_t hash[BATCHES];
    int64_t cell[5][2], collisions, lost[MURK_LOSSES];
} books;

static void keep(books *b, const murk_ledger *l)
{
    const murk_tally *account[5] = {l->emitted, l->absorbed_surfaces,
                                    l->absorbed_media, l->escaped, l->lost};
    for (int a = 0; a < 5; ++a) {
        for (int c = 0; c < 2; ++c) {
            b->cell[a][c] = murk_tally_read(&account[a][c]);
        }
    }
    for (int i = 0; i < MURK_LOSSES; ++i) {
        b->lost[i] = murk_tally_read(&l->lost_photons[i]);
    }
    b->collisions = murk_tally_read(&l->collisions);
}

/* Traces a room with a glass ball partly in water, a ball of water, fog in
 * a box and in a star of many facets, two light sources, and periodic
 * sides. */
static books traced(unsigned threads, uint32_t seed)
{
    /* Light sources and surfaces. */
    murk_source lights[2] = {test_point(murk_vec(1, 1, 2)),
                             test_beam(murk_vec(3, 3, 3), murk_vec(-1, 1, -2))};
    lights[1].power_w.band[0] = 0.4;
    const murk_material materials[2] = {test_material(0.6, 0.1, 0.1, 0),
                                        test_material(0, 0, 0.99, 1.5)};
    const murk_surface_desc surfaces[3] = {
        test_rect(murk_vec(0, 0, 0), murk_vec(4, 0, 0), murk_vec(0, 4, 0), 0),
        test_rect(murk_vec(0, 0, 4), murk_vec(4, 0, 0), murk_vec(0, 4, 0), 0),
        test_sphere(murk_vec(2, 2, 1), 0.8, 1)};
    /* Regions: fog in a box, water below, a ball of water, and fog in the
     * star. */
    const murk_medium fog = test_medium(0.8, 0.95, 0.8);
    murk_mesh *star = closed_star(murk_vec(1, 2.8, 2.5), 0.9, 0.4, 8, 3);
    murk_mesh *const mesh[4] = {NULL, NULL, NULL, star};
    murk_region regions[4] = {
        test_box_region(0, murk_vec(0, 0, 0), murk_vec(3, 4, 2)),
        test_everywhere(0), test_ball_region(0, murk_vec(3, 1, 3), 0.5),
        test_mesh_region(0)};
    regions[1].shape = MURK_REGION_BELOW;
    regions[1].below_z_m = 0.4;
    regions[1].ior = regions[2].ior = 1.34;
    test_world w =
        test_world_made(&(test_setup){.domain = {{{0, 0, 0}, {4, 4, 4}}, true},
                                      .lights = lights,
                                      .n_lights = 2,
                                      .surfaces = surfaces,
                                      .n_surfaces = 3,
                                      .materials = materials,
                                      .n_materials = 2,
                                      .media = &fog,
                                      .n_media = 1,
                                      .regions = regions,
                                      .n_regions = 4,
                                      .mesh = mesh});
    /* Trace with a hash of all events in each batch, and keep the counts of
     * the ledger. */
    books b = {.collisions = 0};
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = seed;
    trace.last = PHOTONS;
    trace.threads = threads;
    trace.sink = hash_event;
    trace.context = b.hash;
    murk_trace_run(&trace, w.ledger);
    CHECK(murk_ledger_imbalance(w.ledger) == 0);
    keep(&b, w.ledger);
    test_world_unmade(&w);
    murk_mesh_destroy(star);
    return b;
}

int main(void)
{
    const books one = traced(1, 1), two = traced(2, 1), five = traced(5, 1);
    CHECK(memcmp(&one, &two, sizeof one) == 0);
    CHECK(memcmp(&one, &five, sizeof one) == 0);
    CHECK(one.collisions > 1000 && one.cell[1][1] > 0 && one.cell[2][0] > 0);
    CHECK(one.cell[0][0] + one.cell[0][1] == PHOTONS * MURK_PACKET);
    const books other = traced(2, 2);
    for (int i = 0; i < BATCHES; ++i) {
        CHECK(one.hash[i] != other.hash[i]);
    }
    return check_done();
}
