/* For tests of boundaries against closed forms: what is counted, and the forms.
 */
#ifndef MURK_TESTS_INTERFACE_WORLDS_H
#define MURK_TESTS_INTERFACE_WORLDS_H

#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 40000
#define Z_TESTS 56
#define WATER   1.34
#define GLASS   1.5
#define DENSE   1.8 /* flint */

static inline double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

static inline double error_of(double share, double n)
{
    return sqrt(share * (1 - share) / n);
}

static inline void check_share(double count, double share)
{
    CHECK_WITHIN(limit(), count / PHOTONS, share, error_of(share, PHOTONS));
}

/* Teeth: what was counted must not agree with this. */
static inline double sigmas_from(double count, double share)
{
    return sigmas_off(count / PHOTONS, share, error_of(share, PHOTONS));
}

/* ---- what is counted ---- */

#define REGIONS 4

typedef struct tale {
    double up, down, lateral; /* escaped through which side */
    double above;             /* escaped above z = 0 */
    double back;              /* escaped against the direction `sent` */
    double met[REGIONS], mirrored[REGIONS];
    double at_surfaces, mirrored_at_surfaces;
    double snell_off, normal_off; /* worst */
    const murk_box *box;
    murk_vec3 sent; /* by the first light */
} tale;

static inline void note_interface(tale *t, const murk_event *event)
{
    const murk_vec3 n = event->normal;
    t->met[event->material_or_medium] += 1;
    t->mirrored[event->material_or_medium] += event->outcome == MURK_MIRRORED;
    CHECK(event->outcome == MURK_MIRRORED ||
          event->outcome == MURK_TRANSMITTED);
    const double in = murk_dot(event->direction_in, n);
    const double out = murk_dot(event->direction_out, n);
    t->normal_off = fmax(t->normal_off, in);
    t->normal_off = fmax(
        t->normal_off, event->outcome == MURK_MIRRORED ? fabs(in + out) : out);
    t->normal_off = fmax(t->normal_off, fabs(murk_length(n) - 1));
}

static inline void note(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    tale *t = context;
    if (event->kind == MURK_EVENT_ESCAPED) {
        const double z = event->position.z;
        t->up += z == t->box->max.z;
        t->down += z == t->box->min.z;
        t->lateral += z < t->box->max.z && z > t->box->min.z;
        t->above += z > 0;
        t->back += murk_dot(event->direction_out, t->sent) < 0;
    } else if (event->kind == MURK_EVENT_INTERFACE) {
        note_interface(t, event);
    } else if (event->kind == MURK_EVENT_SURFACE) {
        t->at_surfaces += 1;
        t->mirrored_at_surfaces += event->outcome == MURK_MIRRORED;
    }
}

static inline tale traced(const test_setup *setup, uint32_t seed)
{
    test_world w = test_world_made(setup);
    tale t = {.box = &setup->domain.box, .sent = setup->lights[0].direction};
    test_world_trace(&w, PHOTONS, seed, note, &t);
    CHECK(test_photons(&w, w.ledger->lost) == 0);
    CHECK(t.up + t.down + t.lateral +
              test_photons(&w, w.ledger->absorbed_media) +
              test_photons(&w, w.ledger->absorbed_surfaces) ==
          PHOTONS);
    CHECK(t.normal_off < 1e-14);
    test_world_unmade(&w);
    return t;
}

static inline murk_region with_index(murk_region region, double ior)
{
    region.ior = ior;
    return region;
}

static inline murk_region below(size_t medium, double z, double ior)
{
    murk_region region = with_index(test_everywhere(medium), ior);
    region.shape = MURK_REGION_BELOW;
    region.below_z_m = z;
    return region;
}

static const murk_medium clear = {.where = "clear"};

/* ---- closed forms ---- */

/* Unpolarised reflectance, from the angle of incidence alone. */
static inline double reflectance(double radians, double n_from, double n_to)
{
    const double a = radians, b = asin(sin(a) * n_from / n_to);
    if (a == 0) {
        return pow((n_from - n_to) / (n_from + n_to), 2);
    }
    return (pow(sin(a - b) / sin(a + b), 2) + pow(tan(a - b) / tan(a + b), 2)) /
           2;
}

typedef struct ends {
    double back, through;
} ends;

/* A plate of faces that reflect r each and let the share a through from face
 * to face. */
static inline ends plate(double r, double a)
{
    const double round = 1 - r * r * a * a;
    return (ends){r + r * a * a * (1 - r) * (1 - r) / round,
                  a * (1 - r) * (1 - r) / round};
}

static inline double stack(const double *r, int n)
{
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        sum += r[i] / (1 - r[i]);
    }
    return sum / (1 + sum);
}

#endif
