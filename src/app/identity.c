/* Writes the options that change results as lines of text, which the library
 * hashes with the scene into the identity. A file is written by its contents,
 * so that the identity does not depend on its place. */
#include "app/identity.h"

#include "app/options.h"
#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>

static murk_status write_option(FILE *to, const murk_option *option,
                                const char *value, murk_error *err)
{
    char sum[65];
    if (option->part == MURK_OPTION_AS_FILE) {
        const murk_status status = murk_file_sha256(value, sum, err);
        if (status) {
            return status;
        }
        value = sum;
    }
    if (option->part != MURK_OPTION_NO_PART) {
        fprintf(to, "%s %s\n", option->name, value ? value : "");
    }
    return MURK_OK;
}

/* Options in the table's order, and those of a name in the order given. */
static murk_status write_all(FILE *to, const murk_options *options,
                             murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        for (size_t k = 0; k < options->n_given && !status; ++k) {
            if (options->given[k].option == &murk_option_table[i]) {
                status = write_option(to, options->given[k].option,
                                      options->given[k].value, err);
            }
        }
    }
    return status;
}

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "for the identity");
}

murk_status murk_identity_asked(char **out, const murk_options *options,
                                murk_error *err)
{
    size_t size = 0;
    *out = NULL;
    FILE *to = open_memstream(out, &size);
    if (!to) {
        return no_memory(err);
    }
    const murk_status status = write_all(to, options, err);
    return fclose(to) != 0 && !status ? no_memory(err) : status;
}

/* Adds the lines of the keys behind an empty line. */
murk_status murk_identity_alone(char **out, const murk_options *options,
                                murk_error *err)
{
    char *asked = NULL;
    size_t size = 0;
    murk_status status = murk_identity_asked(&asked, options, err);
    *out = NULL;
    FILE *to = status ? NULL : open_memstream(out, &size);
    if (to) {
        fprintf(to, "%s\n", asked);
        for (size_t i = 0; i < options->n_overrides; ++i) {
            fprintf(to, "%s\n", options->overrides[i].text);
        }
    }
    if (!status && (!to || fclose(to) != 0)) {
        status = no_memory(err);
    }
    free(asked);
    return status;
}
