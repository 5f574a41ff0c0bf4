/* Writes plan.ply: sensors, their marks and the stored photons, each photon
 * with the number of sensors that see it. The sightlines are looked at once
 * more, for a few sensors at a time, so that memory does not grow with the
 * plan. */
#include "results/plan_ply.h"

#include "placement/sparse_matrix.h"
#include "results/mark.h"
#include "scene/places.h"

#include <stdlib.h>
#include <string.h>

#define RECORD_MAX (MURK_PLACE_BYTES_MAX + 14) /* bytes of a vertex */

#define MARK_SIZE    0.005 /* half an octahedron's width, of the world's size */
#define SENSORS_HELD 16    /* looks in memory at a time */

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "numbers are written as they lie in memory");

typedef enum vertex_kind {
    SENSOR,
    SURFACE_PHOTON,
    VOLUME_PHOTON,
    CORNER
} vertex_kind;

typedef struct seen {
    uint16_t sensors, clarity;
    uint32_t which; /* bit k: sensor k, of the first 32 */
} sighting;

typedef struct parts {
    const murk_scene_desc *scene;
    murk_sight *sight;
    const murk_pose *sensor;
    size_t sensors, photons;
    sighting *seen; /* [photons] */
    double mark_m;
} parts;

/* ---- who sees what ---- */

/* Looks of sensors first, first + 1, .. */
static void take_up(sighting *to, const murk_sparse_matrix *looks, size_t first)
{
    for (size_t j = 0; j < looks->columns; ++j) {
        const size_t sensor = first + j;
        const uint32_t bit =
            sensor < MURK_PLAN_PLY_SENSORS ? UINT32_C(1) << sensor : 0;
        for (size_t k = looks->begin[j]; k < looks->begin[j + 1]; ++k) {
            sighting *s = &to[looks->row[k]];
            s->sensors = (uint16_t)(s->sensors + (s->sensors < UINT16_MAX));
            s->which |= bit;
            if (looks->clarity[k] > s->clarity) {
                s->clarity = looks->clarity[k];
            }
        }
    }
}

static murk_status look_all(parts *p, murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t first = 0; first < p->sensors && !status;
         first += SENSORS_HELD) {
        const size_t left = p->sensors - first;
        murk_sparse_matrix *looks = NULL;
        murk_sight_problem problem;
        murk_sight_problem_init(&problem, p->sight, p->sensor + first,
                                left < SENSORS_HELD ? left : SENSORS_HELD);
        status =
            murk_sparse_matrix_collect(&looks, &problem.problem, SIZE_MAX, err);
        if (!status) {
            take_up(p->seen, looks, first);
        }
        murk_sparse_matrix_destroy(looks);
    }
    return status;
}

/* ---- writing ---- */

static void put_vertex(FILE *to, const parts *p, murk_vec3 at, vertex_kind kind,
                       sighting s)
{
    static const uint8_t yellow[3] = {255, 200, 0}, red[3] = {205, 45, 45},
                         blue[3] = {60, 120, 200}, green[3] = {60, 175, 90};
    const uint8_t *color = kind == SENSOR || kind == CORNER ? yellow
                           : s.sensors == 0                 ? red
                           : s.sensors == 1                 ? blue
                                                            : green;
    const uint8_t number = (uint8_t)kind;
    const float quality = (float)s.clarity / MURK_CLEAR;
    uint8_t bytes[RECORD_MAX];
    const size_t place = murk_place_bytes(p->scene);
    uint8_t *rest = bytes + place;
    murk_place_put(p->scene, at, bytes);
    memcpy(rest, color, 3);
    memcpy(rest + 3, &number, 1);
    memcpy(rest + 4, &s.sensors, 2);
    memcpy(rest + 6, &quality, 4);
    memcpy(rest + 10, &s.which, 4);
    (void)fwrite(bytes, 1, place + 14, to); /* commit asks ferror */
}

static void put_sensor(FILE *to, const parts *p, murk_vec3 at, vertex_kind kind)
{
    put_vertex(to, p, at, kind, (sighting){0, MURK_CLEAR, 0});
}

static void put_map(FILE *to, const parts *p, const murk_photon_map *map,
                    vertex_kind kind, const sighting *seen)
{
    const murk_photon *photon = murk_photon_map_photons(map);
    for (size_t i = 0; i < murk_photon_map_count(map); ++i) {
        put_vertex(to, p, murk_photon_place(&photon[i]), kind, seen[i]);
    }
}

static murk_mark mark_of(const parts *p, size_t sensor)
{
    const murk_sight_desc *sight = murk_sight_described(p->sight);
    const murk_pose *pose = &p->sensor[sensor];
    murk_mark mark;
    murk_mark_make(&mark, &sight->type[pose->type], pose, sight->north,
                   p->mark_m);
    return mark;
}

static void put_corners(FILE *to, const parts *p)
{
    for (size_t k = 0; k < p->sensors; ++k) {
        const murk_mark mark = mark_of(p, k);
        for (size_t c = 0; c < mark.corners; ++c) {
            put_sensor(to, p, mark.corner[c], CORNER);
        }
    }
}

static void put_faces(FILE *to, const parts *p)
{
    size_t first = p->sensors;
    for (size_t k = 0; k < p->sensors; ++k) {
        const murk_mark mark = mark_of(p, k);
        for (size_t f = 0; f < mark.faces; ++f) {
            uint8_t bytes[13] = {3};
            for (int c = 0; c < 3; ++c) {
                const uint32_t vertex = (uint32_t)(first + mark.face[f][c]);
                memcpy(bytes + 1 + 4 * c, &vertex, 4);
            }
            (void)fwrite(bytes, 1, sizeof bytes, to);
        }
        first += mark.corners;
    }
}

static void write_ply(FILE *to, const void *context)
{
    const parts *p = context;
    const murk_sight_desc *maps = murk_sight_described(p->sight);
    size_t corners = 0, faces = 0;
    for (size_t k = 0; k < p->sensors; ++k) {
        const murk_mark mark = mark_of(p, k);
        corners += mark.corners;
        faces += mark.faces;
    }
    fprintf(
        to,
        "ply\nformat binary_little_endian 1.0\n"
        "comment murk plan: sensors, corners of their marks, stored photons\n"
        "comment kind: 0 sensor, 1 surface photon, 2 volume photon, 3 "
        "corner of a mark\n"
        "element vertex %zu\n%s"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "property uchar kind\nproperty ushort seen_by\n"
        "property float quality\nproperty uint sensors\n"
        "element face %zu\nproperty list uchar int vertex_indices\n"
        "end_header\n",
        p->sensors + corners + p->photons, murk_place_ply(p->scene), faces);
    for (size_t k = 0; k < p->sensors; ++k) {
        put_sensor(to, p, p->sensor[k].position, SENSOR);
    }
    put_corners(to, p);
    put_map(to, p, maps->surface_map, SURFACE_PHOTON, p->seen);
    put_map(to, p, maps->volume_map, VOLUME_PHOTON,
            p->seen + murk_photon_map_count(maps->surface_map));
    put_faces(to, p);
}

murk_status murk_add_plan_ply(murk_results *results, const char *name,
                              const murk_scene_desc *scene, murk_sight *sight,
                              const murk_pose *sensor, size_t n, double size_m,
                              murk_error *err)
{
    parts p = {.scene = scene,
               .sight = sight,
               .sensor = sensor,
               .sensors = n,
               .photons = murk_sight_photons(sight),
               .mark_m = MARK_SIZE * size_m};
    p.seen = calloc(p.photons + 1, sizeof *p.seen);
    murk_status status =
        p.seen ? look_all(&p, err)
               : murk_fail(err, MURK_NO_MEMORY, name, "no memory to write it");
    if (!status) {
        status = murk_results_add_stream(results, name, write_ply, &p, err);
    }
    free(p.seen);
    return status;
}
