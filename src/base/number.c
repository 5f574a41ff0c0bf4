/* Parses decimal numbers more strictly than strtod(), which also accepts
 * hexadecimal numbers, infinities and leading blanks, and prints numbers so
 * that they read back as the same double. */
#include "base/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* All whole numbers up to 2^53 are exact in a double. */
#define EXACT_WHOLE 9007199254740992.0

static const char *skip_digits(const char *p)
{
    while (*p >= '0' && *p <= '9') {
        ++p;
    }
    return p;
}

/* True if the text is a decimal number and nothing else. */
static bool is_decimal(const char *text)
{
    /* Sign, digits with an optional point, optional exponent. */
    const char *p = text + (*text == '+' || *text == '-');
    const char *whole = skip_digits(p);
    long digits = whole - p;
    p = whole;
    if (*p == '.') {
        const char *part = skip_digits(p + 1);
        digits += part - (p + 1);
        p = part;
    }
    if (digits == 0) {
        return false;
    }
    if (*p == 'e' || *p == 'E') {
        p += 1 + (p[1] == '+' || p[1] == '-');
        const char *exponent = skip_digits(p);
        if (exponent == p) {
            return false;
        }
        p = exponent;
    }
    return *p == '\0';
}

bool murk_number_parse(const char *text, double *out)
{
    if (!is_decimal(text)) {
        return false;
    }
    const double value = strtod(text, NULL);
    if (!isfinite(value)) {
        return false;
    }
    *out = value;
    return true;
}

bool murk_count_parse(const char *text, uint64_t *out)
{
    const char *p = text + (*text == '+');
    const char *end = skip_digits(p);
    if (end == p || *end != '\0') {
        double value;
        if (!murk_number_parse(text, &value) || !(value >= 0) ||
            !(value <= EXACT_WHOLE) || value != floor(value)) {
            return false;
        }
        *out = (uint64_t)value;
        return true;
    }
    /* Digits only: up to 2^64 - 1. */
    uint64_t value = 0;
    for (; p < end; ++p) {
        const uint64_t digit = (uint64_t)(*p - '0');
        if (value > (UINT64_MAX - digit) / 10) {
            return false;
        }
        value = 10 * value + digit;
    }
    *out = value;
    return true;
}

void murk_number_print(char out[MURK_NUMBER_SIZE], double value)
{
    for (int digits = 15; digits <= 17; ++digits) {
        snprintf(out, MURK_NUMBER_SIZE, "%.*g", digits, value);
        if (strtod(out, NULL) == value) {
            return;
        }
    }
}
