/* The verdict of a fit, from numbers set by hand: the limit of chi-squared, and
 * what is said of values that are not known. */
#include "calibrate/verdict.h"

#include "check.h"

#include <string.h>

/* Chi-squared with one degree of freedom passes this with a chance of 1e-4: the
 * square of the normal quantile 3.890591886. */
#define LIMIT_OF_ONE 15.136705226

typedef struct case_of_two {
    murk_calibration found;
    murk_free_key key[2];
    murk_free_keys keys;
    double error[2];
    bool at_bound[2];
} case_of_two;

static void judge(case_of_two *c, double chi2, long freedom)
{
    strcpy(c->key[0].name, "media.fog.extinction_per_m");
    strcpy(c->key[1].name, "media.fog.albedo");
    c->keys = (murk_free_keys){.n = 2, .key = c->key};
    c->found = (murk_calibration){.n = 2,
                                  .chi2 = chi2,
                                  .degrees_of_freedom = freedom,
                                  .converged = true,
                                  .standard_error = c->error,
                                  .at_bound = c->at_bound};
    murk_calibration_judge(&c->found, &c->keys);
}

static void test_limit(void)
{
    case_of_two c = {.error = {.1, .1}};
    judge(&c, LIMIT_OF_ONE - .01, 1);
    CHECK(c.found.is_accepted);
    CHECK(strncmp(c.found.verdict, "Not well", 8) == 0);
    judge(&c, LIMIT_OF_ONE + .01, 1);
    CHECK(!c.found.is_accepted);
    CHECK(strstr(c.found.verdict, "refuse this model"));
    CHECK_NEAR(c.found.p_value, 1e-4, 1e-6);
    judge(&c, 96, 11);
    CHECK(!c.found.is_accepted);
    judge(&c, 11, 11);
    CHECK(c.found.is_accepted);
    CHECK(strncmp(c.found.verdict, "Yes: ", 5) == 0);
    judge(&c, 1, 11);
    CHECK(c.found.is_accepted);
    CHECK(strncmp(c.found.verdict, "Yes, better", 11) == 0);
}

static void test_no_freedom(void)
{
    case_of_two c = {.error = {.1, .1}};
    judge(&c, 0, 0);
    CHECK(isnan(c.found.p_value));
    CHECK(c.found.is_accepted);
    CHECK(strstr(c.found.verdict, "no more readings than values"));
}

static void test_unknown_values(void)
{
    case_of_two c = {.error = {.1, NAN}};
    judge(&c, 11, 11);
    CHECK(strcmp(murk_calibration_status(&c.found, 0), "determined") == 0);
    CHECK(strcmp(murk_calibration_status(&c.found, 1),
                 "not determined by these data") == 0);
    CHECK(strstr(c.found.verdict, "do not determine media.fog.albedo"));
    c.at_bound[1] = true;
    judge(&c, 11, 11);
    CHECK(strcmp(murk_calibration_status(&c.found, 1), "at its bound") == 0);
    CHECK(!murk_calibration_determines(&c.found, 1));
    CHECK(!strstr(c.found.verdict, "do not determine"));
    CHECK(strstr(c.found.verdict, "1 of the 2 values ended at a bound"));
    c.found.converged = false;
    murk_calibration_judge(&c.found, &c.keys);
    CHECK(strstr(c.found.verdict, "did not converge"));
}

int main(void)
{
    test_limit();
    test_no_freedom();
    test_unknown_values();
    return check_done();
}
