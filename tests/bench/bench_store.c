/* The reference of the surface map: a plain loop over Embree that follows
 * photons through the rooms of tests/bench/rooms.yaml without mist and stores
 * those that are reflected, on one thread. Lamps shine alike in all directions,
 * surfaces reflect .6 by the cosine law; a record is 32 bytes. Own random
 * numbers (xorshift64*), no code of murk.
 *
 *   bench_store MESH.obj RECORDS
 *
 * Prints one JSON object with the numbers of emitted and stored photons. */
#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define MESH_MAX 100000 /* vertices and triangles of the mesh */
#define ALBEDO   .6f

static const float lamps[6][3] = {{3.6f, 2.3f, 2.4f}, {9.5f, 2.2f, 2.4f},
                                  {6.0f, 5.2f, 2.5f}, {2.4f, 8.0f, 2.4f},
                                  {5.9f, 7.9f, 2.5f}, {9.4f, 8.0f, 2.4f}};

typedef struct record {
    float position[3], direction[3];
    uint32_t photon, triangle;
} record;

static _Noreturn void stop(const char *why)
{
    fprintf(stderr, "bench_store: %s\n", why);
    exit(1);
}

/* xorshift64* (Vigna, ACM Trans. Math. Softw. 42 (2016) 30): in (0, 1). */
static float uniform(uint64_t *state)
{
    uint64_t x = *state;
    x ^= x >> 12;
    x ^= x << 25;
    x ^= x >> 27;
    *state = x;
    return ((float)((x * UINT64_C(0x2545f4914f6cdd1d)) >> 41) + .5f) * 0x1p-23f;
}

/* Triangles of an OBJ file of lines "v x y z" and "f a b c". */
static RTCGeometry read_mesh(RTCDevice device, const char *path)
{
    FILE *in = fopen(path, "r");
    if (!in) {
        stop("no such mesh");
    }
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float(*vertex)[3] = malloc(MESH_MAX * sizeof *vertex);
    unsigned(*corner)[3] = malloc(MESH_MAX * sizeof *corner);
    size_t vertices = 0, triangles = 0;
    char line[256];
    /* Vertices and corners, which the file counts from 1. */
    while (vertex && corner && fgets(line, sizeof line, in)) {
        float *v = vertex[vertices];
        unsigned *c = corner[triangles];
        if (sscanf(line, "v %f %f %f", &v[0], &v[1], &v[2]) == 3) {
            ++vertices;
        } else if (sscanf(line, "f %u %u %u", &c[0], &c[1], &c[2]) == 3) {
            --c[0];
            --c[1];
            --c[2];
            ++triangles;
        }
        if (vertices == MESH_MAX || triangles == MESH_MAX) {
            stop("the mesh is too large");
        }
    }
    fclose(in);
    /* Hand exactly so many over to Embree. */
    float *to_vertex =
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0,
                                RTC_FORMAT_FLOAT3, sizeof *vertex, vertices);
    unsigned *to_corner =
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0,
                                RTC_FORMAT_UINT3, sizeof *corner, triangles);
    if (!to_vertex || !to_corner) {
        stop("no triangles");
    }
    for (size_t i = 0; i < vertices * 3; ++i) {
        to_vertex[i] = vertex[i / 3][i % 3];
    }
    for (size_t i = 0; i < triangles * 3; ++i) {
        to_corner[i] = corner[i / 3][i % 3];
    }
    free(vertex);
    free(corner);
    rtcCommitGeometry(mesh);
    return mesh;
}

/* The next surface; false when there is none. */
static bool meets(RTCScene scene, struct RTCRayHit *hit)
{
#if RTC_VERSION_MAJOR < 4
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, hit);
#else
    rtcIntersect1(scene, hit, NULL);
#endif
    return hit->hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

/* A direction by the cosine law about the normal, on the side that the ray came
 * from: the unit normal plus a point of the unit sphere. */
static void reflect(struct RTCRayHit *hit, uint64_t *state)
{
    float n[3] = {hit->hit.Ng_x, hit->hit.Ng_y, hit->hit.Ng_z};
    const float along =
        n[0] * hit->ray.dir_x + n[1] * hit->ray.dir_y + n[2] * hit->ray.dir_z;
    const float scale =
        copysignf(1 / sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), -along);
    const float z = 2 * uniform(state) - 1, r = sqrtf(1 - z * z);
    const float phi = 6.28318531f * uniform(state);
    const float x = n[0] * scale + r * cosf(phi);
    const float y = n[1] * scale + r * sinf(phi);
    const float w = n[2] * scale + z;
    const float length = 1 / sqrtf(x * x + y * y + w * w);
    hit->ray.dir_x = x * length;
    hit->ray.dir_y = y * length;
    hit->ray.dir_z = w * length;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        stop("usage: bench_store MESH.obj RECORDS");
    }
    RTCDevice device = rtcNewDevice("threads=1,user_threads=1");
    RTCScene scene = rtcNewScene(device);
    RTCGeometry mesh = read_mesh(device, argv[1]);
    rtcAttachGeometry(scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);

    const size_t wanted = (size_t)atof(argv[2]);
    record *stored = malloc(wanted * sizeof *stored);
    if (!stored) {
        stop("out of memory");
    }
    uint64_t state = 88172645463325252;
    size_t n = 0;
    uint32_t emitted = 0;
    for (; n < wanted; ++emitted) {
        /* Emit from one lamp after the other, evenly in all directions. */
        const float *lamp = lamps[emitted % 6];
        const float z = 2 * uniform(&state) - 1, r = sqrtf(1 - z * z);
        const float phi = 6.28318531f * uniform(&state);
        struct RTCRayHit hit = {.ray = {.org_x = lamp[0],
                                        .org_y = lamp[1],
                                        .org_z = lamp[2],
                                        .dir_x = r * cosf(phi),
                                        .dir_y = r * sinf(phi),
                                        .dir_z = z}};
        /* From surface to surface until the photon is absorbed. */
        while (n < wanted) {
            hit.ray.tnear = 1e-4f;
            hit.ray.tfar = INFINITY;
            hit.ray.mask = UINT32_MAX;
            hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            if (!meets(scene, &hit) || uniform(&state) > ALBEDO) {
                break;
            }
            hit.ray.org_x += hit.ray.tfar * hit.ray.dir_x;
            hit.ray.org_y += hit.ray.tfar * hit.ray.dir_y;
            hit.ray.org_z += hit.ray.tfar * hit.ray.dir_z;
            stored[n++] =
                (record){{hit.ray.org_x, hit.ray.org_y, hit.ray.org_z},
                         {hit.ray.dir_x, hit.ray.dir_y, hit.ray.dir_z},
                         emitted,
                         hit.hit.primID};
            reflect(&hit, &state);
        }
    }
    double sum = 0; /* so that no store is left out */
    for (size_t i = 0; i < n; ++i) {
        sum += (double)stored[i].position[2];
    }
    printf("{\"emitted\": %u, \"stored\": %zu, \"mean_z_m\": %.4f}\n", emitted,
           n, sum / (double)n);
    free(stored);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
    return 0;
}
