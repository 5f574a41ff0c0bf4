/* The arithmetic of a collision, as loops over lanes (transport/lanes_step.h).
 *
 * The loops are plain C without branches, which the compiler turns into vector
 * instructions; only the rounds of the random numbers are written in vectors.
 * Everything is compiled once for each instruction set. All sets give the same
 * bits: the operations are those of IEEE 754 in the same order, products and
 * sums are never fused (-ffp-contract=off), and logarithm, sine and cosine are
 * made of such operations (base/logarithm.h, transport/turn.h). The walker
 * (transport/walk.c, medium/free_flight.c) makes the same operations in the
 * same order for one photon, and the test transport/lanes compares the two, so
 * a photon may change between lanes and walker at any event. */
#include "transport/lanes_step.h"

#include <stdlib.h>
#include <string.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "base/logarithm.h"
#include "base/philox.h"
#include "medium/clip.h"
#include "medium/phase.h"
#include "transport/turn.h"

/* Inlined into a function for each instruction set. */
#define KERNEL static inline __attribute__((always_inline)) void

/* A loop over lanes. The rounding down changes nothing: it tells the compiler
 * that n is a multiple of the group. */
#define FOR_LANES(n) \
    for (size_t i = 0; i < ((n) & ~(size_t)(MURK_LANE_GROUP - 1)); ++i)

/* The number in (0, 1) of a random word; murk_uniform() for a word in the space
 * of a number. The word is put into the mantissa of 2^52, because few
 * processors convert several integers of 64 bits at once. */
static inline double uniform_of(uint64_t word)
{
    const uint64_t bits = word | UINT64_C(0x4330000000000000);
    double number;
    memcpy(&number, &bits, sizeof number);
    return (number - 0x1p52 + 0.5) * 0x1p-32;
}

/* The rounds of murk_philox() for several photons, in vectors of `vector`. Each
 * element of 64 bits holds a word in the lower half and anything in the upper
 * half; `product` multiplies the lower halves. A compiler that is given the
 * plain loop spends most of the time on moving words between vectors. */
#define MURK_WORDS_FOR(set, target, vector, product)                          \
    target static void words_##set(const murk_photon_lanes *l, uint32_t seed, \
                                   uint32_t purpose, uint64_t *to_a,          \
                                   uint64_t *to_b, uint64_t *to_c,            \
                                   uint64_t *to_d, size_t n)                  \
    {                                                                         \
        const vector zero = {0};                                              \
        const vector factor_a = zero + MURK_PHILOX_FACTOR_A;                  \
        const vector factor_c = zero + MURK_PHILOX_FACTOR_C;                  \
        const vector low = zero + UINT32_MAX;                                 \
        for (size_t i = 0; i < n; i += sizeof zero / sizeof zero[0]) {        \
            /* The counter: photon, event, slot 0. */                         \
            vector a, b, c, d = zero;                                         \
            memcpy(&a, &l->photon_low[i], sizeof a);                          \
            memcpy(&b, &l->photon_high[i], sizeof b);                         \
            memcpy(&c, &l->number[i], sizeof c);                              \
            /* The rounds. */                                                 \
            uint32_t key_a = seed, key_c = purpose;                           \
            for (int round = 0; round < MURK_PHILOX_ROUNDS; ++round) {        \
                const vector from_a = product(a, factor_a);                   \
                const vector from_c = product(c, factor_c);                   \
                a = from_c >> 32 ^ b ^ (zero + key_a);                        \
                c = from_a >> 32 ^ d ^ (zero + key_c);                        \
                b = from_c;                                                   \
                d = from_a;                                                   \
                key_a += MURK_PHILOX_KEY_A;                                   \
                key_c += MURK_PHILOX_KEY_C;                                   \
            }                                                                 \
            /* Without the upper halves. */                                   \
            a &= low;                                                         \
            b &= low;                                                         \
            c &= low;                                                         \
            d &= low;                                                         \
            memcpy(to_a + i, &a, sizeof a);                                   \
            memcpy(to_b + i, &b, sizeof b);                                   \
            memcpy(to_c + i, &c, sizeof c);                                   \
            memcpy(to_d + i, &d, sizeof d);                                   \
        }                                                                     \
    }

/* Vectors of 2, 4 and 8 elements, and the products of the lower halves. */
typedef uint64_t words_2 __attribute__((vector_size(16)));
#if defined(__x86_64__)
typedef uint64_t words_4 __attribute__((vector_size(32)));
typedef uint64_t words_8 __attribute__((vector_size(64)));
#define PRODUCT_2(a, b) ((words_2)_mm_mul_epu32((__m128i)(a), (__m128i)(b)))
#define PRODUCT_4(a, b) ((words_4)_mm256_mul_epu32((__m256i)(a), (__m256i)(b)))
#define PRODUCT_8(a, b) ((words_8)_mm512_mul_epu32((__m512i)(a), (__m512i)(b)))
#else
#define PRODUCT_2(a, b) (((a)&UINT32_MAX) * (b))
#endif

/* The number of the next event. */
KERNEL count(murk_photon_lanes *restrict l, size_t n)
{
    FOR_LANES(n)
    {
        l->number[i] += 1;
    }
}

KERNEL draw_depth(murk_photon_lanes *restrict l, size_t n)
{
    FOR_LANES(n)
    {
        l->tau[i] = -murk_log(uniform_of(l->word_depth[i]));
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
        l->meets[i] = truth(extinction > 0);
        l->distance_m[i] = l->tau[i] / extinction;
    }
}

/* The part of each ray inside a region. */
KERNEL clip(murk_photon_lanes *restrict l, const murk_lane_facts *facts,
            size_t k, size_t n)
{
    const murk_even_region *region = &facts->region[k];
    const murk_box box = region->box;
    const murk_vec3 center = region->center;
    const double radius_m = region->radius_m, level_m = region->level_m;
    const murk_lane_rays *restrict ray = &l->ray;
    double *restrict from = l->span_from[k], *restrict to = l->span_to[k];
    FOR_LANES(n)
    {
        from[i] = 0;
        to[i] = INFINITY;
    }
    if (region->shape == MURK_EVEN_BELOW) {
        FOR_LANES(n)
        {
            murk_clip_coordinate(-INFINITY, level_m, ray->z[i], ray->dz[i],
                                 &from[i], &to[i]);
        }
    } else if (region->shape == MURK_EVEN_BOX) {
        FOR_LANES(n)
        {
            const murk_vec3 o = {ray->x[i], ray->y[i], ray->z[i]};
            const murk_vec3 d = {ray->dx[i], ray->dy[i], ray->dz[i]};
            murk_clip_box(&box, o, d, &from[i], &to[i]);
        }
    } else if (region->shape == MURK_EVEN_SPHERE) {
        FOR_LANES(n)
        {
            const murk_vec3 o = {ray->x[i], ray->y[i], ray->z[i]};
            const murk_vec3 d = {ray->dx[i], ray->dy[i], ray->dz[i]};
            murk_clip_sphere(center, radius_m, o, d, &from[i], &to[i]);
        }
    }
    /* A region that neither replaces others nor has an extinction divides no
     * ray. */
    const double replaces = truth(region->replaces);
    FOR_LANES(n)
    {
        const bool counts =
            (from[i] < to[i]) &
            ((replaces != 0) | (l->region_extinction[k][i] > 0));
        to[i] = counts ? to[i] : -INFINITY;
        from[i] = counts ? from[i] : -INFINITY;
    }
}

/* The next end of a part of the ray beyond piece_from; a lane without one flies
 * no further. */
KERNEL find_piece(murk_photon_lanes *restrict l, size_t regions, size_t n)
{
    FOR_LANES(n)
    {
        l->piece_to[i] = INFINITY;
        l->is_ahead[i] = 0;
        l->piece_extinction[i] = 0;
    }
    /* The nearest end over all regions. */
    for (size_t k = 0; k < regions; ++k) {
        const double *restrict from = l->span_from[k], *restrict to =
                                                           l->span_to[k];
        FOR_LANES(n)
        {
            const double here = l->piece_from[i];
            const double ahead = from[i] > here ? from[i] : to[i];
            const bool is_ahead = ahead > here;
            const bool is_nearer = is_ahead & (ahead < l->piece_to[i]);
            l->is_ahead[i] = is_ahead ? 1 : l->is_ahead[i];
            l->piece_to[i] = is_nearer ? ahead : l->piece_to[i];
        }
    }
    FOR_LANES(n)
    {
        l->flies[i] *= l->is_ahead[i];
    }
}

/* Adds the extinctions of the regions that fill the interval. */
KERNEL add_extinctions(murk_photon_lanes *restrict l,
                       const murk_lane_facts *facts, size_t n)
{
    for (size_t k = 0; k < facts->regions; ++k) {
        const double *restrict from = l->span_from[k], *restrict to =
                                                           l->span_to[k];
        const double keeps = facts->region[k].replaces ? 0 : 1;
        const double *restrict extinction = l->region_extinction[k];
        FOR_LANES(n)
        {
            const bool is_present =
                (from[i] <= l->piece_from[i]) & (to[i] >= l->piece_to[i]);
            const double before = l->piece_extinction[i];
            const double sum = keeps * before + extinction[i];
            l->piece_extinction[i] = is_present ? sum : before;
        }
    }
}

/* Selects the region of the collision in proportion to extinction. */
KERNEL select_region(murk_photon_lanes *restrict l,
                     const murk_lane_facts *facts, size_t n)
{
    FOR_LANES(n)
    {
        l->left[i] = uniform_of(l->word_medium[i]) * l->piece_extinction[i];
        l->scattering_per_m[i] = 0;
        l->first_region[i] = 0;
    }
    /* The last region that replaces those before it. */
    for (size_t k = 0; k < facts->regions; ++k) {
        const double *restrict from = l->span_from[k], *restrict to =
                                                           l->span_to[k];
        const double replaces = truth(facts->region[k].replaces);
        FOR_LANES(n)
        {
            const bool is_present =
                (from[i] <= l->piece_from[i]) & (to[i] >= l->piece_to[i]);
            const bool is_first = is_present & (replaces != 0);
            l->first_region[i] = is_first ? (double)k : l->first_region[i];
        }
    }
    /* The region at which the sum of extinctions exceeds the drawn share. */
    for (size_t k = 0; k < facts->regions; ++k) {
        const double *restrict from = l->span_from[k], *restrict to =
                                                           l->span_to[k];
        const double *restrict extinction = l->region_extinction[k];
        const double *restrict albedo = l->region_albedo[k];
        const double *restrict g = l->region_g[k];
        const double number = (double)k;
        FOR_LANES(n)
        {
            const bool is_present =
                (from[i] <= l->piece_from[i]) & (to[i] >= l->piece_to[i]) &
                (number >= l->first_region[i]) & (extinction[i] > 0);
            const bool is_chosen = is_present & (l->left[i] >= 0);
            const double scattering = l->scattering_per_m[i];
            l->scattering_per_m[i] =
                is_present ? scattering + extinction[i] * albedo[i]
                           : scattering;
            l->region[i] = is_chosen ? number : l->region[i];
            l->albedo[i] = is_chosen ? albedo[i] : l->albedo[i];
            l->g[i] = is_chosen ? g[i] : l->g[i];
            l->left[i] = is_chosen ? l->left[i] - extinction[i] : l->left[i];
        }
    }
}

/* fly_regions() for one region: a short cut, to the same numbers. */
KERNEL fly_region(murk_photon_lanes *restrict l, size_t n)
{
    FOR_LANES(n)
    {
        const double extinction = l->region_extinction[0][i];
        const double from = l->span_from[0][i], to = l->span_to[0][i];
        const double tau = l->tau[i], albedo = l->region_albedo[0][i];
        const double reached = from + tau / extinction;
        const bool meets =
            (to > from) & (extinction > 0) & (extinction * (to - from) >= tau);
        l->meets[i] = truth(meets);
        l->distance_m[i] = reached < to ? reached : to;
        l->piece_extinction[i] = extinction;
        l->scattering_per_m[i] = extinction * albedo;
        l->region[i] = 0;
        l->albedo[i] = albedo;
        l->g[i] = l->region_g[0][i];
    }
}

/* As murk_media_fly() in several even regions: from end to end of the parts of
 * the ray in the regions, until the optical depth is reached. */
KERNEL fly_regions(murk_photon_lanes *restrict l, const murk_lane_facts *facts,
                   size_t n)
{
    for (size_t k = 0; k < facts->regions; ++k) {
        clip(l, facts, k, n);
    }
    if (facts->regions == 1) {
        fly_region(l, n);
        return;
    }
    FOR_LANES(n)
    {
        l->piece_from[i] = 0;
        l->depth[i] = 0;
        l->meets[i] = 0;
        l->flies[i] = 1;
    }
    double flying = 1;
    for (size_t step = 0; flying != 0 && step <= 2 * facts->regions; ++step) {
        find_piece(l, facts->regions, n);
        add_extinctions(l, facts, n);
        FOR_LANES(n)
        {
            const double extinction = l->piece_extinction[i];
            const double begin = l->piece_from[i], end = l->piece_to[i];
            const double depth = l->depth[i], tau = l->tau[i];
            const double more = depth + extinction * (end - begin);
            const double reached = begin + (tau - depth) / extinction;
            const bool flies = l->flies[i] != 0;
            const bool has_extinction = extinction > 0;
            const bool meets = flies & has_extinction & (more >= tau);
            const double distance_m = reached < end ? reached : end;
            l->meets[i] = meets ? 1 : l->meets[i];
            l->distance_m[i] = meets ? distance_m : l->distance_m[i];
            l->depth[i] = has_extinction ? more : depth;
            l->flies[i] = truth(flies & !meets);
            /* A lane that meets keeps the interval of the collision. */
            l->piece_from[i] = (flies & !meets) ? end : begin;
        }
        flying = 0;
        FOR_LANES(n)
        {
            flying = l->flies[i] > flying ? l->flies[i] : flying;
        }
    }
    /* A lane that met keeps piece_from, so find_piece() gives it the same
     * interval again. */
    select_region(l, facts, n);
}

KERNEL collide(murk_photon_lanes *restrict l, const murk_lane_facts *facts,
               size_t n)
{
    const murk_path_sides sides = facts->sides;
    const int64_t events_max = facts->events_max;
    const double min_quanta = facts->min_quanta;
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
        const bool meets = (l->meets[i] != 0) & is_inside &
                           ((int64_t)l->number[i] <= events_max);
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
        const double u = uniform_of(l->word_roulette[i]);
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
        l->cosine[i] = murk_hg_sample(l->g[i], uniform_of(l->word_cosine[i]));
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
#define MURK_COMPILED_FOR(set, target, vector, product)                       \
    MURK_WORDS_FOR(set, target, vector, product)                              \
    target static void draw_##set(murk_photon_lanes *l,                       \
                                  const murk_lane_facts *facts, size_t n)     \
    {                                                                         \
        count(l, n);                                                          \
        if (facts->any_media) {                                               \
            words_##set(l, facts->seed, facts->purpose, l->word_depth,        \
                        l->word_medium, l->word_roulette, l->word_cosine, n); \
            draw_depth(l, n);                                                 \
        }                                                                     \
        if (facts->any_surfaces) {                                            \
            words_##set(l, facts->seed, facts->surface_purpose,               \
                        l->surface_word[0], l->surface_word[1],               \
                        l->surface_word[2], l->surface_word[3], n);           \
        }                                                                     \
    }                                                                         \
    target static void fly_##set(murk_photon_lanes *l, size_t n)              \
    {                                                                         \
        fly(l, n);                                                            \
    }                                                                         \
    target static void fly_regions_##set(                                     \
        murk_photon_lanes *l, const murk_lane_facts *facts, size_t n)         \
    {                                                                         \
        fly_regions(l, facts, n);                                             \
    }                                                                         \
    target static void collide_##set(murk_photon_lanes *l,                    \
                                     const murk_lane_facts *facts, size_t n)  \
    {                                                                         \
        collide(l, facts, n);                                                 \
    }                                                                         \
    target static void turn_##set(murk_photon_lanes *l, size_t n)             \
    {                                                                         \
        turn(l, n);                                                           \
    }                                                                         \
    static const murk_lane_steps steps_##set = {                              \
        #set,          draw_##set, fly_##set, fly_regions_##set,              \
        collide_##set, turn_##set};

MURK_COMPILED_FOR(baseline, , words_2, PRODUCT_2)

#if defined(__x86_64__)
MURK_COMPILED_FOR(avx2, __attribute__((target("avx2"))), words_4, PRODUCT_4)
MURK_COMPILED_FOR(avx512,
                  __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw"))),
                  words_8, PRODUCT_8)
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
