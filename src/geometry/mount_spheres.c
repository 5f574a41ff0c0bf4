/* Candidate sites on spheres: the six poles, and the middles of pieces of
 * each octant that is halved until the pieces are small. */
#include "geometry/mount_builder.h"
#include "geometry/polygon.h"

static bool is_searched(const murk_mount_builder *l,
                        const murk_stored_sphere *b)
{
    return !l->search->materials || l->search->materials[b->material];
}

/* Offers the points of the sphere on the six half axes. */
static void add_poles(murk_mount_builder *l, const murk_stored_sphere *b)
{
    const murk_vec3 center = murk_add(b->center, l->surfaces->soup.anchor);
    for (int i = 0; i < 6; ++i) {
        murk_vec3 pole = {0, 0, 0};
        murk_component_set(&pole, i / 2, i % 2 ? 1 : -1);
        murk_mount_builder_offer(l, murk_along(center, b->radius, pole), pole);
    }
}

/* Distance from a point to a box. */
static double distance_to(const murk_box *box, murk_vec3 p)
{
    return murk_length(
        murk_vec(fmax(0, fmax(box->min.x - p.x, p.x - box->max.x)),
                 fmax(0, fmax(box->min.y - p.y, p.y - box->max.y)),
                 fmax(0, fmax(box->min.z - p.z, p.z - box->max.z))));
}

/* fill_gaps() (mount_pattern.c) for the part of a sphere between three
 * directions, at most an octant. Parts out of reach of the box are skipped. */
static void fill_octant(murk_mount_builder *l, murk_vec3 center, double radius,
                        murk_vec3 a, murk_vec3 b, murk_vec3 c)
{
    const double ab = murk_length(murk_sub(b, a)),
                 bc = murk_length(murk_sub(c, b)),
                 ca = murk_length(murk_sub(a, c));
    /* The middle of the part, and the largest distance of a corner from it. */
    const murk_vec3 mid = murk_unit(murk_add(a, murk_add(b, c)));
    const murk_vec3 place = murk_along(center, radius, mid);
    const double far = fmax(
        murk_length(murk_sub(a, mid)),
        fmax(murk_length(murk_sub(b, mid)), murk_length(murk_sub(c, mid))));
    if (l->status ||
        distance_to(&l->search->within, place) > radius * far + l->slack_m) {
        return;
    }
    /* A small part offers a site; otherwise halve the longest side. */
    if (!(radius * fmax(ab, fmax(bc, ca)) >
          MURK_MOUNT_PIECE * l->search->spacing_m)) {
        murk_mount_builder_offer(l, place, mid);
    } else if (ab >= bc && ab >= ca) {
        const murk_vec3 m = murk_unit(murk_middle(a, b));
        fill_octant(l, center, radius, a, m, c);
        fill_octant(l, center, radius, m, b, c);
    } else if (bc >= ca) {
        const murk_vec3 m = murk_unit(murk_middle(b, c));
        fill_octant(l, center, radius, b, m, a);
        fill_octant(l, center, radius, m, c, a);
    } else {
        const murk_vec3 m = murk_unit(murk_middle(c, a));
        fill_octant(l, center, radius, c, m, b);
        fill_octant(l, center, radius, m, a, b);
    }
}

static void fill_sphere(murk_mount_builder *l, const murk_stored_sphere *b)
{
    const murk_vec3 center = murk_add(b->center, l->surfaces->soup.anchor);
    for (int i = 0; i < 8; ++i) {
        fill_octant(l, center, b->radius, murk_vec(i & 1 ? 1 : -1, 0, 0),
                    murk_vec(0, i & 2 ? 1 : -1, 0),
                    murk_vec(0, 0, i & 4 ? 1 : -1));
    }
}

bool murk_mount_builder_any_sphere(const murk_mount_builder *l)
{
    for (size_t i = 0; i < l->surfaces->soup.spheres; ++i) {
        if (is_searched(l, &l->surfaces->soup.sphere[i])) {
            return true;
        }
    }
    return false;
}

void murk_mount_builder_poles(murk_mount_builder *l)
{
    for (size_t i = 0; i < l->surfaces->soup.spheres && !l->status; ++i) {
        if (is_searched(l, &l->surfaces->soup.sphere[i])) {
            add_poles(l, &l->surfaces->soup.sphere[i]);
        }
    }
}

void murk_mount_builder_spheres(murk_mount_builder *l)
{
    for (size_t i = 0; i < l->surfaces->soup.spheres && !l->status; ++i) {
        if (is_searched(l, &l->surfaces->soup.sphere[i])) {
            fill_sphere(l, &l->surfaces->soup.sphere[i]);
        }
    }
}
