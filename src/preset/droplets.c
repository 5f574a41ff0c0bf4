/* The integral over radii is a trapezoid sum in s = ln x + x / wide, x the
 * size parameter: equal steps in the logarithm for small spheres, in x for
 * large ones, where the fringes of an efficiency are equally wide in x. For a
 * smooth integrand that dies away at both ends such a sum converges faster
 * than any power of the step. Steps are halved, and what is already summed is
 * kept. */
#include "preset/droplets.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.141592653589793

/* Share of the integrals that the ends leave out. */
#define LEFT_OUT 1e-7

/* A faint absorption narrows no resonance that this one leaves: what spheres
 * absorb is worked out for it and is in proportion to k below. Light caught in
 * resonances that are narrower still, which chance sizes would hit or miss, is
 * left out: 3 % of the absorption of Cloud C.1 at 550 nm, itself 3e-7 of the
 * extinction. */
#define FAINT_K 1e-6

/* A co-albedo that is no more than this need not settle. */
#define FAINT 1e-3

/* First step in s; x at which steps turn from relative to absolute ones; and
 * into how many at most the largest sphere's x is divided by the first step:
 * far larger spheres differ little from each other. */
#define FIRST_STEP .25
#define WIDE_MIN   8.
#define WIDE_PARTS 250.
#define HALVINGS   7

/* Fewer spheres leave fringes in a phase function. */
#define RADII_MIN 500

murk_droplets murk_droplets_gamma(double effective_radius_um,
                                  double effective_variance)
{
    assert(effective_radius_um > 0);
    assert(effective_variance > 0 && effective_variance < 1. / 3);
    return (murk_droplets){.a = 1 / effective_variance - 3,
                           .b = 1 / (effective_radius_um * effective_variance),
                           .c = 1};
}

/* Share of the gamma distribution of that order that lies below t: the series
 * t^order e^-t / Gamma(order + 1) (1 + t / (order + 1) + ...), all of one
 * sign. Where it is 1 to rounding, no more terms are asked for. */
static double share_below(double order, double t)
{
    if (!(t < order + 40 + 12 * sqrt(order))) {
        return 1;
    }
    double term = 1, sum = 1;
    for (int i = 1; i < 10000 && term > 1e-17 * sum; ++i) {
        term *= t / (order + i);
        sum += term;
    }
    return fmin(1, sum * exp(order * log(t) - t - lgamma(order + 1)));
}

/* Share of all droplets that are counted. */
static double counted(const murk_droplets *shape)
{
    const double t = shape->b * pow(MURK_COUNTED_FROM_UM, shape->c);
    return 1 - share_below((shape->a + 1) / shape->c, t);
}

/* Mean of r^power over all droplets, counted or not. */
static double moment(const murk_droplets *shape, double power)
{
    const double c = shape->c;
    return exp(lgamma((shape->a + 1 + power) / c) - lgamma((shape->a + 1) / c) -
               power / c * log(shape->b));
}

double murk_droplets_effective_radius_um(const murk_droplets *shape)
{
    return moment(shape, 3) / moment(shape, 2);
}

double murk_droplets_effective_variance(const murk_droplets *shape)
{
    const double third = moment(shape, 3);
    return moment(shape, 4) * moment(shape, 2) / (third * third) - 1;
}

double murk_droplets_water_g_per_m3(const murk_droplets *shape)
{
    /* um3 in a cm3 are 1e-12 parts; a cubic metre of water is 1e6 g */
    return 4 * PI / 3 * moment(shape, 3) / counted(shape) * 1e-12 * 1e6;
}

murk_status murk_droplets_check(const murk_droplets *shape, const char *where,
                                murk_error *err)
{
    if (!(shape->a >= 0 && shape->a <= 40)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the power of r is %g, must be 0..40", shape->a);
    }
    if (!(shape->c >= .1 && shape->c <= 6)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the power of r in the exponential is %g, must be "
                         "0.1..6",
                         shape->c);
    }
    if (!(shape->b > 0 && isfinite(shape->b))) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the factor in the exponential is %g, must be more "
                         "than 0 [um^-%g]",
                         shape->b, shape->c);
    }
    const double radius = murk_droplets_effective_radius_um(shape);
    if (!(radius >= .05 && radius <= 50)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the droplet sizes make an effective radius of %g, "
                         "must be 0.05..50 um",
                         radius);
    }
    const double variance = murk_droplets_effective_variance(shape);
    if (!(variance >= .003 && variance <= 10)) {
        return murk_fail(
            err, MURK_BAD_VALUE, where,
            "the droplet sizes make an effective variance of %g, must be "
            "0.003..10",
            variance);
    }
    if (!(counted(shape) >= .01)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the droplet sizes leave %.2g of the droplets above a "
                         "radius of %g um, "
                         "from which they are counted; must be 0.01 or more",
                         counted(shape), MURK_COUNTED_FROM_UM);
    }
    return MURK_OK;
}

/* The distribution times r^2 at size parameter x, for dr = r d(ln x). */
typedef struct population {
    murk_droplets shape;
    double radius_um; /* of x = 1 */
    double log_norm;
} population;

static double area_per_log(const population *p, double x)
{
    const double log_r = log(x * p->radius_um);
    return exp(p->log_norm + (p->shape.a + 3) * log_r -
               p->shape.b * exp(p->shape.c * log_r));
}

static population population_of(const murk_droplets *shape,
                                double wavelength_nm)
{
    const double order = (shape->a + 1) / shape->c;
    return (population){.shape = *shape,
                        .radius_um = wavelength_nm / 1000 / (2 * PI),
                        .log_norm = log(shape->c) + order * log(shape->b) -
                                    lgamma(order) - log(counted(shape))};
}

/* What the ends are judged by: what a sphere takes from light and where it
 * sends it, without the fringes. Small ones scatter as x^4 and absorb as x;
 * large ones scatter forward as x^2. */
static double weight_small(double x)
{
    return x / (1 + x);
}

static double weight_large(double x)
{
    return x * x * x * x / (1 + x * x);
}

/* The sizes that matter: those between which all but LEFT_OUT of the integral
 * lies, by the weight of each end. Scanned in equal steps of ln x, which is
 * safe as the integrand has one peak and is wider than 1/40 for every shape
 * that passes the check. */
static void ends_of(const population *p, double *least, double *most)
{
    const double step = 1. / 64;
    const int from = -64 * 14, to = 64 * 10; /* x 8e-7..2.2e4 */
    double small = 0, large = 0;
    for (int i = from; i <= to; ++i) {
        const double x = exp(i * step), area = area_per_log(p, x);
        small += area * weight_small(x);
        large += area * weight_large(x);
    }
    int low = from, high = to;
    double sum = 0;
    for (; low < to; ++low) {
        const double x = exp(low * step);
        sum += area_per_log(p, x) * weight_small(x);
        if (!(sum < LEFT_OUT * small)) {
            break;
        }
    }
    sum = 0;
    for (; high > low + 1; --high) {
        const double x = exp(high * step);
        sum += area_per_log(p, x) * weight_large(x);
        if (!(sum < LEFT_OUT * large)) {
            break;
        }
    }
    *least = fmax(exp(low * step), MURK_MIE_SIZE_MIN);
    *most = fmin(exp(high * step), MURK_MIE_SIZE_MAX);
}

/* The nodes of one level: s = from, from + step, ... */
typedef struct ladder {
    double wide, from, step;
    size_t steps;
} ladder;

static ladder ladder_of(double least, double most)
{
    ladder out = {.wide = fmax(WIDE_MIN, most / WIDE_PARTS),
                  .step = FIRST_STEP};
    out.from = log(least) + least / out.wide;
    const double to = log(most) + most / out.wide;
    out.steps = (size_t)ceil((to - out.from) / out.step) + 1;
    return out;
}

/* x where ln x + x / wide is s: Newton in ln x, on a convex function, so from
 * the right-hand side it cannot overshoot. */
static double size_at(const ladder *nodes, double s)
{
    double u = s < 1 ? s : log(nodes->wide * s);
    u = fmin(u, s);
    if (u + exp(u) / nodes->wide < s) {
        u = s;
    }
    for (int i = 0; i < 60; ++i) {
        const double share = exp(u) / nodes->wide;
        const double change = (u + share - s) / (1 + share);
        u -= change;
        if (!(fabs(change) > 1e-14 * (1 + fabs(u)))) {
            break;
        }
    }
    return exp(u);
}

/* Sums over the nodes so far, times no step yet. */
typedef struct sums {
    double scattering, absorption;
    double sent, turned; /* scattering of the spheres solved, and times g */
    size_t radii;
} sums;

typedef struct task {
    murk_mie *mie;
    population population;
    murk_mie_index index; /* k at least FAINT_K */
    double faint;         /* true k over that one */
    double most;          /* largest size parameter */
    size_t angles;
    const double *mu;
    double *intensity; /* [angles] */
} task;

static void add_sphere(sums *total, const task *job, const ladder *nodes,
                       double s)
{
    const double x = size_at(nodes, s);
    if (!(x >= MURK_MIE_SIZE_MIN && x <= job->most)) {
        return; /* rounding, or past the last step */
    }
    const double stretch = 1 / (1 + x / nodes->wide); /* d(ln x) / ds */
    const double weight = PI * area_per_log(&job->population, x) * stretch;
    const murk_mie_sphere sphere = murk_mie_solve(job->mie, x, job->index);
    const double absorbed = sphere.absorption * job->faint;
    total->scattering += weight * (sphere.extinction - absorbed);
    total->absorption += weight * absorbed;
    total->sent += weight * sphere.scattering;
    total->turned += weight * sphere.scattering * sphere.mean_cosine;
    total->radii += 1;
    if (job->angles > 0) {
        murk_mie_add_intensity(job->mie, weight / (PI * x * x), job->angles,
                               job->mu, job->intensity);
    }
}

static bool is_settled(const sums *now, const sums *before, double tolerance)
{
    return now->radii >= RADII_MIN &&
           fabs(now->scattering - before->scattering) <=
               tolerance * now->scattering &&
           fabs(now->absorption - before->absorption) <=
               tolerance * (10 * now->absorption + FAINT * now->scattering) &&
           fabs(now->turned / now->sent - before->turned / before->sent) <=
               tolerance;
}

/* The sums so far, times the step between them. */
static sums times(const sums *total, double step)
{
    return (sums){.scattering = step * total->scattering,
                  .absorption = step * total->absorption,
                  .sent = step * total->sent,
                  .turned = step * total->turned,
                  .radii = total->radii};
}

/* Puts in the spheres of one level: all of the first, the new ones of others.
 * Gives the step between all spheres so far. */
static double add_level(sums *total, const task *job, const ladder *first,
                        int level)
{
    const double step = ldexp(first->step, -level);
    const size_t steps = first->steps << level;
    for (size_t i = level > 0; i<steps; i += level> 0 ? 2 : 1) {
        add_sphere(total, job, first, first->from + (double)i * step);
    }
    return step;
}

/* The level at which the results settle, or HALVINGS + 1. */
static int settle(sums *now, const task *job, const ladder *first,
                  double tolerance)
{
    sums total = {0};
    *now = times(&total, add_level(&total, job, first, 0));
    for (int level = 1; level <= HALVINGS; ++level) {
        const sums before = *now;
        const double step = add_level(&total, job, first, level);
        *now = times(&total, step);
        if (is_settled(now, &before, tolerance)) {
            return level;
        }
    }
    return HALVINGS + 1;
}

/* A level before the last is as near to it as was asked. */
static void add_angles(task *job, const ladder *first, int level, size_t angles,
                       const double *mu, double *phase_per_sr)
{
    memset(phase_per_sr, 0, angles * sizeof *phase_per_sr);
    job->angles = angles;
    job->mu = mu;
    job->intensity = phase_per_sr;
    sums total = {0};
    for (int i = 0; i <= level && (i < level || total.radii < RADII_MIN); ++i) {
        add_level(&total, job, first, i);
    }
    for (size_t i = 0; i < angles; ++i) {
        phase_per_sr[i] /= total.sent;
    }
}

murk_status murk_droplets_solve(murk_droplet_optics *out,
                                const murk_droplets *shape,
                                double wavelength_nm, murk_mie_index index,
                                double tolerance, size_t angles,
                                const double *mu, double *phase_per_sr,
                                murk_error *err)
{
    assert(out && shape && (angles == 0 || (mu && phase_per_sr)));
    assert(wavelength_nm >= 200 && wavelength_nm <= 20000);
    assert(tolerance >= 1e-4 && tolerance <= .1);
    task job = {.population = population_of(shape, wavelength_nm),
                .index = {index.n, fmax(index.k, FAINT_K)}};
    job.faint = index.k / job.index.k;
    double least;
    ends_of(&job.population, &least, &job.most);
    murk_status status = murk_mie_create(&job.mie, job.most, err);
    if (status) {
        return status;
    }
    const ladder first = ladder_of(least, job.most);
    sums now;
    const int level = settle(&now, &job, &first, tolerance);
    if (level > HALVINGS) {
        status = murk_fail(err, MURK_RUN_FAILED, "",
                           "the sum over droplet sizes does not settle to %g "
                           "with %zu sizes",
                           tolerance, now.radii);
        goto done;
    }
    if (angles > 0) {
        add_angles(&job, &first, level, angles, mu, phase_per_sr);
    }
    *out =
        (murk_droplet_optics){.extinction_um2 = now.scattering + now.absorption,
                              .scattering_um2 = now.scattering,
                              .absorption_um2 = now.absorption,
                              .mean_cosine = now.turned / now.sent,
                              .radii = now.radii};
done:
    murk_mie_destroy(job.mie);
    return status;
}

size_t murk_droplet_angles(double angle_deg[MURK_DROPLET_ANGLES_MAX])
{
    size_t n = 0;
    angle_deg[n++] = 0;
    for (int i = 0; i <= 68; ++i) {
        angle_deg[n++] = 10 * pow(2000, (double)(i - 68) / 68);
    }
    static const struct {
        double to, step;
    } stretch[] = {{130, 2}, {176, 1}, {179, .5}, {180, .25}};
    for (size_t i = 0; i < sizeof stretch / sizeof *stretch; ++i) {
        while (angle_deg[n - 1] < stretch[i].to) {
            angle_deg[n] = angle_deg[n - 1] + stretch[i].step;
            ++n;
        }
    }
    assert(n <= MURK_DROPLET_ANGLES_MAX);
    return n;
}
