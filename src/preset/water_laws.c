/* The laws of water as parts of presets. Pure water is one part; each
 * constituent is another part and gives coefficients for itself only. */
#include "preset/laws.h"

#include "preset/case_1.h"
#include "preset/water_contents.h"
#include "preset/water_kd.h"
#include "preset/water_pure.h"

#include <math.h>
#include <stdlib.h>

/* One row for each degree: log-log interpolation between them is within 8e-5 of
 * the formula. */
#define PHASE_ROWS 181

static double word(const murk_law_call *call, murk_word_id id, double otherwise)
{
    return call->words->given[id] ? call->words->value[id][0] : otherwise;
}

static double temperature(const murk_law_call *call)
{
    return word(call, MURK_WORD_TEMPERATURE, 20);
}

static double salinity(const murk_law_call *call)
{
    return word(call, MURK_WORD_SALINITY, 0);
}

static murk_status scatter_as_molecules(murk_law_result *out,
                                        const murk_law_call *call,
                                        murk_error *err)
{
    const murk_status status =
        murk_preset_angles_create(&out->made, PHASE_ROWS, 1, false, err);
    if (status) {
        return status;
    }
    for (size_t i = 0; i < PHASE_ROWS; ++i) {
        const double share = (double)i / (PHASE_ROWS - 1);
        out->made->angle_deg[i] = 180 * share;
        out->made->phase_per_sr[i] =
            murk_water_phase(cos(3.14159265358979324 * share));
    }
    for (size_t i = 0; i < call->n; ++i) {
        out->phase[i] =
            (murk_preset_phase){.kind = MURK_PHASE_TABLE, .angles = out->made};
    }
    out->has_phase = true;
    return MURK_OK;
}

murk_status murk_law_water(murk_law_result *out, const murk_law_call *call,
                           murk_error *err)
{
    for (size_t i = 0; i < call->n; ++i) {
        const double nm = call->wavelength_nm[i];
        out->absorption_per_m[i] = murk_water_absorption(nm);
        out->scattering_per_m[i] =
            murk_water_scattering(nm, temperature(call), salinity(call));
    }
    return scatter_as_molecules(out, call, err);
}

murk_status murk_law_water_morel(murk_law_result *out,
                                 const murk_law_call *call, murk_error *err)
{
    for (size_t i = 0; i < call->n; ++i) {
        const double nm = call->wavelength_nm[i];
        out->absorption_per_m[i] = murk_water_absorption(nm);
        out->scattering_per_m[i] =
            murk_water_scattering_morel(nm, salinity(call));
    }
    return scatter_as_molecules(out, call, err);
}

/* Checks the wavelengths: the spectra of Bricaud et al. cover a smaller range
 * than those of water. */
static murk_status check_chlorophyll(const murk_law_call *call, murk_error *err)
{
    for (size_t i = 0; i < call->n; ++i) {
        const double nm = call->wavelength_nm[i];
        if (!(nm >= MURK_CHLOROPHYLL_MIN_NM && nm <= MURK_CHLOROPHYLL_MAX_NM)) {
            return murk_fail(err, MURK_BAD_VALUE, call->where,
                             "chlorophyll_mg_per_m3 with a band at %.9g nm, "
                             "must be within %g..%g nm (Bricaud et al. 1998)",
                             nm, MURK_CHLOROPHYLL_MIN_NM,
                             MURK_CHLOROPHYLL_MAX_NM);
        }
    }
    return MURK_OK;
}

/* Particles that vary with chlorophyll: scattering, and absorption by the given
 * function. */
static murk_status with_chlorophyll(murk_law_result *out,
                                    const murk_law_call *call,
                                    double (*absorption)(double, double),
                                    murk_error *err)
{
    const double chlorophyll = word(call, MURK_WORD_CHLOROPHYLL, 0);
    if (chlorophyll == 0) {
        return MURK_OK;
    }
    const murk_status status = check_chlorophyll(call, err);
    if (status) {
        return status;
    }
    murk_preset_phase phase = {.kind = MURK_PHASE_FOURNIER_FORAND};
    murk_forand_of_backward(murk_chlorophyll_backward(chlorophyll),
                            &phase.value[0], &phase.value[1]);
    for (size_t i = 0; i < call->n; ++i) {
        const double nm = call->wavelength_nm[i];
        out->absorption_per_m[i] = absorption(nm, chlorophyll);
        out->scattering_per_m[i] = murk_chlorophyll_scattering(nm, chlorophyll);
        out->phase[i] = phase;
    }
    out->has_phase = true;
    return MURK_OK;
}

murk_status murk_law_chlorophyll(murk_law_result *out,
                                 const murk_law_call *call, murk_error *err)
{
    return with_chlorophyll(out, call, murk_chlorophyll_absorption, err);
}

murk_status murk_law_case_1(murk_law_result *out, const murk_law_call *call,
                            murk_error *err)
{
    return with_chlorophyll(out, call, murk_case_1_absorption, err);
}

murk_status murk_law_cdom(murk_law_result *out, const murk_law_call *call,
                          murk_error *err)
{
    (void)err;
    for (size_t i = 0; i < call->n; ++i) {
        out->absorption_per_m[i] = murk_cdom_absorption(
            call->wavelength_nm[i], word(call, MURK_WORD_CDOM, 0),
            MURK_CDOM_SLOPE);
    }
    return MURK_OK;
}

murk_status murk_law_sediment(murk_law_result *out, const murk_law_call *call,
                              murk_error *err)
{
    (void)err;
    const double sediment = word(call, MURK_WORD_SEDIMENT, 0);
    for (size_t i = 0; i < call->n; ++i) {
        const double nm = call->wavelength_nm[i];
        out->absorption_per_m[i] = murk_sediment_absorption(nm, sediment);
        out->scattering_per_m[i] = murk_sediment_scattering(nm, sediment);
    }
    return MURK_OK;
}

/* Absorption and scattering of water with its constituents, known at one
 * wavelength, and how the part of the constituents depends on wavelength;
 * parameters in the order of laws.c. */
typedef struct green {
    double absorption_per_m, scattering_per_m, at_nm;
    double absorption_per_nm, scattering_power;
} green;

/* Sets *scale to the factor of the constituents with which water and
 * constituents together have the beam attenuation of the user at g->at_nm; 1 if
 * the user gives none. Fails with MURK_BAD_VALUE if water alone has more. */
static murk_status scale_of(double *scale, const green *g,
                            const murk_law_call *call, murk_error *err)
{
    const double water =
        murk_water_absorption(g->at_nm) +
        murk_water_scattering(g->at_nm, temperature(call), salinity(call));
    const double whole = g->absorption_per_m + g->scattering_per_m;
    const double asked = word(call, MURK_WORD_BEAM_ATTENUATION, whole);
    if (!(asked >= water)) {
        return murk_fail(err, MURK_BAD_VALUE, call->where,
                         "beam_attenuation_per_m is %.9g, must be at least "
                         "%.6g 1/m, which water has by itself at %.6g nm",
                         asked, water, g->at_nm);
    }
    *scale = (asked - water) / (whole - water);
    return MURK_OK;
}

murk_status murk_law_in_green(murk_law_result *out, const murk_law_call *call,
                              murk_error *err)
{
    const double *p = call->parameter;
    const green g = {p[0], p[1], p[2], p[3], p[4]};
    double scale = 0;
    const murk_status status = scale_of(&scale, &g, call, err);
    if (status) {
        return status;
    }
    const double absorption =
        g.absorption_per_m - murk_water_absorption(g.at_nm);
    const double scattering =
        g.scattering_per_m -
        murk_water_scattering(g.at_nm, temperature(call), salinity(call));
    for (size_t i = 0; i < call->n; ++i) {
        const double nm = call->wavelength_nm[i];
        out->absorption_per_m[i] =
            scale * absorption * exp(-g.absorption_per_nm * (nm - g.at_nm));
        out->scattering_per_m[i] =
            scale * scattering * pow(nm / g.at_nm, -g.scattering_power);
    }
    return MURK_OK;
}

/* Particles that scatter as a power of the wavelength, in water lit by the
 * sun. */
typedef struct daylight {
    double scattering_per_m, at_nm, power, sun_cosine;
    const murk_law_call *call;
} daylight;

static double particles(const daylight *d, double nm)
{
    return d->scattering_per_m * pow(nm / d->at_nm, -d->power);
}

/* The absorption of the constituents with which water and constituents together
 * have the diffuse attenuation of a row of the table; below 0 if pure water
 * alone absorbs more than this attenuation allows. */
static double beside_water(const daylight *d, size_t row)
{
    const murk_preset_table *table = d->call->table;
    const double nm = table->wavelength_nm[row];
    const double molecules =
        murk_water_scattering(nm, temperature(d->call), salinity(d->call));
    return murk_water_absorption_of_kd(table->diffuse_attenuation_per_m[row],
                                       particles(d, nm), molecules,
                                       d->sun_cosine) -
           murk_water_absorption(nm);
}

/* Interpolates the absorption of the constituents, and not that of pure water
 * with them, between rows, because the spectrum of the constituents is smooth,
 * while that of pure water is steep. Values below 0 become 0. */
murk_status murk_law_diffuse_attenuation(murk_law_result *out,
                                         const murk_law_call *call,
                                         murk_error *err)
{
    const double *p = call->parameter;
    const daylight d = {p[0], p[1], p[2], murk_water_sun_cosine(p[3]), call};
    double *beside = calloc(call->table->n, sizeof *beside);
    if (!beside) {
        return murk_no_memory(err, call->where, "for a preset");
    }
    for (size_t row = 0; row < call->table->n; ++row) {
        beside[row] = beside_water(&d, row);
    }
    for (size_t i = 0; i < call->n; ++i) {
        const double nm = call->wavelength_nm[i];
        out->absorption_per_m[i] =
            fmax(murk_preset_table_at(call->table, beside, nm), 0);
        out->scattering_per_m[i] = particles(&d, nm);
    }
    free(beside);
    return MURK_OK;
}
