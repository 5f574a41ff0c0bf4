/* Fog, cloud and haze of water droplets, computed by Mie theory when a preset
 * is read.
 *
 * Droplet populations are computed at wavelengths at most 8 % apart (or at each
 * requested wavelength, if these are farther apart). In between, scattering and
 * the phase function are linear in ln(wavelength). Absorption is interpolated
 * as a ratio to the absorption of bulk water, so that it follows the absorption
 * bands of water at every wavelength. */
#include "preset/laws.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/cache.h"
#include "base/interrupt.h"
#include "base/pool.h"
#include "base/sort.h"
#include "preset/droplets.h"
#include "preset/refraction.h"

/* The largest ratio of neighbouring wavelengths at which droplets are
 * computed. */
#define NODE_RATIO_MAX 1.08

/* Tolerance of cross sections and mean cosine: a fifth of the 1 % within which
 * the tests compare presets with an independent program for Mie theory. */
#define TOLERANCE 2e-3

#define DEGREE 0.017453292519943295 /* pi / 180 */

typedef struct node {
    double nm;
    murk_droplet_optics optics;
    double *phase; /* [angles], within nodes.phase */
    murk_status status;
    murk_error err;
} node;

typedef struct nodes {
    murk_droplets shape;
    node *node; /* [n], rising */
    size_t n, angles;
    double angle_deg[MURK_DROPLET_ANGLES_MAX], mu[MURK_DROPLET_ANGLES_MAX];
    double *phase;
} nodes;

static int by_wavelength(const void *a, const void *b)
{
    return MURK_ORDER(((const node *)a)->nm, ((const node *)b)->nm);
}

/* Thins out the rising wavelengths: both ends stay, and between them those
 * without which a gap would exceed NODE_RATIO_MAX. Equal wavelengths become
 * one. */
static void thin(nodes *all)
{
    size_t n = 0;
    for (size_t i = 0; i < all->n; ++i) {
        const bool is_end = i == 0 || i + 1 == all->n;
        if (is_end ||
            all->node[i + 1].nm > all->node[n - 1].nm * NODE_RATIO_MAX) {
            if (n == 0 || all->node[i].nm > all->node[n - 1].nm) {
                all->node[n++].nm = all->node[i].nm;
            }
        }
    }
    all->n = n;
}

static murk_status choose_nodes(nodes *all, const murk_law_call *call,
                                murk_error *err)
{
    /* Sort the wavelengths of the call and thin them out. */
    all->n = call->n;
    all->angles = murk_droplet_angles(all->angle_deg);
    all->node = calloc(call->n, sizeof *all->node);
    if (all->node) {
        for (size_t i = 0; i < call->n; ++i) {
            all->node[i].nm = call->wavelength_nm[i];
        }
        qsort(all->node, all->n, sizeof *all->node, by_wavelength);
        thin(all);
        all->phase = calloc(all->n * all->angles, sizeof *all->phase);
    }
    if (!all->node || !all->phase) {
        return murk_no_memory(err, call->where, "for droplets");
    }
    for (size_t i = 0; i < all->n; ++i) {
        all->node[i].phase = all->phase + i * all->angles;
    }
    for (size_t i = 0; i < all->angles; ++i) {
        all->mu[i] = cos(all->angle_deg[i] * DEGREE);
    }
    return MURK_OK;
}

/* The cached optical properties of the mean droplet by shape and wavelength.
 * The properties do not depend on the number of droplets, so a fit that varies
 * only that number finds them in the cache each time. */
static murk_cache cache = MURK_CACHE_NONE;

typedef struct solved {
    murk_droplet_optics optics;
    double phase[MURK_DROPLET_ANGLES_MAX];
} solved;

static void solve_node(void *context, uint64_t batch)
{
    nodes *all = context;
    node *one = &all->node[batch];
    const double key[] = {all->shape.a, all->shape.b, all->shape.c, one->nm};
    const size_t phase_bytes = all->angles * sizeof *one->phase;
    size_t size;
    solved *found = murk_cache_find(&cache, key, sizeof key, &size);
    if (found) {
        one->optics = found->optics;
        memcpy(one->phase, found->phase, phase_bytes);
        free(found);
        return;
    }
    one->status = murk_droplets_solve(
        &one->optics, &all->shape, one->nm, murk_water_refraction(one->nm),
        TOLERANCE, all->angles, all->mu, one->phase, &one->err);
    if (!one->status) {
        solved made = {.optics = one->optics};
        memcpy(made.phase, one->phase, phase_bytes);
        murk_cache_put(&cache, key, sizeof key, &made, sizeof made);
    }
}

static murk_status solve(nodes *all, const char *where, murk_error *err)
{
    murk_pool_run(murk_pool_processors(), all->n, solve_node, all);
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, where, "interrupted");
    }
    for (size_t i = 0; i < all->n; ++i) {
        if (all->node[i].status) {
            return murk_fail(err, all->node[i].status, where, "%s",
                             all->node[i].err.text);
        }
    }
    return MURK_OK;
}

/* The absorption of bulk water, except for a constant factor. */
static double bulk(double nm)
{
    return murk_water_refraction(nm).k / nm;
}

static void interpolate(murk_law_result *out, size_t i, double nm,
                        const nodes *all, double per_cm3)
{
    size_t right = all->n > 1 ? 1 : 0;
    while (right + 1 < all->n && all->node[right].nm < nm) {
        ++right;
    }
    const node *b = &all->node[right];
    const node *a = right > 0 ? b - 1 : b;
    const double to_b = a == b ? 0 : log(nm / a->nm) / log(b->nm / a->nm);
    const double to_a = 1 - to_b, scale = MURK_PER_M_OF_UM2 * per_cm3;
    out->scattering_per_m[i] = scale * (to_a * a->optics.scattering_um2 +
                                        to_b * b->optics.scattering_um2);
    out->absorption_per_m[i] = scale * bulk(nm) *
                               (to_a * a->optics.absorption_um2 / bulk(a->nm) +
                                to_b * b->optics.absorption_um2 / bulk(b->nm));
    double *phase = out->made->phase_per_sr + i * all->angles;
    for (size_t k = 0; k < all->angles; ++k) {
        phase[k] = to_a * a->phase[k] + to_b * b->phase[k];
    }
    out->phase[i] = (murk_preset_phase){
        .kind = MURK_PHASE_TABLE, .angles = out->made, .column = i};
}

static murk_status run(murk_law_result *out, const murk_law_call *call,
                       const double abc[3], murk_error *err)
{
    /* Compute the population at the chosen wavelengths. */
    nodes all = {.shape = {abc[0], abc[1], abc[2]}};
    murk_status status = murk_droplets_check(&all.shape, call->where, err);
    if (!status) {
        status = choose_nodes(&all, call, err);
    }
    if (!status) {
        status = solve(&all, call->where, err);
    }
    if (!status) {
        status = murk_preset_angles_create(&out->made, all.angles, call->n,
                                           false, err);
    }
    if (!status) {
        /* Convert the words to a number of droplets per cubic centimetre, and
         * interpolate to each wavelength of the call. */
        const murk_words *words = call->words;
        const double per_cm3 =
            words->given[MURK_WORD_LIQUID_WATER]
                ? words->value[MURK_WORD_LIQUID_WATER][0] /
                      murk_droplets_water_g_per_m3(&all.shape)
                : words->value[MURK_WORD_DROPLETS][0];
        memcpy(out->made->angle_deg, all.angle_deg,
               all.angles * sizeof *all.angle_deg);
        for (size_t i = 0; i < call->n; ++i) {
            interpolate(out, i, call->wavelength_nm[i], &all, per_cm3);
        }
        out->has_phase = true;
    }
    free(all.node);
    free(all.phase);
    return status;
}

murk_status murk_law_droplets(murk_law_result *out, const murk_law_call *call,
                              murk_error *err)
{
    return run(out, call, call->words->value[MURK_WORD_DROPLET_SHAPE], err);
}

murk_status murk_law_gamma_droplets(murk_law_result *out,
                                    const murk_law_call *call, murk_error *err)
{
    return run(out, call, call->parameter, err);
}
