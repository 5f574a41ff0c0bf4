/* The page of a result folder: one HTML file with the results' data, which a
 * bundled script draws. */
#ifndef MURK_REPORT_REPORT_H
#define MURK_REPORT_REPORT_H

#include "report/results_in.h"

#include <stddef.h>
#include <stdint.h>

typedef struct murk_report murk_report;

/* Reads the folder. *out is the caller's in any case: murk_report_destroy().
 * Fails as murk_results_read() does, and for lack of memory. Before any thread
 * or ray device is made. */
murk_status murk_report_read(murk_report **out, const char *folder,
                             murk_error *err);
murk_status murk_report_write(murk_report *report, const char *path,
                              murk_error *err);
void murk_report_destroy(murk_report *report); /* NULL is fine */

typedef struct murk_report_facts {
    const murk_results_in *results;  /* borrowed */
    uint64_t photons, photons_shown; /* of all conditions */
    size_t sensors;
} murk_report_facts;

murk_report_facts murk_report_describe(const murk_report *report);

#endif
