/* Evaluates a preset: computes all parts at every wavelength that the bands
 * require (one for a band of a single wavelength, MURK_PRESET_SAMPLES midpoints
 * for a band with edges), scales parts to the visibility, and averages the
 * coefficients and phase functions of each band. */
#include "preset/check_words.h"
#include "preset/law.h"
#include "preset/mixture.h"
#include "preset/visibility.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* All bands, and 550 nm. */
#define SAMPLES_MAX (MURK_BANDS_MAX * MURK_PRESET_SAMPLES + 1)

/* Wavelengths, band by band. If parts are scaled, 550 nm follows as the last
 * one. */
typedef struct samples {
    size_t n, per_band;
    double nm[SAMPLES_MAX];
} samples;

typedef struct evaluation {
    const murk_preset *preset;
    murk_words words;
    samples at;
    murk_law_result part[MURK_PRESET_PARTS_MAX]; /* into the arrays below */
    double absorption_per_m[MURK_PRESET_PARTS_MAX][SAMPLES_MAX];
    double scattering_per_m[MURK_PRESET_PARTS_MAX][SAMPLES_MAX];
    murk_preset_phase phase[MURK_PRESET_PARTS_MAX][SAMPLES_MAX];
    murk_mixing mixing;
} evaluation;

static murk_status check_band(const murk_preset *preset, double from_nm,
                              double to_nm, const char *where, murk_error *err)
{
    const double *range = preset->wavelength_nm;
    if (from_nm >= range[0] && to_nm <= range[1]) {
        return MURK_OK;
    }
    char band[64];
    snprintf(band, sizeof band, from_nm < to_nm ? "%.9g..%.9g" : "%.9g",
             from_nm, to_nm);
    return murk_fail(err, MURK_BAD_VALUE, where,
                     "a band at %s nm, must be within %.6g..%.6g nm for %s "
                     "(%s)",
                     band, range[0], range[1], preset->name,
                     preset->source[0].from);
}

static bool is_scaled(const murk_preset *preset, const murk_words *words)
{
    bool any = false;
    for (size_t i = 0; i < preset->parts; ++i) {
        any = any || preset->part[i].scaled;
    }
    return any && words->given[MURK_WORD_VISIBILITY];
}

static murk_status choose_samples(samples *at, const murk_preset *preset,
                                  const murk_preset_bands *bands,
                                  const char *where, murk_error *err)
{
    at->per_band = bands->edge_nm ? MURK_PRESET_SAMPLES : 1;
    for (int b = 0; b < bands->n; ++b) {
        const double from =
            bands->edge_nm ? bands->edge_nm[b] : bands->line_nm[b];
        const double to = bands->edge_nm ? bands->edge_nm[b + 1] : from;
        const murk_status status = check_band(preset, from, to, where, err);
        if (status) {
            return status;
        }
        for (size_t k = 0; k < at->per_band; ++k) {
            at->nm[at->n++] =
                from + (to - from) * ((double)k + .5) / (double)at->per_band;
        }
    }
    return MURK_OK;
}

/* ---- parts ---- */

static void read_table(murk_law_result *out, const murk_preset_table *table,
                       const samples *at)
{
    for (size_t i = 0; i < at->n; ++i) {
        if (table->absorption_per_m) {
            out->absorption_per_m[i] =
                murk_preset_table_at(table, table->absorption_per_m, at->nm[i]);
        }
        if (table->scattering_per_m) {
            out->scattering_per_m[i] =
                murk_preset_table_at(table, table->scattering_per_m, at->nm[i]);
        }
        if (table->mean_cosine) {
            out->phase[i] =
                (murk_preset_phase){.kind = MURK_PHASE_HG,
                                    .value = {murk_preset_table_at(
                                        table, table->mean_cosine, at->nm[i])}};
        }
    }
    out->has_phase = table->mean_cosine != NULL;
}

static void multiply(murk_law_result *optics, size_t n, double factor)
{
    for (size_t i = 0; i < n; ++i) {
        optics->absorption_per_m[i] *= factor;
        optics->scattering_per_m[i] *= factor;
    }
}

/* Checks the coefficients of a part. The laws are tested, but they are
 * evaluated with numbers that users give. */
static murk_status check_optics(const murk_law_result *optics, size_t n,
                                const char *name, const char *where,
                                murk_error *err)
{
    for (size_t i = 0; i < n; ++i) {
        const double a = optics->absorption_per_m[i];
        const double b = optics->scattering_per_m[i];
        if (!(a >= 0 && b >= 0 && a + b <= 1e9)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "%s has absorption %.6g and scattering %.6g, must "
                             "be 0..1e9 1/m together",
                             name, a, b);
        }
    }
    return MURK_OK;
}

static murk_status run_part(evaluation *e, size_t index, const char *where,
                            murk_error *err)
{
    const murk_preset_part *part = &e->preset->part[index];
    murk_law_result *out = &e->part[index];
    const size_t n = e->at.n;
    murk_status status = MURK_OK;
    out->absorption_per_m = e->absorption_per_m[index];
    out->scattering_per_m = e->scattering_per_m[index];
    out->phase = e->phase[index];
    /* Coefficients by the law or the table, times the word of the part. */
    if (part->law) {
        const murk_law_call call = {.n = n,
                                    .wavelength_nm = e->at.nm,
                                    .words = &e->words,
                                    .parameter = part->parameter,
                                    .table = &part->table,
                                    .where = where};
        status = part->law->run(out, &call, err);
    } else {
        read_table(out, &part->table, &e->at);
    }
    if (!status && part->times >= 0) {
        multiply(out, n, e->words.value[part->times][0]);
    }
    return status ? status : check_optics(out, n, e->preset->name, where, err);
}

static double extinction_at_550(const evaluation *e, bool scaled)
{
    double sum = 0;
    const size_t last = e->at.n - 1;
    for (size_t i = 0; i < e->preset->parts; ++i) {
        if (e->preset->part[i].scaled == scaled) {
            sum += e->part[i].absorption_per_m[last] +
                   e->part[i].scattering_per_m[last];
        }
    }
    return sum;
}

/* Scales the scaled parts to the extinction at 550 nm that is left for them:
 * the extinction that belongs to the visibility, less that of the other parts.
 * Fails with MURK_BAD_VALUE if the extinction of the other parts alone is
 * larger than that of the visibility (unless the scaled parts may vanish), or
 * if the scaled parts have none. */
static murk_status scale(evaluation *e, const char *where, murk_error *err)
{
    const double visibility_m = e->words.value[MURK_WORD_VISIBILITY][0];
    const double whole = murk_visibility_extinction(visibility_m);
    const double others = extinction_at_550(e, false);
    const double scaled = extinction_at_550(e, true);
    if (!(whole >= others) && !e->preset->scaled_may_vanish) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a visibility of %.9g m, must be at most %.6g m, "
                         "which the rest of %s has by itself",
                         visibility_m, murk_visibility_extinction(others),
                         e->preset->name);
    }
    if (!(scaled > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%s has nothing at 550 nm to scale to a visibility",
                         e->preset->name);
    }
    for (size_t i = 0; i < e->preset->parts; ++i) {
        if (e->preset->part[i].scaled) {
            multiply(&e->part[i], e->at.n, fmax(0, whole - others) / scaled);
        }
    }
    return MURK_OK;
}

/* ---- bands ---- */

static void mix(evaluation *e, size_t part, size_t sample)
{
    const murk_preset_part *p = &e->preset->part[part];
    const double weight = e->part[part].scattering_per_m[sample];
    if (p->has_phase && p->angles) {
        murk_mixing_add_angles(&e->mixing, p->angles, e->at.nm[sample], weight);
    } else if (p->has_phase || e->part[part].has_phase) {
        murk_mixing_add(&e->mixing,
                        p->has_phase ? &p->phase : &e->part[part].phase[sample],
                        weight);
    } else {
        murk_mixing_add(&e->mixing, &(murk_preset_phase){0}, weight);
    }
}

static murk_status join_band(murk_preset_result *out, evaluation *e, int band,
                             const char *where, murk_error *err)
{
    double absorption = 0, scattering = 0;
    e->mixing.n = 0;
    for (size_t k = 0; k < e->at.per_band; ++k) {
        const size_t sample = (size_t)band * e->at.per_band + k;
        for (size_t i = 0; i < e->preset->parts; ++i) {
            absorption += e->part[i].absorption_per_m[sample];
            scattering += e->part[i].scattering_per_m[sample];
            mix(e, i, sample);
        }
    }
    const double extinction = absorption + scattering;
    out->extinction_per_m.band[band] = extinction / (double)e->at.per_band;
    out->albedo.band[band] = extinction > 0 ? scattering / extinction : 1;
    return murk_mixing_finish(&out->mixture[band], &e->mixing, where, err);
}

static void release(evaluation *e)
{
    for (size_t i = 0; i < e->preset->parts; ++i) {
        murk_preset_angles_destroy(e->part[i].made);
    }
    free(e);
}

murk_status murk_preset_evaluate(murk_preset_result *out,
                                 const murk_preset *preset,
                                 const murk_words *words,
                                 const murk_preset_bands *bands,
                                 const char *where, murk_error *err)
{
    assert(bands->n > 0 && bands->n <= MURK_BANDS_MAX && preset->sources > 0);
    murk_preset_result result = {0};
    evaluation *e = calloc(1, sizeof *e);
    if (!e) {
        return murk_no_memory(err, where, "for a preset");
    }
    /* Complete the words and choose the wavelengths. */
    e->preset = preset;
    e->words = *words;
    murk_status status = murk_preset_complete(&e->words, preset, where, err);
    if (!status) {
        status = choose_samples(&e->at, preset, bands, where, err);
    }
    const bool scaled = !status && is_scaled(preset, &e->words);
    if (scaled) {
        e->at.nm[e->at.n++] = MURK_VISIBILITY_NM;
    }
    /* Evaluate and scale the parts, then combine them band by band. */
    for (size_t i = 0; i < preset->parts && !status; ++i) {
        status = run_part(e, i, where, err);
    }
    if (!status && scaled) {
        status = scale(e, where, err);
    }
    for (int band = 0; band < bands->n && !status; ++band) {
        status = join_band(&result, e, band, where, err);
    }
    if (status) {
        murk_preset_result_release(&result);
    } else {
        *out = result;
    }
    release(e);
    return status;
}
