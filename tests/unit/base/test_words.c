/* Which word was meant, and how a word of the user is shown. Nothing here is
 * random. */
#include "base/words.h"
#include "check.h"

static const char *const KNOWN[] = {
    "albedo", "phase", NULL, "grid", "vdb", "", "z_m", "extinction_per_m"};
#define N_KNOWN (sizeof KNOWN / sizeof *KNOWN)

static void test_what_was_meant(void)
{
    static const struct {
        const char *word, *meant; /* NULL: none */
    } words[] = {
        {"", NULL},
        {"albedo", "albedo"},
        {"labedo", "albedo"},  /* two neighbours in the wrong order: one */
        {"albdo", "albedo"},   /* one left out */
        {"albbedo", "albedo"}, /* one too many */
        {"albida", "albedo"},  /* two of six letters wrong */
        {"ilbida", NULL},      /* three of six */
        {"odebla", NULL},      /* the same letters */
        {"phsae", "phase"},    /* of five, one letter may be wrong */
        {"hpsae", NULL},       /* two pairs */
        {"gird", "grid"},      /* of three or four, one */
        {"girt", NULL},
        {"hpase", "phase"}, /* at either end */
        {"phaes", "phase"},
        {"vbd", "vdb"},
        {"vd", "vdb"}, /* one of two, too */
        {"z", NULL},   /* two of one letter is too far */
        {"x", NULL},
        {"zm", "z_m"},
        {"ext", "extinction_per_m"}, /* its beginning, from three letters on */
        {"ex", NULL},
        {"extinction", "extinction_per_m"},
        {"xtinction", NULL},
        {"extinctoin_prem", "extinction_per_m"},
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; ++i) {
        const char *meant = murk_words_meant(words[i].word, KNOWN, N_KNOWN);
        const char *want = words[i].meant;
        CHECK_TEXT(meant ? meant : "none", want ? want : "none");
    }
    CHECK(!murk_words_meant("albedo", KNOWN, 0));
    CHECK_TEXT(murk_words_meant("albedo", KNOWN, 1), "albedo");
    CHECK(!murk_words_meant("phase", KNOWN, 1));
}

/* 64 letters are compared, 65 are not. */
static void test_the_longest(void)
{
    char word[66], other[67];
    memset(word, 'a', 64);
    word[64] = '\0';
    memcpy(other, word, 65);
    other[0] = 'b';
    const char *const known[] = {other};
    CHECK(murk_words_meant(word, known, 1) == other);
    memset(word, 'a', 65);
    word[65] = '\0';
    CHECK(!murk_words_meant(word, known, 1));
    memset(other, 'a', 65);
    other[0] = 'b';
    other[65] = '\0';
    word[64] = '\0';
    CHECK(!murk_words_meant(word, known, 1));
}

static void test_what_is_shown(void)
{
    char out[8];
    murk_words_show(out, sizeof out, "");
    CHECK_TEXT(out, "");
    murk_words_show(out, sizeof out, "1234567");
    CHECK_TEXT(out, "1234567");
    murk_words_show(out, sizeof out, "12345678");
    CHECK_TEXT(out, "1234...");
    murk_words_show(out, sizeof out, "a\nb");
    CHECK_TEXT(out, "a\\nb");
    murk_words_show(out, sizeof out, "123\n56789");
    CHECK_TEXT(out, "123...");
}

int main(void)
{
    test_what_was_meant();
    test_the_longest();
    test_what_is_shown();
    return check_done();
}
