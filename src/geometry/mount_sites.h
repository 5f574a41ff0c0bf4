/* Candidate sites on surfaces: places at which a sensor may be mounted.
 *
 * Sites are about spacing_m apart however the surfaces are cut into triangles.
 * First come sites on the lines of a square lattice along the axis closest to
 * the normal of a face. The lattice is centred in the bounding box of all
 * searched triangles, so a wall along the axes gets rows and columns spacing_m
 * apart. A sphere has its six poles along the axes in place of the lattice.
 * Then slanting faces and small parts are filled: the middle of a small piece
 * of a surface gets a site of its own if the middle is farther than 3/4
 * spacing_m from every site of the surface. No two sites of one surface are
 * closer than 3/4 spacing_m, and no place of a surface is farther from every
 * site than 1.1 spacing_m, in a straight line (except in stacks of thousands of
 * sheets, geometry/mount_builder.c).
 *
 * Two sites are on the same surface if neither rises above the other's plane by
 * more than half of their distance and the planes differ by at most 60 degrees.
 * The two faces of a wall, a floor and a wall in a corner, and shelves above
 * each other all get sites of their own. */
#ifndef MURK_GEOMETRY_MOUNT_SITES_H
#define MURK_GEOMETRY_MOUNT_SITES_H

#include "geometry/surfaces.h"

typedef struct murk_mount_site {
    murk_vec3 position;
    murk_vec3 normal; /* unit vector; either side of the surface */
} murk_mount_site;

typedef struct murk_mount_search {
    double spacing_m;      /* must exceed murk_mount_spacing_min_m() */
    murk_box within;       /* the sites lie in this box, which may be flat */
    const bool *materials; /* [murk_surfaces_materials()] materials that get
                              sites; NULL: all */
    double min_rise,
        max_rise; /* range of |normal.z|: 1 is horizontal, 0 vertical */
    size_t max;   /* largest number of sites; more are an error */
} murk_mount_search;

/* The spacing [m] that spacing_m must exceed; smaller ones are lost in
 * rounding. */
double murk_mount_spacing_min_m(const murk_surfaces *surfaces);

/* Finds the sites. The caller owns the array (*out)[*n], NULL if *n is 0, and
 * frees it with free(). Order: first the lattice, then the rest, each in the
 * order of triangles and spheres. Fails with MURK_BAD_VALUE at `where` if there
 * would be more than search->max sites, with MURK_NO_MEMORY or
 * MURK_INTERRUPTED. */
murk_status murk_surfaces_mount_sites(murk_mount_site **out, size_t *n,
                                      const murk_surfaces *surfaces,
                                      const murk_mount_search *search,
                                      const char *where, murk_error *err);

/* murk_surfaces_near() for a sensor at `point`, mounted at `site` on the
 * side of the normal, without the surface that carries the site. Not counted
 * are: everything that rises less than above_m over the plane of the site;
 * faces tilted by less than 45 degrees that rise no steeper than they are
 * tilted, like those of a tunnel; and the sphere that carries the site. */
bool murk_surfaces_near_mount(const murk_surfaces *surfaces, murk_vec3 point,
                              double radius_m, const murk_mount_site *site,
                              double above_m);

#endif
