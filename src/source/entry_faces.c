/* Distant light that enters through plane faces: computes the power of each
 * face from the sky table or the disc of the light, and draws starts of
 * photons. For portals, the start is moved back along the ray to the boundary
 * of the domain. */
#include "source/entry_faces.h"

#include <assert.h>
#include <stdlib.h>

#include "source/disc.h"
#include "source/dome_table.h"

#define FACES 6 /* of a box */

/* Two portals that are closer along a ray than this share of the largest
 * coordinate of the domain count as coincident: their order in the list
 * decides, not rounding. */
#define AT_ONCE 1e-9

/* Orientations on the same side with a smaller squared sine between them are
 * equal and share a table. */
#define SAME_FACING 1e-24

typedef struct entry_face {
    murk_vec3 corner, edge1, edge2;
    murk_vec3 inward;           /* unit */
    murk_vec3 measure[2];       /* portals: the scalar products with an offset
                                 * from the corner are the coordinates in
                                 * edges */
    double one_m2;              /* power for an irradiance of 1 */
    double end;                 /* cumulative share of the power */
    const murk_dome_table *sky; /* NULL: directional light, or a face that looks
                                 * straight down */
} entry_face;

struct murk_entry_faces {
    bool is_dome;
    murk_vec3 direction;
    double disc; /* tangent of the angular radius */
    murk_box box;
    double at_once_m;
    bool are_portals;
    size_t n, tables;
    entry_face *entry_face;  /* [n] */
    murk_dome_table **table; /* [tables], for different orientations; the first
                              * one is for the level plane */
    murk_vec3 *outward;      /* [tables] */
    double area_m2;
    double level; /* dome: irradiance of a level plane, relative */
};

/* ---- positions ---- */

static void set_box_faces(murk_entry_faces *o, bool is_periodic)
{
    const murk_vec3 a = o->box.min, b = o->box.max;
    const murk_vec3 x = {b.x - a.x, 0, 0}, y = {0, b.y - a.y, 0},
                    z = {0, 0, b.z - a.z};
    /* Top, bottom, then the sides; a periodic domain is entered through the top
     * only. */
    const murk_vec3 frame[FACES][4] = {{{a.x, a.y, b.z}, x, y, {0, 0, -1}},
                                       {a, x, y, {0, 0, 1}},
                                       {a, y, z, {1, 0, 0}},
                                       {{b.x, a.y, a.z}, y, z, {-1, 0, 0}},
                                       {a, z, x, {0, 1, 0}},
                                       {{a.x, b.y, a.z}, z, x, {0, -1, 0}}};
    o->n = is_periodic ? 1 : FACES;
    for (size_t i = 0; i < o->n; ++i) {
        o->entry_face[i] = (entry_face){.corner = frame[i][0],
                                        .edge1 = frame[i][1],
                                        .edge2 = frame[i][2],
                                        .inward = frame[i][3]};
    }
}

static void set_portals(murk_entry_faces *o, const murk_portal *portal,
                        size_t n)
{
    o->n = n;
    for (size_t i = 0; i < n; ++i) {
        const murk_portal *p = &portal[i];
        const murk_vec3 across = murk_cross(p->edge1, p->edge2);
        const double square = murk_dot(across, across);
        o->entry_face[i] = (entry_face){
            .corner = p->corner,
            .edge1 = p->edge1,
            .edge2 = p->edge2,
            .inward = murk_unit(across),
            .measure = {murk_scale(1 / square, murk_cross(p->edge2, across)),
                        murk_scale(1 / square, murk_cross(across, p->edge1))}};
    }
}

/* ---- power ---- */

/* Finds or creates the sky table for an orientation. */
static murk_status table_for(murk_entry_faces *o, const murk_dome *dome,
                             murk_vec3 outward, const murk_dome_table **out,
                             const char *where, murk_error *err)
{
    for (size_t i = 0; i < o->tables; ++i) {
        const murk_vec3 across = murk_cross(o->outward[i], outward);
        if (murk_dot(across, across) < SAME_FACING &&
            murk_dot(o->outward[i], outward) > 0) {
            *out = o->table[i];
            return MURK_OK;
        }
    }
    o->outward[o->tables] = outward;
    const murk_status status =
        murk_dome_table_create(&o->table[o->tables], dome, outward, where, err);
    if (!status) {
        *out = o->table[o->tables++];
    }
    return status;
}

static murk_status set_sky_power(murk_entry_faces *o, const murk_source *light,
                                 murk_error *err)
{
    murk_dome dome = light->dome;
    if (dome.c != 0 || dome.e != 0) {
        dome.towards = murk_unit(dome.towards);
    }
    const murk_dome_table *level = NULL;
    murk_status status =
        table_for(o, &dome, murk_vec(0, 0, 1), &level, light->where, err);
    if (!status) {
        o->level = murk_dome_table_irradiance(level);
    }
    for (size_t i = 0; i < o->n && !status; ++i) {
        entry_face *k = &o->entry_face[i];
        if (k->inward.z >= 1) { /* faces down: no sky */
            continue;
        }
        status = table_for(o, &dome, murk_scale(-1, k->inward), &k->sky,
                           light->where, err);
        if (!status) {
            const double area = murk_length(murk_cross(k->edge1, k->edge2));
            k->one_m2 = area * murk_dome_table_irradiance(k->sky) / o->level;
        }
    }
    return status;
}

static void set_disc_power(murk_entry_faces *o)
{
    for (size_t i = 0; i < o->n; ++i) {
        entry_face *k = &o->entry_face[i];
        k->one_m2 = murk_length(murk_cross(k->edge1, k->edge2)) *
                    murk_disc_cosine(o->direction, o->disc, k->inward);
    }
}

static void add_up(murk_entry_faces *o)
{
    size_t last = 0;
    for (size_t i = 0; i < o->n; ++i) {
        o->area_m2 += o->entry_face[i].one_m2;
        last = o->entry_face[i].one_m2 > 0 ? i : last;
    }
    double sum = 0;
    for (size_t i = 0; i < o->n; ++i) {
        sum += o->entry_face[i].one_m2;
        o->entry_face[i].end = i < last ? sum / o->area_m2 : 1;
    }
}

murk_status murk_entry_faces_create(murk_entry_faces **out,
                                    const murk_source *light,
                                    const murk_domain *domain, murk_error *err)
{
    assert(murk_source_is_distant(light));
    const size_t capacity = light->portals > FACES ? light->portals : FACES;
    murk_entry_faces *o = calloc(1, sizeof *o);
    if (o) {
        o->is_dome = murk_source_type_group(light->type) == MURK_SOURCE_DOME;
        o->direction = light->direction;
        o->disc = tan(light->angular_radius_rad);
        o->box = domain->box;
        o->are_portals = light->portals > 0;
        o->entry_face = calloc(capacity, sizeof *o->entry_face);
        o->table = calloc(capacity + 1, sizeof *o->table);
        o->outward = calloc(capacity + 1, sizeof *o->outward);
    }
    if (!o || !o->entry_face || !o->table || !o->outward) {
        murk_entry_faces_destroy(o);
        return murk_no_memory(err, light->where, "for a light");
    }
    o->at_once_m = AT_ONCE * murk_box_largest_coordinate(&o->box);
    /* Positions and power of the faces, then the shares of power. */
    if (o->are_portals) {
        set_portals(o, light->portal, light->portals);
    } else {
        set_box_faces(o, domain->is_periodic);
    }
    murk_status status = MURK_OK;
    if (o->is_dome) {
        status = set_sky_power(o, light, err);
    } else {
        set_disc_power(o);
    }
    if (status) {
        murk_entry_faces_destroy(o);
        return status;
    }
    add_up(o);
    *out = o;
    return MURK_OK;
}

void murk_entry_faces_destroy(murk_entry_faces *entry_faces)
{
    if (entry_faces) {
        for (size_t i = 0; i < entry_faces->tables; ++i) {
            murk_dome_table_destroy(entry_faces->table[i]);
        }
        free(entry_faces->table);
        free(entry_faces->outward);
        free(entry_faces->entry_face);
        free(entry_faces);
    }
}

double murk_entry_faces_area_m2(const murk_entry_faces *entry_faces)
{
    return entry_faces->area_m2;
}

double murk_entry_faces_one_m2(const murk_entry_faces *entry_faces,
                               size_t which)
{
    assert(which < entry_faces->n);
    return entry_faces->entry_face[which].one_m2;
}

double murk_entry_faces_level(const murk_entry_faces *entry_faces)
{
    return entry_faces->level;
}

/* ---- photons ---- */

/* Returns the first face with a cumulative share above u. */
static size_t choose(const murk_entry_faces *o, double u)
{
    size_t low = 0, high = o->n - 1;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (u < o->entry_face[middle].end) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

static bool is_on(const entry_face *k, murk_vec3 p)
{
    const murk_vec3 from = murk_sub(p, k->corner);
    const double s = murk_dot(from, k->measure[0]);
    const double t = murk_dot(from, k->measure[1]);
    return s >= 0 && s < 1 && t >= 0 && t < 1;
}

/* True if the ray through point p of the portal `own` passes another portal
 * inward before p, or at p (AT_ONCE) if the other portal comes first in the
 * list. */
static bool passes_before(const murk_entry_faces *o, size_t own, murk_vec3 p,
                          murk_vec3 direction)
{
    for (size_t i = 0; i < o->n; ++i) {
        const entry_face *k = &o->entry_face[i];
        const double cosine = murk_dot(direction, k->inward);
        if (i == own || !(cosine > 0)) {
            continue;
        }
        const double ahead =
            murk_dot(murk_sub(k->corner, p), k->inward) / cosine;
        const bool is_first =
            ahead < -o->at_once_m || (ahead <= o->at_once_m && i < own);
        if (is_first && is_on(k, murk_along(p, ahead, direction))) {
            return true;
        }
    }
    return false;
}

static double behind(double p, double d, double minimum, double maximum)
{
    return d > 0 ? (p - minimum) / d : d < 0 ? (p - maximum) / d : INFINITY;
}

/* The point at which a ray through p entered the box. */
static murk_vec3 entry(const murk_box *box, murk_vec3 p, murk_vec3 d)
{
    const murk_vec3 a = box->min, b = box->max;
    const double x = behind(p.x, d.x, a.x, b.x), y = behind(p.y, d.y, a.y, b.y),
                 z = behind(p.z, d.z, a.z, b.z);
    const double back = fmin(x, fmin(y, z));
    murk_vec3 from = murk_along(p, -back, d);
    if (z == back) {
        from.z = d.z > 0 ? a.z : b.z;
    } else if (y == back) {
        from.y = d.y > 0 ? a.y : b.y;
    } else {
        from.x = d.x > 0 ? a.x : b.x;
    }
    return from;
}

murk_ray murk_entry_faces_emit(const murk_entry_faces *o,
                               const double u[MURK_ENTRY_FACES_NUMBERS])
{
    const size_t i = choose(o, u[0]);
    const entry_face *k = &o->entry_face[i];
    murk_ray ray = {.origin = murk_along(k->corner, u[1], k->edge1)};
    ray.origin = murk_along(ray.origin, u[2], k->edge2);
    ray.direction =
        o->is_dome ? murk_scale(-1, murk_dome_table_draw(k->sky, u + 3))
                   : murk_disc_draw(o->direction, o->disc, k->inward, u + 3);
    if (o->are_portals) {
        ray.is_spent =
            o->n > 1 && passes_before(o, i, ray.origin, ray.direction);
        ray.origin = entry(&o->box, ray.origin, ray.direction);
    }
    return ray;
}
