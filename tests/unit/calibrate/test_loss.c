/* The text of a loss function is read with the width of 95 % efficiency, or
 * with the width that it has. */
#include "calibrate/loss.h"
#include "check.h"

#include <string.h>

static void check_loss(const char *text, murk_loss_function want, double width)
{
    murk_loss_function loss = MURK_LOSS_FUNCTION_NONE;
    double got = 0;
    CHECK(murk_loss_read(&loss, &got, text, NULL) == MURK_OK);
    CHECK(loss == want);
    CHECK_NEAR(got, width, 0);
}

static void check_refused(const char *text)
{
    murk_error err = {0};
    murk_loss_function loss;
    double width;
    CHECK(murk_loss_read(&loss, &width, text, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, "loss");
    CHECK(strstr(err.text, "must be none, huber"));
}

int main(void)
{
    check_loss("huber", MURK_LOSS_FUNCTION_HUBER, 1.345); /* Huber 1964 */
    check_loss("cauchy", MURK_LOSS_FUNCTION_CAUCHY, 2.385);
    check_loss("cauchy:0.5", MURK_LOSS_FUNCTION_CAUCHY, .5);
    check_refused("none:2");
    check_refused("huber:0");
    check_refused("huber:nan");
    check_refused("tukey");
    return check_done();
}
