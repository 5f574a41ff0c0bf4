/* Broken phase tables: cut off anywhere, with flipped bytes, with numbers at
 * the ends of what doubles hold. Whatever they are: a phase function that is
 * sane, or one line of error, within bounded time. Deterministic. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "../unit/scene/scene_files.h"
#include "base/rng.h"
#include "world/phases.h"

#include <time.h>

#define SLOWEST_S 2.0 /* of CPU, any one table; a fifth of the bound */

static const char SCENE[] =
    "murk: 1\nmedia: {sea: {extinction_per_m: 1, albedo: 1,\n"
    "  phase: {table: p.csv}}}\n"
    "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n";

static const char GOOD[] = "angle_deg,phase_per_sr\n"
                           "0.1,1766.61\n0.5,218.839\n1,71.6082\n10,1.15257\n"
                           "90,0.00429232\n140,0\n175,0.003\n180,0.00315366\n";

static murk_scene_desc *scene;
static int read_well;

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void check_sane(const murk_phase *phase)
{
    const double mean = murk_phase_mean_cosine(phase);
    double before = 1;
    CHECK(mean >= -1 && mean <= 1);
    for (int i = 1; i < 64; ++i) {
        const double mu = murk_phase_sample(phase, i / 64.);
        const double density = murk_phase_density(phase, mu);
        CHECK(mu >= -1 && mu <= before);
        CHECK(density >= 0 && isfinite(density));
        before = mu;
    }
}

/* One line of error that names the file, or a sane phase function. */
static void try_table(const char *text, size_t size)
{
    murk_phases *phases = NULL;
    murk_error err = {0};
    write_bytes("p.csv", text, size);
    const double start = seconds();
    const murk_status status = murk_phases_create(&phases, scene, NULL, &err);
    CHECK(seconds() - start < SLOWEST_S);
    CHECK((status == MURK_OK) == (phases != NULL));
    if (phases) {
        check_sane(&phases->medium[0][0]);
        ++read_well;
    } else {
        CHECK(strncmp(err.where, "p.csv", 5) == 0);
        CHECK(err.text[0] != '\0' && strchr(err.text, '\n') == NULL);
    }
    murk_phases_destroy(phases);
}

static void test_cut_off_anywhere(void)
{
    for (size_t size = 0; size <= strlen(GOOD); ++size) {
        try_table(GOOD, size);
    }
}

static void test_flipped_bytes(void)
{
    char text[sizeof GOOD];
    for (uint32_t k = 0; k < 1500; ++k) {
        memcpy(text, GOOD, sizeof GOOD);
        for (uint32_t flip = 0; flip <= k % 3; ++flip) {
            const murk_random4 r = murk_random(1, MURK_TEST, k, flip, 0);
            const size_t at = (size_t)(r.u[0] * (double)strlen(GOOD));
            text[at] = k % 2 ? "0123456789.,-+e\n"[(int)(r.u[1] * 16)]
                             : (char)(r.u[1] * 256);
        }
        try_table(text, strlen(GOOD));
    }
}

static void test_ends_of_the_range(void)
{
    static const char *const angles[] = {"0", "5e-324", "1e-300", "1e-6",
                                         "9.999999"};
    static const char *const values[] = {"0",    "1e-30", "1e-31", "1e30",
                                         "1e31", "1e308", "1"};
    for (int i = 0; i < 5 * 7 * 7 * 7; ++i) {
        char text[300];
        snprintf(text, sizeof text,
                 "angle_deg,phase_per_sr\n%s,%s\n10,%s\n179.99999999999,%s\n",
                 angles[i % 5], values[i / 5 % 7], values[i / 35 % 7],
                 values[i / 245]);
        try_table(text, strlen(text));
    }
}

/* As many rows as there may be nodes, as steep as they may be. */
static void test_too_much(void)
{
    enum { ROWS = 60000, LINE = 32 };
    char *text = malloc(ROWS * LINE);
    size_t size = (size_t)sprintf(text, "angle_deg,phase_per_sr\n");
    for (int i = 0; i < ROWS; ++i) {
        size += (size_t)sprintf(text + size, "%.9g,%s\n", 180. * (i + 1) / ROWS,
                                i % 2 ? "1e30" : "1e-30");
    }
    const int before = read_well;
    try_table(text, size);
    CHECK(read_well == before);
    free(text);
}

int main(void)
{
    murk_error err;
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    CHECK(scene_of(&scene, SCENE, NULL, 0, &err) == MURK_OK);
    if (scene) {
        try_table(GOOD, strlen(GOOD));
        CHECK(read_well == 1);
        test_cut_off_anywhere();
        test_flipped_bytes();
        test_ends_of_the_range();
        test_too_much();
        CHECK(read_well > 200); /* both ways were taken */
    }
    murk_scene_desc_destroy(scene);
    folder_leave((const char *const[]){"fog.yaml", "p.csv", NULL});
    return check_done();
}
