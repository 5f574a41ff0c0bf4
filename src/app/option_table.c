#include "app/option_table.h"

#include <string.h>

const murk_option murk_option_table[] = {
    {MURK_OPTION_OUT, "--out", "-o", "DIR",
     "trace place sense render study fit report media",
     "write the results into this folder; without it the summary is printed "
     "and nothing is written (media: the file of a --profile's grid; render: "
     "the image, else SCENE.exr; report: the page, else DIR/report.html)"},
    {MURK_OPTION_FORCE, "--force", NULL, NULL,
     "trace place sense render study fit report media",
     "replace files that murk did not write, or that were edited since; what a "
     "run reads is never replaced"},
    {MURK_OPTION_SEED, "--seed", NULL, "N", NULL,
     "seed of all random numbers, 0..4294967295"},
    {MURK_OPTION_THREADS, "--threads", "-j", "N", NULL,
     "threads, 1..256; default: all processors. The results are the same for "
     "any number"},
    {MURK_OPTION_EMIT, "--emit", NULL, "N",
     "check trace place sense render study fit replay",
     "emit N photons, 1..4294967295 (1e6 is a million); replaces emit or "
     "store of the scene"},
    {MURK_OPTION_STORE, "--store", NULL, "N",
     "check trace place sense render study fit replay",
     "emit until N photons are stored; replaces emit or store of the scene"},
    {MURK_OPTION_COUNT, "--count", NULL, "N", "check place",
     "number of sensors to place; replaces the scene's target"},
    {MURK_OPTION_TARGET, "--target", NULL, "C", "check place",
     "the fewest sensors that cover C, 0..1; replaces the scene's count"},
    {MURK_OPTION_BUDGET, "--budget", NULL, "B", "check place",
     "the best sensors whose costs come to B at most; replaces the scene's "
     "count"},
    {MURK_OPTION_SENSORS, "--sensors", NULL, "FILE", "sense render",
     "a placement, sensors.csv (type, x_m, y_m, z_m) or a plan.json: the one "
     "to "
     "measure; render: who sees each pixel's place, as channels coverage.count "
     "and coverage.clarity"},
    {MURK_OPTION_MATRIX, "--matrix", NULL, "FILE", "place",
     "choose columns of this coverage matrix, CSV or OR-Library text, in place "
     "of a scene; with --count, --target or --budget"},
    {MURK_OPTION_EXPORT, "--export", NULL, "LIST", "trace place sense",
     "write these into DIR, too, with commas between: fields (coverage, "
     "optical "
     "depth, extinction and photon density as .vdb and .vti), photons "
     "(photons.ply), surfaces (surfaces.ply and .vtp); and of place alone "
     "matrix (matrix.csv, the coverage matrix, which --matrix reads, and "
     "candidates.csv), or-library (matrix.txt, the same as OR-Library text), "
     "lp (problem.lp, the problem for an outside solver)"},
    {MURK_OPTION_REPEAT, "--repeat", NULL, "N", "place",
     "do the whole job with N seeds, from --seed on: how far results differ, "
     "and how far the plan (that of the first seed) may be from the best; "
     "repeat.csv has a row a seed"},
    {MURK_OPTION_PHOTON, "--photon", NULL, "N", "replay",
     "index of the emitted photon, from 0"},
    {MURK_OPTION_DATA, "--data", NULL, "FILE", "fit",
     "what was measured: CSV with kind, place, value and standard_error of "
     "each "
     "reading"},
    {MURK_OPTION_FREE, "--free", NULL, "KEY[,KEY...]", "fit",
     "the scene's keys to be found, by their paths; KEY@each: one value for "
     "each condition; gain.NAME: a factor of readings. Repeatable; each starts "
     "from the scene's value"},
    {MURK_OPTION_BOUNDS, "--bounds", NULL, "KEY=LOW:HIGH", "fit",
     "keep a free key within these, either of which may be left out; "
     "repeatable"},
    {MURK_OPTION_LOSS, "--loss", NULL, "none|huber|cauchy[:WIDTH]", "fit",
     "what a residual costs: its square, or less beyond WIDTH standard errors "
     "(1.345, 2.385), so that outliers pull less"},
    {MURK_OPTION_STARTS, "--starts", NULL, "N", "fit",
     "search from N starts, the scene's values and others around them, and "
     "keep the best; default 4. Where the best refuses the model or ends at a "
     "bound, N - 1 more are tried, so 1 makes one search and no more"},
    {MURK_OPTION_TRACES, "--traces", NULL, "N", "fit",
     "trace light at most N times a start; default 12"},
    {MURK_OPTION_NEXT, "--next", NULL, "K", "fit",
     "propose the K places of candidates whose readings would tell most"},
    {MURK_OPTION_PREDICT, "--predict", NULL, "FIT.json", "fit",
     "fit nothing: predict the data at the values of a finished fit"},
    {MURK_OPTION_CAMERA, "--camera", NULL, "NAME", "render",
     "which of the scene's cameras; default: the first"},
    {MURK_OPTION_METHOD, "--method", NULL, "maps|path|maps-only", "render",
     "maps (default): direct light by shadow rays, all other from the photon "
     "maps; maps-only: direct light, too; path: path tracing, which needs no "
     "photons"},
    {MURK_OPTION_FROM_SENSOR, "--from-sensor", NULL, "N", "render",
     "stand where sensor N of --sensors does, from 1: a hfov x vfov view as it "
     "is, all others all round with the way they look in the middle; pixels "
     "and samples are the camera's that is named, else 640 across and 16"},
    {MURK_OPTION_PIXELS, "--pixels", NULL, "WIDTHxHEIGHT", "render",
     "size of the picture; replaces the camera's"},
    {MURK_OPTION_SAMPLES, "--samples", NULL, "N", "render",
     "rays of each pixel, 1..65536; replaces the camera's"},
    {MURK_OPTION_PNG, "--png", NULL, NULL, "render",
     "write the picture for the eye beside the image, too, as .png"},
    {MURK_OPTION_EXPOSURE, "--exposure", NULL, "STOPS", "render",
     "radiance is shown 2^STOPS times as bright in the PNG, -100..100; "
     "default: by the picture, and said"},
    {MURK_OPTION_FALSE_COLOUR, "--false-colour", NULL, "CHANNEL", "render",
     "write one channel in false colour with a legend, too, as "
     "IMAGE-CHANNEL.png: radiance, error, surface, volume, depth (of several "
     "bands: depth.550nm), Z, P.X, R, coverage.count and so on"},
    {MURK_OPTION_RANGE, "--range", NULL, "LOW:HIGH", "render",
     "values that the false colours go from and to; default: by the picture"},
    {MURK_OPTION_SCALE, "--scale", NULL, "linear|log", "render",
     "of the false colours; default: log for radiances and their errors, else "
     "linear"},
    {MURK_OPTION_PROFILE, "--profile", NULL, "FILE", "media",
     "turn this measured profile (CSV: depth_m, z_m or height_m, and a "
     "coefficient such as c_per_m) into a grid, -o FILE.vdb"},
    {MURK_OPTION_COLUMN, "--column", NULL, "NAME", "media",
     "the profile's coefficient, where there are several"},
    {MURK_OPTION_ROWS, "--rows", NULL, "COLUMN=VALUE", "media",
     "these rows of the profile only, such as one cast of many"},
    {MURK_OPTION_VOXEL, "--voxel", NULL, "M", "media trace place sense",
     "media: height of the grid's voxels in m; default: a hundredth of the "
     "profile. With --export: edge in m, at most, of the voxels of fields and "
     "of the pieces of surfaces; default: some 100,000 voxels, and pieces of "
     "five photons or so"},
    {MURK_OPTION_WIDTH, "--width", NULL, "M", "media",
     "width of the grid in x and y in m; default: 1000"},
    {MURK_OPTION_LIGHT, "--light", NULL, "FILE", "place sense render",
     "use this light.murk instead of tracing. Seed and number of photons are "
     "the file's; refused when the command line gives others, or when a scene "
     "key that the light depends on differs"},
    {MURK_OPTION_SET, "--set", NULL, "KEY=VALUE", NULL,
     "set any scene key by its path, repeatable: --set "
     "media.fog.extinction_per_m=0.05 --set lights.0.power_w=10; --set @FILE "
     "sets the KEY: VALUE lines of a file such as fit's calibrated.yaml"},
    {MURK_OPTION_FORMAT, "--format", NULL, "text|json", NULL,
     "what is printed on standard output: a summary, or the command's main "
     "JSON"},
    {MURK_OPTION_QUIET, "--quiet", "-q", NULL, NULL,
     "no summary, no progress, and no warnings but that of a fit that the "
     "data refuse"},
    {MURK_OPTION_PROGRESS, "--progress", NULL, "auto|always|never", NULL,
     "bars on standard error; auto: only on a terminal"},
    {MURK_OPTION_HELP, "--help", "-h", NULL, NULL, "this text"},
    {MURK_OPTION_VERSION, "--version", NULL, NULL, NULL,
     "version, commit, compiler and packages"},
    {MURK_OPTION_MAN, "--man", NULL, NULL, NULL, NULL},
};

const size_t murk_option_table_size =
    sizeof murk_option_table / sizeof *murk_option_table;
_Static_assert(sizeof murk_option_table / sizeof *murk_option_table <=
                   MURK_OPTIONS_MAX,
               "lists of options have room for all");

const murk_option *murk_option_find(const char *text, size_t length)
{
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if ((strlen(option->name) == length &&
             strncmp(option->name, text, length) == 0) ||
            (option->other && strlen(option->other) == length &&
             strncmp(option->other, text, length) == 0)) {
            return option;
        }
    }
    return NULL;
}

const murk_option *murk_option_find_short(const char *text)
{
    const int may_be = text[0] == '-' && text[1] != '-' && strlen(text) > 2;
    const murk_option *option = may_be ? murk_option_find(text, 2) : NULL;
    return option && option->argument ? option : NULL;
}

int murk_option_belongs(const murk_option *option, const char *command)
{
    if (!option->commands) {
        return 1;
    }
    const size_t length = strlen(command);
    for (const char *at = strstr(option->commands, command); at;
         at = strstr(at + 1, command)) {
        const int begins = at == option->commands || at[-1] == ' ';
        if (begins && (at[length] == ' ' || at[length] == '\0')) {
            return 1;
        }
    }
    return 0;
}
