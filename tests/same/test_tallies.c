/* Tallies do not depend on threads, nor on how the photons came to be traced:
 * those of a run that stores N are those of a run that emits as many as it
 * took. Every value and error of every cell is compared bit for bit. */
#include "check.h"
#include "lightmap/lightmap.h"
#include "stage_text.h"

static const char scene_text[] =
    "murk: 1\n"
    "bands_nm: [450, 650]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3], sides: periodic}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [0, 0, 0], edge1_m: [4, 0, 0],"
    " edge2_m: [0, 4, 0]}, material: floor}\n"
    "  - {sphere: {center_m: [1, 1, 1], radius_m: 0.5}, material: glass}\n"
    "materials: {floor: {diffuse: [0.8, 0.3]},"
    " glass: {transmit: 0.99, ior: 1.5}}\n"
    "media: {fog: {extinction_per_m: [1, 2], albedo: 0.95,"
    " phase: {hg: 0.7}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [2, 2, 2], power_w: [10, 3]}\n"
    "  - {type: directional, direction: [1, 2, -3],"
    " irradiance_w_per_m2: [1, 0.2]}\n"
    "photons: {emit: 5000}\n"
    "tallies:\n"
    "  - {name: up, type: plane, point_m: [0, 0, 1], normal: [0.1, 0.2, 1],"
    " bins: [3, 2], angle_bins: 2}\n"
    "  - {name: grid, type: grid, min_m: [0, 0, 0], max_m: [4, 4, 3],"
    " size: [7, 5, 4]}\n"
    "  - {name: probe, type: sphere, center_m: [1, 1, 1], radius_m: 0.9,"
    " hemispheres: true}\n";

#define VALUES (2 * (24 + 140 + 2))

typedef struct book {
    murk_estimate value[VALUES];
    uint64_t emitted;
} book;

static book measured(const char *photons, const char *more, unsigned threads)
{
    /* Trace the scene with these overrides and threads. */
    const char *const overrides[] = {photons, more, NULL};
    book out = {.emitted = 0};
    murk_error err = {0};
    murk_traced *traced = NULL;
    murk_stage *stage = stage_text_create(scene_text, overrides);
    CHECK(stage && !murk_lightmap_trace(&traced, stage, 0, threads, &err));
    if (traced) {
        /* Read all cells of all tallies in both bands. */
        size_t n = 0;
        out.emitted = traced->emitted;
        CHECK(murk_tallies_count(traced->tallies) == 3);
        for (size_t i = 0; i < 3; ++i) {
            const size_t cells =
                murk_tally_cells(murk_tallies_desc(traced->tallies, i));
            for (int band = 0; band < 2; ++band) {
                for (size_t c = 0; c < cells && n < VALUES; ++c) {
                    out.value[n++] = murk_tallies_read(
                        traced->tallies, i, band, c, traced->ledger->emitted,
                        traced->packet_w);
                }
            }
        }
        CHECK(n == VALUES);
    } else {
        printf("%s: %s\n", err.where, err.text);
    }
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return out;
}

static bool are_same(const book *a, const book *b)
{
    return memcmp(a->value, b->value, sizeof a->value) == 0;
}

static void test_threads(const char *more)
{
    const book one = measured("photons.emit=5000", more, 1);
    const book two = measured("photons.emit=5000", more, 2);
    const book five = measured("photons.emit=5000", more, 5);
    CHECK(are_same(&one, &two) && are_same(&one, &five));
    size_t lit = 0;
    for (size_t i = 0; i < VALUES; ++i) {
        lit += one.value[i].value > 0 && one.value[i].standard_error > 0 &&
               one.value[i].standard_error <= 1.01 * one.value[i].value;
    }
    CHECK(lit > VALUES * 9 / 10);
    const book other = measured("photons.emit=5001", more, 2);
    CHECK(!are_same(&one, &other));
}

/* The last wave goes on beyond the last photon: what those brought is taken
 * back. */
static void test_store_is_emit(void)
{
    const book stored = measured("photons={store: 20000}", "seed=2", 2);
    char emit[48];
    snprintf(emit, sizeof emit, "photons.emit=%llu",
             (unsigned long long)stored.emitted);
    const book emitted = measured(emit, "seed=2", 5);
    CHECK(emitted.emitted == stored.emitted);
    CHECK(stored.emitted % MURK_BATCH_PHOTONS != 0);
    CHECK(are_same(&stored, &emitted));
}

int main(void)
{
    test_threads("seed=1");
    test_threads("photons.least_weight=0.001");
    test_store_is_emit();
    return check_done();
}
