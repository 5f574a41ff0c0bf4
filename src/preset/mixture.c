/* Merges phase functions with weights, in the order in which they are added,
 * and copies the tables of the result. */
#include "preset/mixture.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static bool is_same(const murk_preset_phase *a, const murk_preset_phase *b)
{
    if (a->kind != b->kind) {
        return false;
    }
    if (a->kind == MURK_PHASE_TABLE) {
        return a->angles == b->angles && a->column == b->column;
    }
    return a->value[0] == b->value[0] && a->value[1] == b->value[1] &&
           a->value[2] == b->value[2];
}

void murk_mixing_add(murk_mixing *mixing, const murk_preset_phase *phase,
                     double weight)
{
    if (!(weight > 0)) {
        return;
    }
    size_t i = 0;
    while (i < mixing->n && !is_same(&mixing->phase[i], phase)) {
        ++i;
    }
    if (i == mixing->n) {
        assert(i < MURK_MIXING_MAX);
        mixing->phase[i] = *phase;
        mixing->weight[i] = 0;
        ++mixing->n;
    }
    mixing->weight[i] += weight;
}

void murk_mixing_add_angles(murk_mixing *mixing,
                            const murk_preset_angles *angles,
                            double wavelength_nm, double weight)
{
    murk_preset_phase phase = {.kind = MURK_PHASE_TABLE, .angles = angles};
    const double *at = angles->wavelength_nm;
    if (!at || angles->columns == 1) {
        murk_mixing_add(mixing, &phase, weight);
        return;
    }
    double share;
    phase.column =
        murk_preset_interval(at, angles->columns, wavelength_nm, &share);
    murk_mixing_add(mixing, &phase, weight * (1 - share));
    ++phase.column;
    murk_mixing_add(mixing, &phase, weight * share);
}

/* Copies the angles and one column of values to the part; false when out of
 * memory. */
static bool copy_angles(murk_mixture_part *part, const murk_preset_phase *phase)
{
    const murk_preset_angles *angles = phase->angles;
    const size_t n = angles->angles, bytes = n * sizeof(double);
    part->angle_deg = malloc(bytes);
    part->phase_per_sr = malloc(bytes);
    if (!part->angle_deg || !part->phase_per_sr) {
        return false;
    }
    part->angles = n;
    memcpy(part->angle_deg, angles->angle_deg, bytes);
    memcpy(part->phase_per_sr, angles->phase_per_sr + phase->column * n, bytes);
    return true;
}

murk_status murk_mixing_finish(murk_mixture **out, const murk_mixing *mixing,
                               const char *where, murk_error *err)
{
    const size_t n = mixing->n ? mixing->n : 1;
    double sum = 0;
    for (size_t i = 0; i < mixing->n; ++i) {
        sum += mixing->weight[i];
    }
    /* One part for each phase function, with weights divided by their sum.
     * Without any phase function, kind and value of the one part stay zero:
     * MURK_PHASE_HG with mean cosine 0, which is isotropic. */
    murk_mixture *mixture = calloc(1, sizeof *mixture);
    if (mixture) {
        mixture->part = calloc(n, sizeof *mixture->part);
    }
    bool is_whole = mixture && mixture->part;
    for (size_t i = 0; is_whole && i < n; ++i) {
        murk_mixture_part *part = &mixture->part[i];
        mixture->n = i + 1;
        part->share = 1;
        if (mixing->n) {
            part->share = mixing->weight[i] / sum;
            part->kind = mixing->phase[i].kind;
            memcpy(part->value, mixing->phase[i].value, sizeof part->value);
            is_whole = part->kind != MURK_PHASE_TABLE ||
                       copy_angles(part, &mixing->phase[i]);
        }
    }
    if (!is_whole) {
        murk_mixture_destroy(mixture);
        return murk_no_memory(err, where, "for a phase function");
    }
    *out = mixture;
    return MURK_OK;
}

void murk_mixture_destroy(murk_mixture *mixture)
{
    if (mixture) {
        for (size_t i = 0; i < mixture->n; ++i) {
            free(mixture->part[i].angle_deg);
            free(mixture->part[i].phase_per_sr);
        }
        free(mixture->part);
        free(mixture);
    }
}
