/* The progress line fits its window at any width, and says percent, count,
 * unit, elapsed and remaining time. */
#include "base/progress_line.h"
#include "check.h"

#include <math.h>
#include <string.h>

#define SIZE 512

static const murk_progress_facts half = {.step = "trace",
                                         .unit = "photons",
                                         .text = "",
                                         .done = 500000,
                                         .total = 1000000,
                                         .elapsed_s = 30,
                                         .parts_left_s = NAN};

static bool says(const murk_progress_facts *facts, size_t columns,
                 const char *text)
{
    char line[SIZE];
    murk_progress_line(line, sizeof line, facts, columns);
    return strstr(line, text) != NULL;
}

static void test_all_is_said(void)
{
    static const char *const texts[] = {"trace ", "[##########..........]",
                                        " 50 %", "500000 of 1.00e6 photons",
                                        "30 s, 30 s left"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
        CHECK(says(&half, 79, texts[i]));
    }
}

static void test_no_line_is_wider_than_its_window(void)
{
    murk_progress_facts long_one = half;
    long_one.part = 9999;
    long_one.parts = 10000;
    long_one.parts_left_s = 1e6;
    long_one.done = UINT64_MAX / 3;
    long_one.total = UINT64_MAX;
    long_one.text = "start 1, light 2, step 3: chi2 1234.56";
    for (size_t columns = 1; columns < 200; ++columns) {
        char line[SIZE];
        murk_progress_line(line, sizeof line, &long_one, columns);
        CHECK(strlen(line) <= columns);
        murk_progress_line(line, sizeof line, &half, columns);
        CHECK(strlen(line) <= columns);
    }
    CHECK(says(&long_one, 199, "all: 12 days left"));
    CHECK(says(&long_one, 199, "chi2 1234.56"));
}

/* The bar goes first, the count later. */
static void test_minor_lines_are_dropped(void)
{
    CHECK(!says(&half, 60, "[##"));
    CHECK(says(&half, 60, "500000 of 1.00e6 photons"));
    CHECK(says(&half, 60, "30 s left"));
}

static void test_what_is_not_known_is_not_said(void)
{
    murk_progress_facts unknown = half;
    unknown.total = 0;
    CHECK(!says(&unknown, 79, "%"));
    CHECK(!says(&unknown, 79, "left"));
    CHECK(says(&unknown, 79, "500000 photons  30 s"));
    unknown.unit = "";
    CHECK(says(&unknown, 79, "trace  30 s"));
    murk_progress_facts too_many = half;
    too_many.done = 2000000; /* more than foretold */
    CHECK(says(&too_many, 79, "100 %"));
    CHECK(!says(&too_many, 79, "left"));
    murk_progress_facts none = half;
    none.done = 0;
    CHECK(!says(&none, 79, "left"));
}

static void test_a_sentence_has_no_bar(void)
{
    char line[SIZE];
    murk_progress_sentence(line, sizeof line, &half);
    CHECK(strcmp(line, "murk: trace: 50 %, 500000 of 1.00e6 photons, 30 s, 30 "
                       "s left") == 0);
}

int main(void)
{
    test_all_is_said();
    test_no_line_is_wider_than_its_window();
    test_minor_lines_are_dropped();
    test_what_is_not_known_is_not_said();
    test_a_sentence_has_no_bar();
    return check_done();
}
