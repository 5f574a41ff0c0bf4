/* Writes plan.ply: sensors, their marks and the stored photons, each photon
 * with the number of sensors that see it. The sightlines are computed again,
 * for a few sensors at a time, so that memory does not grow with the number of
 * sensors. */
#include "results/plan_ply.h"

#include "results/mark.h"
#include "results/mesh_file.h"
#include "sparse/matrix.h"

#include <stdlib.h>
#include <string.h>

#define MARK_SIZE    0.005 /* half width of an octahedron, of the diagonal */
#define SENSORS_HELD 16    /* whose sightlines are in memory at a time */

typedef enum vertex_kind {
    SENSOR,
    SURFACE_PHOTON,
    VOLUME_PHOTON,
    CORNER
} vertex_kind;

typedef struct sighting {
    uint16_t sensors, clarity;
    uint32_t which; /* bit k: seen by sensor k, of the first 32 */
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

/* Adds what sensors first, first + 1, .. see: the columns of `seen`. */
static void take_up(sighting *to, const murk_sparse_matrix *seen, size_t first)
{
    for (size_t j = 0; j < seen->columns; ++j) {
        const size_t sensor = first + j;
        const uint32_t bit =
            sensor < MURK_PLAN_PLY_SENSORS ? UINT32_C(1) << sensor : 0;
        for (size_t k = seen->begin[j]; k < seen->begin[j + 1]; ++k) {
            sighting *s = &to[seen->row[k]];
            s->sensors = (uint16_t)(s->sensors + (s->sensors < UINT16_MAX));
            s->which |= bit;
            if (seen->clarity[k] > s->clarity) {
                s->clarity = seen->clarity[k];
            }
        }
    }
}

static murk_status see_all(parts *p, murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t first = 0; first < p->sensors && !status;
         first += SENSORS_HELD) {
        const size_t left = p->sensors - first;
        murk_sparse_matrix *seen = NULL;
        murk_sight_problem problem;
        murk_sight_problem_init(&problem, p->sight, p->sensor + first,
                                left < SENSORS_HELD ? left : SENSORS_HELD);
        status =
            murk_sparse_matrix_collect(&seen, &problem.problem, SIZE_MAX, err);
        if (!status) {
            take_up(p->seen, seen, first);
        }
        murk_sparse_matrix_destroy(seen);
    }
    return status;
}

/* ---- writing ---- */

static const murk_mesh_column columns[] = {
    MURK_MESH_COLOR,
    {"kind", MURK_MESH_UINT8, .components = 1},
    {"seen_by", MURK_MESH_UINT16, .components = 1},
    {"quality", MURK_MESH_FLOAT, .components = 1},
    {"sensors", MURK_MESH_UINT32, .components = 1}};

/* The values of a vertex, in the order of the columns. */
typedef struct __attribute__((packed)) record {
    uint8_t color[3], kind;
    uint16_t seen_by;
    float quality;
    uint32_t sensors;
} record;

static void put_vertex(const murk_ply *ply, murk_vec3 at, vertex_kind kind,
                       sighting s)
{
    /* hues that are easy to tell apart */
    static const uint8_t yellow[3] = {255, 200, 0}, red[3] = {205, 45, 45},
                         blue[3] = {60, 120, 200}, green[3] = {60, 175, 90};
    const uint8_t *color = kind == SENSOR || kind == CORNER ? yellow
                           : s.sensors == 0                 ? red
                           : s.sensors == 1                 ? blue
                                                            : green;
    const record r = {{color[0], color[1], color[2]},
                      (uint8_t)kind,
                      s.sensors,
                      (float)s.clarity / MURK_CLEAR,
                      s.which};
    murk_mesh_put_vertex(ply, at, &r);
}

static void put_map(const murk_ply *ply, const murk_photon_map *map,
                    vertex_kind kind, const sighting *seen)
{
    const murk_photon *photon = murk_photon_map_photons(map);
    for (size_t i = 0; i < murk_photon_map_count(map); ++i) {
        put_vertex(ply, murk_photon_place(&photon[i]), kind, seen[i]);
    }
}

/* False for a fixed sensor that has failed by the time of the condition. */
static bool is_there(const parts *p, size_t sensor)
{
    return p->sensor[sensor].type != MURK_POSE_OF_NONE;
}

static size_t count_there(const parts *p)
{
    size_t n = 0;
    for (size_t k = 0; k < p->sensors; ++k) {
        n += is_there(p, k);
    }
    return n;
}

/* The mark of a sensor, without corners and faces if it is not there. */
static murk_mark mark_of(const parts *p, size_t sensor)
{
    const murk_sight_desc *sight = murk_sight_described(p->sight);
    const murk_pose *pose = &p->sensor[sensor];
    murk_mark mark = {0};
    if (is_there(p, sensor)) {
        murk_mark_make(&mark, &sight->type[pose->type], pose, sight->north,
                       p->mark_m);
    }
    return mark;
}

static void put_vertices(const murk_ply *ply, const parts *p)
{
    static const sighting by_all = {0, MURK_CLEAR, 0};
    const murk_sight_desc *maps = murk_sight_described(p->sight);
    for (size_t k = 0; k < p->sensors; ++k) {
        if (is_there(p, k)) {
            put_vertex(ply, p->sensor[k].position, SENSOR, by_all);
        }
    }
    for (size_t k = 0; k < p->sensors; ++k) {
        const murk_mark mark = mark_of(p, k);
        for (size_t c = 0; c < mark.corners; ++c) {
            put_vertex(ply, mark.corner[c], CORNER, by_all);
        }
    }
    put_map(ply, maps->surface_map, SURFACE_PHOTON, p->seen);
    put_map(ply, maps->volume_map, VOLUME_PHOTON,
            p->seen + murk_photon_map_count(maps->surface_map));
}

static void put_faces(const murk_ply *ply, const parts *p)
{
    size_t first = count_there(p);
    for (size_t k = 0; k < p->sensors; ++k) {
        const murk_mark mark = mark_of(p, k);
        for (size_t f = 0; f < mark.faces; ++f) {
            const uint8_t *corner = mark.face[f];
            murk_mesh_put_face(ply, first + corner[0], first + corner[1],
                               first + corner[2], NULL);
        }
        first += mark.corners;
    }
}

static murk_status write_ply(FILE *to, const void *context, murk_error *err)
{
    const parts *p = context;
    size_t corners = 0, faces = 0;
    for (size_t k = 0; k < p->sensors; ++k) {
        const murk_mark mark = mark_of(p, k);
        corners += mark.corners;
        faces += mark.faces;
    }
    murk_ply ply = murk_mesh_begin(
        to, p->scene,
        "comment murk plan: sensors, corners of their marks, stored photons\n"
        "comment kind: 0 sensor, 1 surface photon, 2 volume photon, 3 "
        "corner of a mark\n");
    murk_mesh_vertices(&ply, count_there(p) + corners + p->photons, columns,
                       sizeof columns / sizeof *columns);
    murk_mesh_faces(&ply, faces, NULL, 0);
    murk_mesh_end_header(&ply);
    put_vertices(&ply, p);
    put_faces(&ply, p);
    (void)err;
    return MURK_OK;
}

murk_status murk_add_plan_ply(murk_results *results, const char *name,
                              const murk_stage *stage, murk_sight *sight,
                              const murk_pose *sensor, size_t n,
                              murk_error *err)
{
    const murk_box *box = &stage->world.domain.box;
    parts p = {.scene = stage->scene,
               .sight = sight,
               .sensor = sensor,
               .sensors = n,
               .photons = murk_sight_photons(sight),
               .mark_m = MARK_SIZE * murk_length(murk_sub(box->max, box->min))};
    p.seen = calloc(p.photons + 1, sizeof *p.seen);
    murk_status status =
        p.seen ? see_all(&p, err) : murk_no_memory(err, name, "to write it");
    if (!status) {
        status = murk_results_add_stream(results, name, write_ply, &p, err);
    }
    free(p.seen);
    return status;
}
