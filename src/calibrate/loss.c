/* Reads the name of a loss function with its width. */
#include "calibrate/loss.h"

#include "base/number.h"

#include <string.h>

#define LOSS_WIDTH_MAX 1e6 /* standard errors: far beyond any outlier */

murk_status murk_loss_read(murk_loss_function *loss, double *width,
                           const char *text, murk_error *err)
{
    static const char *const losses[] = {"none", "huber", "cauchy"};
    /* Widths of 95 % efficiency on normal residuals (Holland and Welsch,
     * Commun. Stat. A 6 (1977) 813, doi:10.1080/03610927708827533). */
    static const double widths[] = {1, 1.345, 2.385};
    const size_t length = strcspn(text, ":");
    /* The name of the loss, then its width if one is given. */
    for (int i = 0; i < 3; ++i) {
        if (strlen(losses[i]) != length ||
            strncmp(losses[i], text, length) != 0) {
            continue;
        }
        *loss = (murk_loss_function)i;
        *width = widths[i];
        if (!text[length]) {
            return MURK_OK;
        }
        if (i > 0 && murk_number_parse(text + length + 1, width) &&
            *width > 0 && *width <= LOSS_WIDTH_MAX) {
            return MURK_OK;
        }
    }
    return murk_fail(err, MURK_BAD_VALUE, "loss",
                     "%s, must be none, huber or cauchy, the last two also "
                     "with a width in standard errors: huber:1.345",
                     text);
}
