/* Compares two sets of surfaces. The shapes of a scene keep their order, so
 * most faces are equal from the beginning of both lists on, or up to their
 * ends; the faces between are sorted by their coordinates and compared. */
#include "geometry/changed_surfaces.h"

#include "geometry/boundary_mesh.h"
#include "geometry/ray_scene.h"

#include <stdlib.h>
#include <string.h>

/* A triangle or a sphere: all that an answer about a segment depends on. */
typedef struct face {
    double place[9]; /* corners; or center, radius and zeros */
    murk_face kind;
    bool is_sphere;
    uint16_t material; /* NO_MATERIAL: it does not count */
} face;

#define NO_MATERIAL UINT16_MAX

static int compare_faces(const void *a, const void *b)
{
    const face *p = a, *q = b;
    const int order = memcmp(p->place, q->place, sizeof p->place);
    return order                          ? order
           : p->kind != q->kind           ? (p->kind < q->kind ? -1 : 1)
           : p->is_sphere != q->is_sphere ? (q->is_sphere ? -1 : 1)
           : p->material != q->material   ? (p->material < q->material ? -1 : 1)
                                          : 0;
}

static murk_face kind_of(const size_t first[MURK_FACES + 1], size_t i)
{
    unsigned kind = 0;
    while (i >= first[kind + 1]) {
        ++kind;
    }
    return (murk_face)kind;
}

static murk_box box_of(const face *f, murk_vec3 anchor)
{
    const double *p = f->place;
    const murk_vec3 first = murk_add(anchor, murk_vec(p[0], p[1], p[2]));
    if (f->is_sphere) {
        return murk_box_of_ball(first, p[3]);
    }
    murk_box box = murk_box_with(murk_box_empty(), first);
    for (int k = 3; k < 9; k += 3) {
        const murk_vec3 corner = {p[k], p[k + 1], p[k + 2]};
        box = murk_box_with(box, murk_add(anchor, corner));
    }
    return box;
}

static size_t faces(const murk_surfaces *s)
{
    return s->soup.triangles + s->soup.spheres;
}

#define SAME(a, b, member) \
    (memcmp(&(a)->member, &(b)->member, sizeof(a)->member) == 0)

/* True if the material of that number transmits the same in both, and has the
 * same other properties if these count. */
static bool is_same_material(const murk_surfaces *a, const murk_surfaces *b,
                             size_t i, bool with_materials)
{
    if (i >= a->n_materials || i >= b->n_materials) {
        return false;
    }
    const murk_material *p = &a->material[i], *q = &b->material[i];
    return SAME(p, q, transmit) &&
           (!with_materials ||
            (SAME(p, q, diffuse) && SAME(p, q, specular) && SAME(p, q, ior)));
}

/* Two lists of faces that are compared. */
typedef struct comparison {
    const murk_surfaces *a, *b;
    bool with_materials;              /* of all faces; false: of sheets */
    bool is_same[MURK_MATERIALS_MAX]; /* the material is the same in both */
} comparison;

/* False if the material counts and has changed. */
static bool is_as_before(const comparison *c, const face *f)
{
    return f->material == NO_MATERIAL || c->is_same[f->material];
}

/* Face i of a soup: triangles come first, then spheres. */
static face face_of(const comparison *c, const murk_soup *soup, size_t i)
{
    face out = {.is_sphere = i >= soup->triangles, .material = NO_MATERIAL};
    if (!out.is_sphere) {
        const murk_triangle t = murk_soup_triangle(soup, i);
        const murk_vec3 corner[3] = {t.a, t.b, t.c};
        for (size_t k = 0; k < 9; ++k) {
            out.place[k] = murk_component(corner[k / 3], (int)(k % 3));
        }
        out.kind = kind_of(soup->first_triangle, i);
    } else {
        const size_t k = i - soup->triangles;
        const murk_stored_sphere *s = &soup->sphere[k];
        out.place[0] = s->center.x;
        out.place[1] = s->center.y;
        out.place[2] = s->center.z;
        out.place[3] = s->radius;
        out.kind = kind_of(soup->first_sphere, k);
    }
    if (c->with_materials || out.kind == MURK_FACE_SHEET) {
        out.material = murk_soup_material(soup, i);
    }
    return out;
}

/* True if face i of the first and face k of the second are the same. */
static bool is_same_face(const comparison *c, size_t i, size_t k)
{
    const face p = face_of(c, &c->a->soup, i), q = face_of(c, &c->b->soup, k);
    return compare_faces(&p, &q) == 0 && is_as_before(c, &p);
}

static void add_face(murk_box_list *changed, const comparison *c, const face *f)
{
    murk_box_list_add(changed, box_of(f, c->a->soup.anchor));
}

/* Merges two sorted lists, and adds the faces that only one of them has, or
 * whose material has changed. */
static void add_changed(murk_box_list *changed, const comparison *c,
                        const face *p, size_t n, const face *q, size_t m)
{
    size_t i = 0, k = 0;
    while (i < n || k < m) {
        const int order = i == n   ? 1
                          : k == m ? -1
                                   : compare_faces(&p[i], &q[k]);
        const face *first = order <= 0 ? &p[i] : &q[k];
        if (order != 0 || !is_as_before(c, first)) {
            add_face(changed, c, first);
        }
        i += order <= 0;
        k += order >= 0;
    }
}

/* Compares faces [begin, end) of both, with different ends. */
static murk_status compare_between(murk_box_list *changed, const comparison *c,
                                   size_t begin, size_t end_a, size_t end_b,
                                   murk_error *err)
{
    const size_t n = end_a - begin, m = end_b - begin;
    face *p = malloc((n + m + 1) * sizeof *p);
    if (!p) {
        return murk_no_memory(err, "", "to compare %zu surfaces", n + m);
    }
    face *q = p + n;
    for (size_t i = 0; i < n; ++i) {
        p[i] = face_of(c, &c->a->soup, begin + i);
    }
    for (size_t k = 0; k < m; ++k) {
        q[k] = face_of(c, &c->b->soup, begin + k);
    }
    qsort(p, n, sizeof *p, compare_faces);
    qsort(q, m, sizeof *q, compare_faces);
    add_changed(changed, c, p, n, q, m);
    free(p);
    return MURK_OK;
}

/* True if rays and their margins are the same in both. */
static bool is_same_rounding(const murk_surfaces *a, const murk_surfaces *b)
{
    return memcmp(&a->soup.anchor, &b->soup.anchor, sizeof a->soup.anchor) ==
               0 &&
           a->unit_m == b->unit_m && a->leave_m == b->leave_m &&
           memcmp(&a->reach, &b->reach, sizeof a->reach) == 0 &&
           a->is_reach_sound == b->is_reach_sound;
}

murk_status murk_changed_surfaces(murk_box_list *changed,
                                  const murk_surfaces *a,
                                  const murk_surfaces *b, bool with_materials,
                                  murk_error *err)
{
    if (!is_same_rounding(a, b)) {
        changed->are_all = true;
        return MURK_OK;
    }
    comparison c = {.a = a, .b = b, .with_materials = with_materials};
    for (size_t i = 0; i < MURK_MATERIALS_MAX; ++i) {
        c.is_same[i] = is_same_material(a, b, i, with_materials);
    }
    /* Leave out equal faces at the beginning and at the end. */
    size_t begin = 0, end_a = faces(a), end_b = faces(b);
    while (begin < end_a && begin < end_b && is_same_face(&c, begin, begin)) {
        ++begin;
    }
    while (end_a > begin && end_b > begin &&
           is_same_face(&c, end_a - 1, end_b - 1)) {
        --end_a;
        --end_b;
    }
    return compare_between(changed, &c, begin, end_a, end_b, err);
}

murk_status murk_changed_boundary_meshes(murk_box_list *changed,
                                         const murk_boundary_meshes *a,
                                         const murk_boundary_meshes *b,
                                         murk_error *err)
{
    if (!a || !b) {
        changed->are_all = changed->are_all || a || b;
        return MURK_OK;
    }
    if (a->n != b->n || a->tolerance_m != b->tolerance_m) {
        changed->are_all = true;
        return MURK_OK;
    }
    murk_status status = MURK_OK;
    for (size_t i = 0; i < a->n && !status; ++i) {
        const murk_boundary_mesh *p = &a->boundary_mesh[i],
                                 *q = &b->boundary_mesh[i];
        murk_box_list faces = {0};
        if (p->region != q->region) {
            changed->are_all = true;
            return MURK_OK;
        }
        /* What lies between the faces may have changed, too. */
        status = murk_changed_surfaces(&faces, p->shape, q->shape, false, err);
        if (faces.n > 0 || faces.are_all) {
            murk_box_list_add(changed,
                              murk_surfaces_describe(p->shape).bounds_m);
            murk_box_list_add(changed,
                              murk_surfaces_describe(q->shape).bounds_m);
        }
    }
    return status;
}
