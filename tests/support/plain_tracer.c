/* A photon tracer of some hundred lines by delta tracking, with a random
 * generator of its own (xorshift64*). It shares no code with murk, so that
 * agreement with it is evidence. */
#include "plain_tracer.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* xorshift64* (Vigna, ACM Trans. Math. Softw. 42 (2016) 30): in (0, 1). */
static double uniform(uint64_t *state)
{
    uint64_t x = *state;
    x ^= x >> 12;
    x ^= x << 25;
    x ^= x >> 27;
    *state = x;
    return ((double)((x * UINT64_C(0x2545f4914f6cdd1d)) >> 11) + 0.5) * 0x1p-53;
}

/* Henyey-Greenstein angle and even azimuth, in MCML's form (Wang et al.,
 * Comput. Methods Programs Biomed. 47 (1995) 131, eqs. 3.22 to 3.25). */
static void turn(double d[3], double g, uint64_t *state)
{
    const double u = uniform(state), phi = 6.283185307179586 * uniform(state);
    const double f = (1 - g * g) / (1 - g + 2 * g * u);
    const double mu = g == 0 ? 2 * u - 1 : (1 + g * g - f * f) / (2 * g);
    const double s = sqrt(1 - mu * mu);
    const double a = s * cos(phi), b = s * sin(phi);
    const double x = d[0], y = d[1], z = d[2];
    if (fabs(z) > 0.99999) {
        d[0] = a;
        d[1] = b;
        d[2] = z > 0 ? mu : -mu;
        return;
    }
    const double r = sqrt(1 - z * z);
    d[0] = (a * x * z - b * y) / r + x * mu;
    d[1] = (a * y * z + b * x) / r + y * mu;
    d[2] = -a * r + z * mu;
}

static bool is_outside(const plain_box *box, const double p[3])
{
    return p[0] < 0 || p[1] < 0 || p[2] < 0 || p[0] > box->size_m[0] ||
           p[1] > box->size_m[1] || p[2] > box->size_m[2];
}

/* The side that the flight back from outside came through last: the first on
 * the way out. */
static void count_side(const plain_box *box, const double p[3],
                       const double d[3], double weight, plain_result *out)
{
    double back = -1;
    int axis = 0;
    for (int k = 0; k < 3; ++k) {
        const double past = p[k] < 0 ? p[k] / d[k]
                            : p[k] > box->size_m[k]
                                ? (p[k] - box->size_m[k]) / d[k]
                                : -1;
        if (past > back) {
            back = past;
            axis = k;
        }
    }
    out->escaped[axis][p[axis] > 0] += weight;
}

typedef enum kinds { EVEN, BALL, VOXELS, LINEAR } kinds;

static inline bool is_in_ball(const plain_box *box, const double p[3])
{
    double square = 0;
    for (int k = 0; k < 3; ++k) {
        const double off = p[k] - box->center_m[k];
        square += off * off;
    }
    return square < box->radius_m * box->radius_m;
}

/* The cell of 1 m that contains p. */
static inline size_t cell_at(const plain_box *box, const double p[3])
{
    size_t cell = 0;
    for (int k = 0; k < 3; ++k) {
        const size_t n = (size_t)box->size_m[k];
        const size_t i = (size_t)p[k];
        cell = cell * n + (i < n ? i : n - 1);
    }
    return cell;
}

static inline double extinction_of(const plain_matter *m)
{
    return m->absorption_per_m + m->scattering_per_m;
}

static inline double linear_at(const plain_box *box, const double p[3])
{
    size_t corner = 0, stride[3], n = 1;
    double high[3], density = 0;
    for (int k = 2; k >= 0; --k) {
        const size_t cells = (size_t)box->size_m[k], i = (size_t)p[k];
        const size_t cell = i < cells ? i : cells - 1;
        high[k] = p[k] - (double)cell;
        stride[k] = n;
        corner += cell * n;
        n *= cells + 1;
    }
    for (int which = 0; which < 8; ++which) {
        const int x = which >> 2, y = which >> 1 & 1, z = which & 1;
        density += (x ? high[0] : 1 - high[0]) * (y ? high[1] : 1 - high[1]) *
                   (z ? high[2] : 1 - high[2]) *
                   (double)box->density[corner + (x ? stride[0] : 0) +
                                        (y ? stride[1] : 0) + (size_t)z];
    }
    return density;
}

/* A loop of its own for each kind, so that none pays for what it has not. */
static inline plain_result trace(const plain_box *box, kinds kind,
                                 uint64_t photons, uint64_t seed)
{
    plain_result out = {0};
    uint64_t state = seed * UINT64_C(0x9e3779b97f4a7c15) + 1;
    /* Chances of a real collision and of absorption, in the box and in the
     * ball. */
    const double majorant = box->majorant_per_m;
    const double real = extinction_of(&box->matter) / majorant;
    const double real_in_ball = extinction_of(&box->ball) / majorant;
    const double absorbs =
        box->matter.absorption_per_m / extinction_of(&box->matter);
    const double absorbs_in_ball =
        kind == BALL ? box->ball.absorption_per_m / extinction_of(&box->ball)
                     : 0;
    /* One photon after the other, from the same start. */
    for (uint64_t i = 0; i < photons; ++i) {
        double p[3], d[3], weight = 1;
        for (int k = 0; k < 3; ++k) {
            p[k] = box->start_m[k];
            d[k] = box->direction[k];
        }
        for (;;) {
            /* Fly to the next collision, real or null. */
            const double step = -log(uniform(&state)) / majorant;
            for (int k = 0; k < 3; ++k) {
                p[k] += step * d[k];
            }
            if (is_outside(box, p)) {
                count_side(box, p, d, weight, &out);
                break;
            }
            /* Null collision: fly on unchanged. */
            const bool in_ball = kind == BALL && is_in_ball(box, p);
            const double share =
                in_ball          ? real_in_ball
                : kind == VOXELS ? real * (double)box->density[cell_at(box, p)]
                : kind == LINEAR ? real * linear_at(box, p)
                                 : real;
            if (share < 1 && uniform(&state) > share) {
                continue;
            }
            /* Real collision: absorption or a new direction. */
            ++out.collisions;
            const double chance = in_ball ? absorbs_in_ball : absorbs;
            if (box->absorption) {
                box->absorption[cell_at(box, p)] += (float)(weight * chance);
            }
            if (box->has_weights) {
                out.absorbed += weight * chance;
                weight -= weight * chance;
            } else if (uniform(&state) < chance) {
                out.absorbed += 1;
                break;
            }
            turn(d, in_ball ? box->ball.mean_cosine : box->matter.mean_cosine,
                 &state);
        }
    }
    return out;
}

plain_result plain_trace(const plain_box *box, uint64_t photons, uint64_t seed)
{
    return box->density && box->is_linear ? trace(box, LINEAR, photons, seed)
           : box->density                 ? trace(box, VOXELS, photons, seed)
           : box->radius_m > 0            ? trace(box, BALL, photons, seed)
                                          : trace(box, EVEN, photons, seed);
}
