/* A scene file becomes structs, and the scene as resolved reads back the
 * same. Nothing here is random but the bytes that the last test flips: it
 * checks for no crash, so no luck can fail it. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "base/rng.h"
#include "full_scene.h"
#include "scene_files.h"

static murk_scene_desc *must_read(const char *text,
                                  const murk_override *overrides, size_t n)
{
    murk_scene_desc *scene;
    murk_error err;
    if (scene_of(&scene, text, overrides, n, &err)) {
        printf("%s: %s\n", err.where, err.text);
        CHECK(scene != NULL); /* a good scene was refused */
        exit(check_done());
    }
    return scene;
}

static void test_surfaces_and_materials(const murk_scene_desc *scene)
{
    /* The default material and two of the scene, with values for each band. */
    CHECK(scene->n_materials == 3);
    CHECK_TEXT(scene->materials[0].name, "default");
    CHECK(scene->materials[0].diffuse.band[1] == 0.7);
    CHECK_TEXT(scene->materials[1].name, "wood");
    CHECK(scene->materials[1].ior == 0 && scene->materials[2].ior == 1.5);
    CHECK(scene->materials[2].transmit.band[1] == 0.91);
    CHECK(scene->materials[2].transmit.band[2] == 0);

    /* A mesh file with unit, axis and pose. */
    CHECK(scene->geometries == 4);
    const murk_scene_geometry *file = &scene->geometry[0];
    CHECK(file->shape == MURK_SHAPE_MESH && file->solid.unit_m == 0.01);
    CHECK(file->solid.up == 'y' && file->solid.scale == 2 &&
          file->material == 1);
    CHECK(file->solid.rotate_deg.z == 90 && file->solid.translate_m.y == 2);
    CHECK_TEXT(file->solid.mesh, "m/yard.dae");
    CHECK_TEXT(file->where, "fog.yaml:7:5: geometry.0");
    /* A box, a rectangle without material and a sphere. */
    const murk_scene_geometry *box = &scene->geometry[1];
    CHECK(box->shape == MURK_SHAPE_BOX && box->solid.box.max.z == 3);
    CHECK(box->solid.scale == 1 && box->solid.mesh == NULL &&
          box->solid.unit_m == 0);
    CHECK(scene->geometry[2].shape == MURK_SHAPE_RECT);
    CHECK(scene->geometry[2].edge2.y == 1 && scene->geometry[2].solid.up == 0);
    CHECK(scene->geometry[2].material == -1);
    CHECK(scene->geometry[3].shape == MURK_SHAPE_SPHERE);
    CHECK(scene->geometry[3].solid.radius_m == 0.5);
    CHECK(scene->geometry[3].material == 2);
}

static void test_media_and_regions(const murk_scene_desc *scene)
{
    /* Media with constant coefficients, and a medium from a grid. */
    CHECK(scene->n_media == 5);
    CHECK_TEXT(scene->media[0].name, "haze");
    CHECK_TEXT(scene->media[0].where, "fog.yaml:18:3: media.haze");
    CHECK(scene->media[0].phase[0].mean_cosine.band[1] == 0.8);
    CHECK(scene->media[0].vdb == NULL && scene->media[0].grid == NULL);
    CHECK_TEXT(scene->media[1].vdb, "smoke.vdb");
    CHECK_TEXT(scene->media[1].grid, "density");
    CHECK(scene->media[1].phase[0].mean_cosine.band[1] == -0.5);
    CHECK(scene->media[2].extinction_per_m.band[0] == 1e-3);
    CHECK(scene->media[2].phase[0].mean_cosine.band[0] == 0);

    /* A medium from one frame of a sequence of grids. */
    const murk_scene_medium *plume = &scene->media[3];
    CHECK_TEXT(plume->vdb, "plume.0012.vdb");
    CHECK_TEXT(plume->vdb_frames, "plume.%04d.vdb");
    CHECK_TEXT(plume->albedo_vdb, "plume.0012.vdb");
    CHECK_TEXT(plume->albedo_grid, "albedo");
    CHECK(plume->has_frame && plume->frame == 12 && plume->is_linear);
    CHECK(!scene->media[1].is_linear && !scene->media[1].has_frame);

    /* A medium with a vertical profile. */
    const murk_scene_medium *layer = &scene->media[4];
    CHECK(layer->profile_z_m.n == 4 && layer->profile_per_m.n == 4);
    CHECK(layer->profile_z_m.value[3] == 5);
    CHECK(layer->profile_per_m.value[0].band[1] == 0.2);
    CHECK(layer->profile_per_m.value[1].band[0] == 0.1);
    CHECK(layer->profile_per_m.value[1].band[1] == 0.3);
    CHECK_TEXT(layer->albedo_vdb, "a/ssa.vdb");
    CHECK(layer->vdb == NULL && scene->media[0].profile_z_m.n == 0);

    /* Regions of every shape. */
    CHECK(scene->n_regions == 6);
    CHECK(scene->regions[0].shape == MURK_REGION_EVERYWHERE);
    CHECK(scene->regions[0].solid.scale == 1 && scene->regions[0].medium == 0);
    CHECK(scene->regions[1].shape == MURK_REGION_GRID);
    CHECK(scene->regions[1].solid.rotate_deg.z == 30);
    CHECK(scene->regions[2].shape == MURK_REGION_BOX);
    CHECK(scene->regions[2].replaces && !scene->regions[3].replaces);
    CHECK(scene->regions[3].shape == MURK_REGION_SPHERE);
    CHECK(scene->regions[3].solid.center.x == 5 &&
          scene->regions[3].medium == 2);
    CHECK(scene->regions[3].ior == 0 && scene->regions[4].ior == 1.34);
    CHECK(scene->regions[4].shape == MURK_REGION_BELOW);
    CHECK(scene->regions[4].below_z_m == -0.5 &&
          scene->regions[4].solid.scale == 1);
    CHECK(scene->regions[5].shape == MURK_REGION_MESH);
    CHECK_TEXT(scene->regions[5].solid.mesh, "tank.obj");
    CHECK(scene->regions[5].solid.unit_m == 0.01 &&
          scene->regions[5].solid.up == 'y');
    CHECK(scene->regions[5].solid.scale == 3 && scene->regions[5].ior == 1.5);
    CHECK(scene->regions[4].solid.mesh == NULL);
}

static void test_lights(const murk_scene_desc *scene)
{
    CHECK(scene->n_lights == 5);
    const murk_scene_light *light = scene->lights;
    CHECK(light[0].type == MURK_SOURCE_SPHERE && light[0].radius_m == 0.1);
    CHECK(light[0].power_w.band[0] == 50 && light[0].power_w.band[1] == 50);
    CHECK(light[1].type == MURK_SOURCE_RECT && light[1].edge1.y == 1);
    CHECK(light[1].power_w.band[0] == 10 && light[1].power_w.band[1] == 30);
    CHECK(light[2].type == MURK_SOURCE_POINT && light[2].position.z == 1);
    CHECK(light[3].type == MURK_SOURCE_BEAM);
    CHECK(light[3].divergence_rad == MURK_PI / 2);
    CHECK(light[4].type == MURK_SOURCE_DIRECTIONAL);
    CHECK(light[4].direction.z == -1 && light[4].power_w.band[1] == 500);
}

static void test_tallies(const murk_scene_desc *scene)
{
    CHECK(scene->n_tallies == 3);
    const murk_scene_tally *tally = scene->tallies;
    CHECK_TEXT(tally[0].name, "up");
    CHECK(tally[0].type == MURK_TALLY_PLANE && tally[0].point.z == 9);
    CHECK(tally[0].normal.z == 1 && tally[0].angle_bins == 1);
    CHECK(tally[0].bins[0] == 32 && tally[0].bins[1] == 1);
    CHECK(tally[1].type == MURK_TALLY_GRID);
    CHECK(tally[1].size[0] == 60 && tally[1].size[2] == 20);
    CHECK(tally[1].box.max.y == 20);
    CHECK(tally[2].type == MURK_TALLY_SPHERE && tally[2].hemispheres);
    CHECK(tally[2].center.x == 5 && tally[2].radius_m == 0.2);
}

static void test_the_rest(const murk_scene_desc *scene)
{
    /* The file, bands, seed and domain. */
    CHECK_TEXT(scene->path, "fog.yaml");
    CHECK(strlen(scene->sha256) == 64);
    CHECK(scene->bands == 2 && scene->band_nm[1] == 532 && !scene->has_edges);
    CHECK(scene->seed == 7 && scene->has_domain && scene->domain.is_periodic);
    CHECK(scene->domain.box.max.x == 30);
    CHECK_TEXT(scene->domain_where, "fog.yaml:5:1: domain");

    /* Settings of photons. */
    CHECK(scene->photons.store == 5000 && scene->photons.emit == 0);
    CHECK(scene->photons.store_hits && scene->photons.max_stored == 1000000);
    CHECK(scene->photons.maps == MURK_SCENE_MAPS_VOLUME);

    /* Sensors and candidate sites of every kind. */
    const murk_scene_sensors *sensors = &scene->sensors;
    CHECK(sensors->given && sensors->candidates.has_grid &&
          sensors->count == 3);
    CHECK(sensors->types == 1);
    CHECK_TEXT(sensors->type[0].name, "node");
    CHECK(sensors->type[0].range_m == 12 &&
          sensors->candidates.clearance_m == 0.1);
    CHECK(sensors->candidates.grid_size[0] == 12 &&
          sensors->candidates.grid_size[2] == 9);
    CHECK(sensors->candidates.grid_max.y == 19);
    CHECK(sensors->spacing_m == 0.5);
    CHECK_TEXT(sensors->candidates.grid_where,
               "fog.yaml:60:5: sensors.candidates.grid");
    const murk_scene_candidates *settings = &sensors->candidates;
    CHECK(settings->points.given && settings->points.positions == 1 &&
          settings->points.position[0].z == 3);
    CHECK(settings->points.files == 1);
    CHECK_TEXT(settings->points.file[0], "points.csv");
    CHECK(settings->mounts == 1 && settings->mount[0].materials.n == 1 &&
          settings->mount[0].materials.index[0] == 0 &&
          settings->mount[0].offset_m == .1 &&
          settings->mount[0].spacing_m == 1 && settings->mount[0].has_band &&
          settings->mount[0].band_m[1] == 2 &&
          settings->mount[0].facing == MURK_SCENE_FACING_UP);
    CHECK(settings->avoids == 2 && settings->withins == 0);
    CHECK(settings->avoid[0].shape == MURK_REGION_MESH &&
          settings->avoid[0].solid.up == 'y' &&
          settings->avoid[0].solid.scale == 1);
    CHECK_TEXT(settings->avoid[0].solid.mesh, "crate.obj");
    CHECK(settings->avoid[1].shape == MURK_REGION_SPHERE &&
          settings->avoid[1].solid.radius_m == 2);

    /* Settings of the placement. */
    const murk_scene_placement *placement = &scene->placement;
    CHECK(placement->method == MURK_PLACE_SPOQ && placement->restarts == 20);
    CHECK(placement->by_normal);
    CHECK(placement->knowledge == MURK_SCENE_UNKNOWN);
    CHECK(placement->through == MURK_SCENE_BLOCK);
    CHECK(!placement->balanced && !placement->hold_out);
    CHECK(placement->weight_surface == 1 && placement->weight_volume == 2);
    CHECK(placement->jitter_m == 0.2 && placement->jitter_draws == 100);
    CHECK_NEAR(placement->jitter_rad, 1.5707963267948966, 1e-15);
}

static void test_defaults(void)
{
    murk_scene_desc *scene =
        must_read("{murk: 1, lights: [{type: point, position_m: [0, 0, 0], "
                  "power_w: 3}]}",
                  NULL, 0);
    CHECK(scene->bands == 1 && scene->band_nm[0] == 550 && scene->seed == 1);
    CHECK(!scene->has_domain && scene->geometries == 0 &&
          !scene->sensors.given);
    CHECK(scene->n_materials == 1);
    CHECK_TEXT(scene->materials[0].name, "default");
    CHECK(scene->materials[0].diffuse.band[0] == 0.5);
    CHECK(scene->photons.emit == 100000 && scene->photons.store == 0);
    CHECK(!scene->photons.store_hits);
    CHECK(scene->photons.max_stored == 100000000);
    CHECK_TEXT(scene->photons.where, "fog.yaml: photons");
    CHECK(scene->placement.method == MURK_PLACE_BEST);
    CHECK(scene->placement.balanced && scene->placement.hold_out);
    CHECK(scene->placement.restarts == 200);
    CHECK(scene->placement.through == MURK_SCENE_THIN);
    CHECK(scene->sensors.count == 0 && !scene->sensors.candidates.has_grid);
    murk_scene_desc_destroy(scene);
}

static void test_band_edges(void)
{
    murk_scene_desc *scene = must_read(
        "{murk: 1, band_edges_nm: [400, 500, 700], lights: [{type: point, "
        "position_m: [0, 0, 0], power_w: 3}]}",
        NULL, 0);
    CHECK(scene->bands == 2 && scene->has_edges);
    CHECK(scene->band_nm[0] == 450 && scene->band_nm[1] == 600);
    CHECK(scene->band_edge_nm[2] == 700);
    murk_scene_desc_destroy(scene);
}

/* An override may change one band of a single value that holds for all
 * bands, for lines and for bands between edges, but not of a total power,
 * which a spectrum spreads over the bands. */
static void test_one_band_by_override(void)
{
    /* Two scenes, whose bands are lines or lie between edges. */
    static const char *const bands[] = {"bands_nm: [450, 550]",
                                        "band_edges_nm: [400, 500, 700]"};
    const murk_override overrides[] = {{.text = "media.fog.albedo.1=0.25"},
                                       {.text = "media.fog.albedo.2=0.25"},
                                       {.text = "lights.0.power_w.1=3"}};
    for (size_t i = 0; i < 2; ++i) {
        char text[300];
        murk_scene_desc *scene = NULL;
        murk_error err = {0};
        snprintf(text, sizeof text,
                 "{murk: 1, %s, media: {fog: {extinction_per_m: 1, albedo: "
                 "0.5}}, lights: [{type: point, position_m: [0, 0, 0], "
                 "power_w: 3}]}",
                 bands[i]);
        /* An override of one band turns a single value into a list. */
        scene = must_read(text, overrides, 1);
        CHECK(scene->media[0].albedo.band[0] == .5);
        CHECK(scene->media[0].albedo.band[1] == .25);
        murk_scene_desc_destroy(scene);
        /* A band that the scene does not have is refused, and so is a band
         * of a total power. */
        CHECK(scene_of(&scene, text, overrides + 1, 1, &err) != MURK_OK);
        CHECK_TEXT(err.text, "item 2 of a list of 2, must be 0..1");
        err = (murk_error){0};
        CHECK(scene_of(&scene, text, overrides + 2, 1, &err) != MURK_OK);
        CHECK_TEXT(err.text, "1 is below a single value");
    }
}

/* Frames, layers and albedos from the command line. */
static void test_fillings_by_override(void)
{
    const murk_override overrides[] = {
        {.text = "media.plume.frame=13"},
        {.text = "media.layer.profile.z_m=[-1, 0, 1, 2]"},
        {.text = "media.layer.profile.extinction_per_m.2=0.7"},
        {.text = "media.layer.albedo=[0.5, 0.25]"},
        {.text = "media.thin.albedo.grid=w"},
        {.text = "media.thin.albedo.vdb=z.vdb"}};
    murk_scene_desc *scene = must_read(FULL_SCENE, overrides, 6);
    CHECK_TEXT(scene->media[3].vdb, "plume.0013.vdb");
    CHECK_TEXT(scene->media[3].albedo_vdb, "plume.0013.vdb");
    CHECK(scene->media[4].profile_z_m.value[0] == -1);
    CHECK(scene->media[4].profile_per_m.value[2].band[1] == 0.7);
    CHECK(scene->media[4].albedo_grid == NULL);
    CHECK(scene->media[4].albedo.band[1] == 0.25);
    CHECK_TEXT(scene->media[2].albedo_grid, "w");
    CHECK_TEXT(scene->media[2].albedo_vdb, "z.vdb");
    CHECK_MENTIONS(scene->light_key, "frame: 13");
    murk_scene_desc *again = must_read(scene->resolved, NULL, 0);
    CHECK_TEXT(again->resolved, scene->resolved);
    CHECK_MENTIONS(again->media[3].vdb, "/plume.0013.vdb");
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(scene);
}

/* The frame of a medium with a pattern of files: printed as `shown`, with the
 * files of the frame and of the next one (NULL: none) and the weight of the
 * latter. */
static void check_frame(const char *given, const char *shown, const char *file,
                        const char *next, double weight)
{
    char text[64], line[64];
    snprintf(text, sizeof text, "media.plume.frame=%s", given);
    snprintf(line, sizeof line, "frame: %s,", shown);
    const murk_override overrides[] = {{.text = "media.plume.vdb=s.%d.vdb"},
                                       {.text = "media.plume.albedo=0.5"},
                                       {.text = text}};
    murk_scene_desc *scene = must_read(FULL_SCENE, overrides, 3);
    const murk_scene_medium *plume = &scene->media[3];
    CHECK(plume->has_frame && plume->next_weight == weight);
    CHECK_TEXT(plume->vdb, file);
    CHECK_TEXT(plume->vdb_next ? plume->vdb_next : "none",
               next ? next : "none");
    CHECK_TEXT(plume->vdb_frames, "s.%d.vdb");
    CHECK_MENTIONS(scene->resolved, line);
    CHECK_MENTIONS(scene->light_key, line);
    murk_scene_desc_destroy(scene);
}

/* Whole numbers are printed without a point, however they are written. */
static void test_times_between_frames(void)
{
    check_frame("12", "12", "s.12.vdb", NULL, 0);
    check_frame("12.0", "12", "s.12.vdb", NULL, 0);
    check_frame("+12e0", "12", "s.12.vdb", NULL, 0);
    check_frame("1e6", "1000000", "s.1000000.vdb", NULL, 0);
    check_frame("999999999", "999999999", "s.999999999.vdb", NULL, 0);
    check_frame("0.5", "0.5", "s.0.vdb", "s.1.vdb", .5);
    check_frame("12.25", "12.25", "s.12.vdb", "s.13.vdb", .25);
    check_frame("999999998.75", "999999998.75", "s.999999998.vdb",
                "s.999999999.vdb", .75);
    /* An albedo grid in one file for all frames may have such a time. */
    const murk_override overrides[] = {
        {.text = "media.plume.frame=12.5"},
        {.text = "media.plume.albedo={grid: w, vdb: z.vdb}"}};
    murk_scene_desc *scene = must_read(FULL_SCENE, overrides, 2);
    CHECK_TEXT(scene->media[3].vdb_next, "plume.0013.vdb");
    CHECK_TEXT(scene->media[3].albedo_vdb, "z.vdb");
    murk_scene_desc_destroy(scene);
}

/* Each kind of phase function, for all bands and by band. The file of a
 * table lies in the folder of the scene, and is part of the light key. */
static void test_phases(void)
{
    /* Phase functions for all bands, and one for each band. */
    const murk_override phases[] = {
        {.text = "media.haze.phase={fournier_forand: [1.1, 3.5835]}"},
        {.text = "media.smoke.phase={two_hg: [0.9, -0.4, 0.8]}"},
        {.text = "media.thin.phase=[rayleigh, {table: t/water.csv}]"}};
    murk_scene_desc *scene = must_read(FULL_SCENE, phases, 3);
    const murk_scene_medium *m = scene->media;
    /* Kinds, values and files as given. */
    CHECK(m[0].n_phases == 1);
    CHECK(m[0].phase[0].kind == MURK_PHASE_FOURNIER_FORAND);
    CHECK(m[0].phase[0].value[0] == 1.1);
    CHECK(m[0].phase[0].value[1] == 3.5835);
    CHECK(m[1].n_phases == 1);
    CHECK(m[1].phase[0].kind == MURK_PHASE_TWO_HG);
    CHECK(m[1].phase[0].value[1] == -.4);
    CHECK(m[2].n_phases == 2);
    CHECK(m[2].phase[0].kind == MURK_PHASE_RAYLEIGH);
    CHECK(m[2].phase[0].table == NULL);
    CHECK(m[2].phase[1].kind == MURK_PHASE_TABLE);
    CHECK_TEXT(m[2].phase[1].table, "t/water.csv");
    /* The light key names the file without folders; the resolved scene
     * reads back the same, with the full path. */
    CHECK_MENTIONS(scene->light_key, "[rayleigh, {table: water.csv}]");
    murk_scene_desc *again = must_read(scene->resolved, NULL, 0);
    CHECK_TEXT(again->resolved, scene->resolved);
    CHECK_TEXT(again->light_key, scene->light_key);
    CHECK_MENTIONS(again->media[2].phase[1].table, "/t/water.csv");
    CHECK(again->media[2].phase[1].table[0] == '/');
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(scene);
}

/* 1.2 m in steps of 0.4: four points, though 1.2 / 0.4 rounds below 3. */
static void test_spacing_fills_the_grid(void)
{
    const murk_override spacing = {
        .text = "sensors.candidates.grid={min_m: [0, 0, 1], max_m: "
                "[1.2, 1.5, 1], spacing_m: 0.4}"};
    murk_scene_desc *scene = must_read(FULL_SCENE, &spacing, 1);
    CHECK(scene->sensors.candidates.grid_size[0] == 4);
    CHECK(scene->sensors.candidates.grid_size[1] == 4);
    CHECK(scene->sensors.candidates.grid_size[2] == 1);
    CHECK_NEAR(scene->sensors.candidates.grid_max.y, 1.2, 1e-12);
    CHECK(scene->sensors.candidates.grid_max.z == 1);
    murk_scene_desc_destroy(scene);
}

static void test_resolved_reads_back(const char *text)
{
    murk_scene_desc *scene = must_read(text, NULL, 0);
    murk_scene_desc *again = must_read(scene->resolved, NULL, 0);
    CHECK_TEXT(again->resolved, scene->resolved);
    CHECK_TEXT(again->light_key, scene->light_key);
    CHECK(again->n_lights == scene->n_lights);
    for (size_t i = 0; i < scene->n_lights; ++i) {
        CHECK(memcmp(&again->lights[i].power_w, &scene->lights[i].power_w,
                     sizeof(murk_spectrum)) == 0);
    }
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(scene);
}

static void test_resolved_names_files_fully(void)
{
    char want[600];
    murk_scene_desc *scene = must_read(FULL_SCENE, NULL, 0);
    char here[400];
    CHECK(getcwd(here, sizeof here) != NULL);
    snprintf(want, sizeof want, "vdb: %s/smoke.vdb", here);
    CHECK_MENTIONS(scene->resolved, want);
    murk_scene_desc_destroy(scene);
}

/* A file of --set lies in the working folder, one of the scene beside it. */
static void test_paths(void)
{
    murk_scene_desc *scene = NULL;
    murk_error err = {0};
    const murk_override option = {.text = "media.smoke.vdb=other.vdb"};
    char path[400];
    snprintf(path, sizeof path, "%s/fog.yaml", folder_path);
    write_text("fog.yaml", FULL_SCENE);
    CHECK(murk_scene_desc_read(&scene, path, &option, 1, &err) == MURK_OK);
    if (scene) {
        CHECK_TEXT(scene->media[1].vdb, "other.vdb");
        CHECK_MENTIONS(scene->geometry[0].solid.mesh, "/m/yard.dae");
        CHECK(scene->geometry[0].solid.mesh[0] == '/');
    }
    murk_scene_desc_destroy(scene);
}

/* ---- what the light depends on ---- */

static bool has_same_light(const char *option)
{
    const murk_override override = {.text = option};
    murk_scene_desc *plain = must_read(FULL_SCENE, NULL, 0);
    murk_scene_desc *changed = must_read(FULL_SCENE, &override, 1);
    const bool is_same = strcmp(plain->light_key, changed->light_key) == 0;
    murk_scene_desc_destroy(plain);
    murk_scene_desc_destroy(changed);
    return is_same;
}

static void test_light_key(void)
{
    /* Changes of sensors and placement, and the same values in another
     * spelling. */
    static const char *const sensors[] = {"sensors.count=5",
                                          "sensors.types.0.range_m=3",
                                          "placement.method=best",
                                          "placement.restarts=7",
                                          "sensors.candidates.clearance_m=1",
                                          "photons.store=5e3",
                                          "materials.wood.diffuse=3.5e-1",
                                          "media.haze.albedo=[.99, .99]"};
    /* Changes of the scene that change the light. */
    static const char *const light[] = {"seed=8",
                                        "lights.0.power_w=101",
                                        "materials.wood.diffuse=0.3",
                                        "media.haze.albedo=0.98",
                                        "regions.1.translate_m=[10, 8, 1]",
                                        "photons.store=5001",
                                        "domain.sides=open",
                                        "bands_nm=[450, 533]",
                                        "geometry.1.material=glass",
                                        "photons.maps=both",
                                        "media.smoke.vdb=other.vdb"};
    /* Only changes of the light change the key. */
    for (size_t i = 0; i < sizeof sensors / sizeof *sensors; ++i) {
        CHECK(has_same_light(sensors[i]));
    }
    for (size_t i = 0; i < sizeof light / sizeof *light; ++i) {
        CHECK(!has_same_light(light[i]));
    }
}

/* A scene that moves with its files keeps its light. */
static void test_light_key_knows_no_folders(void)
{
    CHECK(has_same_light("media.smoke.vdb=elsewhere/smoke.vdb"));
    murk_scene_desc *scene = must_read(FULL_SCENE, NULL, 0);
    CHECK_MENTIONS(scene->light_key, "{vdb: smoke.vdb, ");
    CHECK_MENTIONS(scene->light_key, "{file: yard.dae, ");
    CHECK_MENTIONS(scene->light_key, "mesh: tank.obj, ");
    murk_scene_desc_destroy(scene);
}

/* ---- hostile bytes ---- */

/* Neither a cut nor a changed byte may crash or leave a message out. */
static void read_any(const char *bytes, size_t size)
{
    murk_scene_desc *scene = NULL;
    murk_error err = {0};
    write_bytes("fog.yaml", bytes, size);
    const murk_status status =
        murk_scene_desc_read(&scene, "fog.yaml", NULL, 0, &err);
    CHECK((status == MURK_OK) == (scene != NULL));
    CHECK((status == MURK_OK) == (err.text[0] == '\0'));
    CHECK(strchr(err.text, '\n') == NULL && strchr(err.where, '\n') == NULL);
    murk_scene_desc_destroy(scene);
}

static void test_broken_bytes(void)
{
    char bytes[sizeof FULL_SCENE];
    const size_t size = sizeof FULL_SCENE - 1;
    for (size_t cut = 0; cut < size; cut += 7) {
        read_any(FULL_SCENE, cut);
    }
    for (uint64_t i = 0; i < 1500; ++i) {
        const murk_random4 u = murk_random(1, MURK_EMIT, i, 0, 0);
        memcpy(bytes, FULL_SCENE, size);
        bytes[(size_t)(u.u[0] * (double)size)] =
            (char)(int)(256 * u.u[1] - 128);
        if (u.u[2] < 0.5) { /* two at a time reach further */
            bytes[(size_t)(u.u[3] * (double)size)] = "[]{}:,-&*!\n 0"[i % 13];
        }
        read_any(bytes, size);
    }
}

int main(void)
{
    /* One scene with all keys is read once for the tests of each part. */
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    murk_scene_desc *scene = must_read(FULL_SCENE, NULL, 0);
    test_surfaces_and_materials(scene);
    test_media_and_regions(scene);
    test_lights(scene);
    test_tallies(scene);
    test_the_rest(scene);
    murk_scene_desc_destroy(scene);
    /* Defaults, overrides and phase functions. */
    test_defaults();
    test_band_edges();
    test_fillings_by_override();
    test_times_between_frames();
    test_one_band_by_override();
    test_phases();
    test_spacing_fills_the_grid();
    /* The resolved scene, paths and the light key. */
    test_resolved_reads_back(FULL_SCENE);
    test_resolved_reads_back("{murk: 1, band_edges_nm: [1, 2, 3, 5.5], lights: "
                             "[{type: point, position_m: [0, 0, 0], "
                             "power_w: 10}]}");
    test_resolved_names_files_fully();
    test_paths();
    test_light_key();
    test_light_key_knows_no_folders();
    /* Broken files. */
    test_broken_bytes();
    folder_leave((const char *const[]){"fog.yaml", NULL});
    return check_done();
}
