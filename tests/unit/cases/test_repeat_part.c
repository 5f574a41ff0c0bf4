/* Files of parts of repeated runs: the runs come back in every bit, from any
 * number of shards, in any order; and files with contents that no run can have
 * written are refused, although their checksums are right. */
#include "cases/repeat_part.h"

#include "base/log.h"
#include "check.h"
#include "photonmap/map_file.h"

#include <stdlib.h>
#include <unistd.h>

enum { PATH_SIZE = 128, ASKED = 8, SHARDS_MAX = 9 };

static char folder[] = "/tmp/murk-repeat-XXXXXX";

static char key[] = "murk: 1\nseed: 40\n";
static murk_scene_desc scene = {.whole_key = key, .seed = 40};
static const murk_stage stage = {.scene = &scene};
static murk_pose sensor[] = {{.type = 0, .position = {0.1, 1. / 3, 2}}};
static murk_plan_result plan = {
    .place = {.count = 1, .value = 3, .upper = 3, .whole = 4},
    .sensor = sensor,
    .has_held_out = true,
    .held_out = {0.7, 0.01}};
static const murk_repeat_first first = {.plan = &plan, .stage = &stage};

/* Runs of any figures; some have none. */
static murk_repeat make_runs(void)
{
    murk_repeat repeat = {.run = NULL};
    CHECK(!murk_repeat_begin(&repeat, &first, ASKED, NULL));
    for (uint32_t i = 1; i < ASKED; ++i) {
        const double x = 1. / (3 + i);
        repeat.run[i] = (murk_repeat_run){
            .seed = scene.seed + i,
            .sensors = i,
            .in_sample = x,
            .upper = x + 0x1p-52,
            .proven_optimal = i % 2 == 0,
            .held_out = {i == 3 ? NAN : x / 3, i == 3 ? NAN : x / 7},
            .plan = {i == 5 ? NAN : x / 9, i == 5 ? NAN : x / 11}};
    }
    return repeat;
}

static bool same_number(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

static bool same_run(const murk_repeat_run *a, const murk_repeat_run *b)
{
    return a->seed == b->seed && a->sensors == b->sensors &&
           a->proven_optimal == b->proven_optimal &&
           same_number(a->in_sample, b->in_sample) &&
           same_number(a->upper, b->upper) &&
           same_number(a->held_out.value, b->held_out.value) &&
           same_number(a->held_out.standard_error,
                       b->held_out.standard_error) &&
           same_number(a->plan.value, b->plan.value) &&
           same_number(a->plan.standard_error, b->plan.standard_error);
}

static const char *path_of(uint32_t number, uint32_t count)
{
    static char path[SHARDS_MAX][PATH_SIZE];
    snprintf(path[number - 1], PATH_SIZE, "%s/%u-of-%u", folder, number, count);
    return path[number - 1];
}

static void write_part(const murk_repeat *repeat, uint32_t number,
                       uint32_t count)
{
    const murk_shard shard = {number, count};
    CHECK(!murk_repeat_part_write(repeat, &first, shard, path_of(number, count),
                                  NULL));
}

/* Reads parts; *has_run[ASKED] tells which runs they have. */
static murk_status read_parts(murk_repeat *out, bool *has_run,
                              const char *const *path, size_t n,
                              murk_error *err)
{
    memset(has_run, false, ASKED);
    CHECK(!murk_repeat_begin(out, &first, ASKED, NULL));
    return murk_repeat_parts_read(out, has_run, &first, path, n, err);
}

/* All parts in falling order, the first one twice; then all but the second. */
static void test_runs_come_back(void)
{
    murk_repeat repeat = make_runs();
    for (uint32_t count = 1; count <= SHARDS_MAX; ++count) {
        const char *path[SHARDS_MAX + 1];
        bool has_run[ASKED];
        murk_repeat read = {.run = NULL};
        murk_error err = {0};
        for (uint32_t k = 0; k < count; ++k) {
            write_part(&repeat, count - k, count);
            path[k] = path_of(count - k, count);
        }
        path[count] = path[count - 1];
        CHECK(!read_parts(&read, has_run, path, count + 1, &err));
        CHECK_TEXT(err.text, "");
        for (size_t i = 1; i < ASKED; ++i) {
            CHECK(has_run[i] && same_run(&read.run[i], &repeat.run[i]));
        }
        murk_repeat_release(&read);
        /* Without the second part. */
        if (count > 2) {
            path[count - 2] = path[0];
            CHECK(!read_parts(&read, has_run, path, count, &err));
            for (size_t i = 1; i < ASKED; ++i) {
                CHECK(has_run[i] == ((i - 1) % count != 1));
            }
            murk_repeat_release(&read);
        }
    }
    murk_repeat_release(&repeat);
}

static murk_error refusal(const char *const *path, size_t n)
{
    bool has_run[ASKED];
    murk_repeat read = {.run = NULL};
    murk_error err = {0};
    CHECK(read_parts(&read, has_run, path, n, &err) != MURK_OK);
    murk_repeat_release(&read);
    return err;
}

/* Parts of another scene, plan or number of runs or shards; and a part that is
 * there twice with other figures. */
static void test_other_parts_are_refused(void)
{
    murk_repeat repeat = make_runs();
    const char *path[] = {path_of(1, 2), path_of(2, 2)};
    write_part(&repeat, 1, 2);
    write_part(&repeat, 2, 2);
    /* The scene and the plan. */
    static char other[] = "murk: 1\nseed: 41\n";
    scene.whole_key = other;
    murk_error err = refusal(path, 2);
    CHECK_TEXT(err.where, path[0]);
    CHECK_TEXT(err.text, "made for another scene: it has \"seed: 40\", the "
                         "scene has \"seed: 41\"");
    scene.whole_key = key;
    sensor[0].position.x = 0.2;
    CHECK_MENTIONS(refusal(path, 2).text,
                   "made for another first plan: it has \"sensor 0 0.1 0.333");
    sensor[0].position.x = 0.1;
    plan.held_out.value = 0.6;
    CHECK_MENTIONS(refusal(path, 2).text,
                   "made for another first plan: it has \"coverage");
    plan.held_out.value = 0.7;
    /* The number of runs. */
    repeat.asked = ASKED - 1;
    write_part(&repeat, 2, 2);
    CHECK_TEXT(refusal(path, 2).text, "part of 7 runs, must be of 8");
    repeat.asked = ASKED;
    /* Figures that differ. */
    char copy[PATH_SIZE];
    snprintf(copy, sizeof copy, "%s/copy", folder);
    write_part(&repeat, 2, 2);
    CHECK(rename(path[1], copy) == 0);
    repeat.run[4].upper = 0.5;
    write_part(&repeat, 2, 2);
    const char *twice[] = {copy, path[1]};
    err = refusal(twice, 2);
    CHECK_TEXT(err.where, path[1]);
    CHECK_MENTIONS(err.text, "part 2 of 2 again, and other than");
    CHECK_MENTIONS(err.text, "the runs of seed 44 differ");
    /* The number of shards. */
    write_part(&repeat, 3, 3);
    const char *mixed[] = {path[0], path_of(3, 3)};
    CHECK_TEXT(refusal(mixed, 2).text, "part 3 of 3, other parts are of 2");
    murk_repeat_release(&repeat);
}

/* Writes a good part with bytes of one section replaced, and the section cut to
 * `size` bytes unless that is SIZE_MAX; checks that the part is refused. */
static void check_forged(const char *name, size_t at, const void *bytes,
                         size_t n, size_t size, const char *mention)
{
    murk_section *sections = NULL;
    size_t all = 0;
    const char *good = path_of(1, 1), *forged = path_of(2, 2);
    CHECK(!murk_map_file_read(&sections, &all, good, NULL));
    for (size_t i = 0; i < all; ++i) {
        if (strcmp(sections[i].name, name) == 0) {
            CHECK(at + n <= sections[i].size);
            memcpy((char *)sections[i].bytes + at, bytes, n);
            sections[i].size = size < SIZE_MAX ? size : sections[i].size;
        }
    }
    CHECK(!murk_map_file_write(forged, sections, all, NULL));
    murk_map_file_release(sections, all);
    const murk_error err = refusal(&forged, 1);
    CHECK_MENTIONS(err.text, mention);
    CHECK(!strchr(err.text, '\n'));
}

static void check_number(const char *name, size_t at, uint32_t value,
                         const char *mention)
{
    check_forged(name, at, &value, sizeof value, SIZE_MAX, mention);
}

static void test_forged_parts_are_refused(void)
{
    static const double wrong[] = {-1, INFINITY, -INFINITY, -0x1p-1074};
    static const char cannot[] = "a run that murk cannot have made";
    murk_repeat repeat = make_runs();
    write_part(&repeat, 1, 1);
    /* Which part it is: the number of runs, the part, of how many. */
    check_number("part", 0, 9, "part of 9 runs");
    check_number("part", 0, UINT32_MAX, "part of 4294967295 runs");
    check_number("part", 8, 0, "\"part\" is missing");
    check_number("part", 8, 2, "\"part\" is missing");
    check_number("part", 12, 100001, "\"part\" is missing");
    check_number("part", 12, 2, "other runs than those of the part");
    check_number("part", 16, 'x', "made by murk x, this is");
    check_forged("part", 0, "", 0, 8, "\"part\" is missing");
    /* Texts. */
    check_forged("scene", 0, "\n\n\n", 3, SIZE_MAX, "made for another scene");
    check_forged("scene", 0, "", 0, 0, "made for another scene");
    check_forged("plan", 0, "", 0, 3, "made for another first plan");
    /* Runs: their number, seed, flag and figures. */
    check_forged("runs", 0, "", 0, 64, "other runs than those of the part");
    check_number("runs", 8, 42, cannot);
    check_number("runs", 12, 2, cannot);
    for (size_t k = 0; k < 6; ++k) {
        for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
            check_forged("runs", 16 + 8 * k, &wrong[i], 8, SIZE_MAX, cannot);
        }
    }
    murk_repeat_release(&repeat);
}

/* In the dark a part has no runs. */
static void test_dark(void)
{
    murk_repeat repeat = make_runs(), read = {.run = NULL};
    const char *path = path_of(1, 3);
    plan.is_dark = true;
    write_part(&repeat, 1, 3);
    CHECK(!murk_repeat_merge(&read, &first, ASKED, &path, 1, 1, NULL));
    CHECK(read.runs == 0 && !read.run);
    murk_repeat_release(&read);
    plan.is_dark = false;
    CHECK_MENTIONS(refusal(&path, 1).text, "other runs than those of the part");
    murk_repeat_release(&repeat);
}

int main(void)
{
    CHECK(mkdtemp(folder) != NULL);
    murk_warn_to(NULL); /* of missing parts */
    test_runs_come_back();
    test_other_parts_are_refused();
    test_forged_parts_are_refused();
    test_dark();
    return check_done();
}
