#include "plain_tracer.h"

#include <math.h>
#include <stdbool.h>

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
                       const double d[3], plain_result *out)
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
    ++out->escaped[axis][p[axis] > 0];
}

plain_result plain_trace(const plain_box *box, uint64_t photons, uint64_t seed)
{
    plain_result out = {0};
    uint64_t state = seed * UINT64_C(0x9e3779b97f4a7c15) + 1;
    const double extinction = box->absorption_per_m + box->scattering_per_m;
    const double real = extinction / box->majorant_per_m;
    const double absorbs = box->absorption_per_m / extinction;
    for (uint64_t i = 0; i < photons; ++i) {
        double p[3], d[3];
        for (int k = 0; k < 3; ++k) {
            p[k] = box->start_m[k];
            d[k] = box->direction[k];
        }
        for (;;) {
            const double step = -log(uniform(&state)) / box->majorant_per_m;
            for (int k = 0; k < 3; ++k) {
                p[k] += step * d[k];
            }
            if (is_outside(box, p)) {
                count_side(box, p, d, &out);
                break;
            }
            if (real < 1 && uniform(&state) > real) {
                continue;
            }
            ++out.collisions;
            if (uniform(&state) < absorbs) {
                ++out.absorbed;
                break;
            }
            turn(d, box->mean_cosine, &state);
        }
    }
    return out;
}
