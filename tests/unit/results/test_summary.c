/* Lines of the summary: they can be collected and shown later, and name the
 * times and the rows that are not shown. Nothing here is random. */
#include "check.h"
#include "results/summary.h"

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

static void print_two_lines(const void *of)
{
    murk_print("label       %s %s\n", word('a', 60), (const char *)of);
    murk_print("next\n");
}

static void test_collected_lines_are_those_shown(void)
{
    char want[200];
    begin();
    cJSON *lines = murk_print_collect(print_two_lines, "end\033");
    CHECK_TEXT(shown(), "");
    snprintf(want, sizeof want, "label       %s end\\x1b", word('a', 60));
    CHECK(cJSON_GetArraySize(lines) == 2);
    CHECK_TEXT(cJSON_GetArrayItem(lines, 0)->valuestring, want);
    /* Shown now, they are as if they had been shown at once. */
    begin();
    for (int i = 0; i < cJSON_GetArraySize(lines); ++i) {
        murk_print_line(cJSON_GetArrayItem(lines, i)->valuestring);
    }
    snprintf(want, sizeof want, "%s", shown());
    begin();
    print_two_lines("end\033");
    CHECK_TEXT(shown(), want);
    cJSON_Delete(lines);
}

static void test_times_of_what_took_time(void)
{
    const murk_run_facts run = {
        .load_s = .004, .trace_s = 1.25, .map_s = .005, .total_s = 3};
    begin();
    murk_print_time(&run, "bounds", 1.5);
    const char *text = shown();
    CHECK(strncmp(text,
                  "time        3.00 s: trace 1.25, maps 0.01, bounds 1.50"
                  "; memory ",
                  63) == 0);
    CHECK(strstr(text, "load") == NULL);
}

static void test_more_rows_than_are_shown(void)
{
    begin();
    murk_print_more(MURK_PRINTED_ROWS, NULL, "a.csv");
    CHECK_TEXT(shown(), "");
    begin();
    murk_print_more(MURK_PRINTED_ROWS + 3, "out", "a.csv");
    CHECK_TEXT(shown(), "            ... and 3 more in out/a.csv\n");
    begin();
    murk_print_more(MURK_PRINTED_ROWS + 1, NULL, "a.csv");
    CHECK_TEXT(shown(),
               "            ... and 1 more; -o DIR writes all to a.csv\n");
}

int main(void)
{
    snprintf(name, sizeof name, "test_summary.tmp.%ld", (long)getpid());
    test_collected_lines_are_those_shown();
    test_times_of_what_took_time();
    test_more_rows_than_are_shown();
    remove(name);
    return check_done();
}
