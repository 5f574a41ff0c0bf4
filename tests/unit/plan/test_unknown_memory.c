/* Plans with memory for no rows, for some rows and for all. In an unknown
 * environment sensors, bound, evaluations and queries are the same, and those
 * of a search in a known environment without branch and bound; only the looks
 * and the sightlines differ, and they do not depend on threads. Fixed seeds:
 * nothing here is random. */
#include "corridor.h"

#include <string.h>

#define KNOWN   "placement.knowledge=known"
#define UNKNOWN "placement.knowledge=unknown"

static made planned(const char *knowledge, const char *memory,
                    const char *method, const char *detection, unsigned threads)
{
    const char *const list[] = {knowledge,
                                "placement.restarts=5",
                                "placement.nodes=0",
                                "sensors.count=4",
                                NEAR,
                                memory,
                                method,
                                detection,
                                NULL};
    made m = explore_with(CORRIDOR, list, threads);
    CHECK_TEXT(m.err.text, "");
    return m;
}

static bool same_plan(const made *a, const made *b)
{
    const murk_place_result *x = &a->plan.place, *y = &b->plan.place;
    return x->count == y->count && x->value == y->value &&
           memcmp(x->sensor, y->sensor, x->count * sizeof *x->sensor) == 0;
}

static void test_memory_changes_looks_alone(const char *method,
                                            const char *detection)
{
    static const char *const memory[] = {"placement.memory_mb=0",
                                         "placement.memory_mb=0.002",
                                         "placement.memory_mb=1024"};
    made first = planned(UNKNOWN, memory[0], method, detection, 2);
    const murk_place_result *x = &first.plan.place;
    CHECK(first.plan.looks <= first.plan.queries);
    uint64_t looks = first.plan.looks, rays = first.plan.shadow_rays;
    for (size_t k = 0; k < 3; ++k) {
        made of[2] = {planned(UNKNOWN, memory[k], method, detection, 1),
                      planned(UNKNOWN, memory[k], method, detection, 2)};
        for (size_t i = 0; i < 2; ++i) {
            const murk_place_result *y = &of[i].plan.place;
            CHECK(same_plan(&first, &of[i]));
            CHECK(x->upper == y->upper && x->ceiling == y->ceiling);
            CHECK(x->evaluations == y->evaluations);
            CHECK(first.plan.queries == of[i].plan.queries);
        }
        /* The more memory, the fewer looks. */
        CHECK(of[0].plan.looks == of[1].plan.looks);
        CHECK(of[0].plan.shadow_rays == of[1].plan.shadow_rays);
        CHECK(k == 0 ||
              (of[0].plan.looks < looks && of[0].plan.shadow_rays < rays));
        CHECK(k < 2 || of[0].plan.looks == SITES);
        looks = of[0].plan.looks;
        rays = of[0].plan.shadow_rays;
        unmake(&of[0]);
        unmake(&of[1]);
    }
    /* The known environment leads to the same plan, with rows in a scratch file
     * and in memory. */
    for (size_t k = 0; k < 3; ++k) {
        made known = planned(KNOWN, memory[k], method, detection, 2);
        CHECK(same_plan(&first, &known));
        CHECK(known.plan.queries == SITES && known.plan.looks == SITES);
        unmake(&known);
    }
    unmake(&first);
}

int main(void)
{
    test_memory_changes_looks_alone("placement.method=best",
                                    "placement.redundancy=1");
    test_memory_changes_looks_alone("placement.method=spoq",
                                    "placement.redundancy=2");
    test_memory_changes_looks_alone("placement.method=best",
                                    "placement.detection=independent");
    return check_done();
}
