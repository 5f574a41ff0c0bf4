/* Averages the Mie solutions of spheres (preset/mie.h) over a size
 * distribution.
 *
 * The integral over radii is a trapezoid sum in s = ln x + x / wide, where x is
 * the size parameter: steps are equal in the logarithm for small spheres, and
 * in x for large spheres, because the interference fringes of an efficiency are
 * equally wide in x. For a smooth integrand that vanishes at both ends such a
 * sum converges faster than any power of the step. The step is halved until the
 * sums settle, and each level adds only the new spheres. */
#include "preset/droplets.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.141592653589793 /* to the digits of double */

/* The smallest imaginary index k for which spheres are computed. For a smaller
 * k, spheres are computed with this one, and the absorption is scaled in
 * proportion to k. The absorption of light caught in narrower resonances, which
 * the sampled sizes would hit or miss by chance, is then left out: at 550 nm
 * this is 3 % of the absorption of Cloud C.1, and the absorption is 3e-7 of the
 * extinction. */
#define FAINT_K 1e-6

/* A change of the absorption by less than this share of the scattering, times
 * the tolerance, counts as settled. */
#define FAINT 1e-3

/* First step in s; least `wide`, the x at which steps change from relative to
 * absolute; largest ratio of the largest x to `wide` (much larger spheres
 * differ little from each other); and the largest number of halvings, which
 * bounds the time. */
#define FIRST_STEP .25
#define WIDE_MIN   8.
#define WIDE_PARTS 250.
#define HALVINGS   7

/* The least number of spheres: with fewer, fringes remain in the phase
 * function. */
#define RADII_MIN 500

/* The nodes of the first level: s = from, from + step, ... */
typedef struct size_grid {
    double wide, from, step;
    size_t steps;
} size_grid;

static size_grid size_grid_of(double min, double max)
{
    size_grid out = {.wide = fmax(WIDE_MIN, max / WIDE_PARTS),
                     .step = FIRST_STEP};
    out.from = log(min) + min / out.wide;
    const double to = log(max) + max / out.wide;
    out.steps = (size_t)ceil((to - out.from) / out.step) + 1;
    return out;
}

/* Solves ln x + x / wide = s by Newton's method in ln x. The left side is a
 * convex function of ln x, so an iteration that starts above the solution
 * cannot overshoot. */
static double size_at(const size_grid *nodes, double s)
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

/* Sums over the nodes so far, before multiplication by the step. */
typedef struct sums {
    double scattering, absorption;
    double sent, turned; /* `sent`: scattering of the computed spheres;
                          * `turned`: the same times the mean cosine */
    size_t radii;
} sums;

typedef struct task {
    murk_mie *mie;
    murk_droplet_population population;
    murk_mie_index index; /* k is at least FAINT_K */
    double faint;         /* true k / index.k */
    double max;           /* largest size parameter */
    size_t angles;
    const double *mu;
    double *intensity; /* [angles] */
} task;

static void add_sphere(sums *total, const task *job, const size_grid *nodes,
                       double s)
{
    const double x = size_at(nodes, s);
    if (!(x >= MURK_MIE_SIZE_MIN && x <= job->max)) {
        return; /* outside by rounding, or past the last step */
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

/* The sums multiplied by the step between nodes. */
static sums times(const sums *total, double step)
{
    return (sums){.scattering = step * total->scattering,
                  .absorption = step * total->absorption,
                  .sent = step * total->sent,
                  .turned = step * total->turned,
                  .radii = total->radii};
}

/* Adds the spheres of one level: all nodes of the first level, the new nodes of
 * later levels. Returns the step between all nodes so far. */
static double add_level(sums *total, const task *job, const size_grid *first,
                        int level)
{
    const double step = ldexp(first->step, -level);
    const size_t steps = first->steps << level;
    for (size_t i = level > 0; i<steps; i += level> 0 ? 2 : 1) {
        add_sphere(total, job, first, first->from + (double)i * step);
    }
    return step;
}

/* Returns the level at which the results settle, or HALVINGS + 1. */
static int settle(sums *now, const task *job, const size_grid *first,
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

/* Computes the phase function from the levels before `level`, because the
 * results of the level before it were within the tolerance already. The spheres
 * of `level` are added if the others are fewer than RADII_MIN. */
static void add_angles(task *job, const size_grid *first, int level,
                       size_t angles, const double *mu, double *phase_per_sr)
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
    /* Replace a faint absorption, choose the range of sizes. */
    task job = {.population = murk_droplet_population_of(shape, wavelength_nm),
                .index = {index.n, fmax(index.k, FAINT_K)}};
    job.faint = index.k / job.index.k;
    double min;
    murk_droplet_ends(&job.population, &min, &job.max);
    murk_status status = murk_mie_create(&job.mie, job.max, err);
    if (status) {
        return status;
    }
    /* Sum level by level until the results settle. */
    const size_grid first = size_grid_of(min, job.max);
    sums now;
    const int level = settle(&now, &job, &first, tolerance);
    if (level > HALVINGS) {
        status = murk_fail(err, MURK_RUN_FAILED, "",
                           "the sum over droplet sizes does not settle to %g "
                           "with %zu sizes",
                           tolerance, now.radii);
        goto done;
    }
    /* Phase function, then the means. */
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
