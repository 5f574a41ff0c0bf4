/* Writes photons.ply and photons.vtp: each stored photon of both maps with
 * place, direction, normal, power, numbers and a colour. Colours of several
 * bands follow from the colour matching functions (render/colour.h), in sRGB.
 */
#include "results/photons.h"

#include "render/colour.h"
#include "results/mesh_file.h"
#include "results/vtk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct photons {
    const murk_session *session;
    const murk_photon *surface, *volume;
    size_t on, in; /* numbers of photons on surfaces, and in volumes */
    uint8_t band_color[MURK_BANDS_MAX][3];
} photons;

static const murk_photon *photon_at(const photons *p, size_t i)
{
    return i < p->on ? &p->surface[i] : &p->volume[i - p->on];
}

/* ---- colours ---- */

static uint8_t encoded(double linear)
{
    const double v = fmin(fmax(linear, 0), 1);
    return (uint8_t)(255 * (v <= 0.0031308 ? 12.92 * v
                                           : 1.055 * pow(v, 1 / 2.4) - 0.055) +
                     0.5);
}

/* The colour of each band, as bright as sRGB allows. */
static void color_bands(photons *p)
{
    const murk_scene_desc *scene = p->session->scene;
    double from[MURK_BANDS_MAX], to[MURK_BANDS_MAX], w[3][MURK_BANDS_MAX];
    for (int b = 0; b < scene->bands; ++b) {
        from[b] = scene->has_edges ? scene->band_edge_nm[b] : scene->band_nm[b];
        to[b] =
            scene->has_edges ? scene->band_edge_nm[b + 1] : scene->band_nm[b];
    }
    murk_colour_weights(scene->bands, from, to, w);
    for (int b = 0; b < scene->bands; ++b) {
        const double max = fmax(fmax(w[0][b], w[1][b]), w[2][b]);
        for (int c = 0; c < 3; ++c) { /* dark grey for bands that no eye sees */
            p->band_color[b][c] =
                max > 0 ? encoded(w[c][b] / max) : encoded(0.2);
        }
    }
}

static const uint8_t *color_of(const photons *p, const murk_photon *photon)
{
    /* [volume][event class]: warm on surfaces, cold in volumes */
    static const uint8_t by_event[2][4][3] = {
        {{255, 170, 60}, {255, 235, 120}, {205, 110, 60}, {205, 110, 60}},
        {{90, 200, 255}, {150, 240, 215}, {70, 110, 210}, {70, 110, 210}}};
    return p->session->scene->bands > 1
               ? p->band_color[murk_photon_band(photon)]
               : by_event[murk_photon_is_volume(photon) ? 1 : 0]
                         [murk_photon_class(photon)];
}

/* ---- values ---- */

static const murk_mesh_column columns[] = {
    {"normal", MURK_MESH_FLOAT, 3, {"nx", "ny", "nz"}},
    {"direction", MURK_MESH_FLOAT, 3, {"dx", "dy", "dz"}},
    {"power_w", MURK_MESH_FLOAT, .components = 1},
    {"emitted", MURK_MESH_UINT32, .components = 1},
    {"band", MURK_MESH_UINT8, .components = 1},
    {"light", MURK_MESH_UINT8, .components = 1},
    {"material", MURK_MESH_UINT8, .components = 1},
    {"kind", MURK_MESH_UINT8, .components = 1},
    {"event", MURK_MESH_UINT8, .components = 1},
    MURK_MESH_COLOR};
#define COLUMNS (sizeof columns / sizeof *columns)

/* The values of one photon, in the order of the columns. */
typedef struct record {
    float normal[3], direction[3], power_w;
    uint32_t emitted;
    uint8_t band, light, material, kind, event, color[3];
} record;
_Static_assert(sizeof(record) == 40, "records have no padding");

static murk_vec3 position_of(const void *context, size_t i)
{
    return murk_photon_place(photon_at(context, i));
}

static void put_record(const void *context, size_t i, void *out)
{
    const murk_photon *photon = photon_at(context, i);
    const murk_vec3 n = murk_photon_normal(photon);
    const murk_vec3 d = murk_photon_direction(photon);
    const uint8_t *color = color_of(context, photon);
    const record r = {.normal = {(float)n.x, (float)n.y, (float)n.z},
                      .direction = {(float)d.x, (float)d.y, (float)d.z},
                      .power_w = (float)murk_photon_power_w(photon),
                      .emitted = murk_photon_emitted(photon),
                      .band = murk_photon_band(photon),
                      .light = murk_photon_light(photon),
                      .material = murk_photon_material(photon),
                      .kind = murk_photon_is_volume(photon) ? 1 : 0,
                      .event = (uint8_t)murk_photon_class(photon),
                      .color = {color[0], color[1], color[2]}};
    memcpy(out, &r, sizeof r);
}

/* ---- what numbers mean ---- */

typedef struct meanings {
    char bands[32 * MURK_BANDS_MAX];
    char *materials, *media;
    const char *note[16];
} meanings;

static bool meanings_of(meanings *m, const murk_scene_desc *scene)
{
    /* Bands, materials and media are numbers in the records. */
    size_t used = 0;
    for (int b = 0; b < scene->bands; ++b) {
        used += (size_t)snprintf(m->bands + used, sizeof m->bands - used,
                                 "%s%d: %.9g nm", b ? ", " : "", b,
                                 scene->band_nm[b]);
    }
    m->materials =
        murk_numbered_names(scene->n_materials ? scene->materials[0].name : "",
                            scene->n_materials, sizeof *scene->materials);
    m->media = murk_numbered_names(scene->n_media ? scene->media[0].name : "",
                                   scene->n_media, sizeof *scene->media);
    const char *const note[16] = {
        "bands",
        m->bands,
        "materials",
        m->materials,
        "media",
        m->media,
        "kind_means",
        "0 surface, 1 volume",
        "event_means",
        "0 first, 1 only mirrors and glass before, 2 later",
        "power_means",
        "W that leave the event; material is of the surface, or the medium",
        NULL};
    memcpy(m->note, note, sizeof note);
    return m->materials && m->media;
}

/* ---- all ---- */

void murk_photons_add(murk_session *session, murk_error *late)
{
    /* the colour first, because ParaView shows the first array by default */
    static const uint8_t order[] = {9, 0, 1, 2, 3, 4, 5, 6, 7, 8};
    const murk_traced *traced = session->traced;
    photons p = {.session = session,
                 .surface = murk_photon_map_photons(traced->surface),
                 .volume = murk_photon_map_photons(traced->volume),
                 .on = murk_photon_map_count(traced->surface),
                 .in = murk_photon_map_count(traced->volume)};
    meanings m;
    const murk_mesh_export mesh = {
        .name = "photons",
        .comment = "comment murk photons: those of the surface map, then of "
                   "the volume map\n",
        .scene = session->scene,
        .notes = m.note,
        .points = p.on + p.in,
        .column = columns,
        .columns = COLUMNS,
        .order = order,
        .position = position_of,
        .record = put_record,
        .context = &p};
    color_bands(&p);
    if (meanings_of(&m, session->scene)) {
        murk_mesh_add(&session->results, &mesh, late);
    } else {
        (void)murk_fail(late, MURK_NO_MEMORY, "exports",
                        "photons: no memory to write them");
    }
    free(m.materials);
    free(m.media);
}
