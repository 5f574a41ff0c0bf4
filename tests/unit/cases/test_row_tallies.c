/* What a row of a study measures: where its densities and tallies lie, what
 * they are called and in which unit, and what is said of regions that cannot
 * be measured. Light is a lamp in empty space, whose fluence rate is known;
 * seeds are fixed. */
#include "cases/row_tallies.h"

#include "base/log.h"
#include "check.h"
#include "stage_text.h"

#include <stdlib.h>

static const char text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 3, 2]}\n"
    "bands_nm: [500, 600]\n"
    "lights: [{type: point, position_m: [2, 1.5, 1], power_w: [3, 1]}]\n"
    "photons: {emit: 4000}\n"
    "seed: 5\n"
    "tallies:\n"
    "  - {name: level, type: plane, point_m: [2, 1, 0.5], normal: [0, 0, 2],"
    " bins: [4, 3], angle_bins: 2}\n"
    "  - {name: cells, type: grid, min_m: [0, 0, 0], max_m: [4, 3, 2],"
    " size: [4, 3, 2]}\n"
    "  - {name: round, type: sphere, center_m: [3, 1.5, 1], radius_m: 0.5,"
    " hemispheres: true}\n"
    "sensors: {types: [{name: node, range_m: 2}], candidates: {}, count: 1}\n"
    "placement:\n"
    "  interest:\n"
    "    - {name: east, box: {min_m: [3, -1, 0.5], max_m: [9, 2, 7]}}\n"
    "    - {name: away, box: {min_m: [4, 0, 0], max_m: [5, 1, 1]}}\n"
    "    - {name: ball, sphere: {center_m: [1, 1, 1], radius_m: 0.5}}\n"
    "    - {name: low, sphere: {center_m: [1, 1, 0.4], radius_m: 0.5}}\n"
    "    - {name: high, sphere: {center_m: [1, 1, 1.6], radius_m: 0.5}}\n";

static char *words[] = {"density", "level", "round", "cells", "fluence_vdb"};

static murk_study_file study_of(size_t outputs)
{
    return (murk_study_file){.output = words,
                             .outputs = outputs,
                             .outputs_where = "study",
                             .fluence_size = {5, 0, 2}};
}

static murk_outputs outputs_of(const murk_study_file *study)
{
    murk_outputs out = {.study = study};
    for (size_t i = 0; i < study->outputs; ++i) {
        out.wants[murk_output_of(study->output[i])] = true;
    }
    return out;
}

static void test_where_they_lie(void)
{
    murk_stage *stage = stage_text_create(text, NULL);
    const murk_study_file study = study_of(5);
    const murk_outputs outputs = outputs_of(&study);
    murk_row_tallies g = {0};
    murk_error err = {0};
    if (!stage ||
        murk_row_tallies_create(&g, stage, &outputs, &err) != MURK_OK) {
        CHECK(false);
        return;
    }
    static const char *const name[] = {
        "density", "density_east", "density_ball", "level", "round", "cells",
        ""};
    CHECK(g.n == 7 && g.fluence == 6);
    for (size_t i = 0; i < 7 && i < g.n; ++i) {
        char number[16];
        snprintf(number, sizeof number, "study-%zu", i);
        CHECK_TEXT(g.row_tally[i].name, name[i]);
        CHECK_TEXT(g.desc[i].name, number);
        CHECK(g.row_tally[i].is_density == (i < 3));
        CHECK(i > 2 || g.row_tally[i].part.number == i);
    }
    /* of a box, what lies in the domain */
    const murk_box *east = &g.desc[1].box;
    CHECK(east->min.x == 3 && east->min.y == 0 && east->min.z == .5);
    CHECK(east->max.x == 4 && east->max.y == 2 && east->max.z == 2);
    const murk_part *ball = &g.row_tally[2].part;
    CHECK(ball->is_ball && ball->radius_m == .5 && ball->center.x == 1);
    CHECK(ball->box.min.y == .5 && ball->box.max.z == 1.5);
    CHECK_TEXT(g.note, "density_away lies outside the domain; "
                       "density_low reaches out of the domain and is not "
                       "measured; density_high reaches out of the domain and "
                       "is not measured");
    /* tallies as one number each: a plane of 4 x 3 m, forward and backward */
    CHECK_NEAR(g.row_tally[3].per_unit, 1. / 12, 1e-15);
    CHECK(g.row_tally[4].per_unit == 1);
    CHECK(murk_tally_cells(&g.desc[3]) == 2 &&
          murk_tally_cells(&g.desc[4]) == 2);
    CHECK(murk_tally_cells(&g.desc[5]) == 1);
    /* the grid: as asked for along x and z; murk's choice along y. Cubes of
     * 24 / 32768 m3 would be 3 / .09 = 33 along y. */
    CHECK(g.desc[6].size[0] == 5 && g.desc[6].size[2] == 2);
    CHECK(g.desc[6].size[1] == 33);
    murk_row_tallies_release(&g);
    stage_text_destroy(stage);
}

/* The value of that name, and its unit. */
static double value_of(const murk_study_row *row, const char *name,
                       const char *unit)
{
    const murk_study_value *v = murk_study_row_get(row, name);
    CHECK(v != NULL);
    if (!v) {
        printf("no %s\n", name);
        return NAN;
    }
    CHECK_TEXT(v->unit, unit);
    return v->of.value;
}

/* In the dark all is 0; densities are photons, other values as the scene says,
 * and all as the study says where it does. A single band is not told apart. */
static void test_names_and_units_in_the_dark(void)
{
    static const char *const one[] = {"bands_nm=[500]", "lights.0.power_w=1",
                                      NULL};
    for (int bands = 1; bands < 3; ++bands) {
        murk_stage *stage = stage_text_create(text, bands == 1 ? one : NULL);
        murk_study_file study = study_of(5);
        const murk_outputs outputs = outputs_of(&study);
        murk_row_tallies g = {0};
        murk_study_row row = {0};
        murk_error err = {0};
        if (!stage ||
            murk_row_tallies_create(&g, stage, &outputs, &err) != MURK_OK) {
            CHECK(false);
            return;
        }
        CHECK(murk_row_tallies_read(&row, &g, stage, &(murk_row_light){0}, 1,
                                    &err) == MURK_OK);
        CHECK(value_of(&row, "density", "1/s/m2") == 0);
        CHECK(value_of(&row, "level_forward", "W/m2") == 0);
        CHECK(value_of(&row, "level_backward", "W/m2") == 0);
        CHECK(value_of(&row, "round_up", "W/m2") == 0);
        CHECK(value_of(&row, "round_down", "W/m2") == 0);
        CHECK(value_of(&row, "cells", "W/m2") == 0);
        /* three densities, two of level, two of round, one of cells */
        CHECK(row.values == (bands == 1 ? 8 : 24));
        if (bands == 2) {
            CHECK(value_of(&row, "level_backward_600nm", "W/m2") == 0);
        }
        murk_study_row_release(&row);
        study.has_units = true;
        study.units = MURK_PHOTOMETRIC;
        CHECK(murk_row_tallies_read(&row, &g, stage, &(murk_row_light){0}, 1,
                                    &err) == MURK_OK);
        CHECK(value_of(&row, "density_ball", "lux") == 0);
        CHECK(value_of(&row, "cells", "lux") == 0);
        murk_study_row_release(&row);
        murk_row_tallies_release(&g);
        stage_text_destroy(stage);
    }
}

/* Light of the stage, traced with the gauges as its tallies, and what they read
 * of it into the row; NULL where tracing failed. */
static murk_traced *traced_row(murk_study_row *row, murk_row_tallies *g,
                               const murk_stage *stage)
{
    murk_traced *traced = NULL;
    murk_error err = {0};
    murk_scene_desc scene = *stage->scene;
    murk_stage lit = *stage;
    scene.n_tallies = g->n;
    lit.scene = &scene;
    lit.tally = g->desc;
    CHECK(murk_lightmap_trace(&traced, &lit, 0, 2, &err) == MURK_OK);
    if (traced) {
        const murk_row_light light = {traced->tallies, traced->ledger->emitted,
                                      traced->packet_w};
        CHECK(murk_row_tallies_read(row, g, stage, &light, 2, &err) == MURK_OK);
    }
    return traced;
}

/* A lamp of 3 and 1 W in the middle of empty space. Light that passes a
 * level plane 0.5 m below the lamp goes down, through -z, which is backward
 * as the normal of the plane points up. The mean fluence rate of the domain
 * is that of a grid of one cell over the domain, and three quarters are in
 * the first band. The share of the power that goes through the rectangle of
 * 4 x 3 m at distance d = .5 is the solid angle over 4 pi: 4 atan(2 * 1.5 /
 * (.5 sqrt(4 + 2.25 + .25))) / (4 pi) = .372; 4000 photons know it to .008,
 * of which 5 are allowed. */
static void test_values(void)
{
    /* Trace a row of the study with four outputs. */
    static const char *const watts[] = {"placement.interest=[]", NULL};
    murk_stage *stage = stage_text_create(text, watts);
    murk_study_file study = study_of(4);
    const murk_outputs outputs = outputs_of(&study);
    murk_row_tallies g = {0};
    murk_study_row row = {0};
    murk_error err = {0};
    study.has_units = true;
    study.units = MURK_RADIOMETRIC;
    if (!stage ||
        murk_row_tallies_create(&g, stage, &outputs, &err) != MURK_OK) {
        CHECK(false);
        return;
    }
    murk_traced *traced = traced_row(&row, &g, stage);
    if (traced) {
        /* The mean fluence rate is the sum over bands, and equals that of a
         * grid of one cell. */
        const double all = value_of(&row, "density", "W/m2"),
                     green = value_of(&row, "density_500nm", "W/m2"),
                     red = value_of(&row, "density_600nm", "W/m2");
        CHECK(all > 0);
        CHECK_NEAR(green + red, all, 1e-9 * all);
        CHECK_NEAR(green / all, .75, .02);
        CHECK_NEAR(value_of(&row, "cells", "W/m2"), all, 1e-9 * all);
        /* The light through the level rectangle goes backward, by the solid
         * angle. */
        const double share =
            atan(2 * 1.5 / (.5 * sqrt(4 + 2.25 + .25))) / MURK_PI;
        CHECK_NEAR(value_of(&row, "level_backward", "W/m2") * 12 / 4, share,
                   5 * .008);
        CHECK(value_of(&row, "level_forward", "W/m2") == 0);
        CHECK(value_of(&row, "round_up", "W/m2") > 0);
    }
    murk_traced_destroy(traced);
    murk_study_row_release(&row);
    murk_row_tallies_release(&g);
    stage_text_destroy(stage);
}

/* Half of the place is a crate: light crosses the free half alone, so the
 * density there is twice the mean over the place. */
static void test_densities_are_of_free_space(void)
{
    static const char crate[] =
        "murk: 1\n"
        "domain: {min_m: [0, 0, 0], max_m: [4, 3, 2]}\n"
        "geometry: [{box: {min_m: [0.001, 0.001, 0.001],"
        " max_m: [2, 2.999, 1.999]}, material: wall}]\n"
        "materials: {wall: {diffuse: 0}}\n"
        "lights: [{type: point, position_m: [3, 1.5, 1], power_w: 2}]\n"
        "photons: {emit: 1000}\n"
        "tallies: [{name: cells, type: grid, min_m: [0, 0, 0],"
        " max_m: [4, 3, 2], size: [1, 1, 1]}]\n";
    char *both[] = {"density", "cells"};
    murk_study_file study = {.output = both,
                             .outputs = 2,
                             .outputs_where = "study",
                             .has_units = true};
    const murk_outputs outputs = outputs_of(&study);
    murk_stage *stage = stage_text_create(crate, NULL);
    murk_row_tallies g = {0};
    murk_study_row row = {0};
    murk_error err = {0};
    if (!stage ||
        murk_row_tallies_create(&g, stage, &outputs, &err) != MURK_OK) {
        CHECK(false);
        return;
    }
    murk_traced *traced = traced_row(&row, &g, stage);
    if (traced) {
        const double mean = value_of(&row, "cells", "W/m2");
        CHECK(mean > 0);
        CHECK_NEAR(value_of(&row, "density", "W/m2") / mean, 2, .02);
        /* its error: that of light, and of the share, .5 / sqrt(24^3) of .5 */
        const murk_estimate light = murk_study_row_get(&row, "cells")->of,
                            density = murk_study_row_get(&row, "density")->of;
        CHECK_NEAR(density.standard_error / density.value,
                   hypot(light.standard_error / light.value, 1 / sqrt(13824)),
                   1e-5);
    }
    murk_traced_destroy(traced);
    murk_study_row_release(&row);
    murk_row_tallies_release(&g);
    stage_text_destroy(stage);
}

static char *sign_of(const murk_scene_desc *scene, const murk_outputs *outputs)
{
    char *sign = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&sign, &size);
    murk_row_tallies_sign(out, scene, outputs);
    fclose(out);
    return sign;
}

/* Every change of a tally or of a region of interest changes the sign. */
static void test_signs(void)
{
    /* The seed, which is no part of the tallies, and all keys that the
     * outputs depend on. */
    static const char *const change[] = {
        "seed=5",
        "tallies.0.point_m=[2, 1, 0.6]",
        "tallies.0.normal=[0, 0.1, 2]",
        "tallies.1.min_m=[0, 0, 0.1]",
        "tallies.1.max_m=[4, 2.9, 2]",
        "tallies.2.center_m=[3, 1.4, 1]",
        "tallies.2.radius_m=0.4",
        "tallies.2.hemispheres=false",
        "tallies.0.name=flat",
        "placement.interest.0.box.min_m=[2.9, -1, 0.5]",
        "placement.interest.0.box.max_m=[9, 2.1, 7]",
        "placement.interest.0.name=west",
        "placement.interest.2.sphere.center_m=[1, 1, 1.1]",
        "placement.interest.2.sphere.radius_m=0.45",
    };
    /* The sign with five outputs and no change. */
    const murk_study_file study = study_of(5), fewer = study_of(4);
    const murk_outputs outputs = outputs_of(&study), less = outputs_of(&fewer);
    murk_scene_desc *scene = scene_text_create(text, NULL);
    char *sign = scene ? sign_of(scene, &outputs) : NULL;
    /* Each change but the seed gives another sign. */
    for (size_t i = 0; sign && i < sizeof change / sizeof *change; ++i) {
        const char *const overrides[] = {change[i], NULL};
        murk_scene_desc *turned = scene_text_create(text, overrides);
        char *other = turned ? sign_of(turned, &outputs) : NULL;
        if (other && (strcmp(sign, other) == 0) != (i == 0)) {
            printf("sign of %s\n", change[i]);
        }
        CHECK(other && (strcmp(sign, other) == 0) == (i == 0));
        free(other);
        murk_scene_desc_destroy(turned);
    }
    /* Fewer outputs give another sign. */
    char *other = scene ? sign_of(scene, &less) : NULL;
    CHECK(sign && other && strcmp(sign, other) != 0);
    free(other);
    free(sign);
    murk_scene_desc_destroy(scene);
}

int main(void)
{
    murk_warn_to(NULL);
    test_where_they_lie();
    test_names_and_units_in_the_dark();
    test_values();
    test_densities_are_of_free_space();
    test_signs();
    return check_done();
}
