/* The command line that results keep: words quoted for a POSIX shell (2.2), and
 * what results do not depend on left out, however it is spelled. Nothing here
 * is random. */
#include "app/command_line.h"
#include "base/utf8.h"
#include "check.h"

#include <stdlib.h>
#include <string.h>

static void check_word(const char *word, const char *want)
{
    char *got = murk_utf8_shell_word(word);
    CHECK(got != NULL);
    CHECK_TEXT(got ? got : "", want);
    free(got);
}

static void test_words_are_quoted_where_they_must(void)
{
    check_word("scenes/a_b-1.yaml", "scenes/a_b-1.yaml");
    check_word("--set=media.fog.mor_m=50", "--set=media.fog.mor_m=50");
    check_word("", "''");
    check_word("a b", "'a b'");
    check_word("~", "'~'");
    check_word("it's", "'it'\\''s'");
    check_word("$(rm)`x`\"\\", "'$(rm)`x`\"\\'");
    check_word("H\xc3\xb6he", "'H\xc3\xb6he'");
    check_word("a\nb", "$'a\\012b'");
    check_word("\xff'\\\xc3\xb6", "$'\\377\\047\\134\xc3\xb6'");
}

static void check_line(const char *const *argv, const char *want)
{
    char *words[16];
    murk_options options;
    int n = 0;
    while (argv[n]) {
        words[n] = strdup(argv[n]);
        ++n;
    }
    CHECK(murk_options_parse(&options, n, words, NULL) == MURK_OK);
    CHECK_TEXT(options.typed, want);
    murk_options_release(&options);
    while (n > 0) {
        free(words[--n]);
    }
}

static void test_what_changes_no_result_is_left_out(void)
{
    check_line((const char *const[]){"/usr/bin/murk", "place", "a.yaml", "-o",
                                     "out", "--seed", "3", "-j2", "--quiet",
                                     NULL},
               "murk place a.yaml --seed 3");
    check_line((const char *const[]){"murk", "-j", "2", "--out=x y",
                                     "--threads=4", "fit", "a b.yaml",
                                     "--progress", "never", "-q", "--free",
                                     "a,b", "--format=json", NULL},
               "murk fit 'a b.yaml' --free a,b");
    check_line((const char *const[]){"murk", "check", "-q", "--", "--", NULL},
               "murk check -- --");
    check_line((const char *const[]){"murk", "trace", "-oout", "a.yaml",
                                     "--set", "-o=1", NULL},
               "murk trace a.yaml --set -o=1");
    check_line((const char *const[]){"murk", "--version", NULL},
               "murk --version");
}

int main(void)
{
    test_words_are_quoted_where_they_must();
    test_what_changes_no_result_is_left_out();
    return check_done();
}
