/* Sequences of files: formats the name of a frame by a pattern, and lists
 * the frames in a folder by parsing the names of the files. */
#include "scene/frames.h"

#include <dirent.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"

/* 18 digits fit into uint64_t. */
#define DIGITS_MAX 18
#define FRAMES_MAX 1000000 /* more frames of one folder are not listed */

/* The position of the number in a pattern. */
typedef struct place {
    const char *name;        /* name of the file without folders */
    const char *begin, *end; /* begin and end of #### or %04d */
    int digits;              /* smallest number of digits */
} place;

static bool find_place(const char *pattern, place *p)
{
    const char *slash = strrchr(pattern, '/');
    p->name = slash ? slash + 1 : pattern;
    p->begin = strpbrk(p->name, "#%");
    if (!p->begin) {
        return false;
    }
    if (*p->begin == '#') {
        const size_t n = strspn(p->begin, "#");
        p->digits = (int)n;
        p->end = p->begin + n;
        return n <= DIGITS_MAX;
    }
    char *end = NULL;
    const bool is_padded = p->begin[1] == '0';
    const long digits = is_padded ? strtol(p->begin + 2, &end, 10) : 1;
    const char *letter = is_padded ? end : p->begin + 1;
    p->digits = (int)digits;
    p->end = letter + 1;
    return *letter == 'd' && digits >= 1 && digits <= DIGITS_MAX;
}

char *murk_frames_file(const char *pattern, uint64_t frame)
{
    place p;
    if (!find_place(pattern, &p)) {
        return NULL;
    }
    const size_t size = strlen(pattern) + 32;
    char *file = malloc(size);
    if (file) {
        snprintf(file, size, "%.*s%0*" PRIu64 "%s", (int)(p.begin - pattern),
                 pattern, p.digits, frame, p.end);
    }
    return file;
}

/* True if `name` is the name of a frame: it has the pattern's text around
 * the number, and the number has exactly the digits that the pattern writes. */
static bool frame_of(const place *p, const char *name, uint64_t *frame)
{
    const size_t before = (size_t)(p->begin - p->name);
    if (strncmp(name, p->name, before) != 0) {
        return false;
    }
    const char *number = name + before;
    const size_t n = strspn(number, "0123456789");
    char again[32];
    if (n == 0 || n > DIGITS_MAX || strcmp(number + n, p->end) != 0) {
        return false;
    }
    *frame = strtoull(number, NULL, 10);
    snprintf(again, sizeof again, "%0*" PRIu64, p->digits, *frame);
    return strlen(again) == n;
}

static int compare(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* The frames of the folder in rising order, FRAMES_MAX of them at most and
 * fewer when out of memory; the caller frees the array. */
static uint64_t *list_frames(DIR *folder, const place *p, size_t *n)
{
    uint64_t *frames = NULL;
    size_t capacity = 0;
    const struct dirent *entry;
    *n = 0;
    while (*n < FRAMES_MAX && (entry = readdir(folder))) {
        /* Skip other files; append the frame. */
        uint64_t frame;
        if (!frame_of(p, entry->d_name, &frame)) {
            continue;
        }
        if (*n == capacity) {
            capacity = capacity ? 2 * capacity : 64;
            uint64_t *grown = realloc(frames, capacity * sizeof *frames);
            if (!grown) {
                break;
            }
            frames = grown;
        }
        frames[(*n)++] = frame;
    }
    /* readdir() returns files in no particular order. */
    if (*n > 0) {
        qsort(frames, *n, sizeof *frames, compare);
    }
    return frames;
}

static void print_runs(const uint64_t *frames, size_t n, char *out, size_t size)
{
    size_t length = 0;
    for (size_t i = 0; i < n;) {
        size_t last = i;
        while (last + 1 < n && frames[last + 1] <= frames[last] + 1) {
            ++last;
        }
        char run[64];
        if (frames[last] > frames[i]) {
            snprintf(run, sizeof run, "%s%" PRIu64 "..%" PRIu64, i ? ", " : "",
                     frames[i], frames[last]);
        } else {
            snprintf(run, sizeof run, "%s%" PRIu64, i ? ", " : "", frames[i]);
        }
        if (length + strlen(run) + sizeof ", ..." > size) {
            snprintf(out + length, size - length, ", ...");
            return;
        }
        length += (size_t)snprintf(out + length, size - length, "%s", run);
        i = last + 1;
    }
}

/* The existing frames in rising order, FRAMES_MAX of them at most; the caller
 * frees the array. NULL, with *n 0, if there are none. */
static uint64_t *find_frames(const char *pattern, size_t *n)
{
    place p;
    char *path = murk_path_beside(pattern, ".");
    DIR *folder = path && find_place(pattern, &p) ? opendir(path) : NULL;
    uint64_t *frames = NULL;
    *n = 0;
    free(path);
    if (folder) {
        frames = list_frames(folder, &p, n);
        closedir(folder);
    }
    return frames;
}

bool murk_frames_first(const char *pattern, uint64_t *first)
{
    size_t n;
    uint64_t *frames = find_frames(pattern, &n);
    if (n > 0) {
        *first = frames[0];
    }
    free(frames);
    return n > 0;
}

void murk_frames_list(const char *pattern, char *out, size_t size)
{
    size_t n;
    uint64_t *frames = find_frames(pattern, &n);
    snprintf(out, size, "none");
    if (n > 0) {
        print_runs(frames, n, out, size);
    }
    free(frames);
}
