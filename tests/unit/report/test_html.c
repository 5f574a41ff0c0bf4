/* What pages are written with: text that cannot become markup, base64 (RFC
 * 4648, 10), hashes of a policy, numbers with their errors. Nothing here is
 * random. */
#include "check.h"
#include "report/html.h"

#include <stdlib.h>
#include <string.h>

static char written[512];

/* What `write` puts out, as text. */
#define WRITTEN(call)                                                  \
    do {                                                               \
        FILE *to = tmpfile();                                          \
        CHECK(to != NULL);                                             \
        if (to) {                                                      \
            call;                                                      \
            rewind(to);                                                \
            written[fread(written, 1, sizeof written - 1, to)] = '\0'; \
            fclose(to);                                                \
        }                                                              \
    } while (0)

static void test_text_is_never_markup(void)
{
    WRITTEN(murk_html_text(to, "<b a=\"1\" c='2'>&amp;"));
    CHECK_TEXT(written, "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;");
    WRITTEN(murk_html_text(to, "Höhe 中 \xf0\x9f\x8c\xab\n"));
    CHECK_TEXT(written, "Höhe 中 \xf0\x9f\x8c\xab\n");
    WRITTEN(murk_html_text(to, NULL));
    CHECK_TEXT(written, "");
}

static void test_what_is_no_text_is_replaced(void)
{
    static const char *const bad[] = {"\x01",
                                      "\x7f",
                                      "\xff",
                                      "\xc0",
                                      "\xe4",
                                      "\xed\xa0\x80" /* a surrogate */,
                                      "\xf4\x90\x80\x80" /* beyond */,
                                      "\xe0\x80\xbc" /* overlong '<' */};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        WRITTEN(murk_html_text(to, bad[i]));
        CHECK(strncmp(written, "\xef\xbf\xbd", 3) == 0);
        CHECK(strlen(written) == 3 * strlen(bad[i]));
    }
}

static void test_base64(void)
{
    static const char *const known[][2] = {{"", ""},
                                           {"f", "Zg=="},
                                           {"fo", "Zm8="},
                                           {"foo", "Zm9v"},
                                           {"foob", "Zm9vYg=="},
                                           {"fooba", "Zm9vYmE="},
                                           {"foobar", "Zm9vYmFy"}};
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
        WRITTEN(murk_html_base64(to, known[i][0], strlen(known[i][0])));
        CHECK_TEXT(written, known[i][1]);
    }
}

/* The hash of an example in the policy's specification (W3C, CSP Level 3). */
static void test_hash(void)
{
    static const char text[] = "alert('Hello, world.');";
    char hash[MURK_HTML_HASH_SIZE];
    murk_html_hash(hash, text, strlen(text));
    CHECK_TEXT(hash, "sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng=");
}

static void test_numbers(void)
{
    /* Plain numbers with five digits, and a dash for a missing one. */
    WRITTEN(murk_html_number(to, 30423));
    CHECK_TEXT(written, "30423");
    WRITTEN(murk_html_number(to, 0.123456789));
    CHECK_TEXT(written, "0.12346");
    WRITTEN(murk_html_number(to, (double)NAN));
    CHECK_TEXT(written, "\xe2\x80\x93");
    WRITTEN(murk_html_estimate(to, 1.23456, 0.0234));
    CHECK_TEXT(written, "1.235 \xc2\xb1 0.023");
    /* Large and small numbers, and estimates with errors, as powers of ten. */
    WRITTEN(murk_html_number(to, 2.30024e13));
    CHECK_TEXT(written, "2.3002\xc2\xb7"
                        "10\xc2\xb9\xc2\xb3");
    WRITTEN(murk_html_number(to, -1.5e-7));
    CHECK_TEXT(written, "-1.5\xc2\xb7"
                        "10\xe2\x81\xbb\xe2\x81\xb7");
    WRITTEN(murk_html_power(to, 1e5, 5));
    CHECK_TEXT(written, "10\xe2\x81\xb5");
    WRITTEN(murk_html_estimate(to, 890420387029321.25, 15429865000838.934));
    CHECK_TEXT(written, "(8.90 \xc2\xb1 0.15)\xc2\xb7"
                        "10\xc2\xb9\xe2\x81\xb4");
    /* Errors have two digits, and values end at the same digit. */
    WRITTEN(murk_html_estimate(to, 10397, 213));
    CHECK_TEXT(written, "10400 \xc2\xb1 210");
    WRITTEN(murk_html_estimate(to, 0.5, 0.0998));
    CHECK_TEXT(written, "0.50 \xc2\xb1 0.10");
    /* Extreme values stay short, and an error of 0 is left out. */
    WRITTEN(murk_html_estimate(to, 0, 3e-320));
    CHECK_TEXT(written, "(0.0 \xc2\xb1 3.0)\xc2\xb7"
                        "10\xe2\x81\xbb\xc2\xb3\xc2\xb2\xe2\x81\xb0");
    WRITTEN(murk_html_estimate(to, 1e300, 1e-300));
    CHECK(strlen(written) < 60);
    WRITTEN(murk_html_estimate(to, 2, 0));
    CHECK_TEXT(written, "2");
    WRITTEN(murk_html_share(to, 0.91238, 0.00219));
    CHECK_TEXT(written, "91.24 \xc2\xb1 0.22 %");
}

int main(void)
{
    test_text_is_never_markup();
    test_what_is_no_text_is_replaced();
    test_base64();
    test_hash();
    test_numbers();
    return check_done();
}
