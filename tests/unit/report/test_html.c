/* What pages are written with: text that cannot become markup, base64 (RFC
 * 4648, 10), hashes of a policy. Nothing here is random. */
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

int main(void)
{
    test_text_is_never_markup();
    test_what_is_no_text_is_replaced();
    test_base64();
    test_hash();
    return check_done();
}
