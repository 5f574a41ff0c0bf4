/* Legendre moments of phase functions: reads them from a CSV file, sums the
 * series (Clenshaw), writes the sum as a table that a scene can name, and
 * computes moments of a given density by Gauss-Legendre quadrature. */
#include "moments.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI   3.14159265358979324
#define LINE 512

/* The comma-separated cell of that number, or NULL. */
static char *cell_of(char *line, int number)
{
    for (; number > 0 && line; --number) {
        line = strchr(line, ',');
        line = line ? line + 1 : NULL;
    }
    return line;
}

static int column_of(char *header, const char *name)
{
    const size_t length = strlen(name);
    for (int i = 0;; ++i) {
        const char *cell = cell_of(header, i);
        if (!cell) {
            return -1;
        }
        if (strncmp(cell, name, length) == 0 &&
            strcspn(cell, ",\r\n") == length) {
            return i;
        }
    }
}

size_t moments_read(const char *path, const char *column,
                    double chi[MOMENTS_MAX])
{
    FILE *file = fopen(path, "r");
    if (!file) {
        return 0;
    }
    char line[LINE];
    int wanted = -2; /* the header is still to come */
    size_t n = 0;
    while (wanted != -1 && n < MOMENTS_MAX && fgets(line, LINE, file)) {
        if (line[0] == '#') {
            continue;
        }
        if (wanted == -2) {
            wanted = column_of(line, column);
            continue;
        }
        char *cell = cell_of(line, wanted), *end = cell;
        const double value = cell ? strtod(cell, &end) : 0;
        if (end == cell) {
            break;
        }
        chi[n++] = value;
    }
    fclose(file);
    return n;
}

/* Clenshaw's backward sum; (2l + 1) P_l by the recurrence
 * (l + 1) P_(l+1) = (2l + 1) mu P_l - l P_(l-1). */
double moments_density(const double *chi, size_t n, double mu)
{
    double next = 0, after = 0;
    for (size_t l = n; l-- > 0;) {
        const double k = (double)l;
        const double here = (2 * k + 1) * chi[l] +
                            (2 * k + 1) / (k + 1) * mu * next -
                            (k + 1) / (k + 2) * after;
        after = next;
        next = here;
    }
    return next / (4 * PI);
}

double moments_tabulate(const double *chi, size_t n,
                        double angle_deg[MOMENTS_ROWS],
                        double phase_per_sr[MOMENTS_ROWS])
{
    double lost = 0;
    for (int i = 0; i < MOMENTS_ROWS; ++i) {
        angle_deg[i] = i <= 1000 ? i / 100. : 10 + (i - 1000) / 20.;
        const double angle = angle_deg[i] * PI / 180;
        const double step = (i <= 1000 ? .01 : .05) * PI / 180;
        const double p = moments_density(chi, n, cos(angle));
        phase_per_sr[i] = p > 0 ? p : 0;
        lost += p < 0 ? -p * 2 * PI * sin(angle) * step : 0;
    }
    return lost;
}

void moments_write(const char *path, const double *chi, size_t n)
{
    static double angle_deg[MOMENTS_ROWS], phase_per_sr[MOMENTS_ROWS];
    moments_tabulate(chi, n, angle_deg, phase_per_sr);
    FILE *file = fopen(path, "w");
    int wrong = !file || fprintf(file, "angle_deg,phase_per_sr\n") < 0;
    for (int i = 0; i < MOMENTS_ROWS && !wrong; ++i) {
        wrong =
            fprintf(file, "%.10g,%.15g\n", angle_deg[i], phase_per_sr[i]) < 0;
    }
    if (wrong || fclose(file)) {
        perror(path);
        exit(1);
    }
}

/* Nodes and weights of the ten-point rule on [-1, 1], Abramowitz & Stegun,
 * Handbook of Mathematical Functions, 1964, table 25.4. */
static const double NODE[] = {.1488743389816312, .4333953941292472,
                              .6794095682990244, .8650633666889845,
                              .9739065285171717};
static const double WEIGHT[] = {.2955242247147529, .2692667193099963,
                                .2190863625159820, .1494513491505806,
                                .0666713443086881};

static void add_panel(double (*density)(const void *context, double mu),
                      const void *context, double from, double to, double *chi,
                      size_t n)
{
    for (int k = 0; k < 10; ++k) {
        const double at = k < 5 ? NODE[k] : -NODE[k - 5];
        const double angle = .5 * (from + to) + .5 * (to - from) * at;
        const double mu = cos(angle);
        const double share = WEIGHT[k % 5] * .5 * (to - from) * sin(angle) * 2 *
                             PI * density(context, mu);
        double before = 0, legendre = 1; /* P_(l-1), P_l */
        for (size_t l = 0; l < n; ++l) {
            const double j = (double)l;
            chi[l] += share * legendre;
            const double next =
                ((2 * j + 1) * mu * legendre - j * before) / (j + 1);
            before = legendre;
            legendre = next;
        }
    }
}

/* Panels grow by a fiftieth of their angle up to a tenth of a degree. */
void moments_of(double (*density)(const void *context, double mu),
                const void *context, double from_rad, double *chi, size_t n)
{
    memset(chi, 0, n * sizeof *chi);
    double from = from_rad;
    while (from < PI) {
        const double step = fmin(PI / 1800, from > 0 ? from / 50 : 1e-6);
        const double to = fmin(PI, from + step);
        add_panel(density, context, from, to, chi, n);
        from = PI - to < 1e-9 ? PI : to;
    }
}
