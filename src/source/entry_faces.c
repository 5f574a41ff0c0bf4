#include "source/entry_faces.h"

#include <assert.h>
#include <stdlib.h>

#include "source/disc.h"
#include "source/dome_table.h"

#define FACES 6

/* Two portals nearer to each other along a ray than this share of the largest
 * coordinate are met at once, so that the order given decides, not rounding. */
#define AT_ONCE 1e-9

/* Below this sine squared two facings are the same one, and share a table. */
#define SAME_FACING 1e-24

typedef struct opening {
    murk_vec3 corner, edge1, edge2;
    murk_vec3 inward;           /* unit */
    murk_vec3 measure[2];       /* portals: dotted with what lies on it from the
                                   corner, the shares of the edges */
    double one_m2;              /* power for irradiance 1 */
    double end;                 /* cumulative share of the power */
    const murk_dome_table *sky; /* NULL: directional, or no power */
} opening;

struct murk_entry_faces {
    bool is_dome;
    murk_vec3 direction;
    double disc; /* tangent of the angular radius */
    murk_box box;
    double at_once_m;
    bool are_portals;
    size_t n, tables;
    opening *opening;        /* [n] */
    murk_dome_table **table; /* [tables], of different facings; the first one is
                                of the level plane */
    murk_vec3 *outward;      /* [tables] */
    double area_m2;
    double level; /* dome: irradiance of a level plane, relative */
};

/* ---- where they are ---- */

static void lay_faces(murk_entry_faces *o, bool is_periodic)
{
    const murk_vec3 a = o->box.min, b = o->box.max;
    const murk_vec3 x = {b.x - a.x, 0, 0}, y = {0, b.y - a.y, 0},
                    z = {0, 0, b.z - a.z};
    const opening face[FACES] = {
        {.corner = {a.x, a.y, b.z},
         .edge1 = x,
         .edge2 = y,
         .inward = {0, 0, -1}},
        {.corner = a, .edge1 = x, .edge2 = y, .inward = {0, 0, 1}},
        {.corner = a, .edge1 = y, .edge2 = z, .inward = {1, 0, 0}},
        {.corner = {b.x, a.y, a.z},
         .edge1 = y,
         .edge2 = z,
         .inward = {-1, 0, 0}},
        {.corner = a, .edge1 = z, .edge2 = x, .inward = {0, 1, 0}},
        {.corner = {a.x, b.y, a.z},
         .edge1 = z,
         .edge2 = x,
         .inward = {0, -1, 0}}};
    o->n = is_periodic ? 1 : FACES;
    for (size_t i = 0; i < o->n; ++i) {
        o->opening[i] = face[i];
    }
}

static void lay_portals(murk_entry_faces *o, const murk_portal *portal,
                        size_t n)
{
    o->n = n;
    for (size_t i = 0; i < n; ++i) {
        const murk_portal *p = &portal[i];
        const murk_vec3 across = murk_cross(p->edge1, p->edge2);
        const double square = murk_dot(across, across);
        o->opening[i] = (opening){
            .corner = p->corner,
            .edge1 = p->edge1,
            .edge2 = p->edge2,
            .inward = murk_unit(across),
            .measure = {murk_scale(1 / square, murk_cross(p->edge2, across)),
                        murk_scale(1 / square, murk_cross(across, p->edge1))}};
    }
}

/* ---- what they let in ---- */

/* The sky as planes of one facing see it: made where no opening before has it.
 */
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

static murk_status open_to_sky(murk_entry_faces *o, const murk_source *light,
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
        opening *k = &o->opening[i];
        if (k->inward.z >= 1) { /* looks down: no sky */
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

static void open_to_disc(murk_entry_faces *o)
{
    for (size_t i = 0; i < o->n; ++i) {
        opening *k = &o->opening[i];
        k->one_m2 = murk_length(murk_cross(k->edge1, k->edge2)) *
                    murk_disc_cosine(o->direction, o->disc, k->inward);
    }
}

static void add_up(murk_entry_faces *o)
{
    size_t last = 0;
    for (size_t i = 0; i < o->n; ++i) {
        o->area_m2 += o->opening[i].one_m2;
        last = o->opening[i].one_m2 > 0 ? i : last;
    }
    double sum = 0;
    for (size_t i = 0; i < o->n; ++i) {
        sum += o->opening[i].one_m2;
        o->opening[i].end = i < last ? sum / o->area_m2 : 1;
    }
}

murk_status murk_entry_faces_create(murk_entry_faces **out,
                                    const murk_source *light,
                                    const murk_domain *domain, murk_error *err)
{
    assert(murk_source_is_distant(light));
    const size_t room = light->portals > FACES ? light->portals : FACES;
    murk_entry_faces *o = calloc(1, sizeof *o);
    if (o) {
        o->is_dome = murk_source_type_group(light->type) == MURK_SOURCE_DOME;
        o->direction = light->direction;
        o->disc = tan(light->angular_radius_rad);
        o->box = domain->box;
        o->are_portals = light->portals > 0;
        o->opening = calloc(room, sizeof *o->opening);
        o->table = calloc(room + 1, sizeof *o->table);
        o->outward = calloc(room + 1, sizeof *o->outward);
    }
    if (!o || !o->opening || !o->table || !o->outward) {
        murk_entry_faces_destroy(o);
        return murk_fail(err, MURK_NO_MEMORY, light->where,
                         "no memory for a light");
    }
    o->at_once_m = AT_ONCE * murk_box_largest_coordinate(&o->box);
    if (o->are_portals) {
        lay_portals(o, light->portal, light->portals);
    } else {
        lay_faces(o, domain->is_periodic);
    }
    murk_status status = MURK_OK;
    if (o->is_dome) {
        status = open_to_sky(o, light, err);
    } else {
        open_to_disc(o);
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
        free(entry_faces->opening);
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
    return entry_faces->opening[which].one_m2;
}

double murk_entry_faces_level(const murk_entry_faces *entry_faces)
{
    return entry_faces->level;
}

/* ---- photons ---- */

/* The first opening that ends beyond u. */
static size_t choose(const murk_entry_faces *o, double u)
{
    size_t low = 0, high = o->n - 1;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (u < o->opening[middle].end) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

static bool is_on(const opening *k, murk_vec3 p)
{
    const murk_vec3 from = murk_sub(p, k->corner);
    const double s = murk_dot(from, k->measure[0]);
    const double t = murk_dot(from, k->measure[1]);
    return s >= 0 && s < 1 && t >= 0 && t < 1;
}

/* Whether the ray, which has place p on its own portal, passes another one
 * inward before it. */
static bool passes_before(const murk_entry_faces *o, size_t own, murk_vec3 p,
                          murk_vec3 direction)
{
    for (size_t i = 0; i < o->n; ++i) {
        const opening *k = &o->opening[i];
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

/* Where a ray through p came into the box. */
static murk_vec3 entry(const murk_box *box, murk_vec3 p, murk_vec3 d)
{
    const murk_vec3 a = box->min, b = box->max;
    const double x = behind(p.x, d.x, a.x, b.x), y = behind(p.y, d.y, a.y, b.y),
                 z = behind(p.z, d.z, a.z, b.z);
    const double way = fmin(x, fmin(y, z));
    murk_vec3 from = murk_along(p, -way, d);
    if (z == way) {
        from.z = d.z > 0 ? a.z : b.z;
    } else if (y == way) {
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
    const opening *k = &o->opening[i];
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
