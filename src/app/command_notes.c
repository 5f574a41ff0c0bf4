/* Files, formats and examples of each command, which the man pages and --help
 * show beside the options. */
#include "app/command_notes.h"

#include <stddef.h>
#include <string.h>

#define LIGHT_FILES                                                        \
    {"light.murk", "both photon maps, for --light: murk-light(5)"},        \
        {"scene.resolved.yaml", "the scene as resolved, options applied"}, \
        {"ledger.json", "where the energy went; balances to the quantum"}, \
        {"tallies.csv", "what the scene's tallies measured"},              \
    {                                                                      \
        "NAME.vdb, NAME_error.vdb", "a grid tally and its standard error"  \
    }

#define FIELD_FILES                                                    \
    {"coverage.vdb, optical_depth.vdb, extinction.vdb, *_photons.vdb", \
     "--export fields; fields.vti holds the same for ParaView"},       \
        {"photons.ply, photons.vtp", "--export photons"},              \
    {                                                                  \
        "surfaces.ply, surfaces.vtp", "--export surfaces"              \
    }

static const murk_command_notes all[] = {
    {.command = "check",
     .formats = "murk-scene",
     .example = {{"murk check scenes/smoke-hall.yaml",
                  "What is in the hall, and what a run will take."},
                 {"murk check scenes/day-night.yaml --set site.clock=23:00",
                  "Where sun and moon stand at eleven in the evening."}}},
    {.command = "trace",
     .formats = "murk-scene murk-light murk-results",
     .file = {LIGHT_FILES, FIELD_FILES},
     .example = {{"murk trace scenes/slab.yaml",
                  "A slab of fog beside published figures: its reflectance and "
                  "transmittance as tallies."},
                 {"murk trace scenes/smoke-hall.yaml --emit 1e5 -o out",
                  "Light to keep, for place, sense and render --light "
                  "out/light.murk."}}},
    {.command = "place",
     .formats = "murk-scene murk-results murk-light murk-matrix",
     .file = {{"plan.json", "the plan, its coverage, bound and curve"},
              {"sensors.csv", "a row a sensor; input of murk sense"},
              {"coverage.csv", "a row a sensor: what it covers"},
              {"plan.ply", "sensors and photons, with who sees them"},
              {"explore.csv, path.ply", "with knowledge: explore"},
              {"repeat.csv", "with --repeat: a row a seed"},
              {"regret.csv", "over conditions: each plan in each"},
              {"light-NAME.murk, ledger-NAME.json, scene-NAME.yaml, "
               "plan-NAME.ply",
               "over conditions: of each"},
              {"matrix.csv, candidates.csv", "--export matrix"},
              {"matrix.txt", "--export or-library"},
              {"problem.lp", "--export lp"},
              LIGHT_FILES,
              FIELD_FILES},
     .example = {{"murk place scenes/smoke-hall.yaml -o out --export matrix",
                  "Five sensors in a hall with a fire, and the coverage matrix "
                  "that they were chosen from."},
                 {"murk place scenes/paper-room.yaml --target 0.9",
                  "The fewest sensors that cover 90 %."},
                 {"murk place scenes/smoke-hall.yaml --set "
                  "placement.over=worst --count 4 -o out",
                  "One plan for the worst of clear air, fog and smoke."},
                 {"murk place --matrix out/matrix.csv --count 5",
                  "The same by the matrix alone."}}},
    {.command = "sense",
     .formats = "murk-scene murk-results",
     .file = {{"coverage.json", "coverage with its error, sensor by sensor"},
              {"coverage.csv", "a row a sensor"},
              {"coverage.ply", "sensors and photons, with who sees them"},
              LIGHT_FILES,
              FIELD_FILES},
     .example = {{"murk sense scenes/smoke-hall.yaml --sensors out/sensors.csv",
                  "A plan again, in other light with --seed 2, or in other "
                  "air with --set."}}},
    {.command = "render",
     .formats = "murk-scene murk-results",
     .file = {{"IMAGE.exr", "radiance by band, errors, parts and depth"},
              {"IMAGE.png", "--png: for the eye"},
              {"IMAGE-CHANNEL.png", "--false-colour, with a legend"}},
     .example = {{"murk render scenes/smoke-hall.yaml --set "
                  "'cameras=[{name: door, from_m: [28, 2, 2.5], to_m: [15, 9, "
                  "3]}]' -o hall.exr",
                  "The hall from its gate."}}},
    {.command = "study",
     .formats = "murk-study murk-scene murk-results",
     .file = {{"study.json", "rows, plans, units, notes"},
              {"table.csv", "a row a run"},
              {"scene.resolved.yaml", "the base scene as resolved"},
              {"fluence_0001.vdb", "of the output fluence_vdb, by row"},
              {"rows/", "finished rows, to go on from"}},
     .example = {{"murk study scenes/studies/fog-yard.yaml -o out",
                  "A yard from dense fog to clear air, by day and by "
                  "night."}}},
    {.command = "fit",
     .formats = "murk-data murk-scene murk-results",
     .file = {{"fit.json", "values, errors, what is not determined"},
              {"fit.csv", "a row a reading: predicted, residual"},
              {"calibrated.yaml", "what was found, for --set @FILE"},
              {"predict.json", "with --predict, in place of fit.json"},
              {"scene.resolved.yaml", "the scene that the search began with"}},
     .example = {{"murk fit scenes/calibrate-fog.yaml --data "
                  "scenes/calibrate/fog.csv --free "
                  "media.fog.extinction_per_m,media.fog.phase.hg -o out",
                  "Extinction and mean cosine of a fog from 36 readings."},
                 {"murk place scenes/calibrate-fog.yaml --count 2 --set "
                  "@out/calibrated.yaml",
                  "And on from there."}}},
    {.command = "report",
     .formats = "murk-results",
     .file = {{"report.html", "the page"}},
     .example = {{"murk report out", "The page of what lies in out."}}},
    {.command = "replay",
     .formats = "murk-scene",
     .example = {{"murk replay scenes/smoke-hall.yaml --photon 17",
                  "All that befell photon 17."}}},
    {.command = "media",
     .formats = "murk-media murk-scene",
     .file = {{"FILE.vdb", "with --profile: the profile as a grid"}},
     .example = {{"murk media", "All presets."},
                 {"murk media fog/kruse --set visibility_m=200",
                  "What a fog of 200 m comes to, by band."}}},
};

const murk_command_notes *murk_command_notes_of(const char *command)
{
    static const murk_command_notes none = {.formats = ""};
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        if (strcmp(all[i].command, command) == 0) {
            return &all[i];
        }
    }
    return &none;
}
