/* Random sequences of changes of one scene: the rows of each step that are
 * taken over from the step before equal those that are computed, in every bit,
 * with the same counts. The changes: objects that move, leave the domain and
 * come back; materials; media, even, in boxes, and grids whose bricks change;
 * lamps; sensors; nothing; everything.
 *
 * Teeth: without one of the boxes of changed places, rows differ in at least 95
 * of 100 such cases in which photons are the same.
 *
 * Argument: the number of sequences (50). Seeds are fixed. */
#define _DEFAULT_SOURCE /* mkdtemp() */
#include "../unit/plan/chosen.h"
#include "check.h"
#include "lightmap/light_update.h"
#include "lightmap/rank_exchange.h"
#include "medium/grid_write.h"
#include "plan/earlier.h"
#include "stage_text.h"

#include "base/host.h"
#include "base/rng.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define THREADS 2

static char folder[] = "/tmp/murk_changing_XXXXXX";

/* ---- the scene ---- */

static const char scene_form[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [8, 6, 4]}\n"
    "timeline: {from_s: 0, to_s: 1, every_s: 1}\n"
    "geometry:\n"
    "  - {box: {min_m: [0.01, 0.01, 0.01], max_m: [7.99, 5.99, 3.99]},"
    " material: wall}\n"
    "  - {name: load, box: {min_m: [-0.4, -0.5, -0.6], max_m: [0.4, 0.5, 0.6]},"
    " material: metal}\n"
    "  - {name: ball, sphere: {center_m: [0, 0, 0], radius_m: 0.4},"
    " material: metal}\n"
    "  - {name: pane, rect: {corner_m: [0, -1, -1], edge1_m: [0, 2, 0],"
    " edge2_m: [0, 0, 2]}, material: glass}\n"
    "materials: {wall: {diffuse: 0.5}, metal: {diffuse: 0.3, specular: 0.2},"
    " glass: {transmit: 0.7, specular: 0.1}}\n"
    "media:\n"
    "  haze: {extinction_per_m: 0.02, albedo: 0.9}\n"
    "  cloud: {extinction_per_m: 0.5, albedo: 0.8, phase: {hg: 0.6}}\n"
    "  plume: {vdb: '%s/plume.####.vdb', frame: 0, extinction_per_m: 1,"
    " albedo: 0.7, phase: {hg: 0.5}, interpolation: nearest}\n"
    "regions:\n"
    "  - {medium: haze, box: {min_m: [0, 0, 0], max_m: [8, 6, 4]}}\n"
    "  - {medium: cloud, box: {min_m: [-0.7, -0.7, -0.5],"
    " max_m: [0.7, 0.7, 0.5]}, translate_m: [2, 2, 2]}\n"
    "  - {medium: plume, translate_m: [3.5, 2.5, 1]}\n"
    "lights:\n"
    "  - {type: point, position_m: [1, 1, 3.5], power_w: 5}\n"
    "  - {type: point, position_m: [7, 5, 3.5], power_w: 5}\n"
    "tallies:\n"
    "  - {name: inside, type: grid, min_m: [1, 1, 1], max_m: [7, 5, 3],"
    " size: [6, 4, 4]}\n"
    "  - {name: middle, type: plane, point_m: [0, 3, 0], normal: [0, 1, 0]}\n"
    "photons: {emit: 1500}\n"
    "sensors:\n"
    "  types: [{name: node, range_m: 5}, {name: eye, range_m: 8,"
    " view: {cone_deg: 90}, headings: 3}]\n"
    "  candidates: {grid: {min_m: [1, 1, 0.7], max_m: [7, 5, 3.3],"
    " size: [4, 3, 2]}}\n"
    "  count: 2\n"
    "placement: {hold_out: false, method: greedy}\n";

static char scene_text[sizeof scene_form + sizeof folder];

/* A key that changes, and its values, the first of which is that of the scene.
 * Keys without `is_local` may change every sightline. */
typedef struct varied {
    const char *key;
    const char *value[4]; /* NULL ends them */
    bool is_local;
} varied;

static const varied keys[] = {
    {"geometry.1.translate_m",
     {"[4, 3, 2]", "[4.5, 3, 2]", "[40, 3, 2]", "[2, 4, 1.5]"},
     true},
    {"geometry.2.translate_m",
     {"[6, 2, 1]", "[5.8, 2.1, 1.3]", "[6, -20, 1]"},
     true},
    {"geometry.3.translate_m", {"[5, 3, 2]", "[3, 3, 2]"}, true},
    {"materials.glass.transmit", {"0.7", "0.4"}, true},
    {"materials.metal.diffuse", {"0.3", "0.6"}, true},
    {"media.cloud.extinction_per_m", {"0.5", "0", "1.5"}, true},
    {"media.cloud.albedo", {"0.8", "0.3"}, true},
    {"regions.1.translate_m", {"[2, 2, 2]", "[2.3, 2, 2]"}, true},
    {"regions.2.translate_m", {"[3.5, 2.5, 1]", "[3.5, 2.6, 1]"}, true},
    {"media.plume.frame", {"0", "1", "2", "3"}, true},
    {"media.plume.extinction_per_m", {"1", "2"}, true},
    {"media.plume.interpolation", {"nearest", "linear"}, true},
    {"media.haze.extinction_per_m", {"0.02", "0.05"}, false},
    {"lights.0.power_w", {"5", "0", "3"}, true},
    {"lights.1.position_m", {"[7, 5, 3.5]", "[6.5, 5, 3.5]"}, true},
    {"sensors.fixed", {"[]", "[{type: node, position_m: [4, 1, 1]}]"}, true},
    {"sensors.candidates.grid.size", {"[4, 3, 2]", "[5, 3, 2]"}, true},
};
#define KEYS (sizeof keys / sizeof *keys)

/* The places of the two keys of lamps. */
#define FIRST_LAMP 13

/* Settings that hold for a sequence: keys that are set before those above, and
 * one that is set after them. With some settings every change in a box changes
 * clarities. */
#define BEFORE 4
typedef struct held {
    const char *before[BEFORE];
    const char *after;
    bool is_clear;
} held;

/* Without walls, so that photons and sightlines pass the sides of a periodic
 * domain. */
#define OPEN_FLOOR                                                             \
    "geometry.0={box: {min_m: [0.01, 0.01, 0.01], max_m: [7.99, 5.99, 0.05]}," \
    " material: wall}"
#define PERIODIC "domain.sides=periodic", OPEN_FLOOR

/* A pool whose surface lies between the two levels of candidates, and a side of
 * it between two rows of them. */
#define POOL                                                      \
    "regions.0={medium: haze, ior: 1.33, box: {min_m: [0, 0, 0]," \
    " max_m: [6.03, 6, 2.02]}}"

static char cloud_of_mesh[] = "regions.1={medium: cloud, mesh: "
                              "/tmp/murk_changing_XXXXXX/block.obj}";
static const held settings[] = {
    {.before = {"placement.detection=weighted"}, .is_clear = true},
    {.before = {"placement.detection=threshold"},
     .after = "placement.threshold=0.6"},
    {.before = {"placement.detection=independent"}},
    {.before = {"placement.through=block"}},
    {.before = {"placement.visibility=normal"}},
    {.before = {"sensors.types.0.acceptance_deg=5"}},
    {.before = {"placement.redundancy=2"}},
    {.after = "media.plume.interpolation=linear"},
    {.before = {cloud_of_mesh}},
    {.before = {"sensors.types.0.arrival=toward"}},
    {.before = {"sensors.target=0.2"}, .after = "placement.at_least=2"},
    {.before = {"sensors.types.0.least_range_m=1.5"}},
    {.before = {"flight=delta"}},
    {.before = {"photons.least_weight=0.1"}},
    {.before = {"photons.maps=surface"}},
    {.before = {"photons.store_when=hit"}},
    {.before = {PERIODIC}, .is_clear = true},
    {.before = {PERIODIC, cloud_of_mesh}},
    {.before = {POOL}},
    {.before = {POOL, "placement.through=refract"}, .is_clear = true},
    {.before = {PERIODIC, POOL}, .after = "placement.through=refract"},
    {.before = {POOL, cloud_of_mesh, "placement.through=refract"}},
    {.before = {"placement.targets={volume: {points: 1500}}"},
     .is_clear = true},
    {.before = {"placement.targets={surfaces: {points: 900}, "
                "volume: {points: 600}}"}},
    {.before = {"placement.detection=power"}},
    {.before = {"placement.detection=power",
                "placement.targets={surfaces: {points: 900}}"}},
    {.before = {PERIODIC, POOL, "placement.detection=power"},
     .after = "placement.through=refract"},
    {.before = {"placement.detection=power"},
     .after = "placement.power_radius_m=0.5"},
};
#define SETTINGS (sizeof settings / sizeof *settings)

/* Frames of the plume, 24 voxels along each edge: the second differs from the
 * first in one leaf of 8 voxels, the third in most, the fourth in its box of
 * active voxels. */
static void write_frames(void)
{
    enum { EDGE = 24 };
    static float value[EDGE * EDGE * EDGE];
    const size_t size[3] = {EDGE, EDGE, EDGE};
    murk_affine place = murk_affine_identity();
    for (int axis = 0; axis < 3; ++axis) {
        place.matrix[axis][axis] = 0.07;
    }
    for (int frame = 0; frame < 4; ++frame) {
        for (int i = 0; i < EDGE * EDGE * EDGE; ++i) {
            const int x = i % EDGE, y = i / EDGE % EDGE, z = i / EDGE / EDGE;
            const bool in_leaf = x / 8 == 1 && y / 8 == 1 && z / 8 == 1;
            value[i] = 0.5F + 0.02F * (float)(x + y);
            value[i] *= frame == 1 && in_leaf ? 2 : frame == 2 ? 1.3F : 1;
            value[i] = frame == 3 && x == 0 ? 0 : value[i];
        }
        char path[64];
        const murk_grid_field field = {.name = "density", .value = value};
        murk_error err = {0};
        snprintf(path, sizeof path, "%s/plume.%04d.vdb", folder, frame);
        CHECK(murk_grid_write(path, &field, 1, size, &place, &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
    }
}

/* A mesh that bounds a region: the box of the cloud. */
static void write_mesh(void)
{
    static const int face[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                                   {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
    char path[64];
    snprintf(path, sizeof path, "%s/block.obj", folder);
    memcpy(strchr(cloud_of_mesh, '/'), path, strlen(path));
    FILE *to = fopen(path, "w");
    CHECK(to);
    for (int i = 0; i < 8 && to; ++i) {
        fprintf(to, "v %g %g %g\n", i & 1 ? 0.7 : -0.7, i & 2 ? 0.7 : -0.7,
                i & 4 ? 0.5 : -0.5);
    }
    for (int i = 0; i < 6 && to; ++i) {
        fprintf(to, "f %d %d %d %d\n", face[i][0], face[i][1], face[i][2],
                face[i][3]);
    }
    CHECK(to && fclose(to) == 0);
}

static void remove_files(void)
{
    char mesh[64];
    snprintf(mesh, sizeof mesh, "%s/block.obj", folder);
    unlink(mesh);
    for (int frame = 0; frame < 4; ++frame) {
        char path[64];
        snprintf(path, sizeof path, "%s/plume.%04d.vdb", folder, frame);
        unlink(path);
    }
    rmdir(folder);
}

/* What was seen in all sequences. */
static struct {
    size_t steps, updated, taken, photons, photons_new, sightlines, reused,
        left_out, missed, lost, patched;
    bool is_taken[32]; /* [SETTINGS] a row was taken over */
    uint64_t photons_reused, photons_emitted;
    size_t lights, lights_missed;
} total;

/* ---- a step ---- */

typedef struct step {
    murk_stage *stage;
    murk_traced *traced;
    murk_passed_light passed; /* of another stream */
    murk_plan_result plan;
} step;

/* Prepares the plan of a step, whose stage and light are there. */
static void prepare(step *s, const murk_earlier_plan *earlier)
{
    murk_error err = {0};
    CHECK(murk_plan_prepare(&s->plan, s->stage, THREADS, &err) == MURK_OK);
    s->plan.keeps_matrix = true;
    s->plan.earlier = earlier;
    CHECK_TEXT(err.text, "");
}

/* True if two maps have the same records. */
static bool same_maps(const murk_photon_map *a, const murk_photon_map *b)
{
    const size_t n = murk_photon_map_count(a);
    return n == murk_photon_map_count(b) &&
           (n == 0 ||
            memcmp(murk_photon_map_photons(a), murk_photon_map_photons(b),
                   n * sizeof(murk_photon)) == 0);
}

static bool same_sums(const murk_traced *a, const murk_traced *b)
{
    murk_light_sums p, q;
    murk_error err = {0};
    CHECK(murk_light_sums_read(&p, a->ledger, a->tallies, false, MURK_OK,
                               &err) == MURK_OK);
    CHECK(murk_light_sums_read(&q, b->ledger, b->tallies, false, MURK_OK,
                               &err) == MURK_OK);
    const bool are_same =
        p.cells == q.cells && p.words == q.words && p.words > 0 &&
        memcmp(p.cell, q.cell, p.cells * sizeof *p.cell) == 0 &&
        memcmp(p.word, q.word, p.words * sizeof *p.word) == 0;
    murk_light_sums_release(&p);
    murk_light_sums_release(&q);
    return are_same;
}

static bool same_light(const murk_traced *a, const murk_traced *b)
{
    return same_maps(a->surface, b->surface) &&
           same_maps(a->volume, b->volume) && same_sums(a, b) &&
           a->emitted == b->emitted && a->channels == b->channels &&
           memcmp(a->packet_w, b->packet_w,
                  a->channels * sizeof *a->packet_w) == 0;
}

/* The update with the paths of all photons forgotten, of a change that leaves
 * the lamps as they are and the light not: no photon is traced. */
static void leave_cells_out(const step *s, const murk_earlier_plan *earlier,
                            const murk_traced *fresh, uint64_t reused)
{
    murk_path_cells *cells = earlier->traced->cells;
    murk_error err = {0};
    murk_traced *wrong = NULL;
    uint64_t ignored;
    if (reused == 0 || reused == fresh->emitted ||
        same_light(earlier->traced, fresh)) {
        return;
    }
    uint64_t *crossed = cells->crossed;
    cells->crossed = calloc(cells->photons, sizeof *crossed);
    CHECK(cells->crossed);
    CHECK(murk_lightmap_update(&wrong, &ignored, s->stage, earlier->traced,
                               earlier->stage, THREADS, &err) == MURK_OK);
    ++total.lights;
    total.lights_missed += same_light(wrong, fresh);
    murk_traced_destroy(wrong);
    free(cells->crossed);
    cells->crossed = crossed;
}

/* ---- light that is passed to a sink ---- */

#define OTHER_STREAM 1

/* A murk_record_batch_sink: a sum that depends on the order of all batches and
 * records. */
static murk_status add_up(void *context, const murk_record_batch *batch,
                          murk_error *err)
{
    uint64_t *sum = context;
    (void)err;
    const struct {
        const murk_photon *photon;
        size_t n;
    } map[2] = {{batch->surface, batch->n_surface},
                {batch->volume, batch->n_volume}};
    *sum = 31 * (31 * *sum + batch->number) + batch->first + 7 * batch->last;
    for (size_t m = 0; m < 2; ++m) {
        const unsigned char *byte = (const unsigned char *)map[m].photon;
        for (size_t i = 0; i < map[m].n * sizeof(murk_photon); ++i) {
            *sum = 1099511628211U * (*sum ^ byte[i]);
        }
        *sum = 31 * *sum + map[m].n;
    }
    return MURK_OK;
}

/* The light of another stream: that of the step before updated, against all
 * photons traced anew. */
static void pass(step *s, const murk_earlier_plan *earlier)
{
    murk_error err = {0};
    murk_passed_light fresh;
    uint64_t sum = 0, fresh_sum = 0;
    CHECK(murk_lightmap_update_passed(&s->passed, s->stage, OTHER_STREAM,
                                      earlier ? earlier->held_out : NULL,
                                      THREADS, sizeof(murk_photon), add_up,
                                      &sum, &err) == MURK_OK);
    s->passed.stage = s->stage;
    CHECK(murk_lightmap_update_passed(&fresh, s->stage, OTHER_STREAM, NULL,
                                      THREADS, sizeof(murk_photon), add_up,
                                      &fresh_sum, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    CHECK(sum == fresh_sum);
    murk_passed_light_release(&fresh);
}

/* ---- the light of a step ---- */

/* The light of a step: that of the step before updated, against all photons
 * traced anew. */
static void trace(step *s, const murk_earlier_plan *earlier,
                  bool are_same_lamps)
{
    murk_error err = {0};
    if (!earlier) {
        CHECK(murk_lightmap_trace_watched(&s->traced, s->stage,
                                          &s->stage->world.domain.box, THREADS,
                                          &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
        return;
    }
    /* The update, and the light of a run of its own. */
    uint64_t reused = 0;
    murk_traced *fresh = NULL;
    CHECK(murk_lightmap_update(&s->traced, &reused, s->stage, earlier->traced,
                               earlier->stage, THREADS, &err) == MURK_OK);
    CHECK(murk_lightmap_trace(&fresh, s->stage, 0, THREADS, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    CHECK(same_light(s->traced, fresh));
    total.updated += reused > 0;
    total.photons_reused += reused;
    total.photons_emitted += fresh->emitted;
    if (are_same_lamps) {
        leave_cells_out(s, earlier, fresh, reused);
    }
    murk_traced_destroy(fresh);
}

static void step_make(step *out, const size_t choice[KEYS], size_t setting,
                      const murk_earlier_plan *earlier, bool are_same_lamps)
{
    char text[KEYS][96];
    const char *override[KEYS + BEFORE + 2] = {0};
    size_t n = 0;
    for (size_t k = 0; k < BEFORE && settings[setting].before[k]; ++k) {
        override[n++] = settings[setting].before[k];
    }
    for (size_t k = 0; k < KEYS; ++k) {
        snprintf(text[k], sizeof text[k], "%s=%s", keys[k].key,
                 keys[k].value[choice[k]]);
        override[n++] = text[k];
    }
    if (settings[setting].after) {
        override[n++] = settings[setting].after;
    }
    *out = (step){.stage = stage_text_create(scene_text, override)};
    CHECK(out->stage);
    if (!out->stage) {
        exit(check_done());
    }
    /* The light, and what the plan needs. */
    trace(out, earlier, are_same_lamps);
    pass(out, earlier);
    prepare(out, earlier);
}

static void step_choose(step *s)
{
    murk_error err = {0};
    CHECK(choose_sensors(&s->plan, s->stage, s->traced, THREADS, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    CHECK(s->plan.matrix);
}

static void step_release(step *s)
{
    murk_plan_result_release(&s->plan);
    murk_traced_destroy(s->traced);
    murk_passed_light_release(&s->passed);
    stage_text_destroy(s->stage);
}

/* ---- rows ---- */

/* is_binary: clarities above 0 count as full (placement/at_least.h), so that
 * rows that are taken over have no others. */
static bool same_rows(const murk_sparse_row *a, const uint32_t *photon,
                      const uint16_t *clarity, size_t seen, bool is_binary)
{
    bool are_same = a->seen == seen;
    for (size_t k = 0; k < seen && are_same; ++k) {
        are_same = a->photon[k] == photon[k] &&
                   (is_binary ||
                    (a->clarity ? a->clarity[k] : MURK_CLEAR) == clarity[k]);
    }
    return are_same;
}

/* Puts an entry in the place of another; false if that one was not there. */
static bool exchange(uint16_t *clarity, const murk_sparse_row *row, size_t k,
                     bool is_gone)
{
    const uint16_t entry = row->clarity ? row->clarity[k] : MURK_CLEAR;
    uint16_t *at = &clarity[row->photon[k]];
    const bool was_there = *at == (is_gone ? entry : 0);
    *at = is_gone ? 0 : entry;
    return was_there;
}

/* True if the row of a candidate that known->get() has just given is the
 * earlier row, without the entries that are told to be gone and with those that
 * came, from which hashes of columns are computed. */
static bool has_right_differences(const murk_earlier_rows *rows, size_t photons,
                                  size_t candidate, const murk_sparse_row *row)
{
    const size_t slots = murk_matrix_slots(rows->matrix);
    uint32_t *slot = calloc(slots + 1, sizeof *slot);
    uint16_t *entry = calloc(slots + 1, sizeof *entry),
             *by_slot = calloc(slots + 1, sizeof *by_slot),
             *clarity = calloc(photons + 1, sizeof *clarity);
    size_t n, seen = 0;
    bool is_right = murk_matrix_list(slot, entry, &n, rows->matrix,
                                     rows->candidate[candidate]);
    for (size_t k = 0; k < n; ++k) {
        by_slot[slot[k]] = entry[k];
    }
    for (size_t i = 0; i < photons; ++i) {
        if (rows->same[i] != UINT32_MAX) {
            clarity[i] = by_slot[murk_matrix_slot(rows->matrix, rows->same[i])];
        }
    }
    /* Exchange, and compare with the row. */
    murk_sparse_row gone, come;
    rows->known.get_differences(rows->known.context, 0, &gone, &come);
    for (size_t k = 0; k < gone.seen; ++k) {
        is_right = exchange(clarity, &gone, k, true) && is_right;
    }
    for (size_t k = 0; k < come.seen; ++k) {
        is_right = exchange(clarity, &come, k, false) && is_right;
    }
    for (size_t k = 0; k < row->seen; ++k) {
        is_right =
            is_right && clarity[row->photon[k]] ==
                            (row->clarity ? row->clarity[k] : MURK_CLEAR);
    }
    for (size_t i = 0; i < photons; ++i) {
        seen += clarity[i] > 0;
    }
    free(slot);
    free(entry);
    free(by_slot);
    free(clarity);
    return is_right && seen == row->seen;
}

/* The number of candidates whose row with the known entries differs from the
 * row that is computed. *counts_differ: whether the counts do. */
static size_t count_different(const step *s, murk_sight *sight,
                              const murk_known_rows *known, bool *counts_differ)
{
    const murk_poses *poses = s->plan.poses;
    const size_t photons = murk_sight_photons(sight);
    uint32_t *photon = malloc(photons * sizeof *photon);
    uint16_t *clarity = malloc(photons * sizeof *clarity);
    const bool is_binary = murk_plan_at_least(s->stage->scene) > 0;
    size_t different = 0;
    CHECK(photon && clarity);
    *counts_differ = false;
    for (size_t j = 0; j < poses->count; ++j) {
        murk_sparse_row row;
        /* The row as it is computed, and as it is taken over in part. */
        murk_sight_row(sight, 0, &poses->pose[j], &row);
        const murk_row_counts counts = murk_sight_counts(sight, 0);
        const size_t seen = row.seen;
        memcpy(photon, row.photon, seen * sizeof *photon);
        for (size_t k = 0; k < seen; ++k) {
            clarity[k] = row.clarity ? row.clarity[k] : MURK_CLEAR;
        }
        if (!known->get(known->context, 0, j, &row)) {
            continue;
        }
        const murk_row_counts known_counts = murk_sight_counts(sight, 0);
        CHECK(is_binary ||
              has_right_differences(known->context, photons, j, &row));
        different += !same_rows(&row, photon, clarity, seen, is_binary);
        *counts_differ |= memcmp(&counts, &known_counts, sizeof counts) != 0;
    }
    free(photon);
    free(clarity);
    return different;
}

/* Rows without one of the boxes: counts the boxes, and those without which no
 * row differs. */
static void leave_out_each(const step *s, murk_sight *sight,
                           murk_earlier_rows *rows)
{
    murk_box_list *changed = &rows->changes.changed;
    const murk_box_list all = *changed;
    bool ignored;
    for (size_t i = 0; i < all.n; ++i) {
        *changed = all;
        changed->box[i] = changed->box[--changed->n];
        ++total.left_out;
        total.missed += count_different(s, sight, &rows->known, &ignored) == 0;
    }
    *changed = all;
}

static void check_rows(const step *s, const murk_earlier_plan *earlier,
                       size_t setting)
{
    const bool is_clear = settings[setting].is_clear;
    murk_earlier_rows rows;
    murk_sight *sight = NULL;
    murk_error err = {0};
    bool counts_differ;
    CHECK(murk_plan_sight(&sight, s->stage, s->traced, THREADS, &err) ==
          MURK_OK);
    CHECK(murk_earlier_rows_create(&rows, earlier, s->plan.poses, s->stage,
                                   sight, murk_plan_sight_again,
                                   &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    ++total.steps;
    if (rows.known.get) {
        const murk_sight_work before = murk_sight_work_of(sight);
        CHECK(count_different(s, sight, &rows.known, &counts_differ) == 0);
        CHECK(!counts_differ);
        const murk_sight_work after = murk_sight_work_of(sight);
        ++total.taken;
        total.patched += rows.known.patches.matrix != NULL;
        total.is_taken[setting] = true;
        total.lost += after.blocked_by_interfaces + after.totally_reflected;
        total.photons += murk_sight_photons(sight);
        for (size_t i = 0; i < murk_sight_photons(sight); ++i) {
            total.photons_new += rows.same[i] == UINT32_MAX;
        }
        const uint64_t sightlines =
                           (after.shadow_rays - before.shadow_rays) / 2,
                       reused = after.reused - before.reused;
        total.sightlines += sightlines;
        total.reused += reused;
        if (is_clear && 10 * reused > sightlines) { /* else all photons are new
                                                     */
            leave_out_each(s, sight, &rows);
        }
    }
    murk_earlier_rows_release(&rows);
    murk_sight_destroy(sight);
}

/* clarity[photons]: the row of a candidate in a matrix. */
static void list_clarities(uint16_t *clarity, size_t photons,
                           const murk_matrix *matrix, size_t candidate)
{
    const size_t slots = murk_matrix_slots(matrix);
    uint32_t *slot = calloc(slots + 1, sizeof *slot);
    uint16_t *entry = calloc(slots + 1, sizeof *entry),
             *by_slot = calloc(slots + 1, sizeof *by_slot);
    size_t n;
    CHECK(murk_matrix_list(slot, entry, &n, matrix, candidate));
    for (size_t k = 0; k < n; ++k) {
        by_slot[slot[k]] = entry[k];
    }
    for (size_t i = 0; i < photons; ++i) {
        clarity[i] = by_slot[murk_matrix_slot(matrix, (uint32_t)i)];
    }
    free(slot);
    free(entry);
    free(by_slot);
}

/* The stored rows, of which some were patched, are those of a run of its own.
 */
static void check_matrix(const step *s, const step *alone)
{
    murk_error err = {0};
    murk_sight *sight =
        NULL; /* which knows the number of photons, or targets */
    CHECK(murk_plan_sight_again(&sight, s->stage, s->traced, THREADS, &err) ==
          MURK_OK);
    const size_t photons = murk_sight_photons(sight);
    murk_sight_destroy(sight);
    uint16_t *ours = calloc(photons + 1, sizeof *ours),
             *theirs = calloc(photons + 1, sizeof *theirs);
    CHECK(alone->plan.matrix);
    CHECK(murk_matrix_pairs(s->plan.matrix) ==
          murk_matrix_pairs(alone->plan.matrix));
    for (size_t j = 0; j < s->plan.poses->count; ++j) {
        list_clarities(ours, photons, s->plan.matrix, j);
        list_clarities(theirs, photons, alone->plan.matrix, j);
        CHECK(memcmp(ours, theirs, photons * sizeof *ours) == 0);
    }
    free(ours);
    free(theirs);
}

/* ---- sequences ---- */

static uint32_t draw(uint32_t sequence, uint32_t number, uint32_t below)
{
    uint32_t word[4];
    murk_random_words(20, 0, sequence, number, 0, word);
    return murk_random_below(word[0], below);
}

static size_t values_of(size_t key)
{
    size_t n = 0;
    while (n < 4 && keys[key].value[n]) {
        ++n;
    }
    return n;
}

/* Changes none, one to three, or nearly all of the keys; keys that change every
 * sightline less often. */
static void change(size_t choice[KEYS], uint32_t sequence, uint32_t number)
{
    const uint32_t base = 1000 * number, kind = draw(sequence, base, 12);
    const uint32_t n = kind == 0 ? 0 : kind == 1 ? 30 : 1 + kind % 3;
    for (uint32_t i = 0; i < n; ++i) {
        const size_t key = draw(sequence, base + 10 + 2 * i, KEYS);
        if (keys[key].is_local || kind == 1) {
            choice[key] =
                draw(sequence, base + 11 + 2 * i, (uint32_t)values_of(key));
        }
    }
}

/* Every fourth sequence has the first setting, the others take turns. */
static size_t setting_of(uint32_t sequence)
{
    return sequence % 4 ? (sequence - sequence / 4 - 1) % SETTINGS : 0;
}

static void run_sequence(uint32_t sequence)
{
    enum { STEPS = 3 };
    size_t choice[KEYS] = {0};
    const size_t setting = setting_of(sequence);
    step last;
    step_make(&last, choice, setting, NULL, false);
    step_choose(&last);
    for (uint32_t i = 1; i <= STEPS; ++i) {
        step next;
        const murk_earlier_plan earlier = {.stage = last.stage,
                                           .traced = last.traced,
                                           .poses = last.plan.poses,
                                           .tested = last.plan.tested,
                                           .matrix = &last.plan.matrix,
                                           .held_out = &last.passed};
        size_t before[KEYS];
        memcpy(before, choice, sizeof before);
        change(choice, sequence, i);
        step_make(&next, choice, setting, &earlier,
                  before[FIRST_LAMP] == choice[FIRST_LAMP] &&
                      before[FIRST_LAMP + 1] == choice[FIRST_LAMP + 1]);
        check_rows(&next, &earlier, setting);
        /* The whole plan, with and without the earlier one. */
        step alone = {.stage = next.stage, .traced = next.traced};
        prepare(&alone, NULL);
        step_choose(&next);
        step_choose(&alone);
        const murk_place_result *p = &next.plan.place, *q = &alone.plan.place;
        CHECK(p->value == q->value && p->upper == q->upper &&
              p->count == q->count && p->evaluations == q->evaluations &&
              next.plan.shadow_rays == alone.plan.shadow_rays &&
              next.plan.blocked_by_interfaces ==
                  alone.plan.blocked_by_interfaces &&
              next.plan.totally_reflected == alone.plan.totally_reflected);
        CHECK(memcmp(p->sensor, q->sensor, p->count * sizeof *p->sensor) == 0);
        CHECK(!last.plan.matrix); /* it is used up */
        check_matrix(&next, &alone);
        murk_plan_result_release(&alone.plan);
        step_release(&last);
        last = next;
    }
    step_release(&last);
}

int main(int argc, char **argv)
{
    const long sequences = argc > 1 ? atol(argv[1]) : 50;
    /* Stages are made while others, with the threads of their ray devices, are
     * there: a fork could wait for a lock that one of them holds. */
    murk_host_now()->importing = MURK_IMPORT_IN_PROCESS;
    CHECK(mkdtemp(folder));
    snprintf(scene_text, sizeof scene_text, scene_form, folder);
    write_frames();
    write_mesh();
    for (long i = 0; i < sequences; ++i) {
        run_sequence((uint32_t)i);
    }
    remove_files();
    printf("%zu of %zu lights were updated, with %.1f %% of all photons; of "
           "%zu updates without paths %zu are not noticed\n",
           total.updated, total.steps,
           100 * (double)total.photons_reused / (double)total.photons_emitted,
           total.lights, total.lights_missed);
    printf("%zu of %zu steps took rows over, %zu patched them; %.1f %% of the "
           "photons are new, "
           "%.1f %% of the sightlines reused; %zu of %zu boxes left out are "
           "not noticed\n",
           total.taken, total.steps, total.patched,
           100 * (double)total.photons_new / (double)total.photons,
           100 * (double)total.reused / (double)total.sightlines, total.missed,
           total.left_out);
    /* Each setting takes rows over, those with interfaces lose sightlines to
     * them, and most steps take over most of their rows, and some of their
     * photons. */
    CHECK(SETTINGS <= sizeof total.is_taken / sizeof *total.is_taken);
    for (uint32_t i = 0; i < sequences; ++i) {
        CHECK(total.is_taken[setting_of(i)]);
    }
    CHECK(total.lost > 0);
    CHECK(3 * total.updated > total.steps);
    CHECK(20 * total.lights_missed <= total.lights);
    CHECK(3 * total.taken > 2 * total.steps);
    CHECK(4 * total.patched > total.steps);
    CHECK(2 * total.reused > total.sightlines);
    CHECK(2 * total.left_out > (size_t)sequences &&
          20 * total.missed <= total.left_out);
    return check_done();
}
