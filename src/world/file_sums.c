/* Prints checksums (XXH3, 128 bits: base/file.h) of the files that a scene
 * names. A table of the paths asked for so far keeps each file from being read
 * more than once. */
#include "world/file_sums.h"

#include "base/file.h"
#include "fds/data_files.h"
#include "scene/print.h"
#include "world/mesh_files.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

void murk_file_sums_release(murk_file_sums *sums)
{
    for (size_t i = 0; i < sums->n; ++i) {
        free(sums->path[i]);
    }
    free(sums->path);
    free(sums->sum);
    *sums = (murk_file_sums){0};
}

/* The checksum of a file as hexadecimal digits, or "-" if the file cannot be
 * read or is larger than MURK_SUM_BYTES_MAX. NULL when out of memory. */
static const char *sum_of(murk_file_sums *sums, const char *path)
{
    /* A path that was asked for before has an entry. */
    for (size_t i = 0; i < sums->n; ++i) {
        if (strcmp(sums->path[i], path) == 0) {
            return sums->sum[i];
        }
    }
    /* Grow the table by one entry. */
    char **paths = realloc(sums->path, (sums->n + 1) * sizeof *paths);
    sums->path = paths ? paths : sums->path;
    char(*all)[33] = realloc(sums->sum, (sums->n + 1) * sizeof *all);
    sums->sum = all ? all : sums->sum;
    char *copy = strdup(path);
    if (!paths || !all || !copy) {
        free(copy);
        return NULL;
    }
    /* Read the file. */
    uint64_t sum[2];
    const bool is_read =
        murk_file_checksum(path, MURK_SUM_BYTES_MAX, sum, NULL) == MURK_OK;
    paths[sums->n] = copy;
    if (is_read) {
        snprintf(all[sums->n], sizeof *all, "%016" PRIx64 "%016" PRIx64, sum[1],
                 sum[0]);
    } else {
        snprintf(all[sums->n], sizeof *all, "-");
    }
    return all[sums->n++];
}

bool murk_file_sums_put(FILE *out, murk_file_sums *sums, const char *path)
{
    const char *sum = path ? sum_of(sums, path) : "-";
    if (sum) {
        fprintf(out, "file: %s\n", sum);
    }
    return sum != NULL;
}

/* Where the sums of the data files of a simulation go. */
typedef struct sums_to {
    FILE *out;
    murk_file_sums *sums;
} sums_to;

static bool put_data_file(void *context, const char *file)
{
    const sums_to *to = context;
    return murk_file_sums_put(to->out, to->sums, file);
}

bool murk_file_sums_scene(FILE *out, murk_file_sums *sums,
                          const murk_scene_desc *scene)
{
    bool is_whole = true;
    for (size_t i = 0; i < scene->files && is_whole; ++i) {
        is_whole = murk_file_sums_put(out, sums, scene->file[i]);
    }
    /* The grid files of media are printed once more, because for a frame of a
     * sequence the list of files holds the pattern of the names and not the
     * file of the frame, nor that of the next frame for a time between both. */
    for (size_t i = 0; i < scene->n_media && is_whole; ++i) {
        const murk_scene_medium *m = &scene->media[i];
        is_whole = murk_file_sums_put(out, sums, m->vdb) &&
                   murk_file_sums_put(out, sums, m->albedo_vdb) &&
                   (!m->vdb_next || murk_file_sums_put(out, sums, m->vdb_next));
        /* The files of a simulation are not named in the scene. */
        if (is_whole && m->fds) {
            sums_to to = {out, sums};
            is_whole = murk_fds_data_files(m->fds, false, put_data_file, &to);
        }
    }
    for (size_t i = 0; i < murk_mesh_files_count(scene) && is_whole; ++i) {
        const murk_mesh_file file = murk_mesh_file_at(scene, i);
        if (file.path && file.import.is_fds) {
            sums_to to = {out, sums};
            is_whole = murk_fds_data_files(file.path, true, put_data_file, &to);
        }
    }
    for (size_t i = 0; i < scene->n_conditions && is_whole; ++i) {
        is_whole = murk_file_sums_scene(out, sums, scene->conditions[i].scene);
    }
    return is_whole;
}

char *murk_file_sums_print(const murk_scene_desc *scene)
{
    murk_file_sums sums = {0};
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    const bool is_whole = to && murk_file_sums_scene(to, &sums, scene);
    murk_file_sums_release(&sums);
    char *out = to ? murk_print_finish(to, &text) : NULL;
    if (!is_whole) {
        free(out);
        out = NULL;
    }
    return out;
}
