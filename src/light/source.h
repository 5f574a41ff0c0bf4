/* One light, checked, and how its photons start. Private to this room. */
#ifndef MURK_LIGHT_SOURCE_H
#define MURK_LIGHT_SOURCE_H

#include "light/openings.h"

typedef struct murk_source {
    murk_light light;   /* direction made unit; `where` and `portal` are our
                           copies */
    murk_vec3 normal;   /* rect: where it shines to */
    double cone;        /* beam: 1 - cos(half angle) */
    double face_end[3]; /* parallel light onto the domain: cumulative shares of
                           the lit faces across x, y, z */
    murk_openings *openings; /* owned: other distant light; else NULL */
} murk_source;

/* Checks s->light, which the caller has set, against the domain, makes its
 * direction unit and fills the rest of *s, which must be zero.
 * *power_scale: watts for each unit of power_w (the lit area in m2 where that
 * is an irradiance, else 1). Also on failure: murk_source_release(). */
murk_status murk_source_prepare(murk_source *s, size_t bands,
                                const murk_domain *domain, double *power_scale,
                                murk_error *err);

void murk_source_release(murk_source *s);

/* A photon's start for uniform numbers, inside the domain's box. The first four
 * do where there are no openings. */
murk_ray murk_source_emit(const murk_source *s, const murk_box *box,
                          const double u[MURK_OPENINGS_NUMBERS]);

#endif
