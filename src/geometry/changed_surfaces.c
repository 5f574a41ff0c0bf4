/* Compares two sets of surfaces. The shapes of a scene keep their order, so
 * most faces are equal from the beginning of both lists on, or up to their
 * ends; the faces between are sorted by their coordinates and compared. */
#include "geometry/changed_surfaces.h"

#include "geometry/ray_scene.h"

#include <stdlib.h>
#include <string.h>

/* A triangle or a sphere: all that an answer about a segment depends on.
 * Compared as bytes, so there must be no unused ones. */
typedef struct face {
    double place[9]; /* corners; or center, radius and zeros */
    uint64_t kind;   /* of the face, whether it is a sphere, and of a sheet the
                      * material */
} face;

_Static_assert(sizeof(face) == 10 * sizeof(double), "no padding in a face");

static int compare_faces(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(face));
}

static murk_face kind_of(const size_t first[MURK_FACES + 1], size_t i)
{
    unsigned kind = 0;
    while (i >= first[kind + 1]) {
        ++kind;
    }
    return (murk_face)kind;
}

static uint64_t pack_kind(murk_face kind, uint8_t material, bool is_sphere)
{
    return (uint64_t)kind << 16 | (uint64_t)is_sphere << 8 |
           (kind == MURK_FACE_SHEET ? material : 0);
}

/* Face i of the soup: triangles come first, then spheres. */
static face face_of(const murk_soup *soup, size_t i)
{
    face out = {{0}, 0};
    const uint8_t material = murk_soup_material(soup, i);
    if (i < soup->triangles) {
        const murk_triangle t = murk_soup_triangle(soup, i);
        const murk_vec3 corner[3] = {t.a, t.b, t.c};
        for (size_t k = 0; k < 9; ++k) {
            out.place[k] = murk_component(corner[k / 3], (int)(k % 3));
        }
        out.kind = pack_kind(kind_of(soup->first_triangle, i), material, false);
        return out;
    }
    const size_t k = i - soup->triangles;
    const murk_stored_sphere *s = &soup->sphere[k];
    out.place[0] = s->center.x;
    out.place[1] = s->center.y;
    out.place[2] = s->center.z;
    out.place[3] = s->radius;
    out.kind = pack_kind(kind_of(soup->first_sphere, k), material, true);
    return out;
}

static murk_box box_of(const face *f, murk_vec3 anchor)
{
    const double *p = f->place;
    const murk_vec3 first = murk_add(anchor, murk_vec(p[0], p[1], p[2]));
    if (f->kind >> 8 & 1) {
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

/* True if sheets of the material of that number transmit the same in both. Of
 * other faces the kind decides. */
static bool is_same_sheet(const murk_surfaces *a, const murk_surfaces *b,
                          size_t i)
{
    return i < a->n_materials && i < b->n_materials &&
           memcmp(&a->material[i].transmit, &b->material[i].transmit,
                  sizeof a->material[i].transmit) == 0;
}

/* Two lists of faces that are compared. */
typedef struct comparison {
    const murk_surfaces *a, *b;
    bool is_same[MURK_MATERIALS_MAX]; /* sheets of the material transmit the
                                       * same in both */
} comparison;

/* False for a sheet whose material has changed. */
static bool is_as_before(const comparison *c, const face *f)
{
    return f->kind >> 16 != MURK_FACE_SHEET || c->is_same[f->kind & 0xff];
}

/* True if face i of the first and face k of the second are the same. */
static bool is_same_face(const comparison *c, size_t i, size_t k)
{
    const face p = face_of(&c->a->soup, i), q = face_of(&c->b->soup, k);
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
    face *p = malloc((n + m + 1) * sizeof *p), *q = p + n;
    if (!p) {
        return murk_no_memory(err, "", "to compare %zu surfaces", n + m);
    }
    for (size_t i = 0; i < n; ++i) {
        p[i] = face_of(&c->a->soup, begin + i);
    }
    for (size_t k = 0; k < m; ++k) {
        q[k] = face_of(&c->b->soup, begin + k);
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
                                  const murk_surfaces *b, murk_error *err)
{
    if (!is_same_rounding(a, b)) {
        changed->are_all = true;
        return MURK_OK;
    }
    comparison c = {.a = a, .b = b};
    for (size_t i = 0; i < MURK_MATERIALS_MAX; ++i) {
        c.is_same[i] = is_same_sheet(a, b, i);
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
