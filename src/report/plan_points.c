/* Photons of plan.ply and light.murk for the page. If there are many photons,
 * evenly chosen ones are kept, in the order of the file, in which neighbours
 * are near in space. */
#include "report/plan_points.h"

#include "base/inputs.h"
#include "photonmap/map_file.h"
#include "photonmap/photon.h"
#include "scene/places.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define RECORD_MAX (MURK_PLACE_BYTES_MAX + REST) /* bytes of a vertex */

#define TEXT_MAX (HEADER_MAX + 1) /* with the end of the string */

#define HEADER_MAX     2048 /* bytes, several times those that murk writes */
#define REST           14   /* bytes of a vertex after its position */
#define SURFACE_PHOTON 1    /* `kind` of a vertex */
#define VOLUME_PHOTON  2    /* `kind` of a vertex */

#define FARTHEST_M      1e12F      /* limit of murk_is_shown() */
#define LIGHT_MAX_BYTES 2000000000 /* 6e7 photons of 32 bytes */

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "numbers are read as they lie in the file");

static const char photon_properties[] =
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "property uchar kind\nproperty ushort seen_by\n"
    "property float quality\nproperty uint sensors\n";

bool murk_ply_begin(FILE *file, uint64_t *vertices, const char *begin,
                    const char *properties, const murk_scene_desc *scene)
{
    static const char element[] = "\nelement vertex ";
    static const char end[] = "\nend_header\n";
    char text[TEXT_MAX];
    text[fread(text, 1, HEADER_MAX, file)] = '\0';
    /* the number of vertices, then their properties */
    const char *count = strstr(text, element);
    const char *last = strstr(text, end);
    char *behind = NULL;
    *vertices = count ? strtoull(count + sizeof element - 1, &behind, 10) : 0;
    const char *places = murk_place_ply(scene);
    const size_t length = strlen(places);
    return strncmp(text, begin, strlen(begin)) == 0 && behind && last &&
           *behind == '\n' && strncmp(behind + 1, places, length) == 0 &&
           strncmp(behind + 1 + length, properties, strlen(properties)) == 0 &&
           fseek(file, (long)(last - text) + (long)sizeof end - 1, SEEK_SET) ==
               0;
}

typedef struct vertex {
    murk_plan_point point;
    bool is_photon;
} vertex;

static vertex vertex_of(const unsigned char *bytes,
                        const murk_scene_desc *scene)
{
    const unsigned char *rest = bytes + murk_place_bytes(scene);
    const murk_vec3 at = murk_place_take(scene, bytes);
    vertex v = {.is_photon =
                    rest[3] == SURFACE_PHOTON || rest[3] == VOLUME_PHOTON,
                .point.place_m = {(float)at.x, (float)at.y, (float)at.z}};
    memcpy(&v.point.seen_by, rest + 4, 2);
    memcpy(&v.point.sensors, rest + 10, 4);
    v.point.is_volume = rest[3] == VOLUME_PHOTON;
    for (int k = 0; k < 3; ++k) {
        v.is_photon = v.is_photon && fabsf(v.point.place_m[k]) <= FARTHEST_M;
    }
    return v;
}

/* Walks through the vertices. Without out->point, counts the photons in
 * out->photons; else keeps out->n of them, evenly chosen. */
static murk_status walk(murk_plan_points *out, FILE *file, uint64_t vertices,
                        const murk_scene_desc *scene, const char *path,
                        murk_error *err)
{
    unsigned char bytes[RECORD_MAX];
    const size_t size = murk_place_bytes(scene) + REST;
    uint64_t photon = 0;
    size_t chosen = 0;
    for (uint64_t i = 0; i < vertices; ++i) {
        if (fread(bytes, size, 1, file) != 1) {
            return murk_fail(
                err, MURK_BAD_FILE, path, "cut short: %llu of %llu vertices",
                (unsigned long long)i, (unsigned long long)vertices);
        }
        const vertex v = vertex_of(bytes, scene);
        if (!v.is_photon) {
            continue;
        }
        /* photon k * photons / n, rounded down, is the k-th one kept */
        if (out->point && chosen < out->n &&
            photon == (uint64_t)((double)chosen * (double)out->photons /
                                 (double)out->n)) {
            out->point[chosen++] = v.point;
        }
        ++photon;
    }
    if (out->point) {
        out->n = chosen;
    } else {
        out->photons = photon;
    }
    return MURK_OK;
}

static murk_status read_points(murk_plan_points *out, FILE *file,
                               const murk_scene_desc *scene, const char *path,
                               size_t max, murk_error *err)
{
    uint64_t vertices = 0;
    if (!murk_ply_begin(file, &vertices,
                        "ply\nformat binary_little_endian 1.0\n",
                        photon_properties, scene)) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "not a plan.ply of this version of murk");
    }
    /* photons are counted first, then evenly chosen ones are kept */
    const long start = ftell(file);
    const murk_status status = walk(out, file, vertices, scene, path, err);
    if (status) {
        return status;
    }
    out->n = out->photons < max ? (size_t)out->photons : max;
    out->point = malloc((out->n + 1) * sizeof *out->point);
    if (!out->point) {
        return murk_no_memory(err, path, "to read it");
    }
    if (start < 0 || fseek(file, start, SEEK_SET) != 0) {
        return murk_fail(err, MURK_BAD_FILE, path, "%s", strerror(errno));
    }
    return walk(out, file, vertices, scene, path, err);
}

murk_status murk_plan_points_read(murk_plan_points *out, const char *path,
                                  const murk_scene_desc *scene, size_t max,
                                  murk_error *err)
{
    *out = (murk_plan_points){0};
    FILE *file = murk_inputs_open(path);
    if (!file) {
        return murk_fail(err, MURK_BAD_FILE, path, "%s", strerror(errno));
    }
    const murk_status status = read_points(out, file, scene, path, max, err);
    fclose(file);
    return status;
}

/* ---- light.murk ---- */

/* Keeps those of `capacity` evenly chosen photons of the file that are in this
 * map; `before` photons are in maps before it. */
static void take_map(murk_plan_points *out, size_t capacity,
                     const murk_section *map, uint64_t before)
{
    const murk_photon *photon = map->bytes;
    const size_t n = map->size / sizeof *photon;
    const double share = (double)out->photons / (double)capacity;
    while (out->n < capacity) {
        const uint64_t next = (uint64_t)((double)out->n * share);
        if (next - before >= n) {
            return;
        }
        const murk_photon *p = &photon[next - before];
        murk_plan_point *to = &out->point[out->n++];
        *to = (murk_plan_point){.is_volume = murk_photon_is_volume(p)};
        const murk_vec3 place = murk_photon_place(p);
        const float at[3] = {(float)place.x, (float)place.y, (float)place.z};
        for (int k = 0; k < 3; ++k) {
            to->place_m[k] = fabsf(at[k]) <= FARTHEST_M ? at[k] : 0;
        }
    }
}

static murk_status take_light(murk_plan_points *out,
                              const murk_section *sections, size_t n,
                              const char *path, size_t max, murk_error *err)
{
    static const char *const names[] = {"surface", "volume"};
    const murk_section *map[2];
    for (int k = 0; k < 2; ++k) {
        map[k] = murk_map_file_find(sections, n, names[k]);
        if (!map[k]) {
            return murk_fail(err, MURK_BAD_FILE, path, "has no %s map",
                             names[k]);
        }
        out->photons += map[k]->size / sizeof(murk_photon);
    }
    const size_t capacity = out->photons < max ? (size_t)out->photons : max;
    out->point = malloc((capacity + 1) * sizeof *out->point);
    if (!out->point) {
        return murk_no_memory(err, path, "to read it");
    }
    take_map(out, capacity, map[0], 0);
    take_map(out, capacity, map[1], map[0]->size / sizeof(murk_photon));
    return MURK_OK;
}

murk_status murk_plan_points_of_light(murk_plan_points *out, const char *path,
                                      size_t max, murk_error *err)
{
    murk_section *sections = NULL;
    size_t n = 0;
    struct stat known;
    *out = (murk_plan_points){0};
    if (stat(path, &known) == 0 && known.st_size > LIGHT_MAX_BYTES) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "%.1f GB, may have %.0f GB for a view",
                         (double)known.st_size / 1e9, LIGHT_MAX_BYTES / 1e9);
    }
    murk_status status = murk_map_file_read(&sections, &n, path, err);
    if (!status) {
        status = take_light(out, sections, n, path, max, err);
    }
    murk_map_file_release(sections, n);
    return status;
}

void murk_plan_points_release(murk_plan_points *points)
{
    free(points->point);
    *points = (murk_plan_points){0};
}
