/* The table of options. The limits refuse typing errors, and values that no
 * machine could compute with. The help states the limits. */
#include "app/option_values.h"
#include "base/picture_limits.h"

#define MEMBER(member)                    \
    .at = offsetof(murk_options, member), \
    .size = sizeof(((murk_options *)0)->member)
#define COUNT(low, high) .kind = MURK_OPTION_COUNT, .min = low, .max = high
#define WORDS(list)      .kind = MURK_OPTION_WORD, .words = list
#define OWN(reader)      .kind = MURK_OPTION_OWN, .read = reader

/* In the order of murk_method of murk.h. */
static const char *const METHODS[] = {"maps", "path", "maps-only", NULL};

static const char *const FORMATS[] = {"text", "json", NULL};
/* In the order of murk_colour_scale of murk.h behind MURK_SCALE_AUTO. */
static const char *const SCALES[] = {"linear", "log", NULL};
/* The word of zsh is number 1, as main.c expects. */
static const char *const SHELLS[] = {"bash", "zsh", NULL};
static const char *const PROGRESSES[] = {"never", "auto", "always", NULL};

const murk_option murk_option_table[] = {
    {"--out", "-o", "DIR",
     "trace place sense render study follow fit report media merge",
     "write the results into this folder; without it the summary is printed "
     "and nothing is written (media: the file of a --profile's grid; render: "
     "the image, else SCENE.exr; report: the page, else DIR/report.html)",
     OWN(murk_option_out), .is_left_out = true},
    {"--force", NULL, NULL,
     "check trace place sense render study follow fit report media merge",
     "replace files that murk did not write, or that were edited since; what a "
     "run reads is never replaced",
     .kind = MURK_OPTION_SWITCH, MEMBER(force), .is_left_out = true},
    {"--report", NULL, NULL, "trace place sense study follow fit",
     "with -o: write the page of murk report into the folder, too, "
     "DIR/report.html, also if rows of a study or steps of follow failed",
     .kind = MURK_OPTION_SWITCH, MEMBER(wants_page), .is_left_out = true},
    {"--seed", NULL, "N", NULL, "seed of all random numbers, 0..4294967295",
     COUNT(0, UINT32_MAX), .key = "seed"},
    {"--threads", "-j", "N", NULL,
     "threads, 1..256; default: all processors. The results are the same for "
     "any number",
     COUNT(1, 256), MEMBER(threads), .is_left_out = true},
    {"--emit", NULL, "N",
     "check trace place sense render study follow fit replay",
     "emit N photons, 1..4294967295 (1e6 is a million); replaces emit or store "
     "of the scene",
     COUNT(1, UINT32_MAX), .key = "photons.emit"},
    {"--store", NULL, "N",
     "check trace place sense render study follow fit replay",
     "emit until N photons are stored; replaces emit or store of the scene",
     COUNT(1, UINT32_MAX), .key = "photons.store"},
    {"--at", NULL, "T", "check trace place sense render study fit replay",
     "the scene at this time of its timeline [s]; default: the first step",
     .kind = MURK_OPTION_TEXT, .key = "timeline.at_s"},
    {"--count", NULL, "N", "check place follow",
     "number of sensors to place; replaces the scene's target",
     COUNT(1, 1000000), .key = "sensors.count"},
    {"--target", NULL, "C", "check place follow",
     "the fewest sensors that cover C, 0..1; replaces the scene's count",
     .kind = MURK_OPTION_TEXT, .key = "sensors.target"},
    {"--budget", NULL, "B", "check place follow",
     "the best sensors whose costs come to B at most; replaces the scene's "
     "count",
     .kind = MURK_OPTION_TEXT, .key = "sensors.budget"},
    {"--start", NULL, "FILE", "check place follow",
     "begin the search at this plan, a plan.json or sensors.csv, in place of "
     "random starts: a short search that improves an earlier plan",
     .kind = MURK_OPTION_PATH, .key = "placement.start_plan"},
    {"--time-limit", NULL, "S", "check place follow",
     "end the search for a plan S seconds after the work on it began, with the "
     "best plan and bound so far; follow: of each step. Light, sightlines and "
     "files take the time they need",
     .kind = MURK_OPTION_TEXT, .key = "placement.time_limit_s"},
    {"--sensors", NULL, "FILE", "sense render",
     "a placement, sensors.csv (type, x_m, y_m, z_m) or a plan.json: the one "
     "to measure; render: who sees each pixel's place, as channels "
     "coverage.count and coverage.clarity",
     .kind = MURK_OPTION_TEXT, MEMBER(sensors), .part = MURK_OPTION_AS_FILE},
    {"--matrix", NULL, "FILE", "place",
     "choose columns of this coverage matrix, CSV or OR-Library text, in place "
     "of a scene; with --count, --target or --budget",
     .kind = MURK_OPTION_TEXT, MEMBER(matrix), .part = MURK_OPTION_AS_FILE},
    {"--export", NULL, "LIST", "trace place sense follow",
     "write these into DIR, too, with commas between: fields (coverage, "
     "optical depth, extinction and photon density as .vdb and .vti), photons "
     "(photons.ply), surfaces (surfaces.ply and .vtp); of place, sense and "
     "follow geojson (sensors.geojson) and geo-csv (sensors_geo.csv), sensors "
     "by "
     "longitude and latitude; of place alone "
     "matrix (matrix.csv, the coverage matrix, which --matrix reads, and "
     "candidates.csv), or-library (matrix.txt, the same as OR-Library text), "
     "lp (problem.lp, the problem for an outside solver); of follow also light "
     "(light.murk), which the others write in any case",
     OWN(murk_option_exports), .setting = "exports"},
    {"--repeat", NULL, "N", "place",
     "do the whole job with N seeds, from --seed on: how far results differ, "
     "and how far the plan (that of the first seed) may be from the best; "
     "repeat.csv has a row a seed",
     COUNT(1, 10000), .setting = "runs", .part = MURK_OPTION_AS_TEXT},
    {"--checkpoint", NULL, "S", "trace",
     "with -o: write all that was traced so far to DIR/checkpoint.part every S "
     "seconds, from which the same command goes on if it was killed; 0 writes "
     "none; default: 600",
     COUNT(0, 1000000), .setting = "every_s", .is_left_out = true},
    {"--shard", NULL, "K/N", "trace place study follow fit",
     "do part K of N of the work, on this machine, and write the part into DIR "
     "(-o); murk merge puts the parts together to the results of a single run. "
     "Of place the parts divide the seeds of --repeat, of fit the searches",
     OWN(murk_option_shard), .setting = "shard", .is_left_out = true},
    {"--photon", NULL, "N", "replay", "index of the emitted photon, from 0",
     COUNT(0, UINT32_MAX - UINT64_C(1)), .setting = "photon",
     .part = MURK_OPTION_AS_TEXT},
    {"--data", NULL, "FILE", "fit",
     "what was measured: CSV with kind, place, value and standard_error of "
     "each reading; or MAP.yaml, which names columns of another file (CSV, "
     "AERONET, SeaBASS)",
     .kind = MURK_OPTION_TEXT, MEMBER(fit.data), .part = MURK_OPTION_AS_FILE},
    {"--free", NULL, "KEY[,KEY...]", "fit",
     "the scene's keys to be found, by their paths; KEY@each: one value for "
     "each condition; gain.NAME: a factor of readings. Repeatable; each starts "
     "from the scene's value",
     OWN(murk_option_free), .setting = "keys", .has_items = true,
     .part = MURK_OPTION_AS_TEXT},
    {"--bounds", NULL, "KEY=LOW:HIGH", "fit",
     "keep a free key within these, either of which may be left out; "
     "repeatable",
     OWN(murk_option_bounds), .setting = "bounds", .has_items = true,
     .part = MURK_OPTION_AS_TEXT},
    {"--loss", NULL, "none|huber|cauchy[:WIDTH]", "fit",
     "what a residual costs: its square, or less beyond WIDTH standard errors "
     "(1.345, 2.385), so that outliers pull less",
     .kind = MURK_OPTION_TEXT, .setting = "loss", .part = MURK_OPTION_AS_TEXT},
    {"--starts", NULL, "N", "fit",
     "search from N starts, the scene's values and others around them, and "
     "keep the best; default 4. Where the best refuses the model or ends at a "
     "bound, N - 1 more are tried, so 1 makes one search and no more",
     COUNT(1, 1000), .part = MURK_OPTION_AS_TEXT},
    {"--traces", NULL, "N", "fit",
     "trace light at most N times a start; default 12", COUNT(1, 1000),
     .part = MURK_OPTION_AS_TEXT},
    {"--next", NULL, "K", "fit",
     "propose the K places of candidates whose readings would tell most",
     COUNT(1, 100), .part = MURK_OPTION_AS_TEXT},
    {"--predict", NULL, "FIT.json", "fit",
     "fit nothing: predict the data at the values of a finished fit",
     .kind = MURK_OPTION_TEXT, MEMBER(fit.predict),
     .part = MURK_OPTION_AS_FILE},
    {"--camera", NULL, "NAME", "render",
     "which of the scene's cameras; default: the first",
     .kind = MURK_OPTION_TEXT, MEMBER(camera), .setting = "camera",
     .part = MURK_OPTION_AS_TEXT},
    {"--method", NULL, "maps|path|maps-only", "render",
     "maps (default): direct light by shadow rays, all other from the photon "
     "maps; maps-only: direct light, too; path: path tracing, which needs no "
     "photons",
     WORDS(METHODS), .setting = "method", .part = MURK_OPTION_AS_TEXT},
    {"--from-sensor", NULL, "N", "render",
     "stand where sensor N of --sensors does, from 1: a hfov x vfov view as it "
     "is, all others all round with the way they look in the middle; pixels "
     "and samples are the camera's that is named, else 640 across and 16",
     COUNT(1, 1000000), MEMBER(render.from_sensor), .setting = "from_sensor",
     .part = MURK_OPTION_AS_TEXT},
    {"--pixels", NULL, "WIDTHxHEIGHT", "render check",
     "size of the picture; replaces the camera's; check: of --picture, default "
     "1600 pixels wide and as high as needed",
     OWN(murk_option_pixels), .setting = "pixels", .part = MURK_OPTION_AS_TEXT},
    {"--samples", NULL, "N", "render",
     "rays of each pixel, 1..65536; replaces the camera's",
     COUNT(1, MURK_SAMPLES_MAX), MEMBER(render.samples),
     .part = MURK_OPTION_AS_TEXT},
    {"--png", NULL, NULL, "render",
     "write the picture for the eye beside the image, too, as .png",
     .kind = MURK_OPTION_SWITCH, .setting = "png", MEMBER(render.png)},
    {"--exposure", NULL, "STOPS", "render",
     "radiance is shown 2^STOPS times as bright in the PNG, -100..100; "
     "default: by the picture, and said",
     OWN(murk_option_exposure), .part = MURK_OPTION_AS_TEXT},
    {"--false-colour", NULL, "CHANNEL", "render",
     "write one channel in false colour with a legend, too, as "
     "IMAGE-CHANNEL.png: radiance, error, surface, volume, depth (of several "
     "bands: depth.550nm), Z, P.X, R, coverage.count and so on",
     .kind = MURK_OPTION_TEXT, MEMBER(render.false_colour),
     .setting = "false_colour", .part = MURK_OPTION_AS_TEXT},
    {"--range", NULL, "LOW:HIGH", "render",
     "values that the false colours go from and to; default: by the picture",
     OWN(murk_option_range), .part = MURK_OPTION_AS_TEXT},
    {"--scale", NULL, "linear|log", "render",
     "of the false colours; default: log for radiances and their errors, else "
     "linear",
     WORDS(SCALES), .part = MURK_OPTION_AS_TEXT},
    {"--picture", NULL, "FILE.png", "check",
     "draw plan and two sections of the scene: surfaces in the cut, media, "
     "light sources, candidates, sensors, targets, domain, with scale and "
     "legend",
     .kind = MURK_OPTION_TEXT, .setting = "picture", .is_left_out = true},
    {"--cut", NULL, "X,Y,Z", "check",
     "where --picture cuts in m: side section at x, front section at y, plan "
     "at z; default: the middle of the candidates, and 1.5 m above the floor",
     OWN(murk_option_cut), .setting = "cut_m"},
    {"--ranks", NULL, "R", "check",
     "forecast, too, what each of R ranks of murk-mpi computes, holds and "
     "receives, with the threads of -j",
     COUNT(1, 100000), .setting = "ranks", .is_left_out = true},
    {"--profile", NULL, "FILE", "media",
     "turn this measured profile (CSV: depth_m, z_m or height_m, and a "
     "coefficient such as c_per_m) into a grid, -o FILE.vdb",
     .kind = MURK_OPTION_TEXT, MEMBER(profile), .part = MURK_OPTION_AS_FILE},
    {"--column", NULL, "NAME", "media",
     "the profile's coefficient, where there are several",
     .kind = MURK_OPTION_TEXT, .setting = "column",
     .part = MURK_OPTION_AS_TEXT},
    {"--rows", NULL, "COLUMN=VALUE", "media",
     "these rows of the profile only, such as one cast of many",
     .kind = MURK_OPTION_TEXT, .setting = "rows", .part = MURK_OPTION_AS_TEXT},
    {"--voxel", NULL, "M", "media trace place sense follow",
     "media: height of the grid's voxels in m; default: a hundredth of the "
     "profile. With --export: edge in m, at most, of the voxels of fields and "
     "of the pieces of surfaces; default: some 100,000 voxels, and pieces of "
     "five photons or so",
     .kind = MURK_OPTION_TEXT, .setting = "voxel_m", MEMBER(voxel),
     .part = MURK_OPTION_AS_TEXT},
    {"--width", NULL, "M", "media",
     "width of the grid in x and y in m; default: 1000",
     .kind = MURK_OPTION_TEXT, .setting = "width_m",
     .part = MURK_OPTION_AS_TEXT},
    {"--light", NULL, "FILE", "place sense render",
     "use this light.murk instead of tracing. Seed and number of photons are "
     "the file's; refused when the command line gives others, or when a scene "
     "key that the light depends on differs",
     .kind = MURK_OPTION_TEXT, MEMBER(light)},
    {"--set", NULL, "KEY=VALUE", NULL,
     "set any scene key by its path, repeatable: --set "
     "media.fog.extinction_per_m=0.05 --set lights.0.power_w=10; --set @FILE "
     "sets the KEY: VALUE lines of a file such as fit's calibrated.yaml",
     OWN(murk_option_set)},
    {"--format", NULL, "text|json", NULL,
     "what is printed on standard output: a summary, or the command's main "
     "JSON",
     WORDS(FORMATS), MEMBER(json), .is_left_out = true},
    {"--quiet", "-q", NULL, NULL,
     "no summary, no progress, and no warnings but that of a fit that the data "
     "refuse",
     .kind = MURK_OPTION_SWITCH, MEMBER(quiet), .is_left_out = true},
    {"--progress", NULL, "auto|always|never", NULL,
     "bars on standard error; auto: only on a terminal", WORDS(PROGRESSES),
     MEMBER(progress), .is_left_out = true},
    {"--help", "-h", NULL, NULL, "this text", .kind = MURK_OPTION_SWITCH,
     MEMBER(wants_help)},
    {"--version", NULL, NULL, NULL, "version, commit, compiler and packages",
     .kind = MURK_OPTION_SWITCH, MEMBER(wants_version)},
    {"--man", NULL, NULL, NULL, NULL, .kind = MURK_OPTION_SWITCH,
     MEMBER(wants_man)},
    {"--completion", NULL, "bash|zsh", NULL, NULL, WORDS(SHELLS)},
};

const size_t murk_option_table_size =
    sizeof murk_option_table / sizeof *murk_option_table;
_Static_assert(sizeof murk_option_table / sizeof *murk_option_table <=
                   MURK_OPTIONS_MAX,
               "lists of options have room for all");
