/* The identity of a result: a hash of the version, the command, the seed, the
 * options that change results, and the scene with the contents of its files,
 * wherever they lie. */
#include "app/identity.h"

#include "app/option_table.h"
#include "base/file.h"
#include "results/json.h"
#include "results/version.h"
#include "world/file_sums.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Prints all of a scene that results follow from, wherever it lies. */
static bool write_scene(FILE *to, const murk_scene_desc *scene)
{
    murk_file_sums sums = {0};
    fputs(scene->whole_key, to);
    const bool is_whole = murk_file_sums_scene(to, &sums, scene);
    murk_file_sums_release(&sums);
    return is_whole;
}

static murk_status write_option(FILE *to, const murk_option *option,
                                const char *value, murk_error *err)
{
    const murk_option_part part = option->part;
    char sum[65];
    murk_status status = MURK_OK;
    if (part == MURK_OPTION_AS_FILE) {
        status = murk_file_sha256(value, sum, err);
    }
    if (!status && part != MURK_OPTION_NO_PART) {
        fprintf(to, "%s %s\n", option->name,
                part == MURK_OPTION_AS_FILE ? sum
                : value                     ? value
                                            : "");
    }
    return status;
}

/* Options in the table's order, and those of a name in the order given. */
static murk_status write_all(FILE *to, const murk_options *options,
                             const char *of, uint32_t seed, murk_error *err)
{
    murk_status status = MURK_OK;
    fprintf(to, "murk %s\ncommand %s\nseed %lu\n", MURK_VERSION,
            options->command->name, (unsigned long)seed);
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        for (size_t k = 0; k < options->n_given && !status; ++k) {
            if (options->given[k].option == &murk_option_table[i]) {
                status = write_option(to, options->given[k].option,
                                      options->given[k].value, err);
            }
        }
    }
    fputs(of, to);
    return status;
}

static murk_status no_memory(murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the identity");
}

/* Either scene or `of` says what the input is. */
static murk_status identify(char out[65], const murk_options *options,
                            const murk_scene_desc *scene, const char *of,
                            uint32_t seed, murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    murk_status status =
        to ? write_all(to, options, of, seed, err) : no_memory(err);
    if (!status && scene && !write_scene(to, scene)) {
        status = no_memory(err);
    }
    if (to && fclose(to) != 0 && !status) {
        status = no_memory(err);
    }
    if (!status) {
        murk_sha256_hex(text, size, out);
    }
    free(text);
    return status;
}

murk_status murk_identity(char out[65], const murk_options *options,
                          const char *of, uint32_t seed, murk_error *err)
{
    return identify(out, options, NULL, of, seed, err);
}

murk_status murk_identity_scene(char out[65], const murk_options *options,
                                const murk_scene_desc *scene, murk_error *err)
{
    return identify(out, options, scene, "", scene->seed, err);
}

murk_status murk_identify_alone(cJSON *root, const murk_options *options,
                                const char *of, const char *file,
                                murk_error *err)
{
    char identity[65], *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (to) {
        fprintf(to, "%s\n", of);
        for (size_t i = 0; i < options->n_overrides; ++i) {
            fprintf(to, "%s\n", options->overrides[i].text);
        }
    }
    const murk_status status =
        to && fclose(to) == 0 ? murk_identity(identity, options, text, 0, err)
                              : no_memory(err);
    free(text);
    if (!status) {
        cJSON_AddStringToObject(root, "identity", identity);
        murk_json_file(root, file);
    }
    return status;
}
