/* Warnings and notes on standard error: one line each, once in a run of the
 * program. */
#include "base/log.h"

#include "check.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

static char printed[65536];

/* What `say` prints on standard error. */
static const char *said_by(void (*say)(void))
{
    (void)fflush(stderr);
    FILE *file = tmpfile();
    const int before = dup(STDERR_FILENO);
    CHECK(file && before >= 0 && dup2(fileno(file), STDERR_FILENO) >= 0);
    say();
    (void)fflush(stderr);
    (void)dup2(before, STDERR_FILENO);
    (void)close(before);
    rewind(file);
    printed[fread(printed, 1, sizeof printed - 1, file)] = '\0';
    (void)fclose(file);
    return printed;
}

static void say_four_things(void)
{
    for (int i = 0; i < 3; ++i) {
        murk_warn("a.yaml:3", "lamp %d is off", 1);
        murk_warn("a.yaml:4", "lamp %d is off", 1);
        murk_warn("a.yaml:3", "lamp %d is off", 2);
        murk_note("a.yaml:3", "lamp %d is off", 1);
    }
}

static void test_each_line_stands_once(void)
{
    CHECK(strcmp(said_by(say_four_things),
                 "murk: warning: a.yaml:3: lamp 1 is off\n"
                 "murk: warning: a.yaml:4: lamp 1 is off\n"
                 "murk: warning: a.yaml:3: lamp 2 is off\n"
                 "murk: note: a.yaml:3: lamp 1 is off\n") == 0);
    CHECK(strcmp(said_by(say_four_things), "") == 0);
}

static void say_many(void)
{
    for (int i = 0; i < 1000; ++i) {
        murk_warn("", "%d", i);
    }
}

/* More lines than are remembered are all printed, and the latest stay so. */
static void test_many_lines_are_printed(void)
{
    size_t lines = 0;
    for (const char *c = said_by(say_many); *c; ++c) {
        lines += *c == '\n';
    }
    CHECK(lines == 1000);
}

static int heard;

static void hear(const char *where, const char *text)
{
    (void)where;
    (void)text;
    ++heard;
}

/* Who asked to be told of warnings is told of every one. */
static void test_another_sink_gets_all(void)
{
    const murk_warn_sink before = murk_warn_to(hear);
    CHECK(strcmp(said_by(say_four_things), "") == 0);
    CHECK(heard == 12);
    const bool was_silent = murk_warn_quiet(true);
    say_four_things();
    CHECK(heard == 12);
    CHECK(murk_warn_quiet(was_silent));
    murk_warn_to(before);
}

int main(void)
{
    test_each_line_stands_once();
    test_many_lines_are_printed();
    test_another_sink_gets_all();
    return check_done();
}
