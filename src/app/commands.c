/* The table of commands: the function that runs each, and the texts that --help
 * and the man pages show beside the options: arguments, summary, description,
 * files and examples. */
#include "app/options.h"

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

const murk_command murk_commands[] = {
    {"check", "SCENE", "read a scene, validate it, say what is in it",
     "Reads and builds the scene and prints its surfaces, media, lights, "
     "sensors and candidates, how many candidates are usable or doubtful, and "
     "the photons and the memory that a run will take, foretold by a short "
     "pilot; with --ranks also for ranks of murk-mpi. Writes nothing but the "
     "drawing of --picture.",
     murk_command_check, .formats = "murk-scene",
     .example = {{"murk check scenes/smoke-hall.yaml",
                  "What is in the hall, and what a run will take."},
                 {"murk check scenes/day-night.yaml --set site.clock=23:00",
                  "Where sun and moon stand at eleven in the evening."},
                 {"murk check scenes/smoke-hall.yaml --picture hall.png",
                  "Plan and sections of the hall, before anything is traced."}},
     .file = {{"FILE.png",
               "plan and sections on one sheet: --picture FILE.png"}}},
    {"trace", "SCENE [-o DIR]", "fill the photon maps",
     "Traces photons from the lamps through surfaces and media into the "
     "surface and the volume photon map. With -o writes DIR/light.murk, "
     "DIR/scene.resolved.yaml and, last, DIR/ledger.json.",
     murk_command_trace, .has_ranks = true, .ends_in_first = true,
     .formats = "murk-scene murk-light murk-results",
     .example = {{"murk trace scenes/slab.yaml",
                  "A slab of fog beside published figures: its reflectance and "
                  "transmittance as tallies."},
                 {"murk trace scenes/smoke-hall.yaml --emit 1e5 -o out",
                  "Light to keep, for place, sense and render --light "
                  "out/light.murk."}},
     .file = {LIGHT_FILES,
              {"checkpoint.part", "while a long trace runs, to go on from"},
              FIELD_FILES}},
    {"place", "SCENE|--matrix FILE [-o DIR]",
     "the main job: trace, sense, place sensors",
     "Traces, finds which candidate sees which stored photon and how clearly, "
     "chooses the sensors, and measures the choice on a second, independent "
     "map. With -o writes DIR/plan.json (last), sensors.csv, coverage.csv, "
     "plan.ply and all that trace writes; with --repeat DIR/repeat.csv. With "
     "--matrix it chooses columns of a given coverage matrix, so that most of "
     "the rows' weight is covered; DIR/plan.json is then all it writes by "
     "itself, with null where a matrix has no such thing. The formats of a "
     "matrix: murk-matrix(5).",
     murk_command_place, .has_ranks = true,
     .formats = "murk-scene murk-results murk-light murk-matrix",
     .example = {{"murk place scenes/smoke-hall.yaml -o out --export matrix",
                  "Five sensors in a hall with a fire, and the coverage matrix "
                  "that they were chosen from."},
                 {"murk place scenes/paper-room.yaml --target 0.9",
                  "The fewest sensors that cover 90 %."},
                 {"murk place scenes/smoke-hall.yaml --set "
                  "placement.over=worst --count 4 -o out",
                  "One plan for the worst of clear air, fog and smoke."},
                 {"murk place --matrix out/matrix.csv --count 5",
                  "The same by the matrix alone."}},
     .file =
         {{"plan.json", "the plan, its coverage, bound and curve"},
          {"sensors.csv", "a row a sensor; input of murk sense"},
          {"coverage.csv", "a row a sensor: what it covers"},
          {"plan.ply", "sensors and photons, with who sees them"},
          {"explore.csv, path.ply", "with knowledge: explore"},
          {"repeat.csv", "with --repeat: a row a seed"},
          {"regret.csv", "over conditions: each plan in each"},
          {"light-NAME.murk, ledger-NAME.json, scene-NAME.yaml, plan-NAME.ply",
           "over conditions: of each"},
          {"matrix.csv, candidates.csv", "--export matrix"},
          {"matrix.txt", "--export or-library"},
          {"problem.lp", "--export lp"},
          LIGHT_FILES,
          FIELD_FILES}},
    {"sense", "SCENE --sensors FILE [-o DIR]", "measure a given placement",
     "Traces and measures what the given sensors see. With -o writes "
     "DIR/coverage.json (last), coverage.csv, coverage.ply and all that trace "
     "writes.",
     murk_command_sense, .has_ranks = true,
     .formats = "murk-scene murk-results",
     .example = {{"murk sense scenes/smoke-hall.yaml --sensors out/sensors.csv",
                  "A plan again, in other light with --seed 2, or in other air "
                  "with --set."}},
     .file = {{"coverage.json", "coverage with its error, sensor by sensor"},
              {"coverage.csv", "a row a sensor"},
              {"coverage.ply", "sensors and photons, with who sees them"},
              LIGHT_FILES,
              FIELD_FILES}},
    {"render", "SCENE [-o IMAGE.exr]",
     "a picture, as one of its cameras sees it",
     "Writes an OpenEXR image of radiance [W/m2/sr] in each band: with its "
     "standard error, the parts that came from surfaces and from media last, "
     "optical depth, distance and position, and RGB for the eye. By maps it "
     "traces photons (or takes --light's), and the image's errors hold their "
     "noise; by paths it needs none. Without -o the image lies beside the "
     "scene. Channels and method: murk-scene(5), under Cameras.",
     murk_command_render, .has_ranks = true,
     .formats = "murk-scene murk-results",
     .example = {{"murk render scenes/smoke-hall.yaml --set 'cameras=[{name: "
                  "door, from_m: [28, 2, 2.5], to_m: [15, 9, 3]}]' -o hall.exr",
                  "The hall from its gate."}},
     .file = {{"IMAGE.exr", "radiance by band, errors, parts and depth"},
              {"IMAGE.png", "--png: for the eye"},
              {"IMAGE-CHANNEL.png", "--false-colour, with a legend"}}},
    {"study", "STUDY.yaml [-o DIR]",
     "a chain of runs over times and conditions",
     "Runs a scene once for each row of a study: every combination of what the "
     "study's axes list (or one value of each after the other). With -o writes "
     "DIR/table.csv, a row a run with photon density, coverage and their "
     "standard errors, and, last, DIR/study.json. Rows that differ by the "
     "power of lights alone share one traced light. Finished rows are kept in "
     "DIR/rows: the same command goes on where it was stopped. A row that "
     "fails is told in the column failed, the others go on, and the command "
     "ends with 1. The study's keys: murk-study(5).",
     murk_command_study, .has_ranks = true, .input = MURK_INPUT_STUDY,
     .formats = "murk-study murk-scene murk-results",
     .example = {{"murk study scenes/studies/fog-yard.yaml -o out",
                  "A yard from dense fog to clear air, by day and by night."}},
     .file = {{"study.json", "rows, plans, units, notes"},
              {"table.csv", "a row a run"},
              {"scene.resolved.yaml", "the base scene as resolved"},
              {"fluence_0001.vdb", "of the output fluence_vdb, by row"},
              {"rows/", "finished rows, to go on from"}}},
    {"follow", "SCENE [-o DIR]", "a scene with a timeline, step by step",
     "Makes a plan for each step of the scene's timeline. Each step is the "
     "scene at its time (--at), and the search of its plan begins at the plan "
     "of the step before (--start), unless timeline.search_from is start_plan "
     "or the method is greedy. Prints a row a step as it is done. With -o "
     "writes DIR/follow.csv, a row a step with "
     "coverage, its standard error and a bound, DIR/moves.csv, a row for each "
     "sensor that is added, moves, is removed or fails, DIR/steps/0000 and so "
     "on, each with the files of murk place, and, last, DIR/follow.json. Steps "
     "that are done are kept: the same command goes on where it was stopped. A "
     "step whose scene is wrong at its time, such as one whose file is "
     "missing, "
     "is told in the column failed, the others go on, and the command ends "
     "with 1. Fields, surfaces and photons of --export are listed in "
     "DIR/follow.pvd, which ParaView plays.",
     murk_command_follow, .has_ranks = true, .holds_worlds = true,
     .formats = "murk-scene murk-results",
     .example = {{"murk follow scenes/crane-hall.yaml -o out",
                  "A hall in which a crane carries its load past the plume of "
                  "a fire."}},
     .file = {{"follow.json", "the steps, with their figures"},
              {"follow.csv", "a row a step"},
              {"moves.csv", "a row a change of a sensor"},
              {"follow.pvd", "the exports of all steps, for ParaView"},
              {"scene.resolved.yaml",
               "the scene as resolved, at its first step"},
              {"steps/NNNN/", "the files of murk place, by step from 0000; "
                              "light.murk with --export light alone"}}},
    {"fit", "SCENE --data FILE [--free KEY[,KEY...]] [-o DIR]",
     "calibrate: which medium was it?",
     "Finds the values of scene keys that bring the model to what was "
     "measured: coverage, fluence rate, irradiance, transmittance, at many "
     "places and under several conditions. Light is traced seldom and "
     "re-weighted in between. Says how sure each value is, and what the data "
     "do not determine. With -o writes DIR/fit.csv (a row a measured row: "
     "predicted, residual), calibrated.yaml (for --set @FILE) and, last, "
     "fit.json. --free KEY is one value for all conditions, KEY@each one a "
     "condition, gain.NAME a factor of readings. Without --free nothing is "
     "fitted: the readings are predicted at the values of the scene. The "
     "columns of the data, and how to read the result: murk-data(5).",
     murk_command_fit, .has_ranks = true,
     .formats = "murk-data murk-scene murk-results",
     .example =
         {{"murk fit scenes/calibrate-fog.yaml --data scenes/calibrate/fog.csv "
           "--free media.fog.extinction_per_m,media.fog.phase.hg -o out",
           "Extinction and mean cosine of a fog from 36 readings."},
          {"murk place scenes/calibrate-fog.yaml --count 2 --set "
           "@out/calibrated.yaml",
           "And on from there."}},
     .file = {{"fit.json", "values, errors, what is not determined"},
              {"fit.csv", "a row a reading: predicted, residual"},
              {"calibrated.yaml", "what was found, for --set @FILE"},
              {"predict.json", "of a prediction, in place of fit.json"},
              {"scene.resolved.yaml", "the scene that the search began with"}}},
    {"report", "DIR [-o FILE.html]",
     "one self-contained page of a result folder",
     "Writes DIR/report.html (or FILE.html) from what place, sense, study, fit "
     "or trace left in DIR: the summary of the run, tables, plots, tallies, "
     "sensors and photons in space, PNG pictures that lie there (at most 0.7 "
     "MB), how it was made and the commands that make it again. The page is "
     "one file, loads nothing from elsewhere, and can be read without "
     "JavaScript and printed. At most 100000 photons and 40000 triangles are "
     "shown, and it says so.",
     murk_command_report, .input = MURK_INPUT_FOLDER, .formats = "murk-results",
     .example = {{"murk report out", "The page of what lies in out."}},
     .file = {{"report.html", "the page"}}},
    {"merge", "DIR... [-o DIR]", "put the parts of a run together",
     "Puts parts together that --shard K/N of murk trace, study, follow, fit "
     "or place --repeat wrote on any machines, and writes the files of a "
     "single "
     "run, in every bit but for the times in "
     "`run`. Folders may come in any order and more than once. What is in no "
     "part is computed now, with a warning that names the missing parts. Parts "
     "of another scene, of other options or of another version of murk are "
     "refused with the difference. Run it where the parts were made: the paths "
     "of the command line are those of the parts.",
     murk_command_merge, .has_ranks = true, .input = MURK_INPUT_PARTS,
     .formats = "murk-results murk-light",
     .example = {{"murk trace scenes/smoke-hall.yaml --shard 2/8 -o part-2",
                  "The second of eight parts, on any machine."},
                 {"murk merge part-* -o out",
                  "The light that a single run would have traced."}},
     .file = {{"part.txt", "of a part: the command, and which part it is"},
              {"light.part", "of a part of murk trace: the photons"},
              {"repeat.part", "of a part of murk place: a record a seed"},
              {"study.part", "of a part of murk study: which rows it has"},
              {"follow.part", "of a part of murk follow: which steps it has"},
              {"starts.part", "of a part of murk fit: the searches"},
              LIGHT_FILES}},
    {"replay", "SCENE --photon N", "print every event of one emitted photon",
     "Traces the one photon again, event by event: a photon is a pure function "
     "of seed, scene and index.",
     murk_command_replay, .formats = "murk-scene",
     .example = {{"murk replay scenes/smoke-hall.yaml --photon 17",
                  "All that befell photon 17."}}},
    {"media", "[NAME]", "the presets of media, with numbers and sources",
     "Lists the presets that a scene's medium may name (preset: fog/kim). With "
     "NAME says what that one means: its words with ranges and defaults, "
     "extinction, albedo and mean cosine by band, sources and doubts. --set "
     "visibility_m=50 gives a word (or albedo, extinction_per_m, phase), --set "
     "bands_nm=[532] other bands. --profile FILE.csv -o FILE.vdb turns a "
     "measured profile into a grid that holds its optical depth.",
     murk_command_media, .input = MURK_INPUT_PRESET,
     .formats = "murk-media murk-scene",
     .example = {{"murk media", "All presets."},
                 {"murk media fog/kruse --set visibility_m=200",
                  "What a fog of 200 m comes to, by band."}},
     .file = {{"FILE.vdb", "with --profile: the profile as a grid"}}},
    {"init", "[room|street|harbour|smoke]", "a commented scene to start from",
     "Prints a small scene that runs in seconds and needs no other file, with "
     "comments that explain the main keys: a room with fog and lamps (the "
     "default), a street in rain under the sky, a harbour under water, a hall "
     "with smoke and without.",
     murk_command_init, .input = MURK_INPUT_START_SCENE, .is_text_alone = true,
     .formats = "murk-scene",
     .example = {{"murk init room > room.yaml", "A room with fog, to change."},
                 {"murk place room.yaml", "Sensors for that room."}}},
    {"schema", "[>FILE]", "a JSON Schema of scene and study files, for editors",
     "Prints a JSON Schema (draft-07) of scene files and study files, made "
     "from "
     "the tables by which murk reads them: keys, kinds, ranges, words, what is "
     "required, and the reference text of each key. An editor that knows the "
     "schema completes keys, shows their meaning, and marks mistakes while one "
     "writes. What involves several keys or the files that a scene names is "
     "left to murk check. The YAML extension of VS Code takes the schema by "
     "the "
     "line \"# yaml-language-server: $schema=scene.schema.json\" at the top of "
     "a scene.",
     murk_command_schema, .input = MURK_INPUT_NONE, .is_text_alone = true,
     .formats = "murk-scene "
                "murk-study",
     .example = {{"murk schema > scene.schema.json",
                  "The schema as a file, beside the scenes."}}},
    {"help", "[KEY]", "what a key of a scene means, and the values it takes",
     "Prints the reference entry of a scene key: the values that it takes, its "
     "unit, its default and its meaning; of a map, the keys of the map, too. "
     "KEY is a path such as sensors.count or media.fog.extinction_per_m; * "
     "stands for any name or number of an item. Without KEY: the keys of the "
     "top level. The whole reference: murk-scene(5).",
     murk_command_help, .input = MURK_INPUT_KEY, .is_text_alone = true,
     .formats = "murk-scene",
     .example = {{"murk help sensors.types", "The keys of a type of sensors."},
                 {"murk help media.*.extinction_per_m",
                  "The extinction coefficient of a medium."}}},
};
const size_t murk_commands_count = sizeof murk_commands / sizeof *murk_commands;
