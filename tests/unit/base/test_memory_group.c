/* Limits of control groups in folders like those of Linux, version 1 and 2. */
#include "base/memory_group.h"
#include "check.h"
#include "written.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static char root[] = "/tmp/murk-groups-XXXXXX";

static const char *path_of(const char *name)
{
    static char path[256];
    snprintf(path, sizeof path, "%s/%s", root, name);
    return path;
}

static void put(const char *name, const char *text)
{
    write_text(path_of(name), text);
}

static double left_of(const char *list)
{
    char path[256];
    put("list", list);
    snprintf(path, sizeof path, "%s", path_of("list"));
    return murk_memory_group_bytes(path, root);
}

/* The group has no limit of its own, but that around it has. */
static void test_version_2(void)
{
    CHECK(mkdir(path_of("job"), 0700) == 0);
    CHECK(mkdir(path_of("job/step"), 0700) == 0);
    put("job/memory.max", "1000\n");
    put("job/memory.current", "700\n");
    put("job/memory.stat",
        "anon 600\ninactive_file 30\nslab 9\nactive_file 20\n");
    put("job/step/memory.max", "max\n");
    put("job/step/memory.current", "600\n");
    CHECK(left_of("0::/job/step\n") == 350);
    put("job/step/memory.max", "620\n");
    CHECK(left_of("0::/job/step\n") == 20);
    put("job/step/memory.current", "640\n");
    CHECK(left_of("0::/job/step\n") == 0);
    CHECK(left_of("0::/job\n") == 350);
}

/* A container shows its group as the root. */
static void test_version_1(void)
{
    CHECK(mkdir(path_of("memory"), 0700) == 0);
    put("memory/memory.limit_in_bytes", "500\n");
    put("memory/memory.usage_in_bytes", "100\n");
    put("memory/memory.stat", "inactive_file 1\ntotal_inactive_file 7\n");
    CHECK(left_of("3:cpu:/x\n4:memory:/docker/abc\n0::/\n") == 407);
    CHECK(left_of("3:cpuset,memory,cpu:/x\n") == 407);
    CHECK(isinf(left_of("3:cpu,memoryless:/x\n")));
    /* Without a limit the number is near 2^63. */
    put("memory/memory.limit_in_bytes", "9223372036854771712\n");
    CHECK(left_of("4:memory:/docker/abc\n") > 9e18);
}

static void test_no_limit(void)
{
    CHECK(isinf(left_of("3:cpu:/x\n")));
    CHECK(isinf(left_of("")));
    CHECK(isinf(left_of("0::/elsewhere\nno line\n4:cpu")));
    CHECK(isinf(murk_memory_group_bytes("/nowhere/at/all", root)));
}

static void clean(void)
{
    static const char *const names[] = {"list",
                                        "job/memory.max",
                                        "job/memory.current",
                                        "job/memory.stat",
                                        "job/step/memory.max",
                                        "job/step/memory.current",
                                        "job/step",
                                        "job",
                                        "memory/memory.limit_in_bytes",
                                        "memory/memory.usage_in_bytes",
                                        "memory/memory.stat",
                                        "memory"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        CHECK(remove(path_of(names[i])) == 0);
    }
    CHECK(remove(root) == 0);
}

int main(void)
{
    CHECK(mkdtemp(root) != NULL);
    test_version_2();
    test_version_1();
    test_no_limit();
    clean();
    return check_done();
}
