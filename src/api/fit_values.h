/* The values of a finished fit, to predict readings at them. */
#ifndef MURK_API_FIT_VALUES_H
#define MURK_API_FIT_VALUES_H

#include "calibrate/free_keys.h"
#include "results/fit.h"

typedef struct murk_fit_values {
    const char *path; /* of the fit.json, borrowed */
    murk_yaml *root;
    const murk_yaml *list;      /* of parameters, within root */
    char *asked[MURK_FREE_MAX]; /* [n] "KEY" or "KEY@each" */
    size_t n;
} murk_fit_values;

/* Reads a fit.json into *f, which begins as zeros; `path` must outlive *f.
 * Warns if `accepted` is false there, which means that the data rejected the
 * model. Fails with MURK_BAD_FILE if the file cannot be read, or has no list of
 * 1 to MURK_FREE_MAX parameters, each with a key and a value. Release *f also
 * after a failure. */
murk_status murk_fit_values_read(murk_fit_values *f, const char *path,
                                 murk_error *err);
void murk_fit_values_release(murk_fit_values *f);

/* Makes the values of the finished fit the starts of `keys`, which were created
 * from f->asked. Fails with MURK_BAD_FILE if the finished fit has no value of a
 * key, and with MURK_BAD_VALUE if a value is outside of the limits of the key.
 */
murk_status murk_fit_values_set(const murk_fit_values *f, murk_free_keys *keys,
                                murk_error *err);

#endif
