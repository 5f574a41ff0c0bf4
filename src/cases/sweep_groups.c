/* Groups of rows that share the world and differ at most by the power of their
 * lights, so that their light is traced once (lightmap/scaled_light.h). */
#include "cases/sweep_groups.h"

#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static murk_status no_memory(const murk_sweep *sweep, murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, sweep->desc.study->path,
                     "no memory for %zu rows", sweep->desc.study->rows);
}

static murk_status group_rows(murk_sweep *sweep, const murk_sweep_keys *keys,
                              murk_error *err)
{
    const size_t rows = sweep->desc.study->rows;
    sweep->group = calloc(rows + 1, sizeof *sweep->group);
    if (!sweep->group) {
        return no_memory(sweep, err);
    }
    for (size_t i = 0; i < rows; ++i) {
        size_t g = 0;
        if (sweep->row[i].is_done) { /* it cannot be read */
            sweep->row[i].group = SIZE_MAX;
            continue;
        }
        while (g < sweep->groups &&
               strcmp(keys[sweep->group[g].row[0]].world, keys[i].world) != 0) {
            ++g;
        }
        murk_sweep_group *group = &sweep->group[g];
        size_t *grown = realloc(group->row, (group->n + 1) * sizeof *grown);
        if (!grown) {
            return no_memory(sweep, err);
        }
        group->row = grown;
        group->row[group->n++] = i;
        sweep->groups += g == sweep->groups;
        sweep->row[i].group = g;
    }
    return MURK_OK;
}

/* A row is known by itself, and by the different lights in its group: how many
 * photons its light got hangs on them. */
static murk_status sign_rows(murk_sweep *sweep, const murk_sweep_keys *keys,
                             murk_error *err)
{
    for (size_t g = 0; g < sweep->groups; ++g) {
        murk_sweep_group *group = &sweep->group[g];
        char *lights = malloc(group->n * 64 + 1);
        if (!lights) {
            return no_memory(sweep, err);
        }
        /* Collect the different lights of the group. */
        for (size_t k = 0; k < group->n; ++k) {
            const char *own = keys[group->row[k]].light;
            bool is_new = true;
            for (size_t j = 0; j < group->lights && is_new; ++j) {
                is_new = memcmp(lights + 64 * j, own, 64) != 0;
            }
            if (is_new) {
                memcpy(lights + 64 * group->lights++, own, 64);
            }
        }
        /* The key of a row holds its own key and all lights of the group. */
        for (size_t k = 0; k < group->n; ++k) {
            char text[130], all[65];
            murk_sha256_hex(lights, 64 * group->lights, all);
            snprintf(text, sizeof text, "%s\n%s", keys[group->row[k]].own, all);
            murk_sha256_hex(text, strlen(text), sweep->row[group->row[k]].key);
        }
        free(lights);
    }
    return MURK_OK;
}

murk_status murk_sweep_group_rows(murk_sweep *sweep,
                                  const murk_sweep_keys *keys, murk_error *err)
{
    const murk_status status = group_rows(sweep, keys, err);
    return status ? status : sign_rows(sweep, keys, err);
}
