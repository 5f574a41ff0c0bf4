/* Writes path.ply: the stops of an exploration, and a thin three-sided tube
 * about each leg, because some viewers leave the edges of a PLY file out. */
#include "results/path_ply.h"

#include "scene/places.h"

#include <string.h>

#define RECORD_MAX (MURK_PLACE_BYTES_MAX + 6) /* bytes of a vertex */

#define LINE_SIZE 0.001 /* half its thickness, of the world's size */
#define SIDES     3

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "numbers are written as they lie in memory");

typedef enum vertex_kind { STATION, PASSED, CORNER } vertex_kind;

typedef struct path {
    const murk_scene_desc *scene;
    const murk_explore *explore;
    size_t legs;
    double line_m;
} path;

/* The step whose way a stop lies on, from 0. */
static size_t step_of(const murk_explore *explore, size_t stop)
{
    size_t k = 0;
    while (k + 1 < explore->steps && explore->step[k].stops <= stop) {
        ++k;
    }
    return k;
}

static void put_vertex(FILE *to, const path *p, murk_vec3 at, vertex_kind kind,
                       size_t stop)
{
    static const double first[3] = {60, 175, 90}, last[3] = {150, 60, 200};
    const double share = p->legs ? (double)stop / (double)p->legs : 0;
    const uint16_t step = (uint16_t)(step_of(p->explore, stop) + 1);
    uint8_t bytes[RECORD_MAX];
    const size_t place = murk_place_bytes(p->scene);
    uint8_t *rest = bytes + place;
    murk_place_put(p->scene, at, bytes);
    for (int c = 0; c < 3; ++c) {
        rest[c] = (uint8_t)(first[c] + share * (last[c] - first[c]));
    }
    rest[3] = (uint8_t)kind;
    memcpy(rest + 4, &step, 2);
    (void)fwrite(bytes, 1, place + 6, to); /* commit asks ferror */
}

static void put_stops(FILE *to, const path *p)
{
    const murk_explore *explore = p->explore;
    for (size_t k = 0; k < explore->stops; ++k) {
        const bool is_station =
            explore->step[step_of(explore, k)].stops == k + 1;
        put_vertex(to, p, explore->stop[k], is_station ? STATION : PASSED, k);
    }
}

/* Of each leg: about its beginning, then about its end. */
static void put_corners(FILE *to, const path *p)
{
    for (size_t leg = 0; leg < p->legs; ++leg) {
        const murk_vec3 *end = &p->explore->stop[leg];
        murk_vec3 side[2];
        murk_frame(murk_unit(murk_sub(end[1], end[0])), &side[0], &side[1]);
        for (size_t e = 0; e < 2; ++e) {
            for (int s = 0; s < SIDES; ++s) {
                const double angle = 2 * MURK_PI * s / SIDES;
                murk_vec3 at =
                    murk_along(end[e], p->line_m * cos(angle), side[0]);
                at = murk_along(at, p->line_m * sin(angle), side[1]);
                put_vertex(to, p, at, CORNER, leg + e);
            }
        }
    }
}

static void put_numbers(FILE *to, const uint32_t *number, size_t n)
{
    (void)fwrite(number, sizeof *number, n, to);
}

static void put_face(FILE *to, size_t a, size_t b, size_t c)
{
    const uint8_t corners = 3;
    const uint32_t number[3] = {(uint32_t)a, (uint32_t)b, (uint32_t)c};
    (void)fwrite(&corners, 1, 1, to);
    put_numbers(to, number, 3);
}

/* Wound so that normals point out. */
static void put_faces(FILE *to, const path *p)
{
    for (size_t leg = 0; leg < p->legs; ++leg) {
        const size_t near = p->explore->stops + 2 * SIDES * leg;
        const size_t far = near + SIDES;
        for (size_t s = 0; s < SIDES; ++s) {
            const size_t next = (s + 1) % SIDES;
            put_face(to, near + s, near + next, far + next);
            put_face(to, near + s, far + next, far + s);
        }
    }
}

static void put_edges(FILE *to, const path *p)
{
    for (size_t leg = 0; leg < p->legs; ++leg) {
        const uint32_t end[2] = {(uint32_t)leg, (uint32_t)(leg + 1)};
        put_numbers(to, end, 2);
    }
}

static void write_ply(FILE *to, const void *context)
{
    const path *p = context;
    fprintf(to,
            "ply\nformat binary_little_endian 1.0\n"
            "comment murk path: stops, corners of the line between them\n"
            "comment kind: 0 station, 1 passed on the way, 2 corner\n"
            "element vertex %zu\n%s"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property uchar kind\nproperty ushort step\n"
            "element face %zu\nproperty list uchar int vertex_indices\n"
            "element edge %zu\nproperty int vertex1\nproperty int vertex2\n"
            "end_header\n",
            p->explore->stops + 2 * SIDES * p->legs, murk_place_ply(p->scene),
            2 * SIDES * p->legs, p->legs);
    put_stops(to, p);
    put_corners(to, p);
    put_faces(to, p);
    put_edges(to, p);
}

murk_status murk_add_path_ply(murk_results *results,
                              const murk_scene_desc *scene,
                              const murk_explore *explore, double size_m,
                              murk_error *err)
{
    const path p = {scene, explore, explore->stops > 0 ? explore->stops - 1 : 0,
                    LINE_SIZE * size_m};
    return murk_results_add_stream(results, "path.ply", write_ply, &p, err);
}
