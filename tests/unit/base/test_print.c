/* Lines for people: where they are broken, where they go on, and that nothing
 * of a name reaches a terminal as a command. Nothing here is random. */
#include "base/print.h"
#include "check.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char name[64];
static int terminal = -1;

/* Standard output goes to a file until shown() reads it. */
static void begin(void)
{
    fflush(stdout);
    terminal = dup(STDOUT_FILENO);
    CHECK(freopen(name, "w", stdout) != NULL);
}

static const char *shown(void)
{
    static char text[4096];
    fflush(stdout);
    dup2(terminal, STDOUT_FILENO);
    close(terminal);
    FILE *file = fopen(name, "r");
    const size_t n = file ? fread(text, 1, sizeof text - 1, file) : 0;
    text[n] = '\0';
    if (file) {
        fclose(file);
    }
    return text;
}

/* n letters, "aaaa" */
static const char *word(char letter, size_t n)
{
    static char text[2][200];
    static int turn;
    turn = !turn;
    memset(text[turn], letter, n);
    text[turn][n] = '\0';
    return text[turn];
}

static void test_lines_of_80_columns_stay(void)
{
    begin();
    murk_print("label       %s %s\n", word('a', 30), word('b', 37)); /* 80 */
    char want[200];
    snprintf(want, sizeof want, "label       %s %s\n", word('a', 30),
             word('b', 37));
    CHECK_TEXT(shown(), want);
    CHECK(strlen(want) == 81);
}

static void test_longer_lines_go_on_under_their_text(void)
{
    char want[300];
    begin();
    murk_print("label       %s %s\n", word('a', 30), word('b', 38)); /* 81 */
    snprintf(want, sizeof want, "label       %s\n            %s\n",
             word('a', 30), word('b', 38));
    CHECK_TEXT(shown(), want);
    begin();
    murk_print("    %s %s\n", word('a', 40), word('b', 40));
    snprintf(want, sizeof want, "    %s\n    %s\n", word('a', 40),
             word('b', 40));
    CHECK_TEXT(shown(), want);
    begin(); /* neither blanks nor a label before it */
    murk_print("%s %s\n", word('a', 40), word('b', 40));
    snprintf(want, sizeof want, "%s\n  %s\n", word('a', 40), word('b', 40));
    CHECK_TEXT(shown(), want);
    begin(); /* a word that no line holds has a line of its own */
    murk_print("label       %s end\n", word('a', 90));
    snprintf(want, sizeof want, "label       %s\n            end\n",
             word('a', 90));
    CHECK_TEXT(shown(), want);
}

static void test_rows_of_tables_leave_no_blanks_behind(void)
{
    char want[300];
    begin();
    murk_print("            %s  %s  1\n", word('a', 40), word('b', 40));
    snprintf(want, sizeof want, "            %s\n            %s  1\n",
             word('a', 40), word('b', 40));
    CHECK_TEXT(shown(), want);
}

static void test_a_line_is_put_together(void)
{
    begin();
    murk_print("one ");
    murk_print("two\nthree");
    murk_print("\n");
    CHECK_TEXT(shown(), "one two\nthree\n");
}

static void test_names_are_escaped(void)
{
    begin();
    murk_print("name  %s, ", "a\033[2J\nb");
    murk_print("%s\n", "c\rd\xc2\x9b");
    CHECK_TEXT(shown(), "name  a\\x1b[2J\\nb, c\\rd\\xc2\\x9b\n");
}

static void test_json_means_the_same(void)
{
    begin();
    murk_print_json(
        "{\n\t\"a\": \"\x7f\xc2\x9b \xc3\xb6 \xe2\x80\xae\xff\"\n}");
    CHECK_TEXT(shown(), "{\n\t\"a\": \"\\u007f\\u009b \xc3\xb6 "
                        "\\u202e\\ufffd\"\n}\n");
    begin();
    murk_print_json("{}\n");
    CHECK_TEXT(shown(), "{}\n");
}

int main(void)
{
    snprintf(name, sizeof name, "test_print.tmp.%ld", (long)getpid());
    test_lines_of_80_columns_stay();
    test_longer_lines_go_on_under_their_text();
    test_rows_of_tables_leave_no_blanks_behind();
    test_a_line_is_put_together();
    test_names_are_escaped();
    test_json_means_the_same();
    remove(name);
    return check_done();
}
