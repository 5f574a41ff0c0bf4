/* tools/make_media: media as grids, the same content on every run. */
#include "kinds.h"

#include "base/number.h"
#include "medium/grid_write.h"
#include "scene/frames.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define VOXELS_MAX 2e8
#define EDGE_MAX   65536
#define FRAMES_MAX 100000
#define LONG_M     1e9

typedef struct settings {
    const media_kind *kind;
    media_frame frame;
    const char *out;
    uint64_t frames; /* 0: one file, no sequence */
    double step_s;
} settings;

static void print_help(void)
{
    printf(
        "usage: tools/make_media KIND -o FILE.vdb [OPTION...] [NAME=VALUE...]\n"
        "\n"
        "  --size X,Y,Z    voxels\n"
        "  --voxel M       edge of a voxel\n"
        "  --seed N        of everything random, 0..4294967295 (1)\n"
        "  --frames N      a sequence 1..N; FILE has #### for the number\n"
        "  --step S        seconds from frame to frame (1)\n"
        "\nThe grid is `density`. Kinds, and their numbers:\n");
    for (size_t i = 0; i < kinds_count; ++i) {
        const media_kind *k = kinds[i];
        printf("\n%s: %s\n  [%s], %zu x %zu x %zu voxels of %g m\n", k->name,
               k->about, k->unit, k->size[0], k->size[1], k->size[2],
               k->voxel_m);
        for (int w = 0; w < KIND_WORDS_MAX && k->words[w].name; ++w) {
            printf("  %s=%g  %s\n", k->words[w].name, k->words[w].usual,
                   k->words[w].about);
        }
    }
}

static const media_kind *kind_named(const char *name)
{
    for (size_t i = 0; i < kinds_count; ++i) {
        if (strcmp(kinds[i]->name, name) == 0) {
            return kinds[i];
        }
    }
    return NULL;
}

static bool number_in(const char *text, double min, double max, double *out)
{
    return murk_number_parse(text, out) && *out >= min && *out <= max;
}

static bool count_in(const char *text, uint64_t min, uint64_t max,
                     uint64_t *out)
{
    return murk_count_parse(text, out) && *out >= min && *out <= max;
}

static murk_status refuse(murk_error *err, const char *where, const char *found,
                          const char *allowed)
{
    return murk_fail(err, MURK_BAD_VALUE, where, "%.80s, must be %s", found,
                     allowed);
}

static murk_status read_size(media_frame *f, const char *text, murk_error *err)
{
    char copy[64];
    snprintf(copy, sizeof copy, "%s", text);
    char *at = copy;
    for (int axis = 0; axis < 3; ++axis) {
        char *comma = strchr(at, ',');
        uint64_t n;
        if ((comma != NULL) != (axis < 2) || strlen(text) >= sizeof copy) {
            return refuse(err, "--size", text, "X,Y,Z");
        }
        if (comma) {
            *comma = '\0';
        }
        if (!count_in(at, 1, EDGE_MAX, &n)) {
            return refuse(err, "--size", text, "X,Y,Z, each 1..65536");
        }
        f->size[axis] = (size_t)n;
        at = comma ? comma + 1 : at;
    }
    const double voxels =
        (double)f->size[0] * (double)f->size[1] * (double)f->size[2];
    return voxels <= VOXELS_MAX
               ? MURK_OK
               : refuse(err, "--size", text, "2e8 voxels at most");
}

/* NAME=VALUE. */
static murk_status read_word(settings *w, const char *text, murk_error *err)
{
    for (int i = 0; i < KIND_WORDS_MAX && w->kind->words[i].name; ++i) {
        const media_word *word = &w->kind->words[i];
        const size_t n = strlen(word->name);
        if (strncmp(text, word->name, n) != 0 || text[n] != '=') {
            continue;
        }
        if (!number_in(text + n + 1, word->min, word->max, &w->frame.word[i])) {
            return murk_fail(err, MURK_BAD_VALUE, word->name,
                             "%.80s, must be %g..%g", text + n + 1, word->min,
                             word->max);
        }
        return MURK_OK;
    }
    return murk_fail(err, MURK_BAD_VALUE, w->kind->name,
                     "%.80s: no such number or option, see --help", text);
}

static murk_status read_option(settings *w, const char *name, const char *value,
                               murk_error *err)
{
    uint64_t seed;
    if (strcmp(name, "-o") == 0) {
        w->out = value;
    } else if (strcmp(name, "--size") == 0) {
        return read_size(&w->frame, value, err);
    } else if (strcmp(name, "--voxel") == 0) {
        if (!number_in(value, 1e-6, LONG_M, &w->frame.voxel_m)) {
            return refuse(err, name, value, "1e-6..1e9 m");
        }
    } else if (strcmp(name, "--seed") == 0) {
        if (!count_in(value, 0, UINT32_MAX, &seed)) {
            return refuse(err, name, value, "0..4294967295");
        }
        w->frame.seed = (uint32_t)seed;
    } else if (strcmp(name, "--frames") == 0) {
        if (!count_in(value, 1, FRAMES_MAX, &w->frames)) {
            return refuse(err, name, value, "1..100000");
        }
    } else if (!number_in(value, -LONG_M, LONG_M, &w->step_s)) {
        return refuse(err, name, value, "-1e9..1e9 s");
    }
    return MURK_OK;
}

static bool is_option(const char *text)
{
    static const char *const options[] = {"-o",     "--size",   "--voxel",
                                          "--seed", "--frames", "--step"};
    for (size_t i = 0; i < sizeof options / sizeof *options; ++i) {
        if (strcmp(text, options[i]) == 0) {
            return true;
        }
    }
    return false;
}

static murk_status read_settings(settings *w, int argc, char **argv,
                                 murk_error *err)
{
    *w = (settings){.kind = kind_named(argv[1]), .step_s = 1};
    if (!w->kind) {
        return refuse(err, "make_media", argv[1],
                      "fog-bank, rain-shafts, plume, chlorophyll or smoke");
    }
    memcpy(w->frame.size, w->kind->size, sizeof w->frame.size);
    w->frame.voxel_m = w->kind->voxel_m;
    w->frame.seed = 1;
    for (int i = 0; i < KIND_WORDS_MAX; ++i) {
        w->frame.word[i] = w->kind->words[i].usual;
    }
    for (int i = 2; i < argc; ++i) {
        const bool option = is_option(argv[i]);
        if (option && i + 1 == argc) {
            return refuse(err, argv[i], "nothing", "followed by its value");
        }
        const murk_status status =
            option ? read_option(w, argv[i], argv[i + 1], err)
                   : read_word(w, argv[i], err);
        if (status) {
            return status;
        }
        i += option;
    }
    return w->out ? MURK_OK
                  : refuse(err, "-o", "nothing", "the name of a file");
}

static murk_status write_frame(const settings *w, const char *path,
                               float *value, murk_error *err)
{
    kind_fill(w->kind, &w->frame, value);
    const char *const notes[] = {"unit", w->kind->unit, "medium", w->kind->name,
                                 NULL};
    const murk_grid_field field = {
        .name = "density", .value = value, .notes = notes};
    const murk_affine place =
        murk_affine_place(murk_vec(0, 0, 0), w->frame.voxel_m,
                          kind_first_middle(w->kind, &w->frame));
    const murk_status status =
        murk_grid_write(path, &field, 1, w->frame.size, &place, err);
    if (!status) {
        printf("%s\n", path);
    }
    return status;
}

static murk_status make(settings *w, murk_error *err)
{
    const size_t n = w->frame.size[0] * w->frame.size[1] * w->frame.size[2];
    float *value = malloc(n * sizeof *value);
    if (!value) {
        return murk_fail(err, MURK_NO_MEMORY, w->out,
                         "no memory for %zu voxels", n);
    }
    murk_status status =
        w->frames == 0 ? write_frame(w, w->out, value, err) : MURK_OK;
    for (uint64_t i = 1; i <= w->frames && !status; ++i) {
        char *path = murk_frames_file(w->out, i);
        w->frame.time_s = (double)(i - 1) * w->step_s;
        status = path ? write_frame(w, path, value, err)
                      : refuse(err, "-o", w->out,
                               "a pattern such as fog.####.vdb, with --frames");
        free(path);
    }
    free(value);
    return status;
}

int main(int argc, char **argv)
{
    if (argc < 2 || strcmp(argv[1], "--help") == 0) {
        print_help();
        return argc < 2 ? 2 : 0;
    }
    settings w;
    murk_error err = {0};
    murk_status status = read_settings(&w, argc, argv, &err);
    if (!status) {
        status = make(&w, &err);
    }
    if (status) {
        fprintf(stderr, "make_media: %s: %s\n", err.where, err.text);
    }
    return status == MURK_OK ? 0 : status == MURK_BAD_VALUE ? 2 : 1;
}
