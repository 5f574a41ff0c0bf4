/* Parts of the runs of murk_repeat: shard K of N makes every N-th further run,
 * K, K + N, K + 2 N and so on, and writes a file, from which a run that puts
 * the parts together takes them. The first run is made by every shard and by
 * the merging run itself, because each further run measures the plan of the
 * first one.
 *
 * The file is of the form of light.murk (photonmap/map_file.h), so that changed
 * bytes are found and numbers keep every bit. It states the scene, checksums of
 * the files that the scene names, and the first plan. */
#ifndef MURK_CASES_REPEAT_PART_H
#define MURK_CASES_REPEAT_PART_H

#include "base/shard.h"
#include "cases/repeat.h"

/* Makes the runs of a shard and writes the file. A shard may have no run; in
 * the dark no shard has one. Fails as murk_repeat_make(), and then writes
 * nothing; with MURK_RUN_FAILED if the file cannot be written. */
murk_status murk_repeat_part_make(const murk_repeat_first *first, size_t asked,
                                  murk_shard shard, unsigned threads,
                                  const char *path, murk_error *err);

/* Writes the file of a shard with the runs of the shard in repeat->run. Fails
 * with MURK_RUN_FAILED or MURK_NO_MEMORY. */
murk_status murk_repeat_part_write(const murk_repeat *repeat,
                                   const murk_repeat_first *first,
                                   murk_shard shard, const char *path,
                                   murk_error *err);

/* Reads the files of parts, in any order: fills run[i], and sets has_run[i] of
 * [repeat->asked], for each run that a part has; n >= 1. A part may be given
 * several times. Missing parts are named in a warning. Fails with MURK_BAD_FILE
 * if a file is no part or damaged; with MURK_BAD_VALUE if a part is of another
 * scene, first plan, number of runs or of shards, or version of murk, with the
 * first difference, or if two files of one shard differ; or with
 * MURK_NO_MEMORY. */
murk_status murk_repeat_parts_read(murk_repeat *repeat, bool *has_run,
                                   const murk_repeat_first *first,
                                   const char *const *path, size_t n,
                                   murk_error *err);

/* All runs: murk_repeat_begin(), murk_repeat_parts_read() unless n is 0, and
 * murk_repeat_make() of the runs that no part has. *out has no runs in the dark
 * and if the parts are refused. Release *out also after a failure. */
murk_status murk_repeat_merge(murk_repeat *out, const murk_repeat_first *first,
                              size_t asked, const char *const *path, size_t n,
                              unsigned threads, murk_error *err);

#endif
