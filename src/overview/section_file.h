/* The PNG file of plan and sections: its name, planes and size as asked for,
 * the check that it may be written, and the file itself. */
#ifndef MURK_OVERVIEW_SECTION_FILE_H
#define MURK_OVERVIEW_SECTION_FILE_H

#include "overview/section_request.h"
#include "results/json.h"

typedef struct murk_section_file {
    const char *path;    /* ends in .png; NULL: no picture is drawn */
    const double *cut_m; /* [3] planes x, y, z in the coordinates of the user;
                          * NULL: they are chosen */
    size_t pixels[2];    /* width and height; 0: 1600 wide, as high as
                          * needed */
} murk_section_file;

/* Checks the members, and whether the file may be written, before any long
 * work. replaces: a file that murk did not write may be replaced, too. Fails
 * with MURK_BAD_VALUE at "picture" if the name does not end in .png, at
 * "pixels" if the picture would be too small, at "cut_m" or "pixels" if these
 * are given without a path, and at the path if the file there may not be
 * replaced; with MURK_RUN_FAILED if no file can be made there. */
murk_status murk_section_file_check(const murk_section_file *picture,
                                    bool replaces, murk_error *err);

/* Draws the picture and writes it. The caller fills the members stage,
 * candidates, escaped_share and threads of the request; the function sets the
 * others, `cut` and `view` to those of the picture and `targets` to NULL at the
 * end. command: the command line that is kept in the file; NULL: none is kept.
 * Fails as murk_targets_create() (if the scene has targets),
 * murk_section_picture_draw() and murk_png_write(). */
murk_status murk_section_file_write(const murk_section_file *picture,
                                    murk_section_request *request,
                                    const char *command, murk_error *err);

/* Adds "picture": {image, cut_m, sections}, with the rectangle of each view in
 * pixels and the coordinates of its lower left corner. */
void murk_section_file_json(cJSON *root, const char *path,
                            const murk_section_request *request);

#endif
