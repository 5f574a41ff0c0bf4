/* Unstructured geometry of FDS runs: files written here, in both byte orders,
 * with what Smokeview reads around the triangles, and files that are refused.
 */
#include "check.h"
#include "fds/geom.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static char folder[] = "/tmp/murk-fds-XXXXXX";
static unsigned char file[4096];
static size_t size;
static bool is_swapped;

static void put(const void *words, uint32_t n)
{
    const uint32_t length = 4 * n;
    for (uint32_t i = 0; i < n + 2; ++i) {
        uint32_t word = length;
        if (i > 0 && i <= n) {
            memcpy(&word, (const unsigned char *)words + 4 * (i - 1), 4);
        }
        word = is_swapped ? __builtin_bswap32(word) : word;
        memcpy(&file[size], &word, 4);
        size += 4;
    }
}

static const float CORNERS[] = {0, 0, 0, 2, 0, 0, 0, 3, 0.5F, 2, 3, 0.5F};
static const int32_t TRIANGLES[] = {1, 2, 3, 4, 3, 2}, SURFACES[] = {1, 0};

static void put_head(int32_t version)
{
    static const int32_t one = 1, head[] = {2, 1, 1}, seven = 7;
    static const float floats[] = {1, 2};
    size = 0;
    put(&one, 1);
    put(&version, 1);
    put(head, 3);
    put(floats, 2);
    put(&seven, 1);
}

static void put_frame(const int32_t *triangles, const int32_t *surfaces)
{
    static const float time_s = 0, textures[12] = {0};
    static const int32_t sizes[] = {4, 2, 1}, volume[] = {1, 2, 3, 4},
                         material = 1;
    put(&time_s, 1);
    put(sizes, 3);
    put(CORNERS, 12);
    put(triangles, 6);
    put(surfaces, 2);
    put(textures, 12);
    put(volume, 4);
    put(&material, 1);
}

static murk_status read_run(murk_fds_geom *out, const char *name,
                            murk_error *err)
{
    static const char *const run_text =
        "SURFACE\n WALL\n 1 1\n 0 1\n null\nSURFACE\n PIPE\n 1 1\n 0 1\n null\n"
        "GRID one\n 1 1 1 0\nTRNX\n 0\n 0 0.\n 1 1.\nTRNY\n 0\n 0 0.\n 1 1.\n"
        "TRNZ\n 0\n 0 0.\n 1 1.\n";
    char path[128], text[1024];
    snprintf(path, sizeof path, "%s/a.ge", folder);
    write_bytes(path, file, size);
    snprintf(text, sizeof text, "%s%s%s\n", run_text,
             name ? "GEOM      1\n " : "", name ? name : "");
    snprintf(path, sizeof path, "%s/run.smv", folder);
    write_bytes(path, text, strlen(text));
    /* The run, then the geometry. */
    murk_fds_run *run = NULL;
    *err = (murk_error){0};
    *out = (murk_fds_geom){0};
    murk_status status = murk_fds_run_read(&run, path, "test", err);
    if (!status) {
        status = murk_fds_geom_read(out, run, path, "test", err);
    }
    murk_fds_run_destroy(run);
    return status;
}

static void test_triangles(void)
{
    murk_fds_geom g;
    murk_error err;
    for (int swapped = 0; swapped < 2; ++swapped) {
        is_swapped = swapped;
        put_head(2);
        put_frame(TRIANGLES, SURFACES);
        CHECK(read_run(&g, "a.ge", &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
        CHECK(g.vertices == 4 && g.triangles == 2);
        CHECK(g.vertices && !memcmp(g.vertex, CORNERS, sizeof CORNERS));
        for (int i = 0; i < 6 && g.triangles; ++i) {
            CHECK(g.corner[i] == (uint32_t)TRIANGLES[i] - 1);
        }
        CHECK(g.triangles && g.surface[0] == 1 && g.surface[1] == 0);
        murk_fds_geom_release(&g);
    }
    is_swapped = false;
    CHECK(read_run(&g, NULL, &err) == MURK_OK && g.triangles == 0);
    murk_fds_geom_release(&g);
    /* Nothing there: the records of arrays are left out. */
    static const float time_s = 0;
    static const int32_t none[3] = {0};
    put_head(2);
    put(&time_s, 1);
    put(none, 3);
    CHECK(read_run(&g, "a.ge", &err) == MURK_OK && g.triangles == 0);
    murk_fds_geom_release(&g);
}

static void refuses(const char *name, const char *problem, const char *where)
{
    murk_fds_geom g;
    murk_error err;
    CHECK(read_run(&g, name, &err) == MURK_BAD_FILE);
    CHECK_MENTIONS(err.text, problem);
    CHECK_MENTIONS(err.where, where);
    murk_fds_geom_release(&g);
}

static void test_refused(void)
{
    static const int32_t none[] = {0, 2, 3, 4, 3, 2},
                         beyond[] = {1, 2, 5, 4, 3, 2}, surface[] = {0, 2};
    is_swapped = false;
    /* Version, names, frames, corners and surfaces, and the end. */
    put_head(1);
    put_frame(TRIANGLES, SURFACES);
    refuses("a.ge", "version 1, must be of 2", "test: a.ge");
    refuses("b.ge", "No such file", "test: b.ge");
    refuses("../a.ge", "must lie in the folder", "test:25");
    put_head(2);
    refuses("a.ge", "has no frame", "a.ge");
    put_frame(none, SURFACES);
    refuses("a.ge", "a corner or surface that is not there", "a.ge");
    put_head(2);
    put_frame(beyond, SURFACES);
    refuses("a.ge", "a corner or surface that is not there", "a.ge");
    put_head(2);
    put_frame(TRIANGLES, surface);
    refuses("a.ge", "a corner or surface that is not there", "a.ge");
    put_head(2);
    put_frame(TRIANGLES, SURFACES);
    put_frame(TRIANGLES, SURFACES);
    refuses("a.ge", "more than one frame", "a.ge");
    put_head(2);
    put_frame(TRIANGLES, SURFACES);
    size -= 40;
    refuses("a.ge", "ends within", "a.ge");
    size = 20;
    refuses("a.ge", "does not begin", "a.ge");
}

int main(void)
{
    CHECK(mkdtemp(folder) != NULL);
    test_triangles();
    test_refused();
    static const char *const names[] = {"run.smv", "a.ge"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        unlink(path);
    }
    rmdir(folder);
    return check_done();
}
