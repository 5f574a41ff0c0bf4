/* Names of frames, and which of them a folder holds. Nothing here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "check.h"
#include "scene/frames.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static char folder[64];

static void stands_for(const char *pattern, uint64_t frame, const char *want)
{
    char *file = murk_frames_file(pattern, frame);
    CHECK_TEXT(file ? file : "nothing", want);
    free(file);
}

static void test_names(void)
{
    stands_for("smoke.####.vdb", 12, "smoke.0012.vdb");
    stands_for("a#b/s#.vdb", 7, "a#b/s7.vdb");
    stands_for("s##.vdb", 123, "s123.vdb");
    stands_for("s_%04d.vdb", 0, "s_0000.vdb");
    stands_for("%d.vdb", 12, "12.vdb");
    stands_for("####", 999999999, "999999999");
    stands_for("smoke.vdb", 1, "nothing");
    stands_for("a#b/smoke.vdb", 1, "nothing");
    stands_for("s%s.vdb", 1, "nothing");
    stands_for("s%0d.vdb", 1, "nothing");
    stands_for("s%04x.vdb", 1, "nothing");
    stands_for("s%099d.vdb", 1, "nothing");
    stands_for("s%-4d.vdb", 1, "nothing");
    stands_for("s%", 1, "nothing");
    stands_for("###################.vdb", 1, "nothing"); /* 19 */
    stands_for("", 1, "nothing");
}

static void put(const char *name)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    write_text(path, "");
}

static void holds(const char *pattern, const char *want)
{
    char path[128], list[40];
    snprintf(path, sizeof path, "%s/%s", folder, pattern);
    murk_frames_list(path, list, sizeof list);
    CHECK_TEXT(list, want);
}

static void test_lists(void)
{
    /* Files of three sequences, and names that are close to a sequence. */
    static const char *const names[] = {
        "s.0001.vdb",  "s.0002.vdb",     "s.0003.vdb",
        "s.0007.vdb",  "s.00011.vdb",    "s.x.vdb",
        "s.12345.vdb", "s.0009.vdb.bak", "t9.vdb",
        "t10.vdb",     "t0011.vdb",      "t12",
        "u1.vdb",      "u3.vdb",         "u5.vdb",
        "u7.vdb",      "u9.vdb",         "u11.vdb",
        "u13.vdb",     "u15.vdb",        "u17.vdb",
        "u19.vdb",     "u10000000.vdb",  "u99999999999999999999.vdb"};
    const size_t n = sizeof names / sizeof *names;
    for (size_t i = 0; i < n; ++i) {
        put(names[i]);
    }
    /* Each pattern lists the frames of the matching files as ranges, and
     * cuts off a long list. */
    holds("s.####.vdb", "1..3, 7, 12345");
    holds("s.%04d.vdb", "1..3, 7, 12345");
    holds("t#.vdb", "9..10");
    holds("t%04d.vdb", "11");
    holds("u#.vdb", "1, 3, 5, 7, 9, 11, 13, 15, 17, 19, ...");
    holds("v#.vdb", "none");
    holds("s.vdb", "none");
    holds("nowhere/s#.vdb", "none");
    /* Remove the files. */
    for (size_t i = 0; i < n; ++i) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        remove(path);
    }
}

int main(void)
{
    snprintf(folder, sizeof folder, "%s/murk_frames_XXXXXX", P_tmpdir);
    if (!mkdtemp(folder)) {
        return 1;
    }
    test_names();
    test_lists();
    rmdir(folder);
    return check_done();
}
