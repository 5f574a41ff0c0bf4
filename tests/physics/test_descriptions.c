/* A region's light does not depend on how the region is described: fog below a
 * level, said as a box, a half space, a closed mesh, a grid, layers, two
 * halves that overlap or adjoin, all of space less what is clear, a turned box,
 * a box with an index of 1, by march and by delta tracking.
 *
 * Each description has its own seed; what it gives is compared with what the
 * box gives, in the errors of both: power absorbed, power that comes up, and
 * the fluence rate in a ball that lies in the fog's upper side. All z-tests
 * share a 1e-6 chance of a false alarm (Sidak). Teeth: fog 5 cm higher, and fog
 * 1/8 thinner, must be refused. */
#include "base/log.h"
#include "base/stats.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "medium/grid_write.h"
#include "stage_text.h"

#include <inttypes.h>
#include <stdlib.h>
#include <unistd.h>

#define PHOTONS 200000

/* %s: the grid's file, media and regions of one description, its flight. */
static const char scene_text[] =
    "murk: 1\n"
    "seed: %" PRIu32 "\n"
    "domain: {min_m: [-2, -2, -1.5], max_m: [2, 2, 1.5]}\n"
    "media:\n"
    "  fog: {extinction_per_m: 1.2, albedo: 0.8, phase: {hg: 0.4}}\n"
    "  half: {extinction_per_m: 0.6, albedo: 0.8, phase: {hg: 0.4}}\n"
    "  thin: {extinction_per_m: 1.05, albedo: 0.8, phase: {hg: 0.4}}\n"
    "  clear: {extinction_per_m: 0, albedo: 0}\n"
    "  grid: {vdb: %s, extinction_per_m: 2.4, albedo: 0.8, phase: {hg: 0.4}}\n"
    "  layers: {profile: {z_m: [-2, -1, 0], extinction_per_m: [1.2, 1.2, 1.2]},"
    " albedo: 0.8, phase: {hg: 0.4}}\n"
    "regions: %s\n"
    "flight: %s\n"
    "lights:\n"
    "  - {type: point, position_m: [0.3, 0.2, 0.7], power_w: 2}\n"
    "  - {type: beam, origin_m: [-1, 0, 1.4], direction: [0.5, 0.1, -1],"
    " power_w: 1}\n"
    "photons: {emit: %d, maps: none}\n"
    "tallies:\n"
    "  - {name: up, type: plane, point_m: [0, 0, 1.45], normal: [0, 0, 1]}\n"
    "  - {name: ball, type: sphere, center_m: [0.1, 0, 0], radius_m: 0.5}\n";

typedef struct description {
    const char *name;
    const char *regions; /* "mesh": the mesh that is written beside the grid */
    const char *flight;
} description;

#define BELOW_AS_BOX "box: {min_m: [-3, -3, -2], max_m: [3, 3, 0]}"

static const description box = {"box", "[{medium: fog, " BELOW_AS_BOX "}]",
                                "march"};

static const description others[] = {
    {"half space", "[{medium: fog, below_z_m: 0}]", "march"},
    {"mesh", "mesh", "march"},
    {"grid", "[{medium: grid}]", "march"},
    {"layers", "[{medium: layers}]", "march"},
    {"halves that overlap",
     "[{medium: half, " BELOW_AS_BOX "}, {medium: half, below_z_m: 0}]",
     "march"},
    {"halves that adjoin",
     "[{medium: fog, box: {min_m: [-3, -3, -2], max_m: [0.2, 3, 0]}},"
     " {medium: fog, box: {min_m: [0.2, -3, -2], max_m: [3, 3, 0]}}]",
     "march"},
    {"all but what is clear",
     "[{medium: fog}, {medium: clear, replace: true,"
     " box: {min_m: [-3, -3, 0], max_m: [3, 3, 2]}}]",
     "march"},
    {"turned box",
     "[{medium: fog, box: {min_m: [-1.2, -3, -1.5], max_m: [1.2, -1, 1.5]},"
     " rotate_deg: [90, 0, 90], scale: 2, translate_m: [0, 0, 2]}]",
     "march"},
    {"box of index 1", "[{medium: fog, ior: 1, " BELOW_AS_BOX "}]", "march"},
    {"half space of index 1", "[{medium: fog, below_z_m: 0, ior: 1}]", "march"},
    {"half space, by delta", "[{medium: fog, below_z_m: 0}]", "delta"},
    {"grid, by delta", "[{medium: grid}]", "delta"},
};

#define OTHERS     (sizeof others / sizeof others[0])
#define QUANTITIES 3
#define Z_TESTS    (OTHERS * QUANTITIES)

static char folder[] = "/tmp/murk_descriptions_XXXXXX";
static char grid_path[64], mesh_path[64];

/* The same as a closed box of triangles. */
static bool write_mesh(const char *path)
{
    static const int corner[12][3] = {
        {1, 3, 4}, {1, 4, 2}, {5, 6, 8}, {5, 8, 7}, {1, 2, 6}, {1, 6, 5},
        {3, 7, 8}, {3, 8, 4}, {1, 5, 7}, {1, 7, 3}, {2, 4, 8}, {2, 8, 6}};
    FILE *file = fopen(path, "w");
    for (int i = 0; file && i < 8; ++i) {
        fprintf(file, "v %d %d %d\n", i & 1 ? 3 : -3, i & 2 ? 3 : -3,
                i & 4 ? 0 : -2);
    }
    for (int i = 0; file && i < 12; ++i) {
        fprintf(file, "f %d %d %d\n", corner[i][0], corner[i][1], corner[i][2]);
    }
    return file && !fclose(file);
}

/* Density .5 in 12 x 12 x 4 cubes of .5 m below z = 0. */
static bool write_grid(const char *path)
{
    static float value[12 * 12 * 4];
    for (size_t i = 0; i < sizeof value / sizeof *value; ++i) {
        value[i] = .5F;
    }
    const murk_grid_field field = {.name = "density", .value = value};
    const murk_affine place =
        murk_affine_place(murk_vec(0, 0, 0), .5, murk_vec(-2.75, -2.75, -1.75));
    murk_error err = {0};
    return !murk_grid_write(path, &field, 1, (size_t[3]){12, 12, 4}, &place,
                            &err);
}

typedef struct light {
    murk_estimate quantity[QUANTITIES];
} light;

static light lit(const description *d, uint32_t seed, int photons)
{
    /* Complete the scene with the regions, the free flight and the photons
     * of the description. */
    light out = {{{NAN, NAN}, {NAN, NAN}, {NAN, NAN}}};
    char text[4096], as_mesh[128];
    snprintf(as_mesh, sizeof as_mesh, "[{medium: fog, mesh: %s}]", mesh_path);
    const bool is_mesh = strcmp(d->regions, "mesh") == 0;
    snprintf(text, sizeof text, scene_text, seed, grid_path,
             is_mesh ? as_mesh : d->regions, d->flight, photons);
    /* Trace the scene. */
    murk_error err = {0};
    murk_traced *traced = NULL;
    murk_stage *stage = stage_text_create(text, NULL);
    if (!stage || murk_lightmap_trace(&traced, stage, 0, 1, &err)) {
        printf("%s: %s: %s\n", d->name, err.where, err.text);
        stage_text_destroy(stage);
        return out;
    }
    /* The absorbed share is binomial; the two tallies state their own
     * errors. */
    const murk_ledger *ledger = traced->ledger;
    double absorbed = 0;
    for (size_t c = 0; c < ledger->channels; ++c) {
        absorbed += (double)murk_tally_read(&ledger->absorbed_media[c]) /
                    (double)MURK_PACKET / photons;
    }
    out.quantity[0] =
        (murk_estimate){absorbed, sqrt(absorbed * (1 - absorbed) / photons)};
    for (size_t k = 0; k < 2; ++k) {
        out.quantity[1 + k] = murk_tallies_read(
            traced->tallies, k, 0, 0, ledger->emitted, traced->packet_w);
    }
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return out;
}

static double sigmas_between(murk_estimate a, murk_estimate b)
{
    return sigmas_off(a.value, b.value,
                      hypot(a.standard_error, b.standard_error));
}

/* The quantity that is farthest off. */
static double farthest(const light *a, const light *b)
{
    double max = 0;
    for (size_t i = 0; i < QUANTITIES; ++i) {
        max = fmax(max, sigmas_between(a->quantity[i], b->quantity[i]));
    }
    return max;
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    murk_warn_to(NULL); /* of what the domain cuts off */
    CHECK(mkdtemp(folder) != NULL);
    snprintf(grid_path, sizeof grid_path, "%s/fog.vdb", folder);
    snprintf(mesh_path, sizeof mesh_path, "%s/fog.obj", folder);
    CHECK(write_grid(grid_path));
    CHECK(write_mesh(mesh_path));
    const light want = lit(&box, 100 * seed, 4 * PHOTONS);
    for (uint32_t i = 0; i < OTHERS; ++i) {
        const light got = lit(&others[i], 100 * seed + 1 + i, PHOTONS);
        const double off = farthest(&got, &want);
        printf("%s: %.2f sigma off\n", others[i].name, off);
        CHECK(off <= limit);
    }
    const description higher = {"higher", "[{medium: fog, below_z_m: 0.05}]",
                                "march"};
    const description thinner = {"thinner", "[{medium: thin, below_z_m: 0}]",
                                 "march"};
    const light high = lit(&higher, 100 * seed + 50, PHOTONS);
    const light thin = lit(&thinner, 100 * seed + 51, PHOTONS);
    CHECK(farthest(&high, &want) > limit);
    CHECK(farthest(&thin, &want) > limit);
    unlink(grid_path);
    unlink(mesh_path);
    rmdir(folder);
    return check_done();
}
