/* The version of murk, as programs, results and pages state it: "0.1.0" of the
 * three numbers in murk.h. */
#ifndef MURK_BASE_VERSION_H
#define MURK_BASE_VERSION_H

#include "murk.h"

#define MURK_VERSION_DIGITS(number) #number
#define MURK_VERSION_TEXT(major, minor, patch) \
    MURK_VERSION_DIGITS(major)                 \
    "." MURK_VERSION_DIGITS(minor) "." MURK_VERSION_DIGITS(patch)
#define MURK_VERSION                                          \
    MURK_VERSION_TEXT(MURK_VERSION_MAJOR, MURK_VERSION_MINOR, \
                      MURK_VERSION_PATCH)

#endif
