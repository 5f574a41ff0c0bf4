/* Writes photons.ply and photons.vtp: each stored photon of both maps with
 * place, direction, normal, power, numbers and a colour. Colours of several
 * bands follow from the colour matching functions (render/colour.h), in sRGB.
 */
#include "results/photons.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "render/colour.h"
#include "results/vtk.h"
#include "scene/places.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define RECORD_MAX (MURK_PLACE_BYTES_MAX + RECORD) /* bytes of a vertex */

#define SHOWN_EVERY 65536 /* photons between two looks at the bar */
#define RECORD      40    /* bytes of a vertex behind its place */

typedef struct photons {
    const murk_session *session;
    const murk_photon *surface, *volume;
    size_t on, in; /* of them */
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

/* Each band's own colour, as bright as can be. */
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
        for (int c = 0; c < 3; ++c) { /* what no eye sees is grey */
            p->band_color[b][c] =
                max > 0 ? encoded(w[c][b] / max) : encoded(0.2);
        }
    }
}

static const uint8_t *color_of(const photons *p, const murk_photon *photon)
{
    static const uint8_t by_event[2][4][3] = {
        {{255, 170, 60}, {255, 235, 120}, {205, 110, 60}, {205, 110, 60}},
        {{90, 200, 255}, {150, 240, 215}, {70, 110, 210}, {70, 110, 210}}};
    return p->session->scene->bands > 1
               ? p->band_color[murk_photon_band(photon)]
               : by_event[murk_photon_is_volume(photon) ? 1 : 0]
                         [murk_photon_class(photon)];
}

/* ---- values ---- */

static void put_vector(murk_vec3 v, void *item)
{
    const float xyz[3] = {(float)v.x, (float)v.y, (float)v.z};
    memcpy(item, xyz, sizeof xyz);
}

static void put_place(const void *context, size_t i, void *item)
{
    murk_place_put(((const photons *)context)->session->scene,
                   murk_photon_place(photon_at(context, i)), item);
}

static void put_normal(const void *context, size_t i, void *item)
{
    put_vector(murk_photon_normal(photon_at(context, i)), item);
}

static void put_direction(const void *context, size_t i, void *item)
{
    put_vector(murk_photon_direction(photon_at(context, i)), item);
}

static void put_power(const void *context, size_t i, void *item)
{
    const float power_w = (float)murk_photon_power_w(photon_at(context, i));
    memcpy(item, &power_w, sizeof power_w);
}

static void put_emitted(const void *context, size_t i, void *item)
{
    const uint32_t emitted = murk_photon_emitted(photon_at(context, i));
    memcpy(item, &emitted, sizeof emitted);
}

static void put_band(const void *context, size_t i, void *item)
{
    *(uint8_t *)item = murk_photon_band(photon_at(context, i));
}

static void put_light(const void *context, size_t i, void *item)
{
    *(uint8_t *)item = murk_photon_light(photon_at(context, i));
}

static void put_material(const void *context, size_t i, void *item)
{
    *(uint8_t *)item = murk_photon_material(photon_at(context, i));
}

static void put_kind(const void *context, size_t i, void *item)
{
    *(uint8_t *)item =
        (uint8_t)(murk_photon_is_volume(photon_at(context, i)) ? 1 : 0);
}

static void put_event(const void *context, size_t i, void *item)
{
    *(uint8_t *)item = (uint8_t)murk_photon_class(photon_at(context, i));
}

static void put_color(const void *context, size_t i, void *item)
{
    memcpy(item, color_of(context, photon_at(context, i)), 3);
}

static const murk_vtk_array arrays[] = {
    {"color", "UInt8", 3, 3, put_color},
    {"normal", "Float32", 3, 12, put_normal},
    {"direction", "Float32", 3, 12, put_direction},
    {"power_w", "Float32", 1, 4, put_power},
    {"emitted", "UInt32", 1, 4, put_emitted},
    {"band", "UInt8", 1, 1, put_band},
    {"light", "UInt8", 1, 1, put_light},
    {"material", "UInt8", 1, 1, put_material},
    {"kind", "UInt8", 1, 1, put_kind},
    {"event", "UInt8", 1, 1, put_event}};

/* ---- what numbers mean ---- */

/* "0: fog, 1: smoke" of a list whose names begin `stride` bytes apart; the
 * caller frees it. */
static char *listed(const char *first, size_t n, size_t stride)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        return NULL;
    }
    for (size_t i = 0; i < n; ++i) {
        fprintf(out, "%s%zu: %s", i > 0 ? ", " : "", i, first + i * stride);
    }
    if (fclose(out) != 0) {
        free(text);
        return NULL;
    }
    return text;
}

typedef struct meanings {
    char bands[32 * MURK_BANDS_MAX];
    char *materials, *media;
    const char *note[16];
} meanings;

static bool meanings_of(meanings *m, const murk_scene_desc *scene)
{
    size_t used = 0;
    for (int b = 0; b < scene->bands; ++b) {
        used += (size_t)snprintf(m->bands + used, sizeof m->bands - used,
                                 "%s%d: %.9g nm", b ? ", " : "", b,
                                 scene->band_nm[b]);
    }
    m->materials = listed(scene->n_materials ? scene->materials[0].name : "",
                          scene->n_materials, sizeof *scene->materials);
    m->media = listed(scene->n_media ? scene->media[0].name : "",
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

static void meanings_release(meanings *m)
{
    free(m->materials);
    free(m->media);
}

/* ---- files ---- */

static void put_header(FILE *to, const photons *p, const meanings *m)
{
    fputs("ply\nformat binary_little_endian 1.0\n"
          "comment murk photons: those of the surface map, then of the volume "
          "map\n",
          to);
    murk_ply_put_facts(to, p->session->scene);
    for (const char *const *note = m->note; note[0]; note += 2) {
        murk_ply_put_comment(to, note[0], note[1]);
    }
    fprintf(to, "element vertex %zu\n%s", p->on + p->in,
            murk_place_ply(p->session->scene));
    fputs("property float nx\nproperty float ny\nproperty float nz\n"
          "property float dx\nproperty float dy\nproperty float dz\n"
          "property float power_w\nproperty uint emitted\n"
          "property uchar band\nproperty uchar light\n"
          "property uchar material\nproperty uchar kind\n"
          "property uchar event\n"
          "property uchar red\nproperty uchar green\nproperty uchar blue\n"
          "end_header\n",
          to);
}

static void put_vertex(FILE *to, const photons *p, size_t i)
{
    unsigned char bytes[RECORD_MAX];
    const size_t place = murk_place_bytes(p->session->scene);
    unsigned char *rest = bytes + place;
    put_place(p, i, bytes);
    put_normal(p, i, rest);
    put_direction(p, i, rest + 12);
    put_power(p, i, rest + 24);
    put_emitted(p, i, rest + 28);
    put_band(p, i, rest + 32);
    put_light(p, i, rest + 33);
    put_material(p, i, rest + 34);
    put_kind(p, i, rest + 35);
    put_event(p, i, rest + 36);
    put_color(p, i, rest + 37);
    (void)fwrite(bytes, 1, place + RECORD, to); /* commit asks ferror */
}

static murk_status write_ply(const char *path, const void *context,
                             murk_error *err)
{
    const photons *p = context;
    meanings m;
    murk_file *file = NULL;
    murk_status status =
        meanings_of(&m, p->session->scene)
            ? murk_file_create(&file, path, err)
            : murk_fail(err, MURK_NO_MEMORY, path, "no memory to write it");
    if (!status) {
        put_header(murk_file_stream(file), p, &m);
        murk_progress_begin("photons.ply", p->on + p->in, "photons");
    }
    for (size_t i = 0; !status && i < p->on + p->in; ++i) {
        put_vertex(murk_file_stream(file), p, i);
        if ((i + 1) % SHOWN_EVERY == 0) {
            murk_progress_add(SHOWN_EVERY);
            status = murk_interrupted()
                         ? murk_fail(err, MURK_INTERRUPTED, path, "interrupted")
                         : MURK_OK;
        }
    }
    if (file) {
        murk_progress_end();
    }
    meanings_release(&m);
    if (status) {
        murk_file_discard(file);
        return status;
    }
    return murk_file_commit(&file, err);
}

static murk_status write_vtp(const char *path, const void *context,
                             murk_error *err)
{
    const photons *p = context;
    meanings m;
    murk_status status = MURK_OK;
    if (!meanings_of(&m, p->session->scene)) {
        status = murk_fail(err, MURK_NO_MEMORY, path, "no memory to write it");
    } else {
        const murk_vtp vtp = {
            .scene = p->session->scene,
            .notes = m.note,
            .points = p->on + p->in,
            .place = {"place", murk_place_vtk(p->session->scene), 3,
                      murk_place_bytes(p->session->scene), put_place},
            .array = arrays,
            .arrays = sizeof arrays / sizeof *arrays,
            .context = p,
            .step = "photons.vtp"};
        status = murk_vtp_write(&vtp, path, err);
    }
    meanings_release(&m);
    return status;
}

void murk_photons_add(murk_session *session, murk_error *late)
{
    const murk_traced *traced = session->traced;
    photons p = {.session = session,
                 .surface = murk_photon_map_photons(traced->surface),
                 .volume = murk_photon_map_photons(traced->volume),
                 .on = murk_photon_map_count(traced->surface),
                 .in = murk_photon_map_count(traced->volume)};
    color_bands(&p);
    (void)murk_results_add(&session->results, "photons.ply", write_ply, &p,
                           late);
    (void)murk_results_add(&session->results, "photons.vtp", write_vtp, &p,
                           late);
}
