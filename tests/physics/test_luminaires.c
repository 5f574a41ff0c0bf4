/* Illuminance by a luminaire on planes, by the whole chain from a scene with a
 * photometric file, against the point-by-point formula E = I cos / d^2 (the
 * inverse-square cosine law; IES Lighting Handbook, 10th ed., 2011, ch. 10)
 * with the intensity of the table, at five distances; with the luminaire turned
 * and rolled; near a luminaire with a luminous area, where every point of the
 * area counts by the same formula; and near one with luminous sides, whose
 * faces count by their radiance, the intensity divided by the projected area of
 * the box.
 *
 * The expected number of photons in a bin has a binomial distribution, whose
 * sigma is known. The checks share a 1e-6 chance of a false alarm (Sidak); the
 * seed is fixed. A wrong factor of the intensity is shown to fail at each
 * distance. */
#include "base/stats.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "stage_text.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

#define RAD     (MURK_PI / 180)
#define PHOTONS 400000
#define CHECKS  40

/* ---- the lamp, without any symmetry ---- */

enum { GAMMAS = 6, PLANES = 5 };
static const double gamma_deg[GAMMAS] = {0, 15, 35, 60, 90, 120},
                    c_deg[PLANES] = {0, 60, 150, 240, 360},
                    candela[PLANES][GAMMAS] = {{900, 1400, 800, 250, 40, 5},
                                               {900, 1000, 300, 90, 10, 0},
                                               {900, 500, 400, 260, 60, 10},
                                               {900, 1200, 1100, 500, 20, 9},
                                               {900, 1400, 800, 250, 40, 5}};

static void write_lamp(const char *path, const char *high)
{
    char text[2000];
    int n = snprintf(text, sizeof text,
                     "IES:LM-63-2019\n[TEST] none\n[LUMINAIRE] Made up\n"
                     "TILT=NONE\n1 5000 2 %d %d 1 2 1.2 0.8 %s\n0.5 1.1 60\n",
                     GAMMAS, PLANES, high);
    for (int i = 0; i < GAMMAS; ++i) {
        n += snprintf(text + n, sizeof text - (size_t)n, "%g ", gamma_deg[i]);
    }
    for (int i = 0; i < PLANES; ++i) {
        n += snprintf(text + n, sizeof text - (size_t)n, "\n%g", c_deg[i]);
    }
    for (int p = 0; p < PLANES; ++p) {
        for (int i = 0; i < GAMMAS; ++i) {
            n += snprintf(text + n, sizeof text - (size_t)n, "%c%g",
                          i ? ' ' : '\n', candela[p][i]);
        }
    }
    write_text(path, text);
}

/* The intensity in a direction of the lamp: bilinear, by a plain search. */
static double intensity(murk_vec3 d)
{
    const double g = acos(-d.z / murk_length(d)) / RAD;
    double c = atan2(d.y, d.x) / RAD;
    c += c < 0 ? 360 : 0;
    int i = 0, p = 0;
    while (i + 2 < GAMMAS && g > gamma_deg[i + 1]) {
        ++i;
    }
    while (p + 2 < PLANES && c > c_deg[p + 1]) {
        ++p;
    }
    const double s = (g - gamma_deg[i]) / (gamma_deg[i + 1] - gamma_deg[i]);
    const double t = (c - c_deg[p]) / (c_deg[p + 1] - c_deg[p]);
    const double low = (1 - t) * candela[p][i] + t * candela[p + 1][i];
    const double high = (1 - t) * candela[p][i + 1] + t * candela[p + 1][i + 1];
    return g > gamma_deg[GAMMAS - 1] ? 0 : (1 - s) * low + s * high;
}

/* The flux of the table, by sums over fine steps. */
static double lumens_of_table(void)
{
    enum { STEPS = 1200 };
    double sum = 0;
    for (int i = 0; i < STEPS; ++i) {
        const double g = MURK_PI * (i + 0.5) / STEPS;
        for (int k = 0; k < STEPS; ++k) {
            const double c = 2 * MURK_PI * (k + 0.5) / STEPS;
            sum += sin(g) * intensity(murk_vec(sin(g) * cos(c), sin(g) * sin(c),
                                               -cos(g)));
        }
    }
    return sum * 2 * MURK_PI * MURK_PI / STEPS / STEPS;
}

/* ---- the scene ---- */

#define PLACE        \
    {                \
        0.5, -0.3, 9 \
    }
#define BINS   12
#define SIDE   12.0 /* m: bins of 1 m */
#define TILT   30.0 /* degrees, of the turned luminaire */
#define ROLL   40.0
#define N_SETS 4
#define BOX    3 /* the setting with luminous sides */

/* Heights of the planes: distances 1, 2, 4, 6 and 8.5 m. */
static const double height[] = {8, 7, 5, 3, 0.5};
/* The factor of the intensity that each plane is shown to refuse. */
static const double wrong[] = {1.05, 1.05, 1.1, 1.1, 1.15};
enum { HEIGHTS = sizeof height / sizeof *height };

/* A lamp that points straight down; one that is turned about x, so that it
 * points to (0, sin, -cos), and rolled; one with the area of the file; one with
 * the box of another file. */
static const char *const settings[N_SETS] = {
    "",
    ", aim: [0, 0.5, -0.86602540378443865], roll_deg: 40",
    ", size: file",
    ", size: file",
};

/* The box: length 0.8 m along C = 0, width 1.2 m along C = 90 degrees. */
static const double box_m[3] = {0.8, 1.2, 0.9};
#define BOX_HIGH "0.9"

/* A direction of the world in the coordinates of the lamp of a setting. */
static murk_vec3 in_lamp(int setting, murk_vec3 d)
{
    if (setting != 1) {
        return d;
    }
    const double c = cos(TILT * RAD), s = sin(TILT * RAD);
    const murk_vec3 back = {d.x, c * d.y + s * d.z, c * d.z - s * d.y};
    const double a = cos(ROLL * RAD), b = sin(ROLL * RAD);
    return murk_vec(a * back.x + b * back.y, a * back.y - b * back.x, back.z);
}

/* E of the box at a place, given from the center of the box, times the flux:
 * over all faces that the place sees, radiance times both cosines by d^2. */
static double by_box(murk_vec3 place)
{
    enum { POINTS = 12 };
    const double at[3] = {place.x, place.y, place.z};
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        if (fabs(at[k]) <= box_m[k] / 2) {
            continue;
        }
        /* Points of the face that the place sees. */
        for (int p = 0; p < POINTS * POINTS; ++p) {
            double to[3];
            to[k] = at[k] - copysign(box_m[k] / 2, at[k]);
            to[i] = at[i] - box_m[i] * ((p % POINTS + 0.5) / POINTS - 0.5);
            to[j] = at[j] - box_m[j] * ((p / POINTS + 0.5) / POINTS - 0.5);
            const double d =
                sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
            const double shown = (box_m[1] * box_m[2] * fabs(to[0]) +
                                  box_m[0] * box_m[2] * fabs(to[1]) +
                                  box_m[0] * box_m[1] * fabs(to[2])) /
                                 d;
            const double area = box_m[i] * box_m[j] / POINTS / POINTS;
            sum += intensity(murk_vec(to[0], to[1], to[2])) / shown * area *
                   fabs(to[k]) / d * -to[2] / d / (d * d);
        }
    }
    return sum;
}

/* The share of the flux through one bin: E = I cos / d^2, averaged over the bin
 * and over the luminous area. */
static double share_of(int setting, double z, size_t bin_i, size_t bin_j,
                       double lumens)
{
    const murk_vec3 place = PLACE;
    const int points = setting == 2 ? 12 : 1, steps = setting >= 2 ? 20 : 100;
    double sum = 0;
    for (int k = 0; k < steps * steps; ++k) {
        const double x = (double)bin_i + (k % steps + 0.5) / steps - SIDE / 2;
        const double y = (double)bin_j + (k / steps + 0.5) / steps - SIDE / 2;
        if (setting == BOX) {
            sum += by_box(murk_vec(x - place.x, y - place.y, z - place.z));
            continue;
        }
        for (int p = 0; p < points * points; ++p) {
            /* Length 0.8 m along C = 0, width 1.2 m along C = 90 degrees. */
            const double u =
                points == 1 ? 0 : (p % points + 0.5) / points - 0.5;
            const double v =
                points == 1 ? 0 : (p / points + 0.5) / points - 0.5;
            const murk_vec3 to = {x - place.x - 0.8 * u, y - place.y - 1.2 * v,
                                  z - place.z};
            const double d = murk_length(to);
            sum += intensity(in_lamp(setting, to)) * -to.z / (d * d * d);
        }
    }
    return sum / (steps * steps * points * points) / lumens;
}

static murk_stage *stage_of(const char *lamp, int setting)
{
    char text[2000];
    int n = snprintf(text, sizeof text,
                     "murk: 1\nbands_nm: [555]\nunits: photometric\n"
                     "domain: {min_m: [-6, -6, 0], max_m: [6, 6, 10]}\n"
                     "lights: [{type: luminaire, file: %s, position_m: [0.5, "
                     "-0.3, 9]%s}]\n"
                     "photons: {emit: %d, maps: none}\ntallies:\n",
                     lamp, settings[setting], PHOTONS);
    for (int i = 0; i < HEIGHTS; ++i) {
        n += snprintf(text + n, sizeof text - (size_t)n,
                      "  - {name: p%d, type: plane, point_m: [0, 0, %g], "
                      "normal: [0, 0, -1], bins: [%d, %d]}\n",
                      i, height[i], BINS, BINS);
    }
    return stage_text_create(text, NULL);
}

/* Checks the bins of all planes that hold enough light. */
static void check_setting(const char *lamp, int setting, double lumens)
{
    const double limit = murk_sidak_limit(1e-6, CHECKS);
    murk_stage *stage = stage_of(lamp, setting);
    murk_traced *traced = NULL;
    murk_error err = {0};
    CHECK(stage && !murk_lightmap_trace(&traced, stage, 0, 2, &err));
    if (!traced) {
        printf("%s: %s\n", err.where, err.text);
        return;
    }
    /* The power: 2 times 0.5 times the integral, at 683 lm/W. */
    const double power_w = murk_sources_power_w(stage->lights);
    CHECK_NEAR(power_w * 683 / lumens, 1, 1e-5);
    int checked = 0;
    for (size_t plane = 0; plane < HEIGHTS; ++plane) {
        double worst_wrong = 0;
        /* The bin below the lamp, and one aside. */
        for (size_t k = 0; k < 2; ++k) {
            const size_t i = k ? 5 : 6, j = k ? 7 : 5;
            const murk_estimate got =
                murk_tallies_read(traced->tallies, plane, 0, i + BINS * j,
                                  traced->ledger->emitted, traced->packet_w);
            const double p = share_of(setting, height[plane], i, j, lumens);
            const double sigma = sqrt(p * (1 - p) / PHOTONS);
            const double off = sigmas_off(got.value / power_w, p, sigma);
            CHECK_WITHIN(limit, got.value / power_w, p, sigma);
            worst_wrong =
                fmax(worst_wrong,
                     sigmas_off(got.value / power_w, wrong[plane] * p, sigma));
            if (setting == BOX && plane == 0 && k == 0) { /* teeth */
                const double flat = share_of(2, height[plane], i, j, lumens);
                CHECK(sigmas_off(got.value / power_w, flat, sigma) > limit);
            }
            printf("setting %d, %.1f m, bin %zu %zu: %.4f lx, formula %.4f lx, "
                   "%.1f sigma\n",
                   setting, 9 - height[plane], i, j, got.value * 683,
                   p * lumens, off);
            ++checked;
        }
        printf("setting %d, factor %.2f: %.1f sigma, limit %.1f\n", setting,
               wrong[plane], worst_wrong, limit);
        CHECK(worst_wrong > limit); /* teeth */
    }
    CHECK(checked == 2 * HEIGHTS);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
}

/* The sums of all tallies are the same in every bit for 1, 2 and 5 threads. */
static void check_threads(const char *lamp)
{
    static const unsigned threads[] = {1, 2, 5};
    murk_stage *stage = stage_of(lamp, 2);
    uint64_t *sums[3] = {NULL};
    size_t words = 0;
    /* Trace with each number of threads, then compare. */
    for (int i = 0; i < 3 && stage; ++i) {
        murk_traced *traced = NULL;
        murk_error err = {0};
        CHECK(!murk_lightmap_trace(&traced, stage, 0, threads[i], &err));
        if (traced) {
            words = murk_tallies_words(traced->tallies);
            sums[i] = malloc(words * sizeof *sums[i]);
            murk_tallies_read_sums(traced->tallies, sums[i]);
        }
        murk_traced_destroy(traced);
    }
    CHECK(words > 0);
    for (int i = 1; i < 3 && sums[0] && sums[i]; ++i) {
        CHECK(memcmp(sums[0], sums[i], words * sizeof *sums[0]) == 0);
    }
    for (int i = 0; i < 3; ++i) {
        free(sums[i]);
    }
    stage_text_destroy(stage);
}

int main(void)
{
    char lamp[] = "/tmp/murk-lamp-XXXXXX", box[] = "/tmp/murk-lamp-XXXXXX";
    const int fd[] = {mkstemp(lamp), mkstemp(box)};
    CHECK(fd[0] >= 0 && fd[1] >= 0);
    write_lamp(lamp, "0");
    write_lamp(box, BOX_HIGH);
    const double lumens = lumens_of_table();
    for (int i = 0; i < N_SETS; ++i) {
        check_setting(i == BOX ? box : lamp, i, lumens);
    }
    check_threads(lamp);
    close(fd[0]);
    close(fd[1]);
    unlink(lamp);
    unlink(box);
    return check_done();
}
