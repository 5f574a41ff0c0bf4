/* Fluence and irradiances inside semi-infinite media, against depth: each
 * photon that passes a level counts, the fluence over its cosine. The quick
 * form goes down to QUICK_LEAST of the light on the face, where that takes some
 * seconds, and to QUICK_BRIGHT else (`A` with an index, tallies, twins). The
 * medium `thick` is nightly only, for its time: a photon collides there about a
 * thousand times.
 *
 * Counting at a level stays although 1 / |cosine| has a long tail: for the same
 * errors (`A`, down to QUICK_LEAST) murk's thin slices and planes need .78 of
 * the photons, and twice the time. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cases/groups.h"
#include "cases/layer.h"
#include "cases/reference.h"
#include "scores.h"

/* The level "just inside of the face" [optical depths]. */
#define INSIDE 1e-7

/* Halves the time to the same error here, against roulette alone. */
#define MIN_WEIGHT .2

/* Values below these are nightly only. */
#define MIN          1e-5
#define QUICK_MIN    1e-3
#define QUICK_BRIGHT .05

#define DEPTHS_MAX 12
#define KINDS      3

/* Slices for grid tallies: the mean over one differs from its middle by
 * phi'' thickness^2 / 24, where phi'' is less than phi (light falls as exp(-k
 * tau) with k < 1). */
#define SLICE .05

/* Of the domain where murk tallies. */
#define HALF_WIDTH 50.0

typedef struct profile {
    char name[64];
    layer of;
    double extinction_per_cm;
    score_of score[KINDS * DEPTHS_MAX];
    validation_reference reference[KINDS * DEPTHS_MAX];
    char quantity[KINDS * DEPTHS_MAX][32];
    size_t n;
} profile;

static void name_of(const murk_table *t, size_t row, char name[64])
{
    snprintf(name, 64, "%s, index %s", reference_text(t, row, "case"),
             reference_text(t, row, "index"));
}

static void add_depth(profile *p, const murk_table *t, size_t row,
                      double min_value)
{
    static const char *const column[KINDS] = {"fluence", "down", "up"};
    static const score_of kind[KINDS] = {
        {.kind = SCORE_FLUENCE},
        {.kind = SCORE_POWER, .side = 1},
        {.kind = SCORE_POWER, .side = -1},
    };
    const double depth =
        reference_number(t, row, "z_cm") * p->extinction_per_cm;
    for (int k = 0; k < KINDS; ++k) {
        /* All light goes down through the face, where nothing mirrors it. */
        const bool is_plain = depth == 0 && k == 1 && !(p->of.index > 1);
        if (is_plain || !(reference_number(t, row, column[k]) >= min_value)) {
            continue;
        }
        snprintf(p->quantity[p->n], sizeof p->quantity[p->n], "%s at %s cm",
                 column[k], reference_text(t, row, "z_cm"));
        p->score[p->n] = kind[k];
        p->score[p->n].z_m = depth > 0 ? depth : INSIDE;
        p->reference[p->n] =
            reference_value(t, row, column[k], p->quantity[p->n]);
        ++p->n;
    }
}

/* The rows of one profile follow one another. Returns the row after its last.
 */
static size_t read_profile(profile *p, const murk_table *t, size_t row,
                           double min_value)
{
    const double absorption = reference_number(t, row, "absorption_per_cm");
    const double scattering = reference_number(t, row, "scattering_per_cm");
    *p = (profile){.extinction_per_cm = absorption + scattering};
    p->of = (layer){.index = reference_number(t, row, "index"),
                    .albedo = scattering / p->extinction_per_cm,
                    .phase = murk_phase_hg(reference_number(t, row, "g")),
                    .tau = INFINITY};
    name_of(t, row, p->name);
    for (; row < t->rows; ++row) {
        char name[64];
        name_of(t, row, name);
        if (strcmp(name, p->name) != 0) {
            break;
        }
        add_depth(p, t, row, min_value);
    }
    return row;
}

/* The same by murk's own tallies: planes, and thin slices for the fluence. */
static void trace_tallies(validation *v, const profile *p)
{
    char name[80], names[KINDS * DEPTHS_MAX][32];
    murk_tally_desc tally[KINDS * DEPTHS_MAX];
    validation_cell cell[KINDS * DEPTHS_MAX];
    validation_reference reference[KINDS * DEPTHS_MAX];
    layer of = p->of;
    size_t n = 0;
    of.half_width = HALF_WIDTH;
    snprintf(name, sizeof name, "%s, tallies", p->name);
    if (!validation_wants(v, name)) {
        return;
    }
    for (size_t i = 0; i < p->n; ++i) {
        const double z = p->score[i].z_m;
        if (z < SLICE) {
            continue; /* the face itself */
        }
        const bool is_slice = p->score[i].kind == SCORE_FLUENCE;
        snprintf(names[n], sizeof names[n], "level%zu", i);
        tally[n] = is_slice ? layer_slice(names[n], &of, z, SLICE)
                            : layer_plane(names[n], z, 1);
        cell[n] = is_slice
                      ? (validation_cell){n, 0, 4 * HALF_WIDTH * HALF_WIDTH}
                      : (validation_cell){n, p->score[i].side > 0 ? 0 : 1, 1};
        reference[n] = p->reference[i];
        if (is_slice) {
            reference[n].uncertainty =
                hypot(reference[n].uncertainty,
                      reference[n].value * SLICE * SLICE / 24);
        }
        ++n;
    }
    test_world w = layer_made(&of);
    validation_trace(v, &(validation_case){.name = name,
                                           .source = "adding-doubling",
                                           .world = &w.world,
                                           .reference = reference,
                                           .quantities = n,
                                           .tally = tally,
                                           .tallies = n,
                                           .cell = cell,
                                           .cells = n,
                                           .least_weight = MIN_WEIGHT});
    test_world_unmade(&w);
}

static void trace(validation *v, const profile *p, const char *is_wrong)
{
    if (!validation_wants(v, p->name)) {
        return;
    }
    test_world w = layer_made(&p->of);
    const scores score = {p->score, p->n};
    validation_trace(v, &(validation_case){.name = p->name,
                                           .source = "adding-doubling",
                                           .is_wrong = is_wrong,
                                           .world = &w.world,
                                           .reference = p->reference,
                                           .quantities = p->n,
                                           .score = scores_add,
                                           .context = &score,
                                           .least_weight = MIN_WEIGHT});
    test_world_unmade(&w);
}

void cases_depth(validation *v)
{
    murk_table *t = reference_read("depth.csv");
    const bool is_quick = validation_is_quick(v);
    for (size_t row = 0; row < t->rows;) {
        /* All levels of one medium, and only those that are bright. */
        profile p, bright;
        (void)read_profile(&bright, t, row, is_quick ? QUICK_BRIGHT : MIN);
        row = read_profile(&p, t, row, is_quick ? QUICK_MIN : MIN);
        const bool is_slow = strcmp(p.name, "A, index 1.37") == 0;
        const bool is_thick = strncmp(p.name, "thick", strlen("thick")) == 0;
        if (!is_quick || !is_thick) {
            trace(v, is_slow ? &bright : &p, NULL);
        }
        /* Medium A is scored by the tallies of murk, too. */
        if (strncmp(p.name, "A,", 2) == 0) {
            trace_tallies(v, &bright);
        }
        /* Two twins with a slightly wrong constant. */
        if (is_slow) {
            bright.of.index = 1.34;
            trace(v, &bright, "index 1.34");
        } else if (strcmp(p.name, "A, index 1") == 0) {
            bright.of.albedo = .899;
            trace(v, &bright, "albedo .899");
        }
    }
    murk_table_destroy(t);
}
