/* Phase functions of a scene: the kinds and bands reach the media, tables are
 * read from CSV and belong to the light's key, and bad ones are refused at
 * their line. Deterministic. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "../scene/scene_files.h"
#include "world/stage_build.h"

#define SCENE(phase)                                                     \
    "murk: 1\nbands_nm: [450, 532]\n"                                    \
    "domain: {min_m: [0, 0, 0], max_m: [1, 1, 1]}\n"                     \
    "media: {sea: {extinction_per_m: 1, albedo: 1, phase: " phase "}}\n" \
    "regions: [{medium: sea}]\n"                                         \
    "lights: [{type: point, position_m: [.5, .5, .5], power_w: 1}]\n"

#define GOOD "# made up\nangle_deg,extra,phase_per_sr\n0,x,3\n90,y,1\n180,z,2\n"

static murk_status stage_of(murk_scene_desc **scene, murk_stage **stage,
                            const char *text, murk_error *err)
{
    *stage = NULL;
    murk_status status = scene_of(scene, text, NULL, 0, err);
    if (!status) {
        status = murk_stage_create(stage, *scene, err);
    }
    return status;
}

/* Equal tables are made once, however many bands and media have them. */
static void test_tables_are_shared(void)
{
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_error err;
    write_text("p.csv", GOOD);
    CHECK(stage_of(&scene, &stage, SCENE("[{table: p.csv}, {table: p.csv}]"),
                   &err) == MURK_OK);
    CHECK(stage && stage->phases->n == 1);
    CHECK(stage && stage->phases->medium[0][0].table ==
                       stage->phases->medium[0][1].table);
    murk_stage_destroy(stage);
    murk_scene_desc_destroy(scene);
}

/* What differs in one number alone is another table. */
static void test_other_tables_are_not_shared(void)
{
    static const struct {
        const char *text;
        size_t n;
    } cases[] = {
        {SCENE("[{fournier_forand: [1.1, 3.5]}, {fournier_forand: [1.1, "
               "3.5]}]"),
         1},
        {SCENE("[{fournier_forand: [1.1, 3.5]}, {fournier_forand: [1.2, "
               "3.5]}]"),
         2},
        {SCENE("[{fournier_forand: [1.1, 3.5]}, {fournier_forand: [1.1, "
               "3.6]}]"),
         2}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        murk_scene_desc *scene;
        murk_stage *stage;
        murk_error err;
        CHECK(stage_of(&scene, &stage, cases[i].text, &err) == MURK_OK);
        CHECK(stage && stage->phases->n == cases[i].n);
        murk_stage_destroy(stage);
        murk_scene_desc_destroy(scene);
    }
}

/* Each kind of phase function in one band or the other equals the function
 * that medium/phase.h makes. */
static void test_kinds_and_bands(void)
{
    /* Phase functions for both bands or for each band, and the expected
     * functions. */
    static const struct {
        const char *text;
        murk_phase want[2];
        const char *kind[2];
    } cases[] = {
        {SCENE("isotropic"), {{0}, {0}}, {"isotropic", "isotropic"}},
        {SCENE("[rayleigh, {hg: .8}]"),
         {{.kind = MURK_PHASE_RAYLEIGH}, {.value = {.8}}},
         {"rayleigh", "hg"}},
        {SCENE("{hg: [0, -.5]}"), {{0}, {.value = {-.5}}}, {"isotropic", "hg"}},
        {SCENE("{two_hg: [.9, -.4, .8]}"),
         {{.kind = MURK_PHASE_TWO_HG, .value = {.9, -.4, .8}},
          {.kind = MURK_PHASE_TWO_HG, .value = {.9, -.4, .8}}},
         {"two_hg", "two_hg"}},
        {SCENE("[{two_hg: [.9, -.4, .8]}, isotropic]"),
         {{.kind = MURK_PHASE_TWO_HG, .value = {.9, -.4, .8}}, {0}},
         {"two_hg", "isotropic"}}};
    /* Make the stage of each scene. */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        murk_scene_desc *scene;
        murk_stage *stage;
        murk_error err;
        CHECK(stage_of(&scene, &stage, cases[i].text, &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
        /* Kind and density of the phase function of each band. */
        for (int band = 0; stage && band < 2; ++band) {
            const murk_phase *want = &cases[i].want[band];
            const murk_phase *got = &stage->phases->medium[0][band];
            CHECK(got->kind == want->kind && got->table == NULL);
            for (double mu = -1; mu <= 1; mu += .25) {
                CHECK(murk_phase_density(got, mu) ==
                      murk_phase_density(want, mu));
            }
            CHECK_TEXT(murk_phases_kind(&scene->media[0], band),
                       cases[i].kind[band]);
        }
        murk_stage_destroy(stage);
        murk_scene_desc_destroy(scene);
    }
}

static void test_tables(void)
{
    /* A table in the first band, and Fournier-Forand in the second. */
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_error err;
    write_text("p.csv", GOOD);
    CHECK(stage_of(&scene, &stage,
                   SCENE("[{table: p.csv}, {fournier_forand: [1.1, 3.58]}]"),
                   &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    /* Densities follow the table, and the light key holds name and checksum
     * of the file. */
    if (stage) {
        const murk_phase *phase = stage->phases->medium[0];
        CHECK(stage->phases->n == 2);
        CHECK_TEXT(murk_phases_kind(&scene->media[0], 0), "table");
        CHECK_TEXT(murk_phases_kind(&scene->media[0], 1), "fournier_forand");
        CHECK_NEAR(murk_phase_density(&phase[0], 1) /
                       murk_phase_density(&phase[0], 0),
                   3, 1e-12);
        CHECK_NEAR(murk_phase_table_facts(phase[1].table)->integral, 1, 1e-4);
        CHECK_MENTIONS(stage->light_key, "{table: p.csv}");
        CHECK_MENTIONS(stage->light_key, "checksum: ");
    }
    /* Another content of the file gives another light key. */
    char before[4000] = "";
    snprintf(before, sizeof before, "%s", stage ? stage->light_key : "");
    murk_stage_destroy(stage);
    write_text("p.csv", GOOD "# another\n");
    stage = NULL;
    CHECK(scene && murk_stage_create(&stage, scene, &err) == MURK_OK);
    CHECK(stage && strcmp(stage->light_key, before) != 0);
    murk_stage_destroy(stage);
    murk_scene_desc_destroy(scene);
}

static void refused(const char *csv, const char *where, const char *text)
{
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_error err;
    write_text("p.csv", csv);
    CHECK(stage_of(&scene, &stage, SCENE("{table: p.csv}"), &err) != MURK_OK);
    CHECK(stage == NULL);
    CHECK_TEXT(err.where, where);
    CHECK_TEXT(err.text, text);
    murk_scene_desc_destroy(scene);
}

#define HEAD "angle_deg,phase_per_sr\n"

static void test_bad_tables(void)
{
    /* Missing columns, and too few rows. */
    refused("", "p.csv", "empty, must begin with a row of column names");
    refused("angle,phase_per_sr\n0,1\n", "p.csv",
            "misses column angle_deg, must have angle_deg and phase_per_sr");
    refused("angle_deg,phase\n0,1\n", "p.csv",
            "misses column phase_per_sr, must have angle_deg and "
            "phase_per_sr");
    refused(HEAD, "p.csv", "0 rows, must be 2..1000000");
    refused(HEAD "0,1\n", "p.csv", "1 rows, must be 2..1000000");
    /* Angles out of order, and cells that are empty, no numbers or out of
     * limits. */
    refused(HEAD "0,1\n20,1\n\n10,1\n180,1\n", "p.csv:5: angle_deg",
            "10, must be more than the 20 degrees before");
    refused(HEAD "0,1\n,1\n180,1\n", "p.csv:3: angle_deg",
            "an empty cell, must be a number");
    refused(HEAD "0,1\n20,nan\n180,1\n", "p.csv:3: phase_per_sr",
            "nan, must be a number");
    refused(HEAD "0,1\n20,-1\n180,1\n", "p.csv:3: phase_per_sr",
            "-1, must be 0 or 1e-30..1e+30 per sr");
    refused(HEAD "0,1\n20\n180,1\n", "p.csv:3",
            "1 cells, must be 2: one for each column of the header");
    /* Angles that end too early, and a table without light. */
    refused(HEAD "0,1\n20,1\n140,1\n", "p.csv:4: angle_deg",
            "ends at 140, must be 150..180 degrees");
    refused(HEAD "0,0\n20,0\n180,0\n", "p.csv",
            "no light anywhere, the integral over the sphere must be more "
            "than 0");
    /* A missing file is reported with its key in the scene. */
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_error err;
    CHECK(stage_of(&scene, &stage, SCENE("[rayleigh, {table: none.csv}]"),
                   &err) != MURK_OK);
    CHECK_TEXT(err.where, "fog.yaml:4:65: media.sea.phase.1");
    CHECK_MENTIONS(err.text, "none.csv: ");
    murk_scene_desc_destroy(scene);
}

int main(void)
{
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    test_kinds_and_bands();
    test_tables();
    test_tables_are_shared();
    test_other_tables_are_not_shared();
    test_bad_tables();
    folder_leave((const char *const[]){"fog.yaml", "p.csv", NULL});
    return check_done();
}
