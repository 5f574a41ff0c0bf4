/* Writes surfaces.ply and surfaces.vtp: the pieces of the surfaces
 * (results/pieces.h) with irradiance, error, number of photons and, with
 * sensors, coverage. Colours follow a perceptually uniform ramp. */
#include "results/surfaces.h"

#include "base/number.h"
#include "results/lit_pieces.h"
#include "results/vtk.h"
#include "scene/places.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ARRAYS_MAX (COLUMNS + 1) /* and the end of the list */

#define RECORD_MAX (MURK_PLACE_BYTES_MAX + 3) /* bytes of a vertex */

/* Where no size is asked for: so many stored photons to a piece in the mean,
 * and so many pieces. */
#define PHOTONS_USUAL 5
#define PIECES_MIN    5000
#define PIECES_USUAL  100000

/* Colours end at this multiple of the mean irradiance, by area. */
#define BRIGHT 2.5

typedef struct surfaces {
    const murk_session *session;
    const murk_lit_pieces *lit;
    uint32_t *piece; /* [n] that are written */
    size_t n;
    double bright_w_per_m2;
    char *materials; /* names by number */
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
               : murk_fail(err, MURK_BAD_VALUE, "--voxel",
                           "%.80s, must be more than 0 m", text);
}

murk_status murk_surfaces_check(const murk_session *session, murk_error *err)
{
    murk_pieces pieces = {0};
    double edge_m = 0;
    murk_status status = edge_asked(&edge_m, session, err);
    if (!status && edge_m > 0) {
        status = murk_pieces_create(&pieces, session->stage->surfaces, edge_m,
                                    0, "--voxel", err);
    }
    murk_pieces_release(&pieces);
    return status;
}

/* ---- colours ---- */

/* Dark to bright by lightness, in steps of hue that all eyes tell apart. */
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
    const murk_lit_pieces *lit = s->lit;
    if (lit->is_seen ? isnan(lit->coverage[piece]) : lit->photons[piece] == 0) {
        rgb[0] = rgb[1] = rgb[2] = 110;
    } else {
        ramp(lit->is_seen ? (double)lit->coverage[piece]
                          : (double)lit->irradiance[piece] / s->bright_w_per_m2,
             rgb);
    }
}

/* ---- values ---- */

static void put_corner(const void *context, size_t i, void *item)
{
    const surfaces *s = context;
    const murk_piece piece = murk_piece_of(s->lit->pieces, s->piece[i / 3]);
    const murk_vec3 at = piece.corner[i % 3];
    murk_place_put(s->session->scene, at, item);
}

static void put_color(const void *context, size_t i, void *item)
{
    const surfaces *s = context;
    color_of(s, s->piece[i], item);
}

static void put_irradiance(const void *context, size_t i, void *item)
{
    const surfaces *s = context;
    memcpy(item, &s->lit->irradiance[s->piece[i]], 4);
}

static void put_error(const void *context, size_t i, void *item)
{
    const surfaces *s = context;
    memcpy(item, &s->lit->error[s->piece[i]], 4);
}

static void put_photons(const void *context, size_t i, void *item)
{
    const surfaces *s = context;
    memcpy(item, &s->lit->photons[s->piece[i]], 4);
}

static void put_material(const void *context, size_t i, void *item)
{
    const surfaces *s = context;
    *(uint8_t *)item = murk_piece_of(s->lit->pieces, s->piece[i]).material;
}

static void put_coverage(const void *context, size_t i, void *item)
{
    const surfaces *s = context;
    memcpy(item, &s->lit->coverage[s->piece[i]], 4);
}

static void put_clarity(const void *context, size_t i, void *item)
{
    const surfaces *s = context;
    memcpy(item, &s->lit->clarity[s->piece[i]], 4);
}

static void put_sensors(const void *context, size_t i, void *item)
{
    const surfaces *s = context;
    memcpy(item, &s->lit->sensors[s->piece[i]], 2);
}

/* What faces have beside their colour; the last three with sensors only. */
typedef struct column {
    murk_vtk_array array;
    const char *ply;
} column;
static const column columns[] = {
    {{"irradiance", "Float32", 1, 4, put_irradiance}, "float"},
    {{"irradiance_error", "Float32", 1, 4, put_error}, "float"},
    {{"photons", "UInt32", 1, 4, put_photons}, "uint"},
    {{"material", "UInt8", 1, 1, put_material}, "uchar"},
    {{"coverage", "Float32", 1, 4, put_coverage}, "float"},
    {{"clarity", "Float32", 1, 4, put_clarity}, "float"},
    {{"sensors", "UInt16", 1, 2, put_sensors}, "ushort"}};
#define COLUMNS         (sizeof columns / sizeof *columns)
#define WITHOUT_SENSORS 4

static size_t columns_of(const surfaces *s)
{
    return s->lit->is_seen ? COLUMNS : WITHOUT_SENSORS;
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

/* Of those that there are, and the materials. */
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

/* ---- files ---- */

static void put_header(FILE *to, const surfaces *s)
{
    const char *note[16];
    fputs("ply\nformat binary_little_endian 1.0\n"
          "comment murk surfaces, in pieces\n",
          to);
    murk_ply_put_facts(to, s->session->scene);
    meanings_of(s, note);
    for (const char *const *k = note; k[0]; k += 2) {
        murk_ply_put_comment(to, k[0], k[1]);
    }
    fprintf(to,
            "element vertex %zu\n%s"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "element face %zu\n"
            "property list uchar int vertex_indices\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n",
            3 * s->n, murk_place_ply(s->session->scene), s->n);
    for (size_t k = 0; k < columns_of(s); ++k) {
        fprintf(to, "property %s %s\n", columns[k].ply, columns[k].array.name);
    }
    fputs("end_header\n", to);
}

static void put_vertices(FILE *to, const surfaces *s)
{
    for (size_t i = 0; i < s->n; ++i) {
        unsigned char bytes[RECORD_MAX];
        const size_t place = murk_place_bytes(s->session->scene);
        put_color(s, i, bytes + place);
        for (size_t c = 0; c < 3; ++c) {
            put_corner(s, 3 * i + c, bytes);
            (void)fwrite(bytes, 1, place + 3, to); /* commit asks ferror */
        }
    }
}

static void put_faces(FILE *to, const surfaces *s)
{
    for (size_t i = 0; i < s->n; ++i) {
        unsigned char bytes[64] = {3};
        size_t used = 1;
        for (size_t c = 0; c < 3; ++c, used += 4) {
            const uint32_t vertex = (uint32_t)(3 * i + c);
            memcpy(bytes + used, &vertex, 4);
        }
        put_color(s, i, bytes + used);
        used += 3;
        for (size_t k = 0; k < columns_of(s); ++k) {
            columns[k].array.put(s, i, bytes + used);
            used += columns[k].array.item_bytes;
        }
        (void)fwrite(bytes, 1, used, to);
    }
}

static void write_ply(FILE *to, const void *context)
{
    const surfaces *s = context;
    put_header(to, s);
    put_vertices(to, s);
    put_faces(to, s);
}

static murk_status write_vtp(const char *path, const void *context,
                             murk_error *err)
{
    const surfaces *s = context;
    const char *note[16];
    murk_vtk_array array[ARRAYS_MAX];
    const size_t n = columns_of(s);
    size_t used = 0;
    for (size_t k = n; k > 0; --k) { /* coverage before irradiance */
        array[used++] = columns[(k + WITHOUT_SENSORS - 1) % n].array;
    }
    array[used++] = (murk_vtk_array){"color", "UInt8", 3, 3, put_color};
    meanings_of(s, note);
    const murk_vtp vtp = {.scene = s->session->scene,
                          .notes = note,
                          .points = 3 * s->n,
                          .has_triangles = true,
                          .place = {"place", murk_place_vtk(s->session->scene),
                                    3, murk_place_bytes(s->session->scene),
                                    put_corner},
                          .array = array,
                          .arrays = used,
                          .context = s,
                          .step = "surfaces.vtp"};
    return murk_vtp_write(&vtp, path, err);
}

/* ---- all ---- */

/* Those in the domain, and their mean irradiance. */
static void choose(surfaces *s)
{
    const murk_pieces *pieces = s->lit->pieces;
    double area_m2 = 0, w = 0;
    for (size_t i = 0; i < pieces->n; ++i) {
        const murk_piece piece = murk_piece_of(pieces, i);
        if (murk_piece_is_within(&piece, &s->session->stage->world.domain)) {
            s->piece[s->n++] = (uint32_t)i;
            area_m2 += piece.area_m2;
            w += (double)s->lit->irradiance[i] * piece.area_m2;
        }
    }
    s->bright_w_per_m2 = w > 0 ? BRIGHT * w / area_m2 : 1;
}

static char *names_of(const murk_scene_desc *scene)
{
    size_t room = 1;
    for (size_t i = 0; i < scene->n_materials; ++i) {
        room += strlen(scene->materials[i].name) + 16;
    }
    char *text = calloc(room, 1);
    size_t used = 0;
    for (size_t i = 0; text && i < scene->n_materials; ++i) {
        used += (size_t)snprintf(text + used, room - used, "%s%zu: %s",
                                 i ? ", " : "", i, scene->materials[i].name);
    }
    return text;
}

static void add_files(murk_session *session, const murk_lit_pieces *lit,
                      murk_error *late)
{
    surfaces s = {.session = session,
                  .lit = lit,
                  .piece = malloc(lit->pieces->n * sizeof *s.piece + 1),
                  .materials = names_of(session->scene)};
    if (!s.piece || !s.materials) {
        (void)murk_fail(late, MURK_NO_MEMORY, "--export",
                        "surfaces: no memory for %zu pieces", lit->pieces->n);
    } else {
        choose(&s);
        snprintf(s.lost, sizeof s.lost, "%llu", (unsigned long long)lit->lost);
        (void)murk_results_add_stream(&session->results, "surfaces.ply",
                                      write_ply, &s, late);
        (void)murk_results_add(&session->results, "surfaces.vtp", write_vtp, &s,
                               late);
    }
    free(s.piece);
    free(s.materials);
}

void murk_surfaces_add(murk_session *session, murk_sight *sight,
                       const murk_pose *sensor, size_t n, murk_error *late)
{
    const murk_stage *stage = session->stage;
    murk_pieces pieces = {0};
    murk_lit_pieces lit = {0};
    murk_error told = {0};
    double edge_m = 0;
    murk_status status = edge_asked(&edge_m, session, &told);
    if (!status) {
        status =
            murk_pieces_create(&pieces, stage->surfaces, edge_m,
                               usual_pieces(session->traced), "--voxel", &told);
    }
    if (!status) {
        status =
            murk_lit_pieces_make(&lit, &pieces, &stage->world.domain,
                                 session->traced, session->scene->bands, sight,
                                 sensor, n, session->settings.threads, &told);
    }
    if (status) {
        (void)murk_fail(late, status, "--export", "surfaces: %s", told.text);
    } else {
        add_files(session, &lit, late);
    }
    murk_lit_pieces_release(&lit);
    murk_pieces_release(&pieces);
}
