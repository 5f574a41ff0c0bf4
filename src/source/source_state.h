/* One light, checked, and how its photons start. Private to this room. */
#ifndef MURK_SOURCE_SOURCE_STATE_H
#define MURK_SOURCE_SOURCE_STATE_H

#include "source/entry_faces.h"

typedef struct murk_source_state {
    murk_source light; /* direction made unit; `where` and `portal` are our
                         copies */
    const murk_domain *domain;
    bool is_dark;       /* without power */
    double power_scale; /* watts for each unit of power_w: the lit area in m2
                           where that is an irradiance, else 1 */
    murk_vec3 normal;   /* rect: where it shines to */
    double cone;        /* beam: 1 - cos(half angle) */
    double face_end[3]; /* parallel light onto the domain: cumulative shares of
                           the lit faces across x, y, z */
    murk_entry_faces *entry_faces; /* owned: other distant light; else NULL */
} murk_source_state;

/* Checks s->light against s->domain, both set by the caller, makes the light's
 * direction unit and fills the rest of *s, which must be zero. Also on failure:
 * murk_source_state_release(). */
murk_status murk_source_state_prepare(murk_source_state *s, size_t bands,
                                      murk_error *err);

/* The checked light of that index. */
const murk_source_state *murk_sources_state(const murk_sources *lights,
                                            size_t light);

void murk_source_state_release(murk_source_state *s);

/* A photon's start for uniform numbers, inside the domain's box. The first four
 * do where there are no openings. */
murk_ray murk_source_state_emit(const murk_source_state *s,
                                const double u[MURK_ENTRY_FACES_NUMBERS]);

#endif
