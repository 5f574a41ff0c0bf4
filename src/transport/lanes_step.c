/* The arithmetic of a collision, as loops over lanes (transport/lanes_step.h).
 *
 * Only the rounds of the random numbers are written in vectors. Logarithm, sine
 * and cosine are made of the operations of base/lanes.h (base/logarithm.h,
 * transport/turn.h). The walker
 * (transport/walk.c, medium/free_flight.c) makes the same operations in the
 * same order for one photon, and the test transport/lanes compares the two, so
 * a photon may change between lanes and walker at any event. */
#include "transport/lanes_step.h"

#include <string.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "base/logarithm.h"
#include "base/philox.h"
#include "medium/clip.h"
#include "medium/phase.h"
#include "transport/turn.h"

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
MURK_LANE_KERNEL count(murk_photon_lanes *restrict l, size_t n)
{
    MURK_FOR_LANES(n)
    {
        l->number[i] += 1;
    }
}

MURK_LANE_KERNEL draw_depth(murk_photon_lanes *restrict l, size_t n)
{
    MURK_FOR_LANES(n)
    {
        l->tau[i] = -murk_log(uniform_of(l->word_depth[i]));
    }
}

/* As murk_media_fly() in a single even medium. */
MURK_LANE_KERNEL fly(murk_photon_lanes *restrict l, size_t n)
{
    MURK_FOR_LANES(n)
    {
        const double extinction = l->extinction_per_m[i];
        l->meets[i] = murk_truth(extinction > 0);
        l->distance_m[i] = l->tau[i] / extinction;
    }
}

/* The part of each ray inside a region. */
MURK_LANE_KERNEL clip(murk_photon_lanes *restrict l,
                      const murk_lane_facts *facts, size_t k, size_t n)
{
    const murk_lane_region *region = &facts->regions.region[k];
    const murk_box box = region->box;
    const murk_vec3 center = region->center;
    const double radius_m = region->radius_m, level_m = region->level_m;
    const murk_lane_rays *restrict ray = &l->ray;
    double *restrict from = l->span_from[k], *restrict to = l->span_to[k];
    MURK_FOR_LANES(n)
    {
        from[i] = 0;
        to[i] = INFINITY;
    }
    if (region->shape == MURK_LANE_BELOW) {
        MURK_FOR_LANES(n)
        {
            double t0 = 0, t1 = INFINITY;
            murk_clip_coordinate(-INFINITY, level_m, ray->z[i], ray->dz[i], &t0,
                                 &t1);
            from[i] = t0;
            to[i] = t1;
        }
    } else if (region->shape == MURK_LANE_BOX) {
        MURK_FOR_LANES(n)
        {
            const murk_vec3 o = {ray->x[i], ray->y[i], ray->z[i]};
            const murk_vec3 d = {ray->dx[i], ray->dy[i], ray->dz[i]};
            double t0 = 0, t1 = INFINITY;
            murk_clip_box(&box, o, d, &t0, &t1);
            from[i] = t0;
            to[i] = t1;
        }
    } else if (region->shape == MURK_LANE_SPHERE) {
        MURK_FOR_LANES(n)
        {
            const murk_vec3 o = {ray->x[i], ray->y[i], ray->z[i]};
            const murk_vec3 d = {ray->dx[i], ray->dy[i], ray->dz[i]};
            double t0 = 0, t1 = INFINITY;
            murk_clip_sphere(center, radius_m, o, d, &t0, &t1);
            from[i] = t0;
            to[i] = t1;
        }
    }
    if (region->is_grid) {
        const double *const of_ray[6] = {ray->x,  ray->y,  ray->z,
                                         ray->dx, ray->dy, ray->dz};
        facts->grid->clip(&l->grid, &facts->regions.grid, of_ray, from, to, n);
        memset(l->region_extinction[k], 0, sizeof l->region_extinction[k]);
    }
    /* A region that neither replaces others nor has an extinction divides no
     * ray. */
    const double replaces = murk_truth(region->replaces);
    const double *extinction =
        region->is_grid ? l->grid.scale : l->region_extinction[k];
    MURK_FOR_LANES(n)
    {
        const bool counts =
            (from[i] < to[i]) & ((replaces != 0) | (extinction[i] > 0));
        to[i] = murk_choose(counts, to[i], -INFINITY);
        from[i] = murk_choose(counts, from[i], -INFINITY);
    }
}

/* 1 for regions that replace those before them, else 0. */
static inline void note_replacing(double replaces[MURK_LANE_REGIONS_MAX],
                                  const murk_lane_regions *regions)
{
    for (size_t k = 0; k < MURK_LANE_REGIONS_MAX; ++k) {
        replaces[k] = murk_truth(k < regions->n && regions->region[k].replaces);
    }
}

/* The sum of the extinctions of the regions that fill the interval of a lane.
 * The extinction of a grid counts as 0 until the lane has collided. */
static inline __attribute__((always_inline)) double
extinction_of(const murk_photon_lanes *restrict l, const double *replaces,
              size_t regions, size_t i)
{
    const double from = l->piece_from[i], to = l->piece_to[i];
    double extinction = 0;
    for (size_t k = 0; k < regions; ++k) {
        const bool is_present =
            (l->span_from[k][i] <= from) & (l->span_to[k][i] >= to);
        const double sum =
            (1 - replaces[k]) * extinction + l->region_extinction[k][i];
        extinction = murk_choose(is_present, sum, extinction);
    }
    return extinction;
}

/* The next end of a part of the ray beyond piece_from; a lane without one flies
 * no further. Then the regions that fill the interval up to there: the last one
 * that replaces those before it, and the sum of the extinctions. */
MURK_LANE_KERNEL find_piece(murk_photon_lanes *restrict l,
                            const double *replaces, size_t regions, size_t n)
{
    MURK_FOR_LANES(n)
    {
        const double here = l->piece_from[i];
        double to = INFINITY, flies = 0;
        /* The nearest end over all regions. */
        for (size_t k = 0; k < regions; ++k) {
            const double from_k = l->span_from[k][i], to_k = l->span_to[k][i];
            const double ahead = murk_choose(from_k > here, from_k, to_k);
            const bool is_ahead = ahead > here;
            flies = murk_choose(is_ahead, 1, flies);
            to = murk_choose(is_ahead & (ahead < to), ahead, to);
        }
        l->flies[i] *= flies;
        l->piece_to[i] = to;
    }
    MURK_FOR_LANES(n)
    {
        const double from = l->piece_from[i], to = l->piece_to[i];
        double first = 0;
        for (size_t k = 0; k < regions; ++k) {
            const bool is_present =
                (l->span_from[k][i] <= from) & (l->span_to[k][i] >= to);
            first =
                murk_choose(is_present & (replaces[k] != 0), (double)k, first);
        }
        l->first_region[i] = first;
        l->piece_extinction[i] = extinction_of(l, replaces, regions, i);
    }
}

/* Selects the region of the collision in proportion to extinction, from
 * first_region on. */
MURK_LANE_KERNEL select_region(murk_photon_lanes *restrict l, size_t regions,
                               size_t n)
{
    MURK_FOR_LANES(n)
    {
        const double from = l->piece_from[i], to = l->piece_to[i];
        const double first = l->first_region[i];
        double left = uniform_of(l->word_medium[i]) * l->piece_extinction[i];
        double scattering = 0, region = l->region[i], albedo = l->albedo[i],
               g = l->g[i];
        /* The region at which the sum of extinctions exceeds the drawn share.
         */
        for (size_t k = 0; k < regions; ++k) {
            const double number = (double)k;
            const double extinction = l->region_extinction[k][i];
            const double albedo_k = l->region_albedo[k][i];
            const bool is_present = (l->span_from[k][i] <= from) &
                                    (l->span_to[k][i] >= to) &
                                    (number >= first) & (extinction > 0);
            const bool is_chosen = is_present & (left >= 0);
            scattering = murk_choose(
                is_present, scattering + extinction * albedo_k, scattering);
            region = murk_choose(is_chosen, number, region);
            albedo = murk_choose(is_chosen, albedo_k, albedo);
            g = murk_choose(is_chosen, l->region_g[k][i], g);
            left = murk_choose(is_chosen, left - extinction, left);
        }
        l->scattering_per_m[i] = scattering;
        l->region[i] = region;
        l->albedo[i] = albedo;
        l->g[i] = g;
    }
}

/* The flight in one region: a short cut, to the numbers of fly_regions(). */
MURK_LANE_KERNEL fly_region(murk_photon_lanes *restrict l, size_t n)
{
    MURK_FOR_LANES(n)
    {
        const double extinction = l->region_extinction[0][i];
        const double from = l->span_from[0][i], to = l->span_to[0][i];
        const double tau = l->tau[i];
        const double reached = from + tau / extinction;
        const bool meets =
            (to > from) & (extinction > 0) & (extinction * (to - from) >= tau);
        l->meets[i] = murk_truth(meets);
        l->distance_m[i] = reached < to ? reached : to;
        l->piece_extinction[i] = extinction;
    }
}

/* The same for a region that is filled by the grid. */
MURK_LANE_KERNEL fly_grid(murk_photon_lanes *restrict l,
                          const murk_lane_facts *facts, size_t n)
{
    /* Walk along the part in the region. */
    murk_grid_lanes *restrict g = &l->grid;
    MURK_FOR_LANES(n)
    {
        const double from = l->span_from[0][i], to = l->span_to[0][i];
        g->walks[i] = murk_truth(to > from);
        g->from[i] = from;
        g->end[i] = to;
        g->offset[i] = 0;
        g->limit[i] = l->tau[i];
        g->sum[i] = 0;
    }
    facts->grid->walk(g, &facts->regions.grid, n);
    /* The collision, where the walk has stopped. */
    MURK_FOR_LANES(n)
    {
        l->meets[i] = g->walks[i] * g->stops[i];
        l->distance_m[i] = g->to[i];
        l->piece_extinction[i] = g->value[i] * g->scale[i];
    }
}

/* The collision in the only region, with the extinction found there. */
MURK_LANE_KERNEL select_only_region(murk_photon_lanes *restrict l, size_t n)
{
    MURK_FOR_LANES(n)
    {
        const double albedo = l->region_albedo[0][i];
        l->scattering_per_m[i] = l->piece_extinction[i] * albedo;
        l->region[i] = 0;
        l->albedo[i] = albedo;
        l->g[i] = l->region_g[0][i];
    }
}

/* The walks through the grid, of lanes whose interval is in the region of the
 * grid. */
MURK_LANE_KERNEL walk_grid(murk_photon_lanes *restrict l,
                           const murk_lane_facts *facts, size_t n)
{
    murk_grid_lanes *restrict g = &l->grid;
    for (size_t k = 0; k < facts->regions.n; ++k) {
        if (!facts->regions.region[k].is_grid) {
            continue;
        }
        const double region = (double)k;
        MURK_FOR_LANES(n)
        {
            const bool is_present = (l->span_from[k][i] <= l->piece_from[i]) &
                                    (l->span_to[k][i] >= l->piece_to[i]) &
                                    (region >= l->first_region[i]);
            const bool walks = is_present & (l->flies[i] != 0);
            g->walks[i] = murk_truth(walks);
            g->from[i] = l->piece_from[i];
            g->end[i] = l->piece_to[i];
            g->offset[i] = l->piece_extinction[i];
            g->limit[i] = l->tau[i];
            g->sum[i] = l->depth[i];
        }
        facts->grid->walk(g, &facts->regions.grid, n);
        MURK_FOR_LANES(n)
        {
            const bool walks = g->walks[i] != 0;
            const bool stops = walks & (g->stops[i] != 0);
            const double extinction = g->value[i] * g->scale[i];
            l->depth[i] = murk_choose(walks, g->sum[i], l->depth[i]);
            l->meets[i] = murk_choose(stops, 1, l->meets[i]);
            l->distance_m[i] = murk_choose(stops, g->to[i], l->distance_m[i]);
            l->region_extinction[k][i] =
                murk_choose(stops, extinction, l->region_extinction[k][i]);
            /* A lane that has walked crosses no even interval. */
            l->piece_extinction[i] =
                murk_choose(walks, 0, l->piece_extinction[i]);
        }
    }
}

/* Without the collisions of walks: where the extinction of the interval is
 * even, moves to its end, or to the collision. */
MURK_LANE_KERNEL cross_even(murk_photon_lanes *restrict l, size_t n)
{
    MURK_FOR_LANES(n)
    {
        const double extinction = l->piece_extinction[i];
        const double begin = l->piece_from[i], end = l->piece_to[i];
        const double depth = l->depth[i], tau = l->tau[i];
        const double more = depth + extinction * (end - begin);
        const double reached = begin + (tau - depth) / extinction;
        const bool flies = l->flies[i] != 0;
        const bool has_extinction = extinction > 0;
        const bool is_even = flies & has_extinction & (more >= tau);
        const double distance_m = reached < end ? reached : end;
        const bool meets = is_even | (flies & (l->meets[i] != 0));
        l->meets[i] = murk_choose(meets, 1, l->meets[i]);
        l->distance_m[i] = murk_choose(is_even, distance_m, l->distance_m[i]);
        l->depth[i] = murk_choose(has_extinction, more, depth);
        l->flies[i] = murk_truth(flies & !meets);
        /* A lane that meets keeps the interval of the collision. */
        l->piece_from[i] = murk_choose(flies & !meets, end, begin);
    }
}

/* From end to end of the parts of the ray in the regions, until the optical
 * depth is reached. The compiler knows the number of regions and unrolls the
 * loops over them inside of loops over lanes; it may exceed that of the scene,
 * because empty parts of rays and extinctions of 0 change nothing. */
MURK_LANE_KERNEL fly_pieces(murk_photon_lanes *restrict l,
                            const murk_lane_facts *facts, size_t regions,
                            size_t n)
{
    double replaces[MURK_LANE_REGIONS_MAX];
    note_replacing(replaces, &facts->regions);
    MURK_FOR_LANES(n)
    {
        l->piece_from[i] = 0;
        l->depth[i] = 0;
        l->meets[i] = 0;
        l->flies[i] = 1;
    }
    uint64_t flying = 1; /* not 0 if some lane flies on */
    for (size_t step = 0; flying != 0 && step <= 2 * facts->regions.n; ++step) {
        find_piece(l, replaces, regions, n);
        if (facts->grid) {
            walk_grid(l, facts, n);
        }
        cross_even(l, n);
        flying = 0;
        MURK_FOR_LANES(n)
        {
            uint64_t bits;
            memcpy(&bits, &l->flies[i], sizeof bits);
            flying |= bits;
        }
    }
    /* A lane that met keeps piece_from, so find_piece() gave it the same
     * interval again. The extinctions of the interval, with that of the grid.
     */
    if (facts->grid) {
        MURK_FOR_LANES(n)
        {
            l->piece_extinction[i] = extinction_of(l, replaces, regions, i);
        }
    }
    select_region(l, regions, n);
}

/* As murk_media_fly() in several regions. */
MURK_LANE_KERNEL fly_regions(murk_photon_lanes *restrict l,
                             const murk_lane_facts *facts, size_t n)
{
    const size_t regions = facts->regions.n;
    for (size_t k = 0; k < regions; ++k) {
        clip(l, facts, k, n);
    }
    if (regions == 1) {
        if (facts->grid) {
            fly_grid(l, facts, n);
        } else {
            fly_region(l, n);
        }
        select_only_region(l, n);
    } else if (regions == 2) {
        fly_pieces(l, facts, 2, n);
    } else if (regions <= 4) {
        fly_pieces(l, facts, 4, n);
    } else {
        fly_pieces(l, facts, MURK_LANE_REGIONS_MAX, n);
    }
}

/* The azimuths of photons that roulette has decided on: what the roulette has
 * left of its random number. Apart from the loop over all lanes, because the
 * division is dear and packets that are split need none. A photon that roulette
 * has absorbed gets an azimuth without use. */
MURK_LANE_KERNEL draw_azimuth(murk_photon_lanes *restrict l, size_t n)
{
    MURK_FOR_LANES(n)
    {
        const double u = l->azimuth[i];
        l->azimuth[i] = murk_choose(l->is_split[i] != 0, u, u / l->albedo[i]);
    }
}

MURK_LANE_KERNEL collide(murk_photon_lanes *restrict l,
                         const murk_lane_facts *facts, size_t n)
{
    const murk_path_sides sides = facts->sides;
    const int64_t events_max = facts->events_max;
    const double min_quanta = facts->min_quanta;
    murk_lane_rays *restrict ray = &l->ray;
    /* Move. */
    MURK_FOR_LANES(n)
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
        l->meets[i] = murk_truth(meets);
        /* The walker holds the position inside of the sides, which changes no
         * position that lies there. */
        ray->x[i] = murk_choose(meets, x, ray->x[i]);
        ray->y[i] = murk_choose(meets, y, ray->y[i]);
        ray->z[i] = murk_choose(meets, z, ray->z[i]);
    }
    /* Split the packet, or decide by roulette (walk.c, scatter()). */
    uint64_t roulette = 0; /* not 0 if some lane has too few quanta to split */
    MURK_FOR_LANES(n)
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
        l->scatters[i] = murk_truth(meets & survives);
        l->is_split[i] = murk_truth(is_split);
        l->azimuth[i] = u;
        l->is_new[i] = murk_choose(meets, 0, l->is_new[i]);
        l->cosine[i] = murk_hg_sample(l->g[i], uniform_of(l->word_cosine[i]));
        roulette |= is_split ? 0 : UINT64_MAX;
    }
    if (roulette != 0) {
        draw_azimuth(l, n);
    }
}

MURK_LANE_KERNEL turn(murk_photon_lanes *restrict l, size_t n)
{
    murk_lane_rays *restrict ray = &l->ray;
    MURK_FOR_LANES(n)
    {
        const bool scatters = l->scatters[i] != 0;
        const murk_vec3 d = {ray->dx[i], ray->dy[i], ray->dz[i]};
        const murk_vec3 turned =
            murk_turned_direction(d, l->cosine[i], l->azimuth[i]);
        ray->dx[i] = murk_choose(scatters, turned.x, d.x);
        ray->dy[i] = murk_choose(scatters, turned.y, d.y);
        ray->dz[i] = murk_choose(scatters, turned.z, d.z);
    }
}

/* A bit for each lane that is not scattered in a medium, or not scored. */
static inline __attribute__((always_inline)) uint64_t
unfinished(const murk_photon_lanes *restrict l,
           const int64_t *restrict is_scored, size_t n)
{
    uint64_t bits = 0;
    MURK_FOR_LANES(n)
    {
        const bool is_finished =
            (l->meets[i] != 0) & (l->scatters[i] != 0) & (is_scored[i] != 0);
        bits |= (is_finished ? UINT64_C(0) : UINT64_C(1)) << i;
    }
    return bits;
}

/* One function of each kernel for an instruction set. */
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
    target static uint64_t unfinished_##set(                                  \
        const murk_photon_lanes *l, const int64_t *is_scored, size_t n)       \
    {                                                                         \
        return unfinished(l, is_scored, n);                                   \
    }

MURK_COMPILED_FOR(baseline, MURK_TARGET_BASELINE, words_2, PRODUCT_2)
#if defined(__x86_64__)
MURK_COMPILED_FOR(avx2, MURK_TARGET_AVX2, words_4, PRODUCT_4)
MURK_COMPILED_FOR(avx512, MURK_TARGET_AVX512, words_8, PRODUCT_8)
#endif

#define STEPS(number, set)                                                     \
    [number] = {number,        draw_##set, fly_##set,       fly_regions_##set, \
                collide_##set, turn_##set, unfinished_##set}

const murk_lane_steps *murk_lane_steps_chosen(void)
{
    static const murk_lane_steps steps[MURK_LANE_SETS] = {
        STEPS(MURK_LANES_BASELINE, baseline),
#if defined(__x86_64__)
        STEPS(MURK_LANES_AVX2, avx2),
        STEPS(MURK_LANES_AVX512, avx512),
#endif
    };
    murk_lane_set set;
    return murk_lane_set_chosen(&set) ? &steps[set] : NULL;
}
