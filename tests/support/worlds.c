/* Builds the parts of a small world from a description (surfaces, closed
 * meshes, media, light sources, ledger) and releases them. A failure ends the
 * program. */
#include "worlds.h"

#include <stdlib.h>

#include "check.h"

static void must(murk_status status, const murk_error *err)
{
    if (status) {
        printf("cannot make the world: %s: %s\n", err->where, err->text);
        exit(1);
    }
}

/* Regions lie where their mesh does, moved as they say. */
static void make_boundary_meshes(test_world *made, const test_setup *setup,
                                 murk_region *regions)
{
    murk_boundary_mesh_desc desc[MURK_REGIONS_MAX];
    murk_error err = {0};
    size_t n = 0;
    /* One boundary mesh for each region of that shape. */
    for (size_t i = 0; i < setup->n_regions; ++i) {
        regions[i] = setup->regions[i];
        if (regions[i].shape == MURK_REGION_MESH) {
            desc[n++] =
                (murk_boundary_mesh_desc){.region = (int)i,
                                          .mesh = setup->mesh[i],
                                          .to_world = regions[i].to_world};
        }
    }
    if (n > 0) {
        must(murk_boundary_meshes_create(&made->boundary_meshes, desc, n, &err),
             &err);
    }
    /* The bounding box of a region comes from its mesh. */
    for (size_t i = 0; i < setup->n_regions; ++i) {
        if (regions[i].shape == MURK_REGION_MESH) {
            regions[i].box =
                murk_boundary_meshes_describe(made->boundary_meshes, (int)i)
                    .bounds_m;
        }
    }
}

test_world test_world_made(const test_setup *setup)
{
    static const murk_material black = {.name = "default"};
    test_world made = {0};
    murk_error err = {0};
    murk_region regions[MURK_REGIONS_MAX];
    /* Parts first, then the world that borrows them. */
    make_boundary_meshes(&made, setup, regions);
    must(
        murk_surfaces_create(&made.surfaces, setup->surfaces, setup->n_surfaces,
                             setup->n_materials ? setup->materials : &black,
                             setup->n_materials ? setup->n_materials : 1, &err),
        &err);
    must(murk_media_create(&made.media, setup->media, setup->n_media, regions,
                           setup->n_regions, &setup->domain.box, &err),
         &err);
    must(murk_sources_create(&made.lights, setup->lights, setup->n_lights, 1,
                             &setup->domain, &err),
         &err);
    made.world =
        (murk_transport_world){.surfaces = made.surfaces,
                               .media = made.media,
                               .lights = made.lights,
                               .domain = setup->domain,
                               .bands = 1,
                               .boundary_meshes = made.boundary_meshes};
    must(murk_ledger_create(&made.ledger, &made.world, &err), &err);
    return made;
}

void test_world_unmade(test_world *world)
{
    murk_ledger_destroy(world->ledger);
    murk_sources_destroy(world->lights);
    murk_media_destroy(world->media);
    murk_surfaces_destroy(world->surfaces);
    murk_boundary_meshes_destroy(world->boundary_meshes);
}

void test_world_trace(test_world *world, uint64_t n, uint32_t seed,
                      murk_event_sink sink, void *context)
{
    murk_trace trace = murk_trace_defaults();
    trace.world = &world->world;
    trace.seed = seed;
    trace.last = n;
    trace.sink = sink;
    trace.context = context;
    murk_trace_run(&trace, world->ledger);
    CHECK(murk_ledger_imbalance(world->ledger) == 0);
    CHECK(murk_tally_read(&world->ledger->photons) == (int64_t)n);
}

double test_photons(const test_world *world, const murk_tally *account)
{
    int64_t quanta = 0;
    for (size_t c = 0; c < world->ledger->channels; ++c) {
        quanta += murk_tally_read(&account[c]);
    }
    return (double)(quanta / MURK_PACKET);
}

murk_source test_beam(murk_vec3 origin, murk_vec3 direction)
{
    return (murk_source){.type = MURK_SOURCE_BEAM,
                         .position = origin,
                         .direction = direction,
                         .power_w = {{1}},
                         .where = "beam"};
}

murk_source test_point(murk_vec3 position)
{
    return (murk_source){.type = MURK_SOURCE_POINT,
                         .position = position,
                         .power_w = {{1}},
                         .where = "point"};
}

murk_medium test_medium(double extinction_per_m, double albedo,
                        double mean_cosine)
{
    return (murk_medium){.extinction_per_m = {{extinction_per_m}},
                         .albedo = {{albedo}},
                         .phase = {murk_phase_hg(mean_cosine)},
                         .where = "medium"};
}

murk_region test_everywhere(size_t medium)
{
    return (murk_region){.medium = medium,
                         .shape = MURK_REGION_EVERYWHERE,
                         .to_world = murk_affine_identity(),
                         .where = "everywhere"};
}

murk_region test_mesh_region(size_t medium)
{
    return (murk_region){.medium = medium,
                         .shape = MURK_REGION_MESH,
                         .to_world = murk_affine_identity(),
                         .where = "mesh"};
}

murk_region test_box_region(size_t medium, murk_vec3 min, murk_vec3 max)
{
    return (murk_region){.medium = medium,
                         .shape = MURK_REGION_BOX,
                         .box = {min, max},
                         .to_world = murk_affine_identity(),
                         .where = "box region"};
}

murk_region test_ball_region(size_t medium, murk_vec3 center, double radius_m)
{
    return (murk_region){.medium = medium,
                         .shape = MURK_REGION_SPHERE,
                         .center = center,
                         .radius_m = radius_m,
                         .to_world = murk_affine_identity(),
                         .where = "ball region"};
}

murk_material test_material(double diffuse, double specular, double transmit,
                            double ior)
{
    return (murk_material){.name = "test",
                           .diffuse = {{diffuse}},
                           .specular = {{specular}},
                           .transmit = {{transmit}},
                           .ior = ior};
}

static murk_surface_desc surface(murk_shape shape, int material)
{
    return (murk_surface_desc){.shape = shape,
                               .to_world = murk_affine_identity(),
                               .material = material,
                               .where = "surface"};
}

murk_surface_desc test_box(murk_vec3 min, murk_vec3 max, int material)
{
    murk_surface_desc s = surface(MURK_SHAPE_BOX, material);
    s.box = (murk_box){min, max};
    return s;
}

murk_surface_desc test_rect(murk_vec3 corner, murk_vec3 edge1, murk_vec3 edge2,
                            int material)
{
    murk_surface_desc s = surface(MURK_SHAPE_RECT, material);
    s.corner = corner;
    s.edge1 = edge1;
    s.edge2 = edge2;
    return s;
}

murk_surface_desc test_sphere(murk_vec3 center, double radius_m, int material)
{
    murk_surface_desc s = surface(MURK_SHAPE_SPHERE, material);
    s.center = center;
    s.radius_m = radius_m;
    return s;
}

static murk_source wall_lamp(murk_vec3 corner, murk_vec3 edge1, murk_vec3 edge2)
{
    return (murk_source){.type = MURK_SOURCE_RECT,
                         .position = corner,
                         .edge1 = edge1,
                         .edge2 = edge2,
                         .power_w = {{murk_length(murk_cross(edge1, edge2))}},
                         .where = "wall"};
}

void test_wall_lamps(const murk_box *box, murk_source lamp[TEST_WALLS])
{
    const murk_vec3 o = box->min, size = murk_sub(box->max, box->min);
    const murk_vec3 x = {size.x, 0, 0}, y = {0, size.y, 0}, z = {0, 0, size.z};
    lamp[0] = wall_lamp(o, x, y);
    lamp[1] = wall_lamp(o, y, z);
    lamp[2] = wall_lamp(o, z, x);
    lamp[3] = wall_lamp(murk_add(o, z), y, x);
    lamp[4] = wall_lamp(murk_add(o, x), z, y);
    lamp[5] = wall_lamp(murk_add(o, y), x, z);
    double area = 0;
    for (int i = 0; i < TEST_WALLS; ++i) {
        area += lamp[i].power_w.band[0];
    }
    for (int i = 0; i < TEST_WALLS; ++i) {
        lamp[i].power_w.band[0] /= area;
    }
}
