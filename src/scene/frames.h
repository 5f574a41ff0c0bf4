/* Files of a sequence in time, by a pattern: "smoke.####.vdb" or
 * "smoke.%04d.vdb" stands for smoke.0001.vdb, smoke.0002.vdb and so on. As many
 * # as digits, or %0Nd; %d for numbers as they are; longer numbers take more
 * places. The pattern is in the file's own name, not in a folder's. */
#ifndef MURK_SCENE_FRAMES_H
#define MURK_SCENE_FRAMES_H

#include <stddef.h>
#include <stdint.h>

/* The file of one frame: the caller frees it. NULL where there is no pattern,
 * or no memory. */
char *murk_frames_file(const char *pattern, uint64_t frame);

/* Which frames there are, as "1..24, 30"; "none" where there are none or the
 * folder cannot be read. Cut short with "..." where that is longer than out. */
void murk_frames_list(const char *pattern, char *out, size_t size);

#endif
