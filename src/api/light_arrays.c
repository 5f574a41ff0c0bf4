/* Arrays of light: the fields of records, and the values of tallies. A field
 * that records store in the form of murk_light_array() (murk.h) is a view of
 * the records, with the stride of a record. A packed field, and the positions
 * of a scene far from 0, are copied once for each map or batch. */
#include "api/handles.h"

#include <stdio.h>
#include <string.h>

/* ---- records ---- */

/* A field that records store in the form of murk_light_array(). */
typedef struct stored_field {
    const char *name;
    size_t offset, columns; /* columns 0: one number a record */
    murk_type type;
} stored_field;

static const stored_field stored_fields[] = {
    {"position_m", offsetof(murk_photon, position_m), 3, MURK_TYPE_FLOAT32},
    {"power_w", offsetof(murk_photon, power_w), 0, MURK_TYPE_FLOAT32},
    {"emitted", offsetof(murk_photon, emitted), 0, MURK_TYPE_UINT32},
    {"band", offsetof(murk_photon, band), 0, MURK_TYPE_UINT8},
    {"light", offsetof(murk_photon, light), 0, MURK_TYPE_UINT8},
    {"material", offsetof(murk_photon, material), 0, MURK_TYPE_UINT8}};

/* A packed field: unpack() writes the value of the record p to element i of
 * `to`. */
typedef struct packed_field {
    const char *name;
    size_t columns;
    murk_type type;
    void (*unpack)(void *to, size_t i, const murk_photon *p);
} packed_field;

static void put_vector(void *to, size_t i, murk_vec3 v)
{
    float *out = (float *)to + 3 * i;
    out[0] = (float)v.x;
    out[1] = (float)v.y;
    out[2] = (float)v.z;
}

static void unpack_direction(void *to, size_t i, const murk_photon *p)
{
    put_vector(to, i, murk_photon_direction(p));
}

static void unpack_normal(void *to, size_t i, const murk_photon *p)
{
    put_vector(to, i, murk_photon_normal(p));
}

static void unpack_class(void *to, size_t i, const murk_photon *p)
{
    ((uint8_t *)to)[i] = (uint8_t)murk_photon_class(p);
}

static const packed_field packed_fields[] = {
    {"direction", 3, MURK_TYPE_FLOAT32, unpack_direction},
    {"normal", 3, MURK_TYPE_FLOAT32, unpack_normal},
    {"event_class", 0, MURK_TYPE_UINT8, unpack_class}};

/* Records of one map, of a light or of a batch, and the list of the arrays that
 * are made of these records. */
typedef struct record_set {
    const murk_photon *photon;
    size_t n;
    murk_map map;
    const murk_scene_desc *scene;
    murk_made **made;
} record_set;

static const murk_photon_map *map_of(const murk_light *light, murk_map map)
{
    const murk_traced *t = light->session.traced;
    return map == MURK_MAP_VOLUME ? t->volume : t->surface;
}

/* Records of a scene far from 0 have positions relative to a local origin. This
 * function copies the positions as doubles in the coordinates of the scene
 * file, unless there is a copy already. */
static murk_status far_positions(const record_set *set, murk_array *view,
                                 murk_error *err)
{
    char name[64];
    const size_t shape[2] = {set->n, 3};
    snprintf(name, sizeof name, "position_m %d", (int)set->map);
    double *made = murk_made_find(*set->made, name);
    if (!made) {
        made = murk_made_add(set->made, name, set->n * 3 * sizeof *made, err);
        for (size_t i = 0; made && i < set->n; ++i) {
            const murk_vec3 p =
                murk_scene_user(set->scene, murk_photon_place(&set->photon[i]));
            made[3 * i] = p.x;
            made[3 * i + 1] = p.y;
            made[3 * i + 2] = p.z;
        }
    }
    return made ? murk_array_fill(view, made, MURK_TYPE_FLOAT64, 2, shape, true,
                                  err)
                : MURK_NO_MEMORY;
}

static murk_status unpacked(const record_set *set, const packed_field *field,
                            murk_array *view, murk_error *err)
{
    char name[64];
    const size_t shape[2] = {set->n, field->columns};
    const size_t columns = field->columns ? field->columns : 1;
    snprintf(name, sizeof name, "%s %d", field->name, (int)set->map);
    void *made = murk_made_find(*set->made, name);
    if (!made) {
        made =
            murk_made_add(set->made, name,
                          set->n * columns * murk_type_bytes(field->type), err);
        for (size_t i = 0; made && i < set->n; ++i) {
            field->unpack(made, i, &set->photon[i]);
        }
    }
    return made ? murk_array_fill(view, made, field->type,
                                  field->columns ? 2 : 1, shape, true, err)
                : MURK_NO_MEMORY;
}

static murk_status array_of(const record_set *set, const char *field,
                            murk_array *view, murk_error *err)
{
    const murk_vec3 origin = set->scene->origin;
    const bool is_far = origin.x != 0 || origin.y != 0 || origin.z != 0;
    if (is_far && strcmp(field, "position_m") == 0) {
        return far_positions(set, view, err);
    }
    /* A view into the records. */
    for (size_t k = 0; k < sizeof stored_fields / sizeof *stored_fields; ++k) {
        const stored_field *f = &stored_fields[k];
        const size_t shape[2] = {set->n, f->columns};
        if (strcmp(f->name, field) != 0) {
            continue;
        }
        const char *first = (const char *)set->photon;
        const murk_status status =
            murk_array_fill(view, first ? first + f->offset : NULL, f->type,
                            f->columns ? 2 : 1, shape, false, err);
        if (!status) {
            view->stride[0] = (ptrdiff_t)sizeof(murk_photon);
        }
        return status;
    }
    for (size_t k = 0; k < sizeof packed_fields / sizeof *packed_fields; ++k) {
        if (strcmp(packed_fields[k].name, field) == 0) {
            return unpacked(set, &packed_fields[k], view, err);
        }
    }
    return murk_fail(err, MURK_BAD_VALUE, "",
                     "%s is no field of records: must be position_m, power_w, "
                     "emitted, band, light, material, direction, normal or "
                     "event_class",
                     field);
}

size_t murk_light_count(const murk_light *light, murk_map map)
{
    return light ? murk_photon_map_count(map_of(light, map)) : 0;
}

murk_status murk_light_array(murk_light *light, murk_map map, const char *field,
                             murk_array *view, murk_error *error)
{
    if (!light || !field) {
        return murk_call_refuse(error, "light or field is NULL");
    }
    const murk_photon_map *records = map_of(light, map);
    const record_set set = {.photon = murk_photon_map_photons(records),
                            .n = murk_photon_map_count(records),
                            .map = map,
                            .scene = light->session.scene,
                            .made = &light->made};
    murk_call call = murk_call_begin(light->world->context, NULL, error);
    return murk_call_end(&call, array_of(&set, field, view, &call.failure));
}

/* ---- batches ---- */

size_t murk_batch_count(const murk_batch *batch, murk_map map)
{
    return !batch                   ? 0
           : map == MURK_MAP_VOLUME ? batch->records->n_volume
                                    : batch->records->n_surface;
}

/* This function begins no murk_call, because the caller's receiver of batches
 * calls it within the murk_call of murk_light_stream(). */
murk_status murk_batch_array(murk_batch *batch, murk_map map, const char *field,
                             murk_array *view, murk_error *error)
{
    if (!batch || !field) {
        return murk_call_refuse(error, "batch or field is NULL");
    }
    const record_set set = {.photon = map == MURK_MAP_VOLUME
                                          ? batch->records->volume
                                          : batch->records->surface,
                            .n = murk_batch_count(batch, map),
                            .map = map,
                            .scene = batch->scene,
                            .made = &batch->made};
    murk_error failure = {0};
    const murk_status status = array_of(&set, field, view, &failure);
    if (status) {
        murk_call_report(error, &failure);
    }
    return status;
}

uint64_t murk_batch_number(const murk_batch *batch)
{
    return batch ? batch->records->number : 0;
}

void murk_batch_photons(const murk_batch *batch, uint64_t photons[2])
{
    if (batch && photons) {
        photons[0] = batch->records->first;
        photons[1] = batch->records->last;
    }
}

/* ---- tallies ---- */

/* Sets shape[] to the lengths of all axes of a tally but that of the bands, the
 * fastest axis in memory last, and returns the number of these axes. */
static int shape_of(const murk_tally_desc *desc, size_t shape[4])
{
    switch (desc->type) {
    case MURK_TALLY_PLANE:
        shape[0] = murk_tally_directions(desc);
        shape[1] = desc->angle_bins;
        shape[2] = desc->bins[1];
        shape[3] = desc->bins[0];
        return 4;
    case MURK_TALLY_GRID:
        for (int axis = 0; axis < 3; ++axis) {
            shape[axis] = desc->size[2 - axis];
        }
        return 3;
    case MURK_TALLY_SPHERE:
        break;
    }
    shape[0] = murk_tally_directions(desc);
    return 1;
}

/* Fills a view of a tally. In each band the cells lie in memory with the first
 * index fastest, so the order of all axes but that of the bands is reversed. */
static murk_status fill_tally(murk_array *view, const double *values, int bands,
                              const murk_tally_desc *desc, murk_error *err)
{
    size_t shape[5] = {(size_t)bands};
    const int n = shape_of(desc, shape + 1);
    const murk_status status = murk_array_fill(view, values, MURK_TYPE_FLOAT64,
                                               n + 1, shape, true, err);
    for (int k = 0; !status && k < n / 2; ++k) {
        const int a = 1 + k, b = n - k;
        const size_t length = view->shape[a];
        const ptrdiff_t stride = view->stride[a];
        view->shape[a] = view->shape[b];
        view->stride[a] = view->stride[b];
        view->shape[b] = length;
        view->stride[b] = stride;
    }
    return status;
}

/* Returns the values of all cells, band by band, followed by their standard
 * errors in the same order. The light owns the array, which is made at the
 * first call for the tally. NULL when out of memory. */
static double *read_tally(murk_light *light, size_t tally, murk_error *err)
{
    const murk_traced *t = light->session.traced;
    const murk_tally_desc *desc = murk_tallies_desc(t->tallies, tally);
    const size_t bands = (size_t)light->session.scene->bands,
                 cells = murk_tally_cells(desc);
    char name[64];
    snprintf(name, sizeof name, "tally %zu", tally);
    double *made = murk_made_find(light->made, name);
    if (made) {
        return made;
    }
    made = murk_made_add(&light->made, name, 2 * bands * cells * sizeof *made,
                         err);
    for (size_t i = 0; made && i < bands * cells; ++i) {
        const murk_estimate e =
            murk_tallies_read(t->tallies, tally, (int)(i / cells), i % cells,
                              t->ledger->emitted, t->packet_w);
        made[i] = e.value;
        made[bands * cells + i] = e.standard_error;
    }
    return made;
}

static murk_status tally_of(murk_light *light, const char *name,
                            murk_array *values, murk_array *errors,
                            murk_error *err)
{
    const murk_tallies *tallies = light->session.traced->tallies;
    const size_t n = tallies ? murk_tallies_count(tallies) : 0;
    /* Find the tally by its name. */
    size_t i = 0;
    while (i < n && strcmp(murk_tallies_desc(tallies, i)->name, name) != 0) {
        ++i;
    }
    if (i == n) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         tallies ? "the scene has no tally %s"
                                 : "the light has no tallies: the scene has "
                                   "none, or the light was read from a file",
                         name);
    }
    const double *made = read_tally(light, i, err);
    if (!made) {
        return MURK_NO_MEMORY;
    }
    const murk_tally_desc *desc = murk_tallies_desc(tallies, i);
    const int bands = light->session.scene->bands;
    murk_status status =
        values ? fill_tally(values, made, bands, desc, err) : MURK_OK;
    if (!status && errors) {
        status =
            fill_tally(errors, made + (size_t)bands * murk_tally_cells(desc),
                       bands, desc, err);
    }
    return status;
}

murk_status murk_light_tally(murk_light *light, const char *name,
                             murk_array *values, murk_array *errors,
                             murk_error *error)
{
    if (!light || !name) {
        return murk_call_refuse(error, "light or name is NULL");
    }
    murk_call call = murk_call_begin(light->world->context, NULL, error);
    return murk_call_end(&call,
                         tally_of(light, name, values, errors, &call.failure));
}
