/* Writes surfaces.ply and surfaces.vtp: the pieces of the surfaces
 * (results/pieces.h) with irradiance, error, number of photons and, with
 * sensors, coverage. Colours follow a perceptually uniform ramp. */
#include "results/surfaces.h"

#include "base/number.h"
#include "results/lit_pieces.h"
#include "results/mesh_file.h"
#include "results/vtk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* If --voxel is not given: stored photons for each piece in the mean, and the
 * least and the largest limit on the number of pieces beyond one for each
 * triangle or octant of a sphere. */
#define PHOTONS_USUAL 5
#define PIECES_MIN    5000
#define PIECES_USUAL  100000

/* The brightest colour is that of this multiple of the mean irradiance,
 * weighted by area. */
#define BRIGHT 2.5

typedef struct surfaces {
    const murk_session *session;
    const murk_lit_pieces *lit;
    uint32_t *piece;   /* [n]; numbers of the pieces that are written */
    uint8_t *material; /* [n] */
    size_t n;
    double bright_w_per_m2;
    char *materials; /* names of the materials by number, as text */
    char lost[24];
} surfaces;

static double usual_pieces(const murk_traced *traced)
{
    const double photons = (double)murk_photon_map_count(traced->surface);
    return fmin(PIECES_USUAL, fmax(PIECES_MIN, photons / PHOTONS_USUAL));
}

static murk_status edge_asked(double *edge_m, const murk_session *session,
                              murk_error *err)
{
    const char *text = session->settings.voxel;
    *edge_m = 0;
    return !text || (murk_number_parse(text, edge_m) && *edge_m > 0)
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, "voxel_m",
                           "%.80s, must be more than 0 m", text);
}

murk_status murk_surfaces_check(const murk_session *session, murk_error *err)
{
    murk_pieces pieces = {0};
    double edge_m = 0;
    murk_status status = edge_asked(&edge_m, session, err);
    if (!status && edge_m > 0) {
        status = murk_pieces_create(&pieces, session->stage->surfaces, edge_m,
                                    0, "voxel_m", err);
    }
    murk_pieces_release(&pieces);
    return status;
}

/* ---- colours ---- */

/* Colour of t from 0 to 1: from dark violet to yellow, with rising lightness,
 * so that colour-blind eyes can tell the order, too. */
static void ramp(double t, uint8_t rgb[3])
{
    static const double stop[5][3] = {{68, 1, 84},
                                      {59, 82, 139},
                                      {33, 145, 140},
                                      {94, 201, 98},
                                      {253, 231, 37}};
    const double at = fmin(fmax(t, 0), 1) * 4;
    const int k = at < 3 ? (int)at : 3;
    for (int c = 0; c < 3; ++c) {
        rgb[c] = (uint8_t)(stop[k][c] +
                           (at - k) * (stop[k + 1][c] - stop[k][c]) + 0.5);
    }
}

static void color_of(const surfaces *s, uint32_t piece, uint8_t rgb[3])
{
    const bool is_seen = s->lit->is_seen;
    const murk_lit_piece *lit = &s->lit->piece[piece];
    if (is_seen ? isnan(lit->coverage) : lit->photons == 0) {
        rgb[0] = rgb[1] = rgb[2] = 110; /* grey: nothing is known */
    } else {
        ramp(is_seen ? (double)lit->coverage
                     : (double)lit->irradiance / s->bright_w_per_m2,
             rgb);
    }
}

/* ---- values ---- */

/* Columns of a face. The last three are written with sensors only. */
static const murk_mesh_column columns[] = {
    MURK_MESH_COLOR,
    {"irradiance", MURK_MESH_FLOAT, .components = 1},
    {"irradiance_error", MURK_MESH_FLOAT, .components = 1},
    {"photons", MURK_MESH_UINT32, .components = 1},
    {"material", MURK_MESH_UINT8, .components = 1},
    {"coverage", MURK_MESH_FLOAT, .components = 1},
    {"clarity", MURK_MESH_FLOAT, .components = 1},
    {"sensors", MURK_MESH_UINT16, .components = 1}};
#define COLUMNS         (sizeof columns / sizeof *columns)
#define WITHOUT_SENSORS 5

/* The values of a face, in the order of the columns. */
typedef struct __attribute__((packed)) record {
    uint8_t color[3];
    float irradiance, error;
    uint32_t photons;
    uint8_t material;
    float coverage, clarity;
    uint16_t sensors;
} record;

static murk_vec3 corner_of(const void *context, size_t i)
{
    const surfaces *s = context;
    return murk_piece_of(s->lit->pieces, s->piece[i / 3]).corner[i % 3];
}

static void put_record(const void *context, size_t i, void *out)
{
    const surfaces *s = context;
    const murk_lit_piece *lit = &s->lit->piece[s->piece[i]];
    record r = {.irradiance = lit->irradiance,
                .error = lit->error,
                .photons = lit->photons,
                .material = s->material[i],
                .coverage = lit->coverage,
                .clarity = lit->clarity,
                .sensors = lit->sensors};
    color_of(s, s->piece[i], r.color);
    memcpy(out, &r, sizeof r);
}

static const char *const meanings[] = {
    "irradiance_means",
    "W/m2 of all bands, what arrives on both sides together, by the photon "
    "map; irradiance_error: its standard error",
    "photons_means",
    "stored photons on the piece",
    "coverage_means",
    "0..1, what the plan sees of the weight of what it looks at on the piece; "
    "NaN: nothing lies there",
    "clarity_means",
    "0..1, what the plan would count of a photon in the piece's middle",
    "sensors_means",
    "number of sensors that see the piece's middle, from either side",
    NULL};

/* Notes: the meanings of the columns that are written, the number of photons on
 * no piece, and the materials. */
static void meanings_of(const surfaces *s, const char *note[16])
{
    size_t n = 0;
    for (size_t i = 0; meanings[i] && (s->lit->is_seen || i < 4); ++i) {
        note[n++] = meanings[i];
    }
    note[n++] = "photons_on_no_piece";
    note[n++] = s->lost;
    note[n++] = "materials";
    note[n++] = s->materials;
    note[n] = NULL;
}

/* ---- all ---- */

/* Chooses the pieces in the domain, and the brightest irradiance from their
 * mean. */
static void choose(surfaces *s)
{
    const murk_pieces *pieces = s->lit->pieces;
    double area_m2 = 0, w = 0;
    for (size_t i = 0; i < pieces->n; ++i) {
        const murk_piece piece = murk_piece_of(pieces, i);
        if (murk_piece_is_within(&piece, &s->session->stage->world.domain)) {
            s->piece[s->n] = (uint32_t)i;
            s->material[s->n++] = piece.material;
            area_m2 += piece.area_m2;
            w += (double)s->lit->piece[i].irradiance * piece.area_m2;
        }
    }
    s->bright_w_per_m2 = w > 0 ? BRIGHT * w / area_m2 : 1;
}

static void add_files(murk_session *session, const murk_lit_pieces *lit,
                      murk_error *late)
{
    /* the order of arrays in surfaces.vtp is that of earlier versions */
    static const uint8_t order[] = {4, 3, 2, 1, 0};
    static const uint8_t with_sensors[] = {4, 3, 2, 1, 7, 6, 5, 0};
    const murk_scene_desc *scene = session->scene;
    surfaces s = {.session = session,
                  .lit = lit,
                  .piece = malloc(lit->pieces->n * sizeof *s.piece + 1),
                  .material = malloc(lit->pieces->n + 1),
                  .materials = murk_numbered_names(
                      scene->n_materials ? scene->materials[0].name : "",
                      scene->n_materials, sizeof *scene->materials)};
    if (!s.piece || !s.material || !s.materials) {
        (void)murk_fail(late, MURK_NO_MEMORY, "exports",
                        "surfaces: no memory for %zu pieces", lit->pieces->n);
    } else {
        /* Both files have the same pieces. */
        const char *note[16];
        choose(&s);
        snprintf(s.lost, sizeof s.lost, "%llu", (unsigned long long)lit->lost);
        meanings_of(&s, note);
        const murk_mesh_export mesh = {
            .name = "surfaces",
            .comment = "comment murk surfaces, in pieces\n",
            .scene = scene,
            .notes = note,
            .points = 3 * s.n,
            .has_triangles = true,
            .column = columns,
            .columns = lit->is_seen ? COLUMNS : WITHOUT_SENSORS,
            .order = lit->is_seen ? with_sensors : order,
            .position = corner_of,
            .record = put_record,
            .context = &s};
        murk_mesh_add(&session->results, &mesh, late);
    }
    free(s.piece);
    free(s.material);
    free(s.materials);
}

void murk_surfaces_add(murk_session *session, murk_sight *sight,
                       const murk_pose *sensor, size_t n, murk_error *late)
{
    const murk_stage *stage = session->stage;
    murk_pieces pieces = {0};
    murk_lit_pieces lit = {0};
    murk_error why = {0};
    double edge_m = 0;
    /* Cut the surfaces, then compute irradiance and coverage of the pieces. */
    murk_status status = edge_asked(&edge_m, session, &why);
    if (!status) {
        status =
            murk_pieces_create(&pieces, stage->surfaces, edge_m,
                               usual_pieces(session->traced), "voxel_m", &why);
    }
    if (!status) {
        status =
            murk_lit_pieces_make(&lit, &pieces, &stage->world.domain,
                                 session->traced, session->scene->bands, sight,
                                 sensor, n, session->settings.threads, &why);
    }
    if (status) {
        (void)murk_fail(late, status, "exports", "surfaces: %s", why.text);
    } else {
        add_files(session, &lit, late);
    }
    murk_lit_pieces_release(&lit);
    murk_pieces_release(&pieces);
}
