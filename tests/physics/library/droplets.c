/* Presets of fog, haze and cloud droplets against an independent Lorenz-Mie
 * computation: extinction, albedo and mean cosine by wavelength. */
#include "library/library.h"
#include "medium/phase_table.h"
#include "scene/presets.h"

#include <math.h>
#include <stdio.h>

#define PI 3.141592653589793

/* From shared/physics/fog_cloud_mie.csv: an independent Lorenz-Mie code, itself
 * checked against Bohren & Huffman's and Wiscombe's values. */
typedef struct row {
    const char *preset;
    double shape[3], droplets; /* where the preset is cloud/droplets */
    double nm, extinction_per_km, albedo, mean_cosine;
} row;

static const row ROWS[] = {
    {"cloud/c1", {0}, 0, 550, 16.6374, .9999997, .85365},
    {"fog/advection-heavy", {0}, 0, 550, 28.7396, .9999992, .87248},
    {"fog/advection", {0}, 0, 550, 18.4785, .9999993, .86996},
    {"fog/radiation-heavy", {0}, 0, 550, 16.6374, .9999997, .85365},
    {"fog/radiation", {0}, 0, 550, 8.6350, .9999998, .83126},
    {"haze/l", {0}, 0, 550, 3.912 / 84.7909, 1, .80449},
    {"cloud/droplets", {7, 1, 1}, 100, 550, 47.2647, .9999996, .86417},
    {"cloud/c1", {0}, 0, 850, 16.9986, .9999661, .84222},
    {"fog/advection-heavy", {0}, 0, 850, 29.0268, .9999196, .86833},
    {"fog/advection", {0}, 0, 850, 18.6914, .9999346, .86488},
    {"fog/radiation-heavy", {0}, 0, 850, 16.9986, .9999661, .84222},
    {"fog/radiation", {0}, 0, 850, 8.9299, .9999864, .80773},
    {"haze/l", {0}, 0, 850, 3.912 / 113.4482, .9999977, .79768},
    {"cloud/droplets", {7, 1, 1}, 100, 850, 47.9774, .9999544, .85686},
    {"cloud/c1", {0}, 0, 1550, 17.7315, .9947316, .81924},
    {"fog/advection-heavy", {0}, 0, 1550, 29.5847, .9841961, .86506},
    {"fog/advection", {0}, 0, 1550, 19.1129, .9870777, .85902},
    {"fog/radiation-heavy", {0}, 0, 1550, 17.7315, .9947316, .81924},
    {"fog/radiation", {0}, 0, 1550, 9.8052, .9976265, .77703},
    {"haze/l", {0}, 0, 1550, 3.912 / 268.3229, .9989940, .74013},
    {"cloud/droplets", {7, 1, 1}, 100, 1550, 49.4155, .9914246, .84599},
};

typedef struct answer {
    double extinction_per_m, albedo;
    double moment[18]; /* Legendre: [0] is 1, [1] the mean cosine */
} answer;

static double density(const murk_mixture *mixture, murk_phase_table *const *of,
                      double mu)
{
    double sum = 0;
    for (size_t i = 0; i < mixture->n; ++i) {
        sum += mixture->part[i].share * murk_phase_table_density(of[i], mu);
    }
    return sum;
}

/* One line gives one table. */
static void moments_of(const murk_mixture *mixture, double moment[18])
{
    murk_phase_table *table = NULL;
    const murk_mixture_part *part = &mixture->part[0];
    const murk_phase_rows rows = {.rows = part->angles,
                                  .angle_deg = part->angle_deg,
                                  .phase_per_sr = part->phase_per_sr,
                                  .where = "mixture"};
    for (int l = 0; l < 18; ++l) {
        moment[l] = NAN;
    }
    if (mixture->n != 1 || murk_phase_table_create(&table, &rows, NULL)) {
        return;
    }
    for (int l = 0; l < 18; ++l) {
        moment[l] = 0;
    }
    const int steps = 40000;
    for (int i = 0; i < steps; ++i) {
        /* steps in angle^2 close to forward, in angle beyond */
        const double at = (i + .5) / steps, angle = PI * at * at;
        const double mu = cos(angle);
        const double share = 2 * PI * sin(angle) * 2 * PI * at / steps *
                             density(mixture, &table, mu);
        double before = 1, now = mu;
        moment[0] += share;
        for (int l = 1; l < 18; ++l) {
            moment[l] += share * now;
            const double next = ((2 * l + 1) * mu * now - l * before) / (l + 1);
            before = now;
            now = next;
        }
    }
    murk_phase_table_destroy(table);
}

static answer ask(const char *name, const double shape[3], double droplets,
                  double nm)
{
    /* Unless the preset has droplets of its own, give the diameter and
     * shape of the droplets. */
    answer out = {.extinction_per_m = NAN, .albedo = NAN, .moment = {NAN, NAN}};
    murk_preset *preset = NULL;
    murk_preset_result result = {0};
    murk_words words = {0};
    if (droplets > 0) {
        words.given[MURK_WORD_DROPLETS] = true;
        words.value[MURK_WORD_DROPLETS][0] = droplets;
        words.given[MURK_WORD_DROPLET_SHAPE] = true;
        for (int k = 0; k < 3; ++k) {
            words.value[MURK_WORD_DROPLET_SHAPE][k] = shape[k];
        }
    }
    /* Evaluate the preset in one band of one wavelength. */
    const murk_preset_bands bands = {.n = 1, .line_nm = &nm};
    if (!murk_presets_read(&preset, name, name, NULL) &&
        !murk_preset_evaluate(&result, preset, &words, &bands, name, NULL)) {
        out.extinction_per_m = result.extinction_per_m.band[0];
        out.albedo = result.albedo.band[0];
        moments_of(result.mixture[0], out.moment);
    }
    murk_preset_result_release(&result);
    murk_preset_destroy(preset);
    return out;
}

/* Haze L and Cloud C.1 at .7 um, index 1.33: Garcia & Siewert, Transport Theory
 * Stat. Phys. 14 (1985) 437, doi:10.1080/00411458508211687, at second hand from
 * the tests of PythonicDISORT. */
static void compare_moments(murk_library *library)
{
    static const struct {
        const char *preset;
        int l;
        double value;
    } known[] = {{"haze/l", 1, .8042},       {"haze/l", 2, .646094},
                 {"haze/l", 3, .48185143},   {"haze/l", 5, .26304545},
                 {"cloud/c1", 1, .848},      {"cloud/c1", 2, .7766},
                 {"cloud/c1", 5, .53518182}, {"cloud/c1", 17, .38931429}};
    const double none[3] = {0};
    answer haze = ask("haze/l", none, 0, 700);
    answer cloud = ask("cloud/c1", none, 0, 700);
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
        char name[80];
        snprintf(name, sizeof name, "%s, 700 nm, Legendre moment %d",
                 known[i].preset, known[i].l);
        const answer *got = known[i].preset[0] == 'h' ? &haze : &cloud;
        murk_library_row(library, name, "-", known[i].value,
                         got->moment[known[i].l], .01 * known[i].value,
                         "1 %: their index is 1.33",
                         "Garcia & Siewert 1985, second hand");
    }
}

void murk_library_droplets(murk_library *library)
{
    /* Title and source of the reference. */
    const char *source = "fog_cloud_mie: independent Lorenz-Mie";
    murk_library_title(
        library, "Fog, cloud and haze of droplets",
        "Presets against an independent Lorenz-Mie computation, whose index of "
        "water is 1.333, 1.329 and 1.317 with 1.1e-4 absorbed (told from its "
        "values); 1 - albedo goes with the imaginary part, which murk takes "
        "from Segelstein (1.34e-4 at 1550 nm).");
    /* Extinction, albedo and mean cosine of each preset at each wavelength. */
    for (size_t i = 0; i < sizeof ROWS / sizeof *ROWS; ++i) {
        const row *r = &ROWS[i];
        const answer got = ask(r->preset, r->shape, r->droplets, r->nm);
        char name[80];
        snprintf(name, sizeof name, "%s, %g nm, extinction", r->preset, r->nm);
        murk_library_row(library, name, "1/km", r->extinction_per_km,
                         1000 * got.extinction_per_m,
                         .01 * r->extinction_per_km, "1 %: asked for", source);
        snprintf(name, sizeof name, "%s, %g nm, albedo", r->preset, r->nm);
        murk_library_row(library, name, "-", r->albedo, got.albedo,
                         .01 * r->albedo, "1 %: asked for", source);
        snprintf(name, sizeof name, "%s, %g nm, mean cosine", r->preset, r->nm);
        murk_library_row(library, name, "-", r->mean_cosine, got.moment[1],
                         .01 * r->mean_cosine, "1 %: asked for", source);
    }
    compare_moments(library);
}
