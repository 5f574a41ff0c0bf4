/* Photons in lanes: delta tracking (Woodcock et al., ANL-7050, 1965) in single
 * precision. Each lane holds one photon; one step moves all lanes to the next
 * tentative collision by the same operations without branches, so the compiler
 * turns the loop over lanes into vector instructions of whatever width the
 * machine has (-O3 -march=native -ffast-math). Photons that have ended are then
 * replaced one by one. There are several vectors of lanes, so the processor
 * overlaps the work of one vector with that of the next.
 *
 * Random numbers: xoshiro128+, one generator a lane (Blackman and Vigna, ACM
 * Trans. Math. Softw. 47 (2021) 36). New directions: an orthonormal basis
 * without a special case at the poles (Duff et al., J. Comput. Graph. Tech. 6
 * (2017) 1). Polynomials for logarithm, sine and cosine are good to some 1e-6.
 */
#include "lane_loop.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define LANES 64 /* the fastest of 16 to 128, measured with AVX2 */

typedef struct lanes {
    float x[LANES], y[LANES], z[LANES];    /* position */
    float dx[LANES], dy[LANES], dz[LANES]; /* direction */
    float weight[LANES];
    float absorbed[LANES]; /* weight that the last step left behind */
    int is_on[LANES];      /* 1: the lane has a photon */
    int is_real[LANES];    /* 1: the last step ended in a real collision */
    int has_ended[LANES];  /* 1: the last step ended the photon */
    uint32_t s0[LANES], s1[LANES], s2[LANES], s3[LANES]; /* of the generator */
} lanes;

typedef enum kinds { EVEN, BALL, VOXELS, LINEAR } kinds;

/* The box in single precision. */
typedef struct field {
    float size[3], start[3], direction[3];
    float majorant;
    float center[3], square; /* of the ball and of its radius */
    float share[2];      /* extinction / majorant, of the box, of the ball */
    float chance[2];     /* absorption / extinction */
    float g[2], half[2]; /* mean cosine g, and .5 / g */
    int n[3];            /* cells of 1 m */
    const float *density;
} field;

/* splitmix64, which fills the states of generators (Steele et al., OOPSLA
 * 2014). */
static uint64_t split(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

/* Uniform in (0, 1). */
static inline float uniform(lanes *g, int l)
{
    const uint32_t sum = g->s0[l] + g->s3[l], t = g->s1[l] << 9;
    g->s2[l] ^= g->s0[l];
    g->s3[l] ^= g->s1[l];
    g->s1[l] ^= g->s2[l];
    g->s0[l] ^= g->s3[l];
    g->s2[l] ^= t;
    g->s3[l] = g->s3[l] << 11 | g->s3[l] >> 21;
    return ((float)(int)(sum >> 9) + .5f) * 0x1p-23f;
}

/* Logarithm of x in (0, 1): exponent, and the series of artanh for the
 * mantissa in [1/sqrt(2), sqrt(2)). */
static inline float log_of(float x)
{
    int bits;
    memcpy(&bits, &x, sizeof bits);
    const int shifted = bits - 0x3f3504f3; /* 1/sqrt(2) */
    const int exponent = shifted >> 23;
    bits -= exponent * (1 << 23);
    float m;
    memcpy(&m, &bits, sizeof m);
    const float s = (m - 1) / (m + 1), q = s * s;
    return (float)exponent * .69314718f +
           s * (2 + q * (.66666667f +
                         q * (.4f + q * (.28571429f + q * .22222222f))));
}

/* Sine and cosine of the angle 2 pi u, u in (0, 1): Taylor series of half the
 * angle less a quarter turn, in (-pi/2, pi/2), and the formulas of the double
 * angle. The angle is off by half a turn, which is nothing to an even azimuth.
 */
static inline void sine_cosine(float u, float *sine, float *cosine)
{
    const float a = (u - .5f) * 3.14159265f, q = a * a;
    const float s =
        a * (1 + q * (-1 / 6.f +
                      q * (1 / 120.f + q * (-1 / 5040.f + q / 362880.f))));
    const float c =
        1 +
        q * (-.5f + q * (1 / 24.f +
                         q * (-1 / 720.f + q * (1 / 40320.f - q / 3628800.f))));
    *sine = 2 * s * c;
    *cosine = 1 - 2 * s * s;
}

/* The trilinear density between whole coordinates, ny and nz of them along two
 * axes. */
static inline __attribute__((always_inline)) float
linear_at(const float *d, int ny, int nz, float x, float y, float z)
{
    const int i = (int)x, j = (int)y, k = (int)z;
    const int c = (i * ny + j) * nz + k;
    const float u = x - (float)i, v = y - (float)j, w = z - (float)k;
    const float d00 = d[c] + w * (d[c + 1] - d[c]);
    const float d01 = d[c + nz] + w * (d[c + nz + 1] - d[c + nz]);
    const int e = c + ny * nz;
    const float d10 = d[e] + w * (d[e + 1] - d[e]);
    const float d11 = d[e + nz] + w * (d[e + nz + 1] - d[e + nz]);
    const float low = d00 + v * (d01 - d00), high = d10 + v * (d11 - d10);
    return low + u * (high - low);
}

/* One flight and, where a real collision is met, one scattering, in all lanes.
 */
static inline __attribute__((always_inline)) void
step(lanes *g, const field *field_of_box, kinds kind, bool has_weights)
{
    const field f = *field_of_box; /* a copy, which no store can change */
    const float share_of_box = f.share[0], share_of_ball = f.share[1];
    const float chance_of_box = f.chance[0], chance_of_ball = f.chance[1];
    const float g_of_box = f.g[0], g_of_ball = f.g[1];
    const float half_of_box = f.half[0], half_of_ball = f.half[1];
    const float per_majorant = -1 / f.majorant;
    for (int l = 0; l < LANES; ++l) {
        /* Fly to the next tentative collision. */
        const float s = log_of(uniform(g, l)) * per_majorant;
        const float x = g->x[l] + s * g->dx[l];
        const float y = g->y[l] + s * g->dy[l];
        const float z = g->z[l] + s * g->dz[l];
        const int is_inside = (x > 0) & (y > 0) & (z > 0) & (x < f.size[0]) &
                              (y < f.size[1]) & (z < f.size[2]) & g->is_on[l];

        /* The matter there. Lanes outside read the first cell instead. */
        const float rx = x - f.center[0], ry = y - f.center[1];
        const float rz = z - f.center[2];
        const int in_ball =
            kind == BALL && rx * rx + ry * ry + rz * rz < f.square;
        float share = in_ball ? share_of_ball : share_of_box;
        const float chance = in_ball ? chance_of_ball : chance_of_box;
        const float mean = in_ball ? g_of_ball : g_of_box;
        const float half = in_ball ? half_of_ball : half_of_box;
        const float in = (float)is_inside;
        const float px = x * in, py = y * in, pz = z * in;
        if (kind == VOXELS) {
            share *= f.density[((int)px * f.n[1] + (int)py) * f.n[2] + (int)pz];
        } else if (kind == LINEAR) {
            share *= linear_at(f.density, f.n[1] + 1, f.n[2] + 1, px, py, pz);
        }
        const int is_real =
            kind == EVEN ? is_inside : is_inside & (uniform(g, l) < share);

        /* Absorption: part of the weight, or the whole photon by chance. */
        const float part = is_real ? g->weight[l] * chance : 0;
        const int is_absorbed =
            has_weights ? 0 : is_real & (uniform(g, l) < chance);
        g->weight[l] -= has_weights ? part : 0;
        g->absorbed[l] = part;

        /* A new direction by Henyey and Greenstein. */
        const float t =
            (1 - mean * mean) / (1 - mean + 2 * mean * uniform(g, l));
        const float near = (1 + mean * mean - t * t) * half;
        const float mu = near > 1 ? 1 : near < -1 ? -1 : near;
        const float across = sqrtf(1 - mu * mu);
        float sine, cosine;
        sine_cosine(uniform(g, l), &sine, &cosine);
        const float u = across * cosine, v = across * sine;
        const float dx = g->dx[l], dy = g->dy[l], dz = g->dz[l];
        const float sign = copysignf(1, dz);
        const float a = -1 / (sign + dz), b = dx * dy * a;
        const float nx = u * (1 + sign * dx * dx * a) + v * b + mu * dx;
        const float ny = u * sign * b + v * (sign + dy * dy * a) + mu * dy;
        const float nz = -u * sign * dx - v * dy + mu * dz;
        /* One step of Newton's keeps the length at 1. */
        const float length = 1.5f - .5f * (nx * nx + ny * ny + nz * nz);
        g->dx[l] = is_real ? nx * length : dx;
        g->dy[l] = is_real ? ny * length : dy;
        g->dz[l] = is_real ? nz * length : dz;
        g->x[l] = x;
        g->y[l] = y;
        g->z[l] = z;
        g->is_real[l] = is_real;
        g->has_ended[l] = g->is_on[l] & ((is_inside ^ 1) | is_absorbed);
    }
}

/* The side that the flight back from outside came through last. */
static void count_side(const lanes *g, int l, const field *f, plain_result *out)
{
    const float p[3] = {g->x[l], g->y[l], g->z[l]};
    const float d[3] = {g->dx[l], g->dy[l], g->dz[l]};
    float back = -1;
    int axis = 0;
    for (int k = 0; k < 3; ++k) {
        const float past = p[k] <= 0            ? p[k] / d[k]
                           : p[k] >= f->size[k] ? (p[k] - f->size[k]) / d[k]
                                                : -1;
        if (past > back) {
            back = past;
            axis = k;
        }
    }
    out->escaped[axis][p[axis] > 0] += (double)g->weight[l];
}

static void launch(lanes *g, int l, const field *f)
{
    g->x[l] = f->start[0];
    g->y[l] = f->start[1];
    g->z[l] = f->start[2];
    g->dx[l] = f->direction[0];
    g->dy[l] = f->direction[1];
    g->dz[l] = f->direction[2];
    g->weight[l] = 1;
    g->is_on[l] = 1;
}

/* A loop of its own for each kind, so that none pays for what it has not. */
static inline __attribute__((always_inline)) plain_result
trace(const plain_box *box, const field *f, kinds kind, bool has_weights,
      uint64_t photons, uint64_t seed)
{
    plain_result out = {0};
    lanes all, *g = &all;
    memset(g, 0, sizeof *g);
    uint64_t launched = 0, on = 0, state = seed;
    /* Seed the generators, and launch a photon in each lane. */
    for (int l = 0; l < LANES; ++l) {
        const uint64_t a = split(&state), b = split(&state);
        g->s0[l] = (uint32_t)a;
        g->s1[l] = (uint32_t)(a >> 32);
        g->s2[l] = (uint32_t)b;
        g->s3[l] = (uint32_t)(b >> 32);
        launch(g, l, f);
        g->is_on[l] = launched < photons;
        launched += (uint64_t)g->is_on[l];
        on += (uint64_t)g->is_on[l];
    }
    while (on > 0) {
        step(g, f, kind, has_weights);
        /* Sums over the lanes, and the tally. */
        int real = 0, ended = 0;
        float absorbed = 0;
        for (int l = 0; l < LANES; ++l) {
            real += g->is_real[l];
            ended += g->has_ended[l];
            absorbed += g->absorbed[l];
        }
        out.collisions += (uint64_t)real;
        out.absorbed += has_weights ? (double)absorbed : 0;
        for (int l = 0; box->absorption && l < LANES; ++l) {
            if (g->is_real[l]) {
                box->absorption[((int)g->x[l] * f->n[1] + (int)g->y[l]) *
                                    f->n[2] +
                                (int)g->z[l]] += g->absorbed[l];
            }
        }
        /* Count the photons that have ended, and refill their lanes. */
        for (int l = 0; ended > 0 && l < LANES; ++l) {
            if (!g->has_ended[l]) {
                continue;
            }
            --ended;
            if (g->is_real[l]) {
                out.absorbed += 1;
            } else {
                count_side(g, l, f, &out);
            }
            launch(g, l, f);
            g->is_on[l] = launched < photons;
            on -= launched >= photons;
            launched += launched < photons;
        }
    }
    return out;
}

static plain_result trace_kind(const plain_box *box, const field *f,
                               bool has_weights, uint64_t photons,
                               uint64_t seed)
{
    return box->density && box->is_linear
               ? trace(box, f, LINEAR, has_weights, photons, seed)
           : box->density ? trace(box, f, VOXELS, has_weights, photons, seed)
           : box->radius_m > 0
               ? trace(box, f, BALL, has_weights, photons, seed)
               : trace(box, f, EVEN, has_weights, photons, seed);
}

plain_result lane_trace(const plain_box *box, uint64_t photons, uint64_t seed)
{
    field f = {.majorant = (float)box->majorant_per_m,
               .square = (float)(box->radius_m * box->radius_m),
               .density = box->density};
    for (int k = 0; k < 3; ++k) {
        f.size[k] = (float)box->size_m[k];
        f.n[k] = (int)box->size_m[k];
        f.start[k] = (float)box->start_m[k];
        f.direction[k] = (float)box->direction[k];
        f.center[k] = (float)box->center_m[k];
    }
    /* Without a ball the second matter is never met. */
    const plain_matter matter[2] = {
        box->matter, box->radius_m > 0 ? box->ball : box->matter};
    for (int i = 0; i < 2; ++i) {
        const plain_matter *m = &matter[i];
        const double extinction = m->absorption_per_m + m->scattering_per_m;
        f.share[i] = (float)(extinction / box->majorant_per_m);
        f.chance[i] = (float)(m->absorption_per_m / extinction);
        f.g[i] = (float)m->mean_cosine;
        f.half[i] = (float)(.5 / m->mean_cosine);
    }
    return box->has_weights ? trace_kind(box, &f, true, photons, seed)
                            : trace_kind(box, &f, false, photons, seed);
}
