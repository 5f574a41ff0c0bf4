/* The peer of the occlusion bench: the sightlines are stored as packets of 16
 * rays beforehand, and rtcOccluded16 casts one packet after the other on the
 * thread pool. Nothing of murk's own code stands between the rays and Embree.
 */
#include "peer_occlusion.h"

#include "base/pool.h"
#include "base/tally.h"

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include <stdlib.h>
#include <string.h>

#define WIDE  16
#define BATCH 64 /* packets */

typedef struct packet {
    int valid[WIDE] __attribute__((aligned(64)));
    struct RTCRay16 ray;
} packet;

struct peer_occlusion {
    RTCDevice device;
    RTCScene scene;
    packet *packet;
    size_t packets, capacity;
};

static bool add_mesh(peer_occlusion *peer, const murk_mesh *mesh)
{
    RTCGeometry geometry =
        rtcNewGeometry(peer->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *vertex = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                            RTC_FORMAT_FLOAT3,
                                            3 * sizeof *vertex, mesh->vertices);
    unsigned *corner = rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
        3 * sizeof *corner, mesh->triangles);
    if (!vertex || !corner) {
        rtcReleaseGeometry(geometry);
        return false;
    }
    memcpy(vertex, mesh->vertex_m, 3 * mesh->vertices * sizeof *vertex);
    memcpy(corner, mesh->corner, 3 * mesh->triangles * sizeof *corner);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(peer->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(peer->scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(peer->scene);
    return rtcGetDeviceError(peer->device) == RTC_ERROR_NONE;
}

peer_occlusion *peer_occlusion_create(const murk_mesh *mesh)
{
    peer_occlusion *peer = calloc(1, sizeof *peer);
    if (!peer) {
        return NULL;
    }
    peer->device = rtcNewDevice("threads=1,user_threads=1,set_affinity=0");
    peer->scene = peer->device ? rtcNewScene(peer->device) : NULL;
    if (!peer->scene || !add_mesh(peer, mesh)) {
        peer_occlusion_destroy(peer);
        return NULL;
    }
    return peer;
}

void peer_occlusion_destroy(peer_occlusion *peer)
{
    if (!peer) {
        return;
    }
    if (peer->scene) {
        rtcReleaseScene(peer->scene);
    }
    if (peer->device) {
        rtcReleaseDevice(peer->device);
    }
    free(peer->packet);
    free(peer);
}

static packet *new_packet(peer_occlusion *peer)
{
    if (peer->packets == peer->capacity) {
        const size_t capacity = peer->capacity ? 2 * peer->capacity : 1024;
        packet *grown = aligned_alloc(64, capacity * sizeof *grown);
        if (!grown) {
            return NULL;
        }
        if (peer->packets) {
            memcpy(grown, peer->packet, peer->packets * sizeof *grown);
        }
        free(peer->packet);
        peer->packet = grown;
        peer->capacity = capacity;
    }
    packet *p = &peer->packet[peer->packets++];
    memset(p, 0, sizeof *p);
    return p;
}

static void set_lane(packet *p, size_t lane, murk_vec3 from, murk_vec3 sensor,
                     double trim_m)
{
    murk_vec3 offset = murk_sub(from, sensor);
    const double trim = trim_m / murk_length(offset);
    const murk_vec3 origin = murk_along(sensor, trim, offset);
    offset = murk_scale(1 - 2 * trim, offset);
    struct RTCRay16 *r = &p->ray;
    p->valid[lane] = -1;
    r->org_x[lane] = (float)origin.x;
    r->org_y[lane] = (float)origin.y;
    r->org_z[lane] = (float)origin.z;
    r->dir_x[lane] = (float)offset.x;
    r->dir_y[lane] = (float)offset.y;
    r->dir_z[lane] = (float)offset.z;
    r->tfar[lane] = 1;
    r->mask[lane] = UINT32_MAX;
}

bool peer_occlusion_add(peer_occlusion *peer, const murk_vec3 *from, size_t n,
                        murk_vec3 sensor, double trim_m)
{
    packet *p = NULL;
    for (size_t i = 0; i < n; ++i) {
        p = i % WIDE == 0 ? new_packet(peer) : p;
        if (!p) {
            return false;
        }
        set_lane(p, i % WIDE, from[i], sensor, trim_m);
    }
    return true;
}

typedef struct cast {
    const peer_occlusion *peer;
    bool is_coherent;
    murk_tally blocked;
} cast;

static void cast_batch(void *context, uint64_t batch)
{
    cast *c = context;
    const peer_occlusion *peer = c->peer;
    const size_t begin = (size_t)batch * BATCH;
    const size_t end =
        begin + BATCH < peer->packets ? begin + BATCH : peer->packets;
/* The hint about coherence has another name in each version of Embree. */
#if RTC_VERSION_MAJOR < 4
    struct RTCIntersectContext how;
    rtcInitIntersectContext(&how);
    how.flags = c->is_coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                               : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
#else
    struct RTCOccludedArguments how;
    rtcInitOccludedArguments(&how);
    how.flags = c->is_coherent ? RTC_RAY_QUERY_FLAG_COHERENT
                               : RTC_RAY_QUERY_FLAG_INCOHERENT;
#endif
    /* Embree sets tfar of a blocked ray to minus infinity. */
    int64_t blocked = 0;
    for (size_t i = begin; i < end; ++i) {
        const packet *p = &peer->packet[i];
        struct RTCRay16 ray = p->ray;
#if RTC_VERSION_MAJOR < 4
        rtcOccluded16(p->valid, peer->scene, &how, &ray);
#else
        rtcOccluded16(p->valid, peer->scene, &ray, &how);
#endif
        for (int lane = 0; lane < WIDE; ++lane) {
            blocked += ray.tfar[lane] < 0;
        }
    }
    murk_tally_add(&c->blocked, blocked);
}

size_t peer_occlusion_cast(const peer_occlusion *peer, unsigned threads,
                           bool is_coherent)
{
    cast c = {.peer = peer, .is_coherent = is_coherent};
    murk_pool_run(threads, (peer->packets + BATCH - 1) / BATCH, cast_batch, &c);
    return (size_t)murk_tally_read(&c.blocked);
}
