/* Writes everything that results depend on into one text and hashes the
 * text. */
#include "results/identity.h"

#include "base/file.h"
#include "results/version.h"
#include "world/file_sums.h"

#include <stdio.h>
#include <stdlib.h>

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "for the identity");
}

murk_status murk_identity_of(char out[65], const char *command,
                             const char *asked, const murk_scene_desc *scene,
                             const char *of, uint32_t seed, murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (!to) {
        return no_memory(err);
    }
    fprintf(to, "murk %s\ncommand %s\nseed %lu\n%s%s", MURK_VERSION, command,
            (unsigned long)seed, asked, of);
    /* The scene and the contents of its files, whatever their paths. */
    bool is_whole = true;
    if (scene) {
        murk_file_sums sums = {0};
        fputs(scene->whole_key, to);
        is_whole = murk_file_sums_scene(to, &sums, scene);
        murk_file_sums_release(&sums);
    }
    is_whole = fclose(to) == 0 && is_whole;
    if (is_whole) {
        murk_sha256_hex(text, size, out);
    }
    free(text);
    return is_whole ? MURK_OK : no_memory(err);
}
