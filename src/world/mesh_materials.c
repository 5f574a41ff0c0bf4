/* Lists the material names of the imported meshes of the geometry, with the
 * area of the triangles of each name and with the material of the scene that
 * each name was given. (murk_surfaces_material_named() finds the material by
 * the same function by which geometry/placed_shapes.c assigns it to triangles.)
 * Warns of names that match no entry of `materials` and of entries that no
 * surface uses. */
#include "world/mesh_materials.h"

#include "base/log.h"
#include "geometry/triangle.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The number of names that one warning lists at most, and the size of the text
 * of these names, which is cut off beyond. 8 names of 50 characters fill some
 * 430 characters; a name has at most 63 (MURK_NAME_SIZE in geometry/mesh.h). */
#define NAMES_IN_WARNING 8
#define WARNING_SIZE     480

/* True if the name is empty, "default" or "DefaultMaterial", in any case.
 * Importers give these names to triangles that have no material in the file, so
 * the user has probably not written such a name. */
static bool is_no_name(const char *name)
{
    return !*name || strcasecmp(name, "default") == 0 ||
           strcasecmp(name, "DefaultMaterial") == 0;
}

/* Adds the area of each triangle of a mesh, transformed by to_world, to the
 * element of area_m2 of the triangle's material name. */
static void add_areas(double *area_m2, const murk_mesh *mesh,
                      const murk_affine *to_world)
{
    for (size_t i = 0; i < mesh->triangles; ++i) {
        murk_triangle t =
            murk_triangle_at(mesh->vertex_m, mesh->corner + 3 * i);
        t.a = murk_affine_point(to_world, t.a);
        t.b = murk_affine_point(to_world, t.b);
        t.c = murk_affine_point(to_world, t.c);
        area_m2[mesh->material[i]] += murk_triangle_area(&t);
    }
}

murk_status murk_mesh_materials(murk_mesh_material **out, size_t *n,
                                const murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    /* Count the names of all meshes, and find the largest number of one mesh.
     */
    size_t all = 0, max = 0;
    for (size_t i = 0; i < scene->geometries; ++i) {
        const size_t names = stage->mesh[i] ? stage->mesh[i]->materials : 0;
        all += names;
        max = names > max ? names : max;
    }
    murk_mesh_material *list = calloc(all + 1, sizeof *list);
    double *area_m2 = calloc(max + 1, sizeof *area_m2);
    if (!list || !area_m2) {
        free(list);
        free(area_m2);
        return murk_no_memory(err, scene->path, "for %zu names of materials",
                              all);
    }
    /* Sum the areas of each mesh and list the names that have an area. */
    size_t found = 0;
    for (size_t i = 0; i < scene->geometries; ++i) {
        const murk_scene_geometry *g = &scene->geometry[i];
        const murk_mesh *mesh = stage->mesh[i];
        if (!mesh) {
            continue; /* a box, a rectangle or a sphere */
        }
        const murk_affine to_world = murk_scene_placed(&g->solid);
        memset(area_m2, 0, mesh->materials * sizeof *area_m2);
        add_areas(area_m2, mesh, &to_world);
        for (size_t k = 0; k < mesh->materials; ++k) {
            if (!(area_m2[k] > 0)) {
                continue; /* no triangle with an area has this name */
            }
            murk_mesh_material *m = &list[found++];
            *m = (murk_mesh_material){.geometry = i,
                                      .name = mesh->material_name[k],
                                      .area_m2 = area_m2[k],
                                      .is_forced = g->material >= 0};
            m->material = m->is_forced
                              ? g->material
                              : (int)murk_surfaces_material_named(
                                    stage->surfaces, m->name, &m->is_named);
        }
    }
    free(area_m2);
    *out = list;
    *n = found;
    return MURK_OK;
}

/* Prints one warning for those of n names of one mesh that got the material
 * `default` because no entry of `materials` matches; nothing if there are
 * none. */
static void warn_of_names(const murk_mesh_material *list, size_t n,
                          const murk_scene_desc *scene)
{
    char names[WARNING_SIZE] = "";
    size_t at = 0, fallen = 0;
    double area_m2 = 0;
    for (size_t i = 0; i < n; ++i) {
        const murk_mesh_material *m = &list[i];
        if (m->is_forced || m->is_named || is_no_name(m->name)) {
            continue;
        }
        area_m2 += m->area_m2;
        if (fallen++ < NAMES_IN_WARNING && at < sizeof names) {
            at += (size_t)snprintf(names + at, sizeof names - at, "%s\"%s\"",
                                   at ? ", " : "", m->name);
        }
    }
    if (fallen > 0) {
        murk_warn(scene->geometry[list[0].geometry].where,
                  "%s%s: no entry of materials has %s, so %.4g m2 of the mesh "
                  "are of material default",
                  names, fallen > NAMES_IN_WARNING ? " and more" : "",
                  fallen > 1 ? "these names" : "this name", area_m2);
    }
}

static void warn_of_entries(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    for (size_t i = 1; i < scene->n_materials; ++i) { /* 0 is `default` */
        const murk_scene_material *m = &scene->materials[i];
        if (!(murk_surfaces_material_area(stage->surfaces, i) > 0)) {
            murk_warn(m->where,
                      "no surface is of this material: no geometry refers to "
                      "it, and no mesh has this name (murk check lists the "
                      "names)");
        }
    }
}

void murk_warn_of_materials(const murk_stage *stage)
{
    murk_mesh_material *list = NULL;
    size_t n = 0;
    if (murk_mesh_materials(&list, &n, stage, NULL)) {
        return; /* no memory for a warning */
    }
    for (size_t first = 0, last; first < n; first = last) {
        for (last = first + 1;
             last < n && list[last].geometry == list[first].geometry; ++last) {
        }
        warn_of_names(list + first, last - first, stage->scene);
    }
    free(list);
    warn_of_entries(stage);
}
