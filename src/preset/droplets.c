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

/* The nodes of one level: s = from, from + step, ... */
typedef struct ladder {
    double wide, from, step;
    size_t steps;
} ladder;

static ladder ladder_of(double min, double max)
{
    ladder out = {.wide = fmax(WIDE_MIN, max / WIDE_PARTS), .step = FIRST_STEP};
    out.from = log(min) + min / out.wide;
    const double to = log(max) + max / out.wide;
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
    murk_droplet_population population;
    murk_mie_index index; /* k at least FAINT_K */
    double faint;         /* true k over that one */
    double max;           /* largest size parameter */
    size_t angles;
    const double *mu;
    double *intensity; /* [angles] */
} task;

static void add_sphere(sums *total, const task *job, const ladder *nodes,
                       double s)
{
    const double x = size_at(nodes, s);
    if (!(x >= MURK_MIE_SIZE_MIN && x <= job->max)) {
        return; /* rounding, or past the last step */
    }
    const double stretch = 1 / (1 + x / nodes->wide); /* d(ln x) / ds */
    const double weight = PI * murk_droplet_area(&job->population, x) * stretch;
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
    task job = {.population = murk_droplet_population_of(shape, wavelength_nm),
                .index = {index.n, fmax(index.k, FAINT_K)}};
    job.faint = index.k / job.index.k;
    double min;
    murk_droplet_ends(&job.population, &min, &job.max);
    murk_status status = murk_mie_create(&job.mie, job.max, err);
    if (status) {
        return status;
    }
    const ladder first = ladder_of(min, job.max);
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
