/* Photon density beside the fluence rate of grid tallies. */
#include "results/voxel_fields.h"

#include "base/log.h"
#include "world/scene_tallies.h"
#include "world/units.h"

#include <stdlib.h>

#define FILE_SIZE (MURK_TALLY_NAME_SIZE + 16)

/* A tally's values in one unit, all bands. */
typedef struct values {
    const murk_session *session;
    size_t tally, cells;
    double packet[MURK_SOURCES_MAX * MURK_BANDS_MAX];
} values;

static values values_in(murk_quantity quantity, const murk_session *session,
                        size_t tally, size_t cells)
{
    values v = {.session = session, .tally = tally, .cells = cells};
    murk_units_packets(v.packet, quantity, session->stage,
                       session->traced->packet_w);
    return v;
}

static murk_estimate read_cell(const values *v, int band, size_t cell)
{
    const murk_traced *traced = v->session->traced;
    return murk_tallies_read(traced->tallies, v->tally, band, cell,
                             traced->ledger->emitted, v->packet);
}

/* Fields under way, each with values of its own. */
typedef struct fields {
    murk_voxel_field field[4 * MURK_BANDS_MAX + 2];
    size_t n;
    const murk_scene_desc *scene;
} fields;

static float *new_field(fields *f, const murk_voxel_field *like, int band,
                        size_t cells)
{
    float *value = malloc(cells * sizeof *value + 1);
    if (value) {
        murk_voxel_field *field = &f->field[f->n++];
        *field = *like;
        field->band = band;
        field->value = value;
        if (band >= 0) {
            murk_field_name_of(field->name, like->name,
                               f->scene->band_nm[band]);
        }
    }
    return value;
}

static void release(fields *f)
{
    for (size_t i = 0; i < f->n; ++i) {
        free((void *)(uintptr_t)f->field[i].value);
    }
    f->n = 0;
}

/* A field of one band (-1: the sum of all) and one of its errors. */
static bool put(fields *f, const values *v, int band,
                const murk_voxel_field like[2])
{
    float *value = new_field(f, &like[0], band, v->cells);
    float *error = value ? new_field(f, &like[1], band, v->cells) : NULL;
    for (size_t c = 0; error && c < v->cells; ++c) {
        murk_estimate e[MURK_BANDS_MAX];
        for (int b = 0; band < 0 && b < f->scene->bands; ++b) {
            e[b] = read_cell(v, b, c);
        }
        const murk_estimate cell = band < 0 ? murk_units_sum(e, f->scene->bands)
                                            : read_cell(v, band, c);
        value[c] = (float)cell.value;
        error[c] = (float)cell.standard_error;
    }
    return error != NULL;
}

static bool put_bands(fields *f, const values *v,
                      const murk_voxel_field like[2])
{
    bool has_room = true;
    for (int band = 0; has_room && band < f->scene->bands; ++band) {
        has_room = put(f, v, band, like);
    }
    return has_room;
}

static bool put_density(fields *f, const values *v)
{
    static const murk_voxel_field like[2] = {
        {.name = "photon_density",
         .unit = "1/s/m2",
         .quantity = "photon density",
         .meaning = "scalar irradiance, photons that cross a small sphere per "
                    "second and m2 of its cross-section, mean over the voxel"},
        {.name = "photon_density_error",
         .unit = "1/s/m2",
         .quantity = "standard error of the photon density"}};
    return (f->scene->bands == 1 || put(f, v, -1, like)) &&
           put_bands(f, v, like);
}

static bool put_fluence(fields *f, const values *v)
{
    const char *unit = murk_units_of(f->scene->units).irradiance;
    const murk_voxel_field like[2] = {
        {.name = "fluence", .unit = unit, .quantity = "fluence rate"},
        {.name = "fluence_error",
         .unit = unit,
         .quantity = "standard error of the fluence rate"}};
    return put_bands(f, v, like);
}

static void add_tally(murk_session *session, size_t i, murk_error *late)
{
    const murk_tally_desc *d = murk_tallies_desc(session->traced->tallies, i);
    const size_t cells = murk_tally_cells(d);
    const murk_field_box box = {.box = d->box,
                                .size = {d->size[0], d->size[1], d->size[2]}};
    fields *f = calloc(1, sizeof *f);
    bool has_room = f != NULL;
    if (has_room) {
        f->scene = session->scene;
        const values photons = values_in(MURK_PHOTONS, session, i, cells);
        const values own = values_in(session->scene->units, session, i, cells);
        char name[FILE_SIZE];
        has_room = put_density(f, &photons);
        if (has_room) {
            snprintf(name, sizeof name, "%s_photons.vdb", d->name);
            (void)murk_field_add_vdb(&session->results, name, session->scene,
                                     &box, f->field, f->n, MURK_FIELD_SCALED,
                                     late);
            has_room = put_fluence(f, &own);
        }
        if (has_room) {
            snprintf(name, sizeof name, "%s.vti", d->name);
            (void)murk_field_add_vti(&session->results, name, session->scene,
                                     &box, f->field, f->n, late);
        }
        release(f);
    }
    free(f);
    if (!has_room) {
        (void)murk_fail(late, MURK_NO_MEMORY, d->name,
                        "no memory for the fields of %zu cells", cells);
    }
}

void murk_fields_add_tallies(murk_session *session, murk_error *late)
{
    const murk_tallies *tallies = session->traced->tallies;
    size_t grids = 0;
    for (size_t i = 0; tallies && i < murk_tallies_count(tallies); ++i) {
        if (murk_tallies_desc(tallies, i)->type == MURK_TALLY_GRID) {
            add_tally(session, i, late);
            ++grids;
        }
    }
    if (grids == 0) {
        murk_note("--export", "fields: no fluence rate and photon density, "
                              "which a tally of type grid measures");
    }
}
