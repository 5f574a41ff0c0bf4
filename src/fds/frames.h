/* Frames of the binary files of FDS (fds/records.h). For use inside src/fds
 * only.
 *
 * .s3d: a record of eight integers (1, 0, the first and last node along x, y
 * and z), then for each frame records with the time, with two numbers of bytes
 * (before and after compression), and with the bytes. The bytes are run-length
 * coded: 255 v n stands for n times v.
 * .sf: three labels of 30 characters, a record of six grid lines, then for each
 * frame records with the time and with the values, x fastest. */
#ifndef MURK_FDS_FRAMES_H
#define MURK_FDS_FRAMES_H

#include "fds/records.h"
#include "fds/run.h"

#include <stdio.h>

typedef struct murk_fds_frames {
    FILE *file;
    murk_fds_records records;
    bool is_smoke3d;
    int32_t nodes[6];  /* lowest and highest along x, y and z */
    uint64_t values;   /* of a frame */
    size_t n;          /* frames */
    double *time_s;    /* [n], rising; of single precision */
    int64_t *offset;   /* [n], of the records after the time */
    const char *where; /* the file, for messages */
} murk_fds_frames;

/* Opens a file and finds the frames; a last frame that is cut off, as in a run
 * that goes on, is left out. The caller releases *out with
 * murk_fds_frames_close(), after a failure, too. `where` is borrowed. Fails
 * with MURK_BAD_FILE or MURK_NO_MEMORY at `where`. */
murk_status murk_fds_frames_open(murk_fds_frames *out, const char *path,
                                 bool is_smoke3d, const char *where,
                                 murk_error *err);
void murk_fds_frames_close(murk_fds_frames *frames);

/* Reads the values of a frame to out[values]: the bytes of a .s3d file as
 * numbers, or the numbers of a .sf file. */
murk_status murk_fds_frames_read(murk_fds_frames *frames, size_t frame,
                                 float *out, murk_error *err);

#endif
