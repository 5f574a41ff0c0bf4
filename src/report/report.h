/* The page of a result folder: one HTML file with the data of the results, and
 * a script that draws them. */
#ifndef MURK_REPORT_REPORT_H
#define MURK_REPORT_REPORT_H

#include "report/results_in.h"

#include <stddef.h>
#include <stdint.h>

typedef struct murk_report murk_report;

/* Reads the folder; `folder` is borrowed. made_by (borrowed) is NULL if the
 * folder is kept. If the folder is removed afterwards, made_by says what made
 * the results, and the page shows that in place of the name of the folder, the
 * list of its files and the commands that use it. The caller owns
 * *out (murk_report_destroy()), also after a failure. Fails as
 * murk_results_read() does, or with MURK_NO_MEMORY. To be called before the
 * program makes a thread or a ray device. */
murk_status murk_report_read(murk_report **out, const char *folder,
                             const char *made_by, murk_error *err);
murk_status murk_report_write(murk_report *report, const char *path,
                              murk_error *err);
void murk_report_destroy(murk_report *report); /* NULL is fine */

typedef struct murk_report_facts {
    const murk_results_in *results;  /* borrowed */
    uint64_t photons, photons_shown; /* of all conditions: in the files, and in
                                        the page */
    size_t sensors;
} murk_report_facts;

murk_report_facts murk_report_describe(const murk_report *report);

#endif
