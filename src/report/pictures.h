/* Pictures of a result folder: PNG files, such as murk render --png writes,
 * become part of the page; EXR files are named. */
#ifndef MURK_REPORT_PICTURES_H
#define MURK_REPORT_PICTURES_H

#include "report/results_in.h"

#include <stddef.h>
#include <stdio.h>

/* Largest number of PNG files that are read. More are only counted. */
#define MURK_REPORT_PICTURES_MAX 8

/* Largest number of bytes of all PNG files in the page, which should stay below
 * 3 MB; in the page they take a third more. Files that do not fit are only
 * named. */
#define MURK_REPORT_PICTURES_BYTES 700000

typedef struct murk_report_picture {
    const char *name;     /* of the file, borrowed from the results */
    unsigned char *bytes; /* [size]; NULL: too large for the page, or no
                             memory */
    size_t size;
    unsigned width, height; /* pixels */
} murk_report_picture;

typedef struct murk_report_pictures {
    murk_report_picture picture[MURK_REPORT_PICTURES_MAX];
    size_t n, carried;
    size_t more;                    /* PNG files beyond the limit, not read */
    size_t exr;                     /* EXR files */
    const murk_results_in *results; /* borrowed */
} murk_report_pictures;

/* Reads the pictures. Files that are no PNG are left out. Fails with
 * MURK_NO_MEMORY. Release *out in any case. */
murk_status murk_report_pictures_read(murk_report_pictures *out,
                                      const murk_results_in *results,
                                      murk_error *err);
void murk_report_pictures_release(murk_report_pictures *pictures);

/* Writes the section of pictures; nothing if there are no PNG or EXR files. */
void murk_report_pictures_write(FILE *to, const murk_report_pictures *pictures);

#endif
