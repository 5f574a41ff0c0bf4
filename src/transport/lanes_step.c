/* The arithmetic of a collision, as loops over lanes (transport/lanes_step.h).
 *
 * The loops are plain C without branches, which the compiler turns into vector
 * instructions; each loop is compiled once for every instruction set. All sets
 * give the same bits: the operations are those of IEEE 754 in the same order,
 * products and sums are never fused (-ffp-contract=off), and logarithm, sine
 * and cosine are made of such operations (base/logarithm.h, transport/turn.h).
 * The walker (transport/walk.c) uses the same functions, so a photon may change
 * between lanes and walker at any event. */
#include "transport/lanes_step.h"

#include <stdlib.h>
#include <string.h>

#include "base/logarithm.h"
#include "base/philox.h"
#include "medium/phase.h"
#include "transport/turn.h"

/* Inlined into a function for each instruction set. */
#define KERNEL static inline __attribute__((always_inline)) void

/* A loop over lanes. The compiler may know that their number is a multiple of
 * the group. */
#define FOR_LANES(n) \
    for (size_t i = 0; i < ((n) & ~(size_t)(MURK_LANE_GROUP - 1)); ++i)

KERNEL draw(murk_photon_lanes *restrict l, const murk_lane_facts *facts,
            size_t n)
{
    const uint32_t seed = facts->seed, purpose = facts->purpose;
    FOR_LANES(n)
    {
        const uint32_t number = l->number[i] + 1;
        uint32_t word[4];
        murk_philox(seed, purpose, l->photon_low[i], l->photon_high[i], number,
                    0, word);
        l->number[i] = number;
        l->word_depth[i] = word[0];
        l->word_medium[i] = word[1];
        l->word_roulette[i] = word[2];
        l->word_cosine[i] = word[3];
    }
    FOR_LANES(n)
    {
        l->tau[i] = -murk_log(murk_uniform(l->word_depth[i]));
    }
}

static inline double truth(bool is_true)
{
    return is_true ? 1 : 0;
}

/* As murk_media_fly() in a single even medium. */
KERNEL fly(murk_photon_lanes *restrict l, size_t n)
{
    FOR_LANES(n)
    {
        const double extinction = l->extinction_per_m[i];
        const double limit_m = l->limit_m[i], tau = l->tau[i];
        const double distance_m = tau / extinction;
        l->meets[i] = truth(extinction > 0) * truth(limit_m > 0) *
                      truth(extinction * limit_m >= tau);
        l->distance_m[i] = distance_m < limit_m ? distance_m : limit_m;
    }
}

KERNEL collide(murk_photon_lanes *restrict l, const murk_lane_facts *facts,
               size_t n)
{
    const murk_path_sides sides = facts->sides;
    const double events_max = facts->events_max;
    const double min_quanta = facts->min_quanta;
    const bool is_open = facts->is_open;
    murk_lane_rays *restrict ray = &l->ray;
    /* Move. */
    FOR_LANES(n)
    {
        const double d = l->distance_m[i];
        const double x = ray->x[i] + d * ray->dx[i];
        const double y = ray->y[i] + d * ray->dy[i];
        const double z = ray->z[i] + d * ray->dz[i];
        const bool is_inside = (x >= sides.x[0]) & (x <= sides.x[1]) &
                               (y >= sides.y[0]) & (y <= sides.y[1]) &
                               (z >= sides.z[0]) & (z <= sides.z[1]);
        const bool meets = (l->meets[i] != 0) & (is_inside | !is_open) &
                           ((double)l->number[i] <= events_max);
        l->meets[i] = truth(meets);
        ray->x[i] = meets ? murk_path_side_hold(x, sides.x) : ray->x[i];
        ray->y[i] = meets ? murk_path_side_hold(y, sides.y) : ray->y[i];
        ray->z[i] = meets ? murk_path_side_hold(z, sides.z) : ray->z[i];
    }
    /* Split the packet, or decide by roulette (walk.c, scatter()). */
    FOR_LANES(n)
    {
        const bool meets = l->meets[i] != 0;
        const double before = ray->quanta[i];
        const double albedo = l->albedo[i];
        const double u = murk_uniform(l->word_roulette[i]);
        const bool is_split = before > min_quanta;
        const double share = floor(before * albedo + u);
        const double left = share < before ? share : before;
        const double after = (meets & is_split) ? left : before;
        const bool survives =
            (is_split & (left > 0)) | (!is_split & (u < albedo));
        ray->quanta[i] = after;
        l->absorbed[i] += before - after;
        l->scatters[i] = truth(meets & survives);
        l->azimuth[i] = is_split ? u : u / albedo;
        l->is_new[i] = meets ? 0 : l->is_new[i];
        l->cosine[i] = murk_hg_sample(l->g[i], murk_uniform(l->word_cosine[i]));
    }
}

KERNEL turn(murk_photon_lanes *restrict l, size_t n)
{
    murk_lane_rays *restrict ray = &l->ray;
    FOR_LANES(n)
    {
        const bool scatters = l->scatters[i] != 0;
        const murk_vec3 d = {ray->dx[i], ray->dy[i], ray->dz[i]};
        const murk_vec3 turned =
            murk_turned_direction(d, l->cosine[i], l->azimuth[i]);
        ray->dx[i] = scatters ? turned.x : d.x;
        ray->dy[i] = scatters ? turned.y : d.y;
        ray->dz[i] = scatters ? turned.z : d.z;
    }
}

/* One function of each kernel for an instruction set, and the row of them. */
#define MURK_COMPILED_FOR(set, target)                                       \
    target static void draw_##set(murk_photon_lanes *l,                      \
                                  const murk_lane_facts *facts, size_t n)    \
    {                                                                        \
        draw(l, facts, n);                                                   \
    }                                                                        \
    target static void fly_##set(murk_photon_lanes *l, size_t n)             \
    {                                                                        \
        fly(l, n);                                                           \
    }                                                                        \
    target static void collide_##set(murk_photon_lanes *l,                   \
                                     const murk_lane_facts *facts, size_t n) \
    {                                                                        \
        collide(l, facts, n);                                                \
    }                                                                        \
    target static void turn_##set(murk_photon_lanes *l, size_t n)            \
    {                                                                        \
        turn(l, n);                                                          \
    }                                                                        \
    static const murk_lane_steps steps_##set = {draw_##set, fly_##set,       \
                                                collide_##set, turn_##set};

MURK_COMPILED_FOR(baseline, )

#if defined(__x86_64__)
MURK_COMPILED_FOR(avx2, __attribute__((target("avx2"))))
MURK_COMPILED_FOR(avx512,
                  __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw"))))
#endif

const murk_lane_steps *murk_lane_steps_chosen(void)
{
    const char *name = getenv("MURK_LANES");
    name = name ? name : "";
    if (strcmp(name, "off") == 0) {
        return NULL;
    }
#if defined(__x86_64__)
    const bool has_avx512 = __builtin_cpu_supports("avx512f") &&
                            __builtin_cpu_supports("avx512dq") &&
                            __builtin_cpu_supports("avx512vl") &&
                            __builtin_cpu_supports("avx512bw");
    const bool is_baseline = strcmp(name, "baseline") == 0;
    if (has_avx512 && !is_baseline && strcmp(name, "avx2") != 0) {
        return &steps_avx512;
    }
    if (__builtin_cpu_supports("avx2") && !is_baseline) {
        return &steps_avx2;
    }
#endif
    return &steps_baseline;
}
