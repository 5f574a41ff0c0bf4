/* Writes the tallies of planes and spheres as tallies.csv, and the tallies of
 * grids as OpenVDB files of value and standard error. With --export fields,
 * also writes the photon density of grids (NAME_photons.vdb), and the photon
 * density and fluence rate together for ParaView (NAME.vti). All tallies have
 * lines in the summary. Values are converted from watts into the units of the
 * scene, and for the photon density into photons per second (world/units.h). */
#include "results/tallies.h"

#include "base/log.h"
#include "base/quantile.h"
#include "results/field_files.h"
#include "results/summary.h"
#include "transport/tallies.h"
#include "world/scene_tallies.h"
#include "world/units.h"

#include <stdlib.h>
#include <string.h>

#define FILE_SIZE (MURK_TALLY_NAME_SIZE + 16) /* NAME_photons.vdb */

#define PRINTED_VALUES_MAX 4 /* of a tally that is printed in full */

/* One tally of a run. */
typedef struct tally {
    const murk_traced *traced;
    const murk_scene_desc *scene;
    const murk_tally_desc *desc;
    size_t number;
    murk_units units;
    /* [channels]; value of a packet of each channel (light source and band), in
     * `units` */
    double packet[MURK_SOURCES_MAX * MURK_BANDS_MAX];
} tally;

static tally tally_in(murk_quantity quantity, const murk_session *session,
                      size_t i)
{
    tally t = {.traced = session->traced,
               .scene = session->scene,
               .desc = murk_tallies_desc(session->traced->tallies, i),
               .number = i,
               .units = murk_units_of(quantity)};
    murk_units_packets(t.packet, quantity, session->stage,
                       session->traced->packet_w);
    return t;
}

static tally tally_of(const murk_session *session, size_t i)
{
    return tally_in(session->scene->units, session, i);
}

static murk_estimate read_cell(const tally *t, int band, size_t cell)
{
    return murk_tallies_read(t->traced->tallies, t->number, band, cell,
                             t->traced->ledger->emitted, t->packet);
}

/* The sum of all bands. */
static murk_estimate read_sum(const tally *t, size_t cell)
{
    murk_estimate value[MURK_BANDS_MAX];
    for (int band = 0; band < t->scene->bands; ++band) {
        value[band] = read_cell(t, band, cell);
    }
    return murk_units_sum(value, t->scene->bands);
}

static const char *direction_of(const murk_tally_desc *desc, size_t direction)
{
    if (murk_tally_directions(desc) == 1) {
        return "";
    }
    return desc->type == MURK_TALLY_PLANE ? direction ? "backward" : "forward"
           : direction                    ? "down"
                                          : "up";
}

static const char *unit_of(const murk_tally_desc *desc, const murk_units *units)
{
    return desc->type == MURK_TALLY_PLANE ? units->power : units->irradiance;
}

/* ---- tallies.csv ---- */

/* One value of a tally: a line of tallies.csv. */
typedef struct tally_value {
    const tally *of;
    int band;
    size_t bin, direction; /* direction: from 0 */
    murk_estimate value;
} tally_value;

/* Number of bins along the first or second axis of a plane; 1 for a sphere. */
static size_t bins_of(const murk_tally_desc *d, int axis)
{
    return d->type == MURK_TALLY_PLANE ? d->bins[axis] : 1;
}

void murk_results_list_tally(murk_results_fields *f, const void *of, size_t i)
{
    const tally_value *v = of;
    const murk_tally_desc *d = v ? v->of->desc : NULL;
    (void)i; /* `of` is a single value */
    MURK_TEXT(f, "tally", "name", d->name);
    MURK_ROUNDED(f, "band_nm", "nm", "band", v->of->scene->band_nm[v->band], 9);
    MURK_COUNT(f, "bin_i", "along the first axis, from 0",
               v->bin % bins_of(d, 0));
    MURK_COUNT(f, "bin_j", "along the second axis, from 0",
               v->bin / bins_of(d, 0) % bins_of(d, 1));
    MURK_COUNT(f, "bin_k", "of angle, from 0",
               v->bin / bins_of(d, 0) / bins_of(d, 1));
    MURK_TEXT(f, "direction", "forward, backward, up or down",
              direction_of(d, v->direction));
    MURK_ROUNDED(f, "value", "", "in the unit", v->value.value, 12);
    MURK_ROUNDED(f, "standard_error", "", "of value", v->value.standard_error,
                 6);
    MURK_TEXT(f, "unit", "of value", unit_of(d, &v->of->units));
}

static void write_rows(const tally *t, FILE *file)
{
    const murk_tally_desc *d = t->desc;
    const size_t bins = murk_tally_cells(d) / murk_tally_directions(d);
    for (int band = 0; band < t->scene->bands; ++band) {
        for (size_t c = 0; c < murk_tally_cells(d); ++c) {
            const tally_value v = {t, band, c % bins, c / bins,
                                   read_cell(t, band, c)};
            murk_results_csv_line(file, murk_results_list_tally, &v, 0);
        }
    }
}

static murk_status write_csv(FILE *to, const void *context, murk_error *err)
{
    const murk_session *session = context;
    murk_results_csv_heading(to, murk_results_list_tally);
    for (size_t i = 0; i < murk_tallies_count(session->traced->tallies); ++i) {
        const tally t = tally_of(session, i);
        if (t.desc->type != MURK_TALLY_GRID) {
            write_rows(&t, to);
        }
    }
    (void)err;
    return MURK_OK;
}

/* ---- grids ---- */

static murk_field_box box_of(const murk_tally_desc *d)
{
    return (murk_field_box){.box = d->box,
                            .size = {d->size[0], d->size[1], d->size[2]}};
}

/* Adds the values of one band, or of the sums over all bands (band -1), as a
 * field; with is_error the standard errors of these. False when out of
 * memory. */
static bool add_field(murk_voxel_fields *fields, const tally *t, int band,
                      bool is_error, const murk_voxel_field *like)
{
    float *value = murk_voxel_fields_add(fields, like, band);
    for (size_t c = 0; value && c < murk_tally_cells(t->desc); ++c) {
        const murk_estimate e =
            band < 0 ? read_sum(t, c) : read_cell(t, band, c);
        value[c] = (float)(is_error ? e.standard_error : e.value);
    }
    return value != NULL;
}

/* Adds a field of one band, or of the sums over all bands (band -1), and a
 * field of the errors. */
static bool add_pair(murk_voxel_fields *fields, const tally *t, int band,
                     const murk_voxel_field like[2])
{
    return add_field(fields, t, band, false, &like[0]) &&
           add_field(fields, t, band, true, &like[1]);
}

static murk_status no_memory(const tally *t, murk_error *err)
{
    return murk_no_memory(err, t->desc->name, "for the fields of %zu cells",
                          murk_tally_cells(t->desc));
}

static murk_status add_grid(murk_results *results, const tally *t,
                            bool is_error, murk_error *err)
{
    const murk_voxel_field like = {
        .name = "fluence",
        .unit = t->units.irradiance,
        .quantity =
            is_error ? "standard error of the fluence rate" : "fluence rate"};
    char name[FILE_SIZE];
    murk_voxel_fields fields = {.scene = t->scene, .box = box_of(t->desc)};
    bool has_memory = true;
    for (int band = 0; has_memory && band < t->scene->bands; ++band) {
        has_memory = add_field(&fields, t, band, is_error, &like);
    }
    snprintf(name, sizeof name, "%s%s.vdb", t->desc->name,
             is_error ? "_error" : "");
    const murk_status status =
        has_memory
            ? murk_field_add_vdb(results, name, &fields, MURK_DENSITY_NONE, err)
            : no_memory(t, err);
    murk_voxel_fields_release(&fields);
    return status;
}

murk_status murk_add_tallies(murk_session *session, murk_error *err)
{
    const murk_tallies *tallies = session->traced->tallies;
    if (!tallies) {
        if (session->scene->n_tallies > 0) {
            murk_warn(session->scene->tallies[0].where,
                      "not measured: light from a file is not traced");
        }
        return MURK_OK;
    }
    murk_status status = murk_results_add_stream(
        &session->results, "tallies.csv", write_csv, session, err);
    for (size_t i = 0; i < murk_tallies_count(tallies) && !status; ++i) {
        tally t = tally_of(session, i);
        if (t.desc->type == MURK_TALLY_GRID) {
            status = add_grid(&session->results, &t, false, err);
            status =
                status ? status : add_grid(&session->results, &t, true, err);
        }
    }
    return status;
}

/* ---- photon density beside the fluence rate of grids ---- */

static void add_density(murk_session *session, size_t i, murk_error *late)
{
    static const murk_voxel_field density[2] = {
        {.name = "photon_density",
         .unit = "1/s/m2",
         .quantity = "photon density",
         .meaning = "scalar irradiance, photons that cross a small sphere per "
                    "second and m2 of its cross-section, mean over the voxel"},
        {.name = "photon_density_error",
         .unit = "1/s/m2",
         .quantity = "standard error of the photon density"}};
    const tally photons = tally_in(MURK_PHOTONS, session, i);
    const tally own = tally_of(session, i);
    const char *unit = own.units.irradiance;
    const murk_voxel_field fluence[2] = {
        {.name = "fluence", .unit = unit, .quantity = "fluence rate"},
        {.name = "fluence_error",
         .unit = unit,
         .quantity = "standard error of the fluence rate"}};
    const int bands = session->scene->bands;
    /* NAME_photons.vdb has the density alone, NAME.vti the fluence too. */
    char name[FILE_SIZE];
    murk_voxel_fields fields = {.scene = session->scene,
                                .box = box_of(own.desc)};
    bool has_memory = bands == 1 || add_pair(&fields, &photons, -1, density);
    for (int band = 0; has_memory && band < bands; ++band) {
        has_memory = add_pair(&fields, &photons, band, density);
    }
    if (has_memory) {
        snprintf(name, sizeof name, "%s_photons.vdb", own.desc->name);
        (void)murk_field_add_vdb(&session->results, name, &fields,
                                 MURK_DENSITY_SCALED, late);
    }
    for (int band = 0; has_memory && band < bands; ++band) {
        has_memory = add_pair(&fields, &own, band, fluence);
    }
    if (has_memory) {
        snprintf(name, sizeof name, "%s.vti", own.desc->name);
        (void)murk_field_add_vti(&session->results, name, &fields, late);
    } else {
        (void)no_memory(&own, late);
    }
    murk_voxel_fields_release(&fields);
}

void murk_add_tally_fields(murk_session *session, murk_error *late)
{
    const murk_tallies *tallies = session->traced->tallies;
    size_t grids = 0;
    for (size_t i = 0; tallies && i < murk_tallies_count(tallies); ++i) {
        if (murk_tallies_desc(tallies, i)->type == MURK_TALLY_GRID) {
            add_density(session, i, late);
            ++grids;
        }
    }
    if (grids == 0) {
        murk_note("exports", "fields: no fluence rate and photon density, "
                             "which a tally of type grid measures");
    }
}

/* ---- lines ---- */

/* Prints the line of one value of a band, or of the sum over all bands (-1). */
static void print_value(const tally *t, int band, size_t cell, murk_estimate e)
{
    const murk_tally_desc *d = t->desc;
    const size_t directions = murk_tally_directions(d);
    const size_t bins = murk_tally_cells(d) / directions;
    murk_print("tally       %s", d->name);
    if (band < 0) {
        murk_print(" all bands");
    } else if (t->scene->bands > 1) {
        murk_print(" %.6g nm", t->scene->band_nm[band]);
    }
    if (bins > 1) {
        murk_print(" bin %zu", cell % bins);
    }
    murk_print("%s%s: %.5g +- %.2g %s\n", directions > 1 ? " " : "",
               direction_of(d, cell / bins), e.value, e.standard_error,
               unit_of(d, &t->units));
}

static void print_values(const tally *t)
{
    const size_t cells = murk_tally_cells(t->desc);
    for (int band = 0; band < t->scene->bands; ++band) {
        for (size_t c = 0; c < cells; ++c) {
            print_value(t, band, c, read_cell(t, band, c));
        }
    }
}

static void print_errors(const tally *t)
{
    const size_t cells = murk_tally_cells(t->desc);
    const size_t values = cells * (size_t)t->scene->bands;
    /* Relative errors of values above 0, of which the median is shown. */
    double *share = malloc(values * sizeof *share);
    size_t lit = 0;
    for (int band = 0; share && band < t->scene->bands; ++band) {
        for (size_t c = 0; c < cells; ++c) {
            const murk_estimate e = read_cell(t, band, c);
            if (e.value > 0) {
                share[lit++] = e.standard_error / e.value;
            }
        }
    }
    if (share) {
        murk_sort(share, lit);
        murk_print("tally       %s: %zu values, %zu of them lit", t->desc->name,
                   values, lit);
        if (lit > 0) {
            const double percent = 100 * share[(lit - 1) / 2];
            murk_print(percent < 99.5
                           ? ", half of these known to %.2g %% or better"
                           : ", half of these known to %.0f %% or better",
                       percent);
        }
        murk_print("\n");
    }
    free(share);
}

void murk_print_tallies(const murk_session *session)
{
    const murk_tallies *tallies = session->traced->tallies;
    for (size_t i = 0; tallies && i < murk_tallies_count(tallies); ++i) {
        const tally t = tally_of(session, i);
        const size_t cells = murk_tally_cells(t.desc);
        const bool has_sums = t.scene->bands > 1 && cells <= PRINTED_VALUES_MAX;
        if (cells * (size_t)t.scene->bands <= PRINTED_VALUES_MAX) {
            print_values(&t);
        } else {
            print_errors(&t);
        }
        for (size_t c = 0; has_sums && c < cells; ++c) {
            print_value(&t, -1, c, read_sum(&t, c));
        }
    }
}

/* ---- check ---- */

void murk_json_tallies(cJSON *root, const murk_session *session)
{
    const murk_units units = murk_units_of(session->scene->units);
    cJSON *list = cJSON_AddArrayToObject(root, "tallies");
    for (size_t i = 0; i < session->scene->n_tallies; ++i) {
        const murk_tally_desc *d = &session->stage->tally[i];
        cJSON *item = murk_json_item(list);
        cJSON_AddStringToObject(item, "name", d->name);
        cJSON_AddStringToObject(item, "type", murk_tally_type_name(d->type));
        cJSON_AddNumberToObject(item, "cells", (double)murk_tally_cells(d));
        cJSON_AddStringToObject(item, "unit", unit_of(d, &units));
    }
}

void murk_print_asked_tallies(const murk_session *session)
{
    const murk_units units = murk_units_of(session->scene->units);
    for (size_t i = 0; i < session->scene->n_tallies; ++i) {
        const murk_tally_desc *d = &session->stage->tally[i];
        murk_print("tally       %s: ", d->name);
        /* The shape decides about bins and unit. */
        if (d->type == MURK_TALLY_PLANE) {
            int axes[2];
            murk_tally_axes(d, axes);
            murk_print("plane, %zu x %zu bins along %c and %c, %zu by angle, "
                       "forward and backward, %s\n",
                       d->bins[0], d->bins[1], "xyz"[axes[0]], "xyz"[axes[1]],
                       d -> angle_bins, units.power);
        } else if (d->type == MURK_TALLY_GRID) {
            const murk_field_box box = box_of(d);
            const murk_affine a = murk_field_to_world(&box);
            murk_print("grid, %zu x %zu x %zu cells of %.4g x %.4g x %.4g m, "
                       "%s\n",
                       d->size[0], d->size[1], d->size[2], a.matrix[0][0],
                       a.matrix[1][1], a.matrix[2][2], units.irradiance);
        } else {
            murk_print("sphere of %.4g m%s, %s\n", d->radius_m,
                       d->hemispheres ? ", upward and downward light apart"
                                      : "",
                       units.irradiance);
        }
    }
    if (session->scene->n_tallies > 0) {
        murk_print(
            "            %.3g MB for them and for writing them\n",
            murk_tallies_bytes(session->stage, session->settings.threads) /
                1e6);
    }
}

murk_status murk_session_add_all_of_light(murk_session *session,
                                          murk_error *err)
{
    murk_status status = murk_session_add_light(session, err);
    if (!status) {
        status = murk_session_add_ledger(
            session, "ledger.json",
            &(murk_ledger_results){session->traced, session->stage}, err);
    }
    return status ? status : murk_add_tallies(session, err);
}

void murk_print_trace(const void *of)
{
    murk_print_light(of);
    murk_print_tallies(of);
}
