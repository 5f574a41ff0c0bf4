/* What is said before a plan in an unknown environment: when, how much work it
 * foretells, and the alternatives that it names. The seed is fixed: nothing
 * here is random. */
#include "base/log.h"
#include "corridor.h"

#include <stdlib.h>
#include <string.h>

#define STARTS 3
#define COUNT  3

static char note[1024];
static int notes;

static void keep_note(const char *where, const char *text)
{
    if (strcmp(where, "placement.knowledge") == 0) {
        snprintf(note, sizeof note, "%s", text);
        ++notes;
    }
}

static made planned(const char *override)
{
    const char *const list[] = {"placement.knowledge=unknown",
                                "placement.restarts=3",
                                "placement.memory_mb=0",
                                "sensors.count=3",
                                NEAR,
                                override,
                                NULL};
    note[0] = 0;
    notes = 0;
    const murk_warn_sink before = murk_warn_to(keep_note);
    made m = explore_with(CORRIDOR, list, 2);
    (void)murk_warn_to(before);
    CHECK_TEXT(m.err.text, "");
    return m;
}

/* A start of `best` looks from each place for each sensor, some sweeps long. */
static void test_best_is_forecast(void)
{
    made m = planned("placement.method=best");
    CHECK(notes == 1);
    CHECK_MENTIONS(note, "unknown with method: best looks again for each row");
    CHECK_MENTIONS(note, "memory_mb: 1 holds all rows");
    CHECK_MENTIONS(note, "with knowledge: known, 17 queries");
    CHECK_MENTIONS(note, "method: greedy or spoq, or fewer restarts");
    CHECK_MENTIONS(note, "with 3 starts (at most 3 are made)");
    const char *about = strstr(note, "at most about ");
    const double queries =
        about ? strtod(about + strlen("at most about "), NULL) : 0;
    CHECK_NEAR(queries, STARTS * 4 * COUNT * SITES, 0.05 * queries);
    /* in a place so small the search ends sooner, never later */
    printf("foretold %g queries, made %g\n", queries, (double)m.plan.queries);
    CHECK((double)m.plan.queries <= queries &&
          (double)m.plan.queries > queries / 10);
    const char *rays = strstr(note, "queries, ");
    const double each =
        (rays ? strtod(rays + strlen("queries, "), NULL) : 0) / queries;
    /* Only the first look follows all sightlines. */
    const double was = (double)m.plan.shadow_rays / (double)m.plan.looks;
    printf("foretold %g rays a look, made %g\n", each, was);
    CHECK(was > 0 && each >= was);
    unmake(&m);
}

/* What takes little is not spoken of. */
static void test_what_is_quick_is_not_forecast(void)
{
    static const char *const quick[] = {
        "placement.method=greedy", "placement.method=spoq", "sensors.count=1",
        "placement.knowledge=known", "placement.memory_mb=1024"};
    for (size_t i = 0; i < sizeof quick / sizeof *quick; ++i) {
        made m = planned(quick[i]);
        CHECK(notes == 0);
        unmake(&m);
    }
}

int main(void)
{
    test_best_is_forecast();
    test_what_is_quick_is_not_forecast();
    return check_done();
}
