/* The table of commands: name, arguments, summary and the function that runs
 * it. */
/* The commands, with what --help says of each. */
#include "app/options.h"

const murk_command murk_commands[] = {
    {"check", "SCENE", "read a scene, validate it, say what is in it",
     "Reads and builds the scene and prints its surfaces, media, lights, "
     "sensors and candidates, how many candidates are usable or doubtful, and "
     "the photons and the memory that a run will take, foretold by a short "
     "pilot. Nothing is written.",
     murk_command_check},
    {"trace", "SCENE [-o DIR]", "fill the photon maps",
     "Traces photons from the lamps through surfaces and media into the "
     "surface and the volume photon map. With -o writes DIR/light.murk, "
     "DIR/scene.resolved.yaml and, last, DIR/ledger.json.",
     murk_command_trace},
    {"place", "SCENE|--matrix FILE [-o DIR]",
     "the main job: trace, sense, place sensors",
     "Traces, finds which candidate sees which stored photon and how clearly, "
     "chooses the sensors, and measures the choice on a second, independent "
     "map. With -o writes DIR/plan.json (last), sensors.csv, coverage.csv, "
     "plan.ply and all that trace writes; with --repeat DIR/repeat.csv. With "
     "--matrix it chooses columns of "
     "a given "
     "coverage matrix, so that most of the rows' weight is covered; "
     "DIR/plan.json is then all it writes by itself, with null where a matrix "
     "has no such thing. The formats of a matrix: scenes/README.md.",
     murk_command_place},
    {"sense", "SCENE --sensors FILE [-o DIR]", "measure a given placement",
     "Traces and measures what the given sensors see. With -o writes "
     "DIR/coverage.json (last), coverage.csv, coverage.ply and all that trace "
     "writes.",
     murk_command_sense},
    {"render", "SCENE [-o IMAGE.exr]",
     "a picture, as one of its cameras sees it",
     "Writes an OpenEXR image of radiance [W/m2/sr] in each band: with its "
     "standard error, the parts that came from surfaces and from media last, "
     "optical depth, distance and position, and RGB for the eye. By maps it "
     "traces photons (or takes --light's), and the image's errors hold their "
     "noise; by paths it needs none. Without -o the image lies beside the "
     "scene. Channels and method: scenes/README.md.",
     murk_command_render},
    {"study", "STUDY.yaml [-o DIR]",
     "a chain of runs over times and conditions",
     "Runs a scene once for each row of a study: every combination of what the "
     "study's axes list (or one value of each after the other). With -o writes "
     "DIR/table.csv, a row a run with photon density, coverage and their "
     "standard errors, and, last, DIR/study.json. Rows that differ by the "
     "power "
     "of lights alone share one traced light. Finished rows are kept in "
     "DIR/rows: the same command goes on where it was stopped. A row that "
     "fails "
     "is told in the column failed, the others go on, and the command ends "
     "with "
     "1. The study's keys: scenes/README.md.",
     murk_command_study},
    {"fit", "SCENE --data FILE --free KEY[,KEY...] [-o DIR]",
     "calibrate: which medium was it?",
     "Finds the values of scene keys that bring the model to what was "
     "measured: "
     "coverage, fluence rate, irradiance, transmittance, at many places and "
     "under several conditions. Light is traced seldom and re-weighted in "
     "between. Says how sure each value is, and what the data do not "
     "determine. "
     "With -o writes DIR/fit.csv (a row a measured row: predicted, residual), "
     "calibrated.yaml (for --set @FILE) and, last, fit.json. --free KEY is one "
     "value for all conditions, KEY@each one a condition, gain.NAME a factor "
     "of "
     "readings. The columns of the data, and how to read the result: "
     "scenes/README.md.",
     murk_command_fit},
    {"report", "DIR [-o FILE.html]",
     "one self-contained page of a result folder",
     "Writes DIR/report.html (or FILE.html) from what place, sense, study, fit "
     "or trace left in DIR: what was asked and the answer in short, tables, "
     "plots, tallies, sensors and photons in space, PNG pictures that lie "
     "there (at most 0.7 MB), how it was made and the commands that make it "
     "again. The page is one file, "
     "loads nothing from elsewhere, and can be read without JavaScript and "
     "printed. At most 100000 photons and 40000 triangles are shown, and it "
     "says so.",
     murk_command_report},
    {"replay", "SCENE --photon N", "print every event of one emitted photon",
     "Traces the one photon again, event by event: a photon is a pure function "
     "of seed, scene and index.",
     murk_command_replay},
    {"media", "[NAME]", "the presets of media, with numbers and sources",
     "Lists the presets that a scene's medium may name (preset: fog/kim). With "
     "NAME says what that one means: its words with ranges and defaults, "
     "extinction, albedo and mean cosine by band, sources and doubts. --set "
     "visibility_m=50 gives a word (or albedo, extinction_per_m, phase), --set "
     "bands_nm=[532] other bands. --profile FILE.csv -o FILE.vdb turns a "
     "measured profile into a grid that holds its optical depth.",
     murk_command_media},
};
const size_t murk_commands_count = sizeof murk_commands / sizeof *murk_commands;
