/* What the terminal says of a plan over conditions. Nothing here is random. */
#include "check.h"
#include "results/condition_results.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The line of the bound for a regret and its lower bound. */
static const char *bound_of(double regret, double lower)
{
    static char text[1024];
    char name[] = "/tmp/murk-over-XXXXXX";
    murk_scene_desc scene = {0};
    murk_conditions all = {.scene = &scene};
    const murk_condition_plans over = {.conditions = &all,
                                       .regret = regret,
                                       .regret_lower = lower,
                                       .regret_upper = 0.5};
    const int file = mkstemp(name), terminal = dup(STDOUT_FILENO);
    CHECK(file >= 0 && dup2(file, STDOUT_FILENO) >= 0);
    murk_print_regret_bound(&over, "sample");
    fflush(stdout);
    dup2(terminal, STDOUT_FILENO);
    close(terminal);
    const ssize_t n = pread(file, text, sizeof text - 1, 0);
    text[n > 0 ? n : 0] = '\0';
    close(file);
    unlink(name);
    for (char *c = text; *c; ++c) { /* one line, with single blanks */
        if (*c == '\n' || *c == ' ') {
            const size_t blanks = strspn(c, " \n");
            memmove(c + 1, c + blanks, strlen(c + blanks) + 1);
            *c = ' ';
        }
    }
    return text;
}

static void test_no_regret_is_said_to_be_below_0(void)
{
    CHECK_MENTIONS(bound_of(0.02, -0.0014),
                   "no plan has less than 0.0000 to the true optima on");
    CHECK_MENTIONS(bound_of(0.02, 0.0123), "no plan has less than 0.0123 on");
    CHECK_MENTIONS(bound_of(0.02, 0.02),
                   "no plan has less than 0.0200 (proven optimal) on");
}

int main(void)
{
    test_no_regret_is_said_to_be_below_0();
    return check_done();
}
