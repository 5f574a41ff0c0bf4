/* The validation harness gives the verdicts it should: it passes what is
 * within the limit, and refuses a value that is off, a twin that is not, a run
 * without checks, errors too large for no reason, and light that is lost.
 * Errors come down to required, and a joined run is the whole one.
 * Deterministic but for one traced slab, whose only z-test has a 1e-3 chance of
 * a false alarm. */
#include "check.h"
#include "scores.h"
#include "validation.h"
#include "worlds.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

static const validation_settings quick = {
    .is_quick = true, .threads = 2, .seed = 1};
static const validation_settings nightly = {.threads = 2, .seed = 2};

static void add(validation *v, const char *is_wrong, double value)
{
    validation_check(v, "made up", "nobody", is_wrong,
                     &(validation_reference){"one", 1, 0},
                     (murk_estimate){value, .01}, 1000);
}

static void test_verdicts(void)
{
    validation *v = validation_create(&quick);
    validation_group(v, "made");
    CHECK(!validation_passed(v)); /* nothing was checked */
    add(v, NULL, 1.02);
    CHECK(validation_passed(v)); /* 2 of 3.29 sigmas */
    add(v, "wrong", 1.2);
    CHECK(validation_passed(v));
    add(v, "not wrong enough", 1.02);
    CHECK(!validation_passed(v));
    validation_destroy(v);
    v = validation_create(&quick);
    add(v, NULL, 1.04);
    CHECK(!validation_passed(v));
    validation_destroy(v);
    v = validation_create(&quick);
    add(v, NULL, NAN);
    CHECK(!validation_passed(v));
    validation_destroy(v);
}

static void test_digits(void)
{
    CHECK_NEAR(validation_half_digit_of("1.738497e+00"), 5e-7, 1e-20);
    CHECK_NEAR(validation_half_digit_of("2.516851e-04"), 5e-11, 1e-24);
    CHECK_NEAR(validation_half_digit_of(".09739"), 5e-6, 1e-19);
    CHECK_NEAR(validation_half_digit_of("3"), .5, 0);
}

/* Half of the light comes through the fog unscattered; no other light comes
 * through if the albedo is 0 or a photon has one event only. */
static void trace(validation *v, double albedo, uint32_t events_max)
{
    /* The case of one quantity. */
    static const score_of through = {.kind = SCORE_ESCAPED, .side = 1};
    const scores score = {&through, 1};
    const validation_reference half = {"through", .5, 0};
    /* A beam through fog of optical depth ln 2. */
    const murk_source light = test_beam(murk_vec(0, 0, 0), murk_vec(0, 0, 1));
    const murk_medium fog = test_medium(log(2), albedo, 0);
    const murk_region region = test_everywhere(0);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-1, -1, 0}, {1, 1, 1}}, false},
                      .lights = &light,
                      .n_lights = 1,
                      .media = &fog,
                      .n_media = 1,
                      .regions = &region,
                      .n_regions = 1});
    validation_trace(v, &(validation_case){.name = "half",
                                           .source = "ln 2",
                                           .world = &w.world,
                                           .reference = &half,
                                           .quantities = 1,
                                           .score = scores_add,
                                           .context = &score,
                                           .events_max = events_max});
    test_world_unmade(&w);
}

static size_t read_all(FILE *file, char *text, size_t size)
{
    rewind(file);
    const size_t n = fread(text, 1, size - 1, file);
    text[n] = '\0';
    return n;
}

static void test_traced_and_joined(void)
{
    /* Trace a case, and write the report and the CSV file. */
    static char whole[8192], joined[8192];
    char path[] = "/tmp/murk-validation-XXXXXX";
    validation *v = validation_create(&quick);
    validation_group(v, "fog");
    trace(v, 0, 0);
    CHECK(validation_passed(v));
    FILE *text = tmpfile();
    FILE *csv = fdopen(mkstemp(path), "w");
    validation_markdown(v, text);
    validation_csv(v, csv);
    fclose(csv);
    CHECK(read_all(text, whole, sizeof whole) > 0);
    fclose(text);
    CHECK_MENTIONS(whole, "| half | through | 0.5 | 0.");
    validation_destroy(v);

    /* A report joined from the CSV file is the same. */
    v = validation_create(&quick);
    validation_join(v, path);
    unlink(path);
    text = tmpfile();
    validation_markdown(v, text);
    read_all(text, joined, sizeof joined);
    fclose(text);
    CHECK_TEXT(joined, whole);
    validation_destroy(v);
}

static void read_markdown(const validation *v, char *text, size_t size)
{
    FILE *file = tmpfile();
    validation_markdown(v, file);
    read_all(file, text, size);
    fclose(file);
}

static void test_short_rows_need_a_reason(void)
{
    /* In the quick form a row that is too uncertain is marked and passes. */
    static char text[8192];
    validation *v = validation_create(&quick);
    validation_group(v, "made");
    add(v, NULL, 1.02);
    validation_mark_short(v, NULL);
    add(v, NULL, .98);
    read_markdown(v, text, sizeof text);
    CHECK_MENTIONS(text, "| 1.02 | 1.0e-02 * |");
    CHECK_MENTIONS(text, "| 0.98 | 1.0e-02 |");
    CHECK(validation_passed(v));
    validation_destroy(v);

    /* In the nightly form the row passes with a reason, and fails without
     * one. */
    v = validation_create(&nightly);
    validation_group(v, "made");
    add(v, NULL, 1.02);
    validation_mark_short(v, "it would take a week");
    read_markdown(v, text, sizeof text);
    CHECK_MENTIONS(text, "| 1.02 | 1.0e-02 * |");
    CHECK_MENTIONS(text, "* made, made up: it would take a week");
    CHECK(validation_passed(v));
    add(v, NULL, 1.02);
    validation_mark_short(v, NULL);
    read_markdown(v, text, sizeof text);
    CHECK_MENTIONS(text, "| 1.02 | 1.0e-02 **short** |");
    CHECK(!validation_passed(v));
    validation_destroy(v);
}

/* 3.1 sigmas are within the limit of one check, 3.29, but not within 3. */
static void test_rows_may_have_limits_of_their_own(void)
{
    validation *v = validation_create(&nightly);
    add(v, NULL, 1.031);
    CHECK(validation_passed(v));
    validation_mark_limit(v, 3);
    CHECK(!validation_passed(v));
    validation_mark_limit(v, 5); /* none is wider than the run's */
    CHECK(validation_passed(v));
    add(v, NULL, 1.05);
    validation_mark_limit(v, 5.5);
    CHECK(!validation_passed(v));
    validation_destroy(v);
}

static void test_bounds(void)
{
    validation *v = validation_create(&nightly);
    add(v, NULL, .5); /* 50 sigmas below */
    CHECK(!validation_passed(v));
    validation_mark_bound(v);
    CHECK(validation_passed(v));
    add(v, "no farther off than a bound lets it be", .5);
    validation_mark_bound(v);
    CHECK(!validation_passed(v));
    validation_destroy(v);
    v = validation_create(&nightly);
    add(v, NULL, 1.0001); /* a hundredth of a sigma above */
    validation_mark_bound(v);
    CHECK(!validation_passed(v));
    validation_destroy(v);
}

/* Writes the rows to a file and unmakes them. */
static void write_part(validation *v, char *path)
{
    FILE *csv = fdopen(mkstemp(path), "w");
    validation_csv(v, csv);
    fclose(csv);
    validation_destroy(v);
}

static void test_joined_rows_keep_what_is_known(void)
{
    static char text[8192];
    char a[] = "/tmp/murk-validation-XXXXXX",
         b[] = "/tmp/murk-validation-XXXXXX";
    validation *v = validation_create(&quick);
    validation_group(v, "low");
    add(v, NULL, 1.01);
    write_part(v, a);
    validation_settings other = nightly;
    other.seed = quick.seed;
    v = validation_create(&other);
    validation_group(v, "high");
    add(v, NULL, .5);
    validation_mark_bound(v);
    add(v, NULL, 1.029);
    validation_mark_limit(v, 3);
    validation_mark_short(v, "it would take a week");
    write_part(v, b);

    v = validation_create(&nightly); /* of another seed, which it drops */
    validation_join(v, a);
    validation_join(v, b);
    CHECK(validation_passed(v));
    read_markdown(v, text, sizeof text);
    CHECK_MENTIONS(text, "references, nightly and quick form");
    CHECK_MENTIONS(text, "Seed 1.");
    CHECK_MENTIONS(text, "## low, quick form");
    CHECK_MENTIONS(text, "## high, nightly form");
    CHECK_MENTIONS(text, "at most 1 | 0.5 |");
    CHECK_MENTIONS(text, "(limit 3)");
    CHECK_MENTIONS(text, "* high, made up: it would take a week");
    validation_destroy(v);
    unlink(a);
    unlink(b);
}

static void test_unsound_stays_so_when_joined(void)
{
    char path[] = "/tmp/murk-validation-XXXXXX";
    validation *v = validation_create(&quick);
    validation_group(v, "fog");
    trace(v, .5, 1);
    add(v, NULL, 1);
    write_part(v, path);
    v = validation_create(&quick);
    validation_join(v, path);
    unlink(path);
    static char text[8192];
    read_markdown(v, text, sizeof text);
    CHECK_MENTIONS(text, "**unsound**");
    CHECK_MENTIONS(text, "whose ledger is off: 1.");
    CHECK(!validation_passed(v));
    validation_destroy(v);
}

static void test_errors_wanted(void)
{
    validation *v = validation_create(&quick);
    CHECK_NEAR(validation_error_wanted(v, .5, 0), 2e-3, 1e-18);
    CHECK_NEAR(validation_error_wanted(v, 1e-3, 0), 1.2e-4, 1e-19);
    CHECK_NEAR(validation_error_wanted(v, 1e-3, .1), 1.2e-5, 1e-20);
    validation_destroy(v);
}

static void test_lost_light_is_noticed(void)
{
    validation *v = validation_create(&quick);
    validation_group(v, "fog");
    trace(v, 0, 1);
    CHECK(validation_passed(v));
    trace(v, .5, 1); /* what scatters has no event left */
    CHECK(!validation_passed(v));
    validation_destroy(v);
}

int main(void)
{
    test_verdicts();
    test_digits();
    test_short_rows_need_a_reason();
    test_rows_may_have_limits_of_their_own();
    test_bounds();
    test_errors_wanted();
    test_traced_and_joined();
    test_lost_light_is_noticed();
    test_joined_rows_keep_what_is_known();
    test_unsound_stays_so_when_joined();
    return check_done();
}
