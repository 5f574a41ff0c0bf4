/* Names of the files of a sequence in time: the pattern "smoke.####.vdb" or
 * "smoke.%04d.vdb" stands for smoke.0001.vdb, smoke.0002.vdb and so on. A
 * pattern has 1..18 characters #, one for each digit, or %0Nd for N digits (N
 * is 1..18), or %d for numbers without leading zeros. A number with more
 * digits is written in full. The pattern is in the name of the file, not of a
 * folder. */
#ifndef MURK_SCENE_FRAMES_H
#define MURK_SCENE_FRAMES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The file name of a frame, which the caller frees. NULL if there is no
 * pattern, or no memory. */
char *murk_frames_file(const char *pattern, uint64_t frame);

/* Finds the smallest number of the existing frames. False if there are none or
 * the folder cannot be read. */
bool murk_frames_first(const char *pattern, uint64_t *first);

/* Lists the existing frames, as "1..24, 30"; "none" if there are none or the
 * folder cannot be read. A list longer than `out` ends with "...". */
void murk_frames_list(const char *pattern, char *out, size_t size);

#endif
