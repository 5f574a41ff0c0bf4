/* Makes the fields of --export fields over the domain: extinction at the middle
 * of each voxel, and coverage, number of sensors, clarity and optical depth, as
 * placement would count a photon that is stored there (sensing/places_seen.h).
 */
#include "results/voxel_fields.h"

#include "base/number.h"
#include "plan/target_records.h"
#include "sensing/places_seen.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define VOXELS_USUAL 100000  /* some 46 along each edge */
#define VALUES_USUAL 400000  /* voxels times bands */
#define EDGE_MAX_M   1e9     /* limit on --voxel, beyond any scene */
#define NO_DEPTH     (-1.0F) /* no sightline; 0 is a valid depth */

/* ---- the box ---- */

/* Fills the box with voxels of at most this edge. Returns their number. */
static double fill_box(murk_field_box *out, double edge_m)
{
    const murk_vec3 all = murk_sub(out->box.max, out->box.min);
    const double edge[3] = {all.x, all.y, all.z};
    double voxels = 1;
    for (int k = 0; k < 3; ++k) {
        /* A side of the box that is a multiple of edge_m within rounding takes
         * no further voxel. */
        const double n = fmax(1, ceil(edge[k] / edge_m * (1 - 1e-12)));
        out->size[k] = n < 1e15 ? (size_t)n : (size_t)1e15;
        voxels *= n;
    }
    return voxels;
}

/* Fills the box with about the smallest edge (to 1 %) that makes at most so
 * many voxels. Returns the edge. */
static double edge_for(murk_field_box *out, double voxels)
{
    const murk_vec3 all = murk_sub(out->box.max, out->box.min);
    double edge_m = cbrt(all.x * all.y * all.z / voxels);
    while (!(fill_box(out, edge_m) <= voxels)) {
        edge_m *= 1.01;
    }
    return edge_m;
}

murk_status murk_fields_box(murk_field_box *out, const murk_session *session,
                            murk_error *err)
{
    const char *text = session->settings.voxel;
    const double bands = session->scene->bands;
    double edge_m = 0;
    *out = (murk_field_box){.box = session->stage->world.domain.box};
    /* Without an edge that is asked for, a usual number of voxels. */
    if (!text) {
        edge_for(out, fmin(VOXELS_USUAL, VALUES_USUAL / bands));
        return MURK_OK;
    }
    if (!murk_number_parse(text, &edge_m) ||
        !(edge_m > 0 && edge_m <= EDGE_MAX_M)) {
        return murk_fail(err, MURK_BAD_VALUE, "voxel_m",
                         "%.80s, must be more than 0 and at most %g m", text,
                         EDGE_MAX_M);
    }
    const double values = bands * fill_box(out, edge_m);
    if (!(values <= MURK_FIELDS_MAX)) {
        murk_field_box cut = *out;
        return murk_fail(err, MURK_BAD_VALUE, "voxel_m",
                         "%.80s m: %.3g voxels in the domain and its bands, "
                         "must be at most %d: %.2g m would do",
                         text, values, MURK_FIELDS_MAX,
                         edge_for(&cut, MURK_FIELDS_MAX / bands) * 1.05);
    }
    return MURK_OK;
}

/* ---- fields over the domain ---- */

typedef struct domain_fields {
    const murk_stage *stage;
    murk_voxel_fields list;
    murk_affine to_world;
    size_t voxels;
    int band; /* present one */
} domain_fields;

static murk_vec3 middle_of(const domain_fields *f, size_t voxel)
{
    const size_t *n = f->list.box.size;
    return murk_affine_point(&f->to_world,
                             murk_vec((double)(voxel % n[0]),
                                      (double)(voxel / n[0] % n[1]),
                                      (double)(voxel / n[0] / n[1])));
}

/* Adds a field of f->band. NULL when out of memory. */
static float *new_field(domain_fields *f, const murk_voxel_field *like)
{
    return murk_voxel_fields_add(&f->list, like, f->band);
}

static murk_status make_extinction(domain_fields *f, murk_error *err)
{
    static const murk_voxel_field like = {
        .name = "extinction",
        .unit = "1/m",
        .quantity = "extinction",
        .meaning = "of all media together, at the voxel's middle"};
    float *value = new_field(f, &like);
    for (size_t i = 0; value && i < f->voxels; ++i) {
        const murk_vec3 p = middle_of(f, i);
        const murk_inside inside =
            f->stage->boundary_meshes
                ? murk_boundary_meshes_at(f->stage->boundary_meshes, p)
                : 0;
        value[i] =
            (float)murk_media_extinction(f->stage->media, f->band, inside, p);
    }
    return value ? MURK_OK
                 : murk_no_memory(err, "exports", "for %zu voxels", f->voxels);
}

/* A stored photon in the middle of a voxel. */
static murk_photon record_of(const void *context, size_t voxel)
{
    const domain_fields *f = context;
    const murk_vec3 p = middle_of(f, voxel);
    return murk_photon_make(&(murk_photon_values){
        .position_m = p,
        .band = (uint8_t)f->band,
        .material = murk_target_medium(f->stage, f->band, p),
        .is_volume = true});
}

/* The fields of the sensors of a plan, in order. */
enum { COVERAGE, SENSORS, CLARITY, DEPTH, SEEN_FIELDS };

static const murk_voxel_field seen_fields[SEEN_FIELDS] = {
    [COVERAGE] = {.name = "coverage",
                  .unit = "1",
                  .quantity = "coverage",
                  .meaning =
                      "what a plan counts of a photon stored here: the clarity "
                      "of the clearest sensor, or of several as detection and "
                      "redundancy say"},
    [SENSORS] = {.name = "sensors",
                 .unit = "1",
                 .quantity = "number of sensors that see a photon stored here"},
    [CLARITY] = {.name = "clarity",
                 .unit = "1",
                 .quantity = "clarity of the clearest sensor"},
    [DEPTH] = {.name = "optical_depth",
               .unit = "1",
               .quantity = "optical depth",
               .meaning =
                   "of the media, the least of all straight open sightlines "
                   "from sensors within range and view; -1: none"}};

static murk_status make_seen(domain_fields *f, const murk_sight *sight,
                             const murk_pose *sensor, size_t n, murk_error *err)
{
    const murk_sight_desc *like = murk_sight_described(sight);
    const bool adds_up =
        like->redundancy > 1 || like->combining == MURK_COMBINE_INDEPENDENT;
    murk_place_seen *seen = malloc(f->voxels * sizeof *seen + 1);
    bool has_memory = seen != NULL;
    float *value[SEEN_FIELDS] = {NULL};
    for (int k = 0; has_memory && k < SEEN_FIELDS; ++k) {
        /* clarity differs from coverage only if several sensors combine */
        if (k != CLARITY || adds_up) {
            value[k] = new_field(f, &seen_fields[k]);
            has_memory = value[k] != NULL;
        }
    }
    const murk_places places = {.n = f->voxels,
                                .record = record_of,
                                .context = f,
                                .wants_depth = true,
                                .step = "fields"};
    const murk_status status =
        has_memory
            ? murk_places_see(seen, &places, sight, sensor, n, err)
            : murk_no_memory(err, "exports", "for %zu voxels", f->voxels);
    for (size_t i = 0; !status && i < f->voxels; ++i) {
        value[COVERAGE][i] = seen[i].worth;
        value[SENSORS][i] = (float)seen[i].sensors;
        value[DEPTH][i] = isfinite(seen[i].depth) ? seen[i].depth : NO_DEPTH;
        if (value[CLARITY]) {
            value[CLARITY][i] = seen[i].clarity;
        }
    }
    free(seen);
    return status;
}

/* Adds a .vdb of the fields whose names begin with one of begins[] (NULL at the
 * end) and "_". Adds none if there is no such field. */
static void add_vdb(murk_session *session, const domain_fields *f,
                    const char *name, const char *const *begins,
                    murk_field_density density, murk_error *late)
{
    murk_voxel_fields picked = {f->list.scene, f->list.box, .n = 0};
    for (; *begins; ++begins) {
        for (size_t i = 0; i < f->list.n; ++i) {
            const murk_voxel_field *field = &f->list.field[i];
            const size_t length = strlen(*begins);
            if (strncmp(field->name, *begins, length) == 0 &&
                field->name[length] == '_') {
                picked.field[picked.n++] = *field;
            }
        }
    }
    if (picked.n > 0) {
        (void)murk_field_add_vdb(&session->results, name, &picked, density,
                                 late);
    }
}

static void add_files(murk_session *session, const domain_fields *f,
                      murk_error *late)
{
    static const char *const extinction[] = {"extinction", NULL};
    static const char *const coverage[] = {"coverage", "sensors", "clarity",
                                           NULL};
    static const char *const depth[] = {"optical_depth", NULL};
    add_vdb(session, f, "extinction.vdb", extinction, MURK_DENSITY_EQUAL, late);
    add_vdb(session, f, "coverage.vdb", coverage, MURK_DENSITY_SCALED, late);
    add_vdb(session, f, "optical_depth.vdb", depth, MURK_DENSITY_SCALED, late);
    if (f->list.n > 0) {
        (void)murk_field_add_vti(&session->results, "fields.vti", &f->list,
                                 late);
    }
}

void murk_fields_add(murk_session *session, const murk_sight *sight,
                     const murk_pose *sensor, size_t n, murk_error *late)
{
    domain_fields f = {.stage = session->stage, .list.scene = session->scene};
    murk_error why = {0};
    murk_status status = murk_fields_box(&f.list.box, session, &why);
    f.to_world = murk_field_to_world(&f.list.box);
    f.voxels = murk_field_voxels(&f.list.box);
    for (f.band = 0; !status && f.band < session->scene->bands; ++f.band) {
        if (sight) {
            status = make_seen(&f, sight, sensor, n, &why);
        }
        if (!status && murk_media_any(session->stage->media)) {
            status = make_extinction(&f, &why);
        }
    }
    if (status) {
        (void)murk_fail(late, status, "exports", "fields: %s", why.text);
    } else {
        add_files(session, &f, late);
    }
    murk_voxel_fields_release(&f.list);
}
