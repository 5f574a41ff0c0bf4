/* Small worlds for tests of the tracer, in a few lines of C. Creation is
 * checked: a failure is a failed check and ends the program. */
#ifndef MURK_TESTS_WORLDS_H
#define MURK_TESTS_WORLDS_H

#include "transport/trace.h"

/* Room for a world's parts; owned by it. */
typedef struct test_world {
    murk_transport_world world;
    murk_surfaces *surfaces;
    murk_media *media;
    murk_sources *lights;
    murk_boundary_meshes *boundary_meshes;
    murk_ledger *ledger;
} test_world;

/* What a test says of its world; counts may be 0. One band. materials[0] is
 * the default; none given: black. */
typedef struct test_setup {
    murk_domain domain;
    const murk_source *lights;
    size_t n_lights;
    const murk_surface_desc *surfaces;
    size_t n_surfaces;
    const murk_material *materials;
    size_t n_materials;
    const murk_medium *media;
    size_t n_media;
    const murk_region *regions;
    size_t n_regions;
    murk_mesh *const *mesh; /* [n_regions] of the regions that are meshes,
                        borrowed; NULL: none is */
} test_setup;

test_world test_world_made(const test_setup *setup);
void test_world_unmade(test_world *world);

/* Traces photons [0, n) with seed and sink into world->ledger. */
void test_world_trace(test_world *world, uint64_t n, uint32_t seed,
                      murk_event_sink sink, void *context);

/* Photons counted in one of the ledger's accounts, over all channels. */
double test_photons(const test_world *world, const murk_tally *account);

/* Parts with everything else as it should be. */
murk_source test_beam(murk_vec3 origin, murk_vec3 direction);
murk_source test_point(murk_vec3 position);
murk_medium test_medium(double extinction_per_m, double albedo,
                        double mean_cosine);
murk_region test_everywhere(size_t medium);
murk_region test_box_region(size_t medium, murk_vec3 min, murk_vec3 max);
murk_region test_mesh_region(size_t medium); /* its mesh: test_setup.mesh */
murk_region test_ball_region(size_t medium, murk_vec3 center, double radius_m);
murk_material test_material(double diffuse, double specular, double transmit,
                            double ior);
murk_surface_desc test_box(murk_vec3 min, murk_vec3 max, int material);
murk_surface_desc test_rect(murk_vec3 corner, murk_vec3 edge1, murk_vec3 edge2,
                            int material);
murk_surface_desc test_sphere(murk_vec3 center, double radius_m, int material);

/* The six walls of a box as lamps that shine inwards by cosine law, all alike,
 * one watt together. */
#define TEST_WALLS 6
void test_wall_lamps(const murk_box *box, murk_source lamp[TEST_WALLS]);

#endif
