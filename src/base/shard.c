/* Checks the number of a shard, and names parts that are missing. */
#include "base/shard.h"

#include "base/log.h"

#include <stdio.h>
#include <string.h>

/* Bytes of the names of missing parts in a warning: some twenty names. */
#define NAMES_SIZE 128

/* A number of a part with a comma and a blank, and ", ...". */
#define NAME_SIZE 16

murk_status murk_shard_check(murk_shard shard, murk_error *err)
{
    return shard.number >= 1 && shard.number <= shard.count &&
                   shard.count <= MURK_SHARDS_MAX
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, "shard",
                           "%u of %u, must be 1 of 1 to %d of %d", shard.number,
                           shard.count, MURK_SHARDS_MAX, MURK_SHARDS_MAX);
}

murk_status murk_shard_check_version(const char *made_by, size_t size,
                                     const char *version, const char *path,
                                     murk_error *err)
{
    return strncmp(made_by, version, size) == 0
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, path,
                           "made by murk %.*s, this is %s",
                           (int)strnlen(made_by, size), made_by, version);
}

void murk_shards_warn_of_missing(bool (*has_part)(const void *of,
                                                  uint32_t number),
                                 const void *of, uint32_t count,
                                 const char *now)
{
    char names[NAMES_SIZE] = "";
    size_t length = 0, missing = 0;
    for (uint32_t number = 1; number <= count; ++number) {
        if (has_part(of, number)) {
            continue;
        }
        ++missing;
        if (length + NAME_SIZE < sizeof names) {
            length += (size_t)snprintf(names + length, sizeof names - length,
                                       "%s%u", length ? ", " : "", number);
        }
    }
    if (missing > 0) {
        murk_warn("merge", "%zu of %u parts are missing (%s%s): %s", missing,
                  count, names,
                  length + NAME_SIZE < sizeof names ? "" : ", ...", now);
    }
}
