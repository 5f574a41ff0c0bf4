/* Check macros for plain test programs: they print what was off, count it in
 * check_failures, and stay on in release builds. A test's main ends with
 * `return check_done();`. */
#ifndef MURK_TESTS_CHECK_H
#define MURK_TESTS_CHECK_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

extern int check_failures; /* so far */
extern int check_count;    /* checks made so far */

/* 0 when all held; 1 when one failed or when nothing at all was checked. */
int check_done(void);

/* Ends the program as skipped (ctest: exit 77), with a line that says why. */
_Noreturn void check_skip(const char *why);

/* |got - want| / sigma; infinite where anything is NaN or sigma is not > 0. */
double sigmas_off(double got, double want, double sigma);

#define CHECK(condition)                                                   \
    do {                                                                   \
        ++check_count;                                                     \
        if (!(condition)) {                                                \
            printf("%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
            ++check_failures;                                              \
        }                                                                  \
    } while (0)

#define CHECK_WITHIN(limit, got, want, sigma)                                 \
    do {                                                                      \
        ++check_count;                                                        \
        const double off_ = sigmas_off((got), (want), (sigma));               \
        if (!(off_ <= (limit))) {                                             \
            printf("%s:%d: %s = %.9g, want %.9g: %.1f sigma off\n", __FILE__, \
                   __LINE__, #got, (double)(got), (double)(want), off_);      \
            ++check_failures;                                                 \
        }                                                                     \
    } while (0)

#define CHECK_NEAR(got, want, tolerance)                              \
    do {                                                              \
        ++check_count;                                                \
        const double got_ = (got), want_ = (want);                    \
        if (!(fabs(got_ - want_) <= (tolerance))) {                   \
            printf("%s:%d: %s = %.17g, want %.17g to %g\n", __FILE__, \
                   __LINE__, #got, got_, want_, (double)(tolerance)); \
            ++check_failures;                                         \
        }                                                             \
    } while (0)

#define CHECK_TEXT(got, want)                                         \
    do {                                                              \
        ++check_count;                                                \
        const char *got_ = (got), *want_ = (want);                    \
        if (strcmp(got_, want_) != 0) {                               \
            printf("%s:%d: %s is \"%s\",\n  want \"%s\"\n", __FILE__, \
                   __LINE__, #got, got_, want_);                      \
            ++check_failures;                                         \
        }                                                             \
    } while (0)

/* The text holds that part. */
#define CHECK_MENTIONS(got, part)                                       \
    do {                                                                \
        ++check_count;                                                  \
        const char *got_ = (got), *part_ = (part);                      \
        if (!strstr(got_, part_)) {                                     \
            printf("%s:%d: %s is \"%s\",\n  does not mention \"%s\"\n", \
                   __FILE__, __LINE__, #got, got_, part_);              \
            ++check_failures;                                           \
        }                                                               \
    } while (0)

#endif
