/* Evaluates the series of Lorenz-Mie theory (preset/mie.h).
 *
 * With the Riccati-Bessel functions psi_n(x), chi_n(x) (signs of Bohren and
 * Huffman: xi = psi - i chi), and the logarithmic derivative D_n of psi_n at m
 * x, m being the relative refractive index, a coefficient is
 *
 *     a_n = N / (N - i C),  N = A psi_n - psi_{n-1},  C = A chi_n - chi_{n-1},
 *
 * where A is D_n / m + n / x for a_n, and m D_n + n / x for b_n. The share that
 * a term absorbs is Re a_n - |a_n|^2. Written out, this is Im A times the
 * Wronskian psi_n chi_{n-1} - psi_{n-1} chi_n = -1, divided by |N - i C|^2: no
 * difference of nearly equal numbers, however small the absorption is.
 * Extinction is then the sum of scattering and absorption.
 *
 * D_n, and the ratios psi_n / psi_{n-1} beyond n = x, are computed by downward
 * recurrence; psi_n below n = x and chi_n by upward recurrence. Each direction
 * is the stable one. */
#include "preset/mie.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* The number of angles that are computed together: eight doubles fill a
 * register of AVX-512. */
#define LANES 8

typedef struct complex_number {
    double re, im;
} complex_number;

struct murk_mie {
    size_t capacity;       /* number of terms for which there is memory */
    size_t terms;          /* number of terms of the last sphere */
    complex_number *a, *b; /* index 1..terms */
    complex_number *d;     /* index 1..terms */
    double *ratio;         /* psi_n / psi_{n-1}, index x < n <= terms */
};

static complex_number divide(complex_number p, complex_number q)
{
    const double scale = 1 / (q.re * q.re + q.im * q.im);
    return (complex_number){(p.re * q.re + p.im * q.im) * scale,
                            (p.im * q.re - p.re * q.im) * scale};
}

static double squared(complex_number p)
{
    return p.re * p.re + p.im * p.im;
}

/* Re(p conj(q)) */
static double alike(complex_number p, complex_number q)
{
    return p.re * q.re + p.im * q.im;
}

/* The number of terms of the series for size parameter x (Wiscombe 1980). */
static size_t terms_of(double x)
{
    const double width = cbrt(x);
    if (x <= 8) {
        return (size_t)(x + 4 * width + 1) + 1;
    }
    return (size_t)(x + (x < 4200 ? 4.05 : 4) * width + 2) + 1;
}

murk_status murk_mie_create(murk_mie **out, double largest, murk_error *err)
{
    assert(out && largest >= MURK_MIE_SIZE_MIN && largest <= MURK_MIE_SIZE_MAX);
    murk_mie *mie = calloc(1, sizeof *mie);
    if (mie) {
        mie->capacity = terms_of(largest);
        const size_t count = mie->capacity + 2;
        mie->a = calloc(count, sizeof *mie->a);
        mie->b = calloc(count, sizeof *mie->b);
        mie->d = calloc(count, sizeof *mie->d);
        mie->ratio = calloc(count, sizeof *mie->ratio);
    }
    if (!mie || !mie->a || !mie->b || !mie->d || !mie->ratio) {
        murk_mie_destroy(mie);
        return murk_no_memory(err, "", "for a sphere");
    }
    *out = mie;
    return MURK_OK;
}

void murk_mie_destroy(murk_mie *mie)
{
    if (mie) {
        free(mie->a);
        free(mie->b);
        free(mie->d);
        free(mie->ratio);
        free(mie);
    }
}

/* D_n(z), n = 1..terms. The recurrence D_{n-1} = n/z - 1/(D_n + n/z) forgets
 * the starting value within a few |z|^(1/3) terms of n = |z|, the width over
 * which psi changes from an oscillation to a power. */
static void derivatives(murk_mie *mie, complex_number z)
{
    const double size = hypot(z.re, z.im);
    size_t n = (size_t)(size + 8 * cbrt(size) + 16);
    if (n < mie->terms + 16) {
        n = mie->terms + 16;
    }
    const complex_number inverse = divide((complex_number){1, 0}, z);
    complex_number d = {(double)n * inverse.re, (double)n * inverse.im};
    for (; n > 1; --n) {
        const double order = (double)n;
        const complex_number step = {order * inverse.re, order * inverse.im};
        const complex_number sum = {d.re + step.re, d.im + step.im};
        const complex_number part = divide((complex_number){1, 0}, sum);
        d = (complex_number){step.re - part.re, step.im - part.im};
        if (n - 1 <= mie->terms) {
            mie->d[n - 1] = d;
        }
    }
}

static void ratios(murk_mie *mie, double x)
{
    size_t n = mie->terms + (size_t)(8 * cbrt(x)) + 16;
    double ratio = x / (2 * (double)n + 1);
    for (; n >= 1 && (double)n > x; --n) {
        ratio = 1 / ((2 * (double)n + 1) / x - ratio);
        if (n <= mie->terms) {
            mie->ratio[n] = ratio;
        }
    }
}

/* Computes one coefficient, with A = slope, into *out and returns the share
 * that the term absorbs. */
static double coefficient(complex_number *out, complex_number slope, double psi,
                          double psi_before, double chi, double chi_before)
{
    const complex_number numerator = {slope.re * psi - psi_before,
                                      slope.im * psi};
    const complex_number other = {slope.re * chi - chi_before, slope.im * chi};
    const complex_number whole = {numerator.re + other.im,
                                  numerator.im - other.re};
    *out = divide(numerator, whole);
    return -slope.im / squared(whole);
}

/* Fills a and b. Returns the sum of (2 n + 1) times the absorbed shares. */
static double solve_terms(murk_mie *mie, double x, murk_mie_index index)
{
    const complex_number m = {index.n, index.k};
    double psi_before = sin(x), chi_before = cos(x);
    double psi_older = chi_before, chi_older = -psi_before;
    double absorbed = 0;
    for (size_t i = 1; i <= mie->terms; ++i) {
        const double n = (double)i, up = (2 * n - 1) / x;
        /* The next psi (by the ratio beyond n = x) and chi. */
        const double psi =
            n > x ? mie->ratio[i] * psi_before : up * psi_before - psi_older;
        const double chi = up * chi_before - chi_older;
        const complex_number d = mie->d[i];
        /* A of a_n and of b_n, then both coefficients. */
        complex_number electric = divide(d, m);
        electric.re += n / x;
        const complex_number magnetic = {m.re * d.re - m.im * d.im + n / x,
                                         m.re * d.im + m.im * d.re};
        absorbed += (2 * n + 1) * (coefficient(&mie->a[i], electric, psi,
                                               psi_before, chi, chi_before) +
                                   coefficient(&mie->b[i], magnetic, psi,
                                               psi_before, chi, chi_before));
        psi_older = psi_before;
        psi_before = psi;
        chi_older = chi_before;
        chi_before = chi;
    }
    return absorbed;
}

murk_mie_sphere murk_mie_solve(murk_mie *mie, double x, murk_mie_index index)
{
    assert(mie && x >= MURK_MIE_SIZE_MIN && terms_of(x) <= mie->capacity);
    assert(index.n > 0 && index.k >= 0);
    assert(hypot(index.n, index.k) <= MURK_MIE_INDEX_MAX);
    mie->terms = terms_of(x);
    derivatives(mie, (complex_number){index.n * x, index.k * x});
    ratios(mie, x);
    const double absorbed = solve_terms(mie, x, index);

    /* Efficiencies and mean cosine as sums over the coefficients (Bohren and
     * Huffman, sections 4.4 and 4.5). */
    double scattered = 0, turned = 0;
    for (size_t i = 1; i <= mie->terms; ++i) {
        const double n = (double)i;
        const complex_number a = mie->a[i], b = mie->b[i];
        scattered += (2 * n + 1) * (squared(a) + squared(b));
        turned += (2 * n + 1) / (n * (n + 1)) * alike(a, b);
        if (i < mie->terms) {
            turned += n * (n + 2) / (n + 1) *
                      (alike(a, mie->a[i + 1]) + alike(b, mie->b[i + 1]));
        }
    }
    const double scale = 2 / (x * x);
    return (murk_mie_sphere){.scattering = scale * scattered,
                             .absorption = scale * absorbed,
                             .extinction = scale * (scattered + absorbed),
                             .mean_cosine = 2 * turned / scattered};
}

/* Adds the intensity at count <= LANES angles. With p = pi_n + tau_n and q =
 * pi_n - tau_n, S1 + S2 is the sum of (a_n + b_n) p, and S1 - S2 the sum of
 * (a_n - b_n) q, each term multiplied by (2 n + 1) / (n (n + 1)). */
static void add_lanes(const murk_mie *mie, double weight, size_t count,
                      const double *angles, double *intensity)
{
    double mu[LANES] = {0}, before[LANES] = {0}, now[LANES] = {0};
    double plus_re[LANES] = {0}, plus_im[LANES] = {0};
    double minus_re[LANES] = {0}, minus_im[LANES] = {0};
    for (size_t j = 0; j < count; ++j) {
        mu[j] = angles[j];
        now[j] = 1;
    }
    /* Sum over terms, with upward recurrence of pi_n and tau_n. */
    for (size_t i = 1; i <= mie->terms; ++i) {
        const double n = (double)i, factor = (2 * n + 1) / (n * (n + 1));
        const double s_re = factor * (mie->a[i].re + mie->b[i].re);
        const double s_im = factor * (mie->a[i].im + mie->b[i].im);
        const double d_re = factor * (mie->a[i].re - mie->b[i].re);
        const double d_im = factor * (mie->a[i].im - mie->b[i].im);
        const double grow = (n + 1) / n;
        for (int j = 0; j < LANES; ++j) {
            const double ahead = mu[j] * now[j], step = ahead - before[j];
            const double tau = n * step - before[j];
            const double p = now[j] + tau, q = now[j] - tau;
            plus_re[j] += s_re * p;
            plus_im[j] += s_im * p;
            minus_re[j] += d_re * q;
            minus_im[j] += d_im * q;
            before[j] = now[j];
            now[j] = ahead + grow * step;
        }
    }
    /* (|S1|^2 + |S2|^2) / 2 = (|S1 + S2|^2 + |S1 - S2|^2) / 4. */
    for (size_t j = 0; j < count; ++j) {
        intensity[j] += weight / 4 *
                        (plus_re[j] * plus_re[j] + plus_im[j] * plus_im[j] +
                         minus_re[j] * minus_re[j] + minus_im[j] * minus_im[j]);
    }
}

void murk_mie_add_intensity(const murk_mie *mie, double weight, size_t count,
                            const double *mu, double *intensity)
{
    assert(mie && mie->terms > 0 && mu && intensity);
    for (size_t i = 0; i < count; i += LANES) {
        add_lanes(mie, weight, count - i < LANES ? count - i : LANES, mu + i,
                  intensity + i);
    }
}
