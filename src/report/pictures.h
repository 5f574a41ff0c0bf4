/* Pictures of a result folder: PNG files, as murk render --png writes them,
 * carried in the page; EXR files by name. */
#ifndef MURK_REPORT_PICTURES_H
#define MURK_REPORT_PICTURES_H

#include "report/results_in.h"

#include <stddef.h>
#include <stdio.h>

/* PNG files that are carried: cameras of a scene, and sensors; more are
 * counted.
 */
#define MURK_REPORT_PICTURES_MAX 8

/* Bytes of all that are carried: a third more in the page, which is to stay
 * below 3 MB. Larger ones are named only. */
#define MURK_REPORT_PICTURES_BYTES 700000

typedef struct murk_report_picture {
    const char *name;     /* of the file, borrowed of the results */
    unsigned char *bytes; /* [size]; NULL: too large to be carried */
    size_t size;
    unsigned width, height; /* pixels */
} murk_report_picture;

typedef struct murk_report_pictures {
    murk_report_picture picture[MURK_REPORT_PICTURES_MAX];
    size_t n, carried;
    size_t more;                    /* PNG files beyond those, not read */
    size_t exr;                     /* EXR files */
    const murk_results_in *results; /* borrowed: the files of the folder */
} murk_report_pictures;

/* What is no PNG is passed over. Fails with MURK_NO_MEMORY. Release in any
 * case. */
murk_status murk_report_pictures_read(murk_report_pictures *out,
                                      const murk_results_in *results,
                                      murk_error *err);
void murk_report_pictures_release(murk_report_pictures *pictures);

/* The section; nothing where there are none. */
void murk_report_pictures_write(FILE *to, const murk_report_pictures *pictures);

#endif
