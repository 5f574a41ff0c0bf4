/* Surfaces of FDS runs: a run of two meshes of different cells, written here,
 * whose areas by surface are known by counting faces; obstructions that
 * overlap, a plate, vents, and events. */
#include "check.h"
#include "fds/walls.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static char path[] = "/tmp/murk-fds-XXXXXX";

/* Mesh 1: 4 x 4 x 4 cells of 1 m from x = 0; mesh 2: 2 x 4 x 4 cells, of 2 m
 * along x, from x = 4. */
static const char *const HEAD = "CHID\n run\n"
                                "SURFACE\n WALL\n 1 1\n 0 1 1\n null\n"
                                "SURFACE\n BLOCK\n 1 1\n 0 1 1\n null\n"
                                "SURFACE\n LATER\n 1 1\n 0 1 1\n null\n"
                                "SURFACE\n OPEN\n 1 1\n 2 1 1\n null\n"
                                "SURFACE\n OBST\n 1 1\n 0 1 1\n null\n";
enum { WALL, BLOCK, LATER, OPEN, SHEET, SURFACES };

static const char *const LINES =
    "TRNY\n 0\n 0 0.\n 1 1.\n 2 2.\n 3 3.\n 4 4.\n"
    "TRNZ\n 0\n 0 0.\n 1 1.\n 2 2.\n 3 3.\n 4 4.\n";

static void write_run(const char *obstructions1, const char *vents1,
                      const char *obstructions2, const char *events)
{
    char text[8192];
    snprintf(text, sizeof text,
             "%sGRID one\n 4 4 4 0\n"
             "TRNX\n 1\n 9 9 9\n 0 0.\n 1 1.\n 2 2.\n 3 3.\n 4 4.\n%s"
             "OBST\n%s\nVENT\n%s\n"
             "GRID two\n 2 4 4 0\nTRNX\n 0\n 0 4.\n 1 6.\n 2 8.\n%s"
             "OBST\n%s\nVENT\n 0 0\n%s",
             HEAD, LINES, obstructions1, vents1, LINES, obstructions2, events);
    write_bytes(path, text, strlen(text));
}

/* The area of each surface. */
static void measure(double area[SURFACES], double time_s)
{
    murk_fds_run *run = NULL;
    murk_fds_walls walls;
    murk_error err = {0};
    memset(area, 0, SURFACES * sizeof *area);
    CHECK(murk_fds_run_read(&run, path, "test", &err) == MURK_OK);
    if (!run) {
        printf("%s: %s\n", err.where, err.text);
        return;
    }
    CHECK(murk_fds_walls_find(&walls, run, time_s));
    /* The edges of each rectangle, of which one coordinate is the same. */
    for (size_t i = 0; i < walls.n; ++i) {
        const murk_fds_wall *w = &walls.wall[i];
        double edge[2] = {0};
        for (int axis = 0; axis < 3; ++axis) {
            edge[0] += fabs(w->corner_m[1][axis] - w->corner_m[0][axis]);
            edge[1] += fabs(w->corner_m[3][axis] - w->corner_m[0][axis]);
            CHECK(w->corner_m[2][axis] == w->corner_m[1][axis] +
                                              w->corner_m[3][axis] -
                                              w->corner_m[0][axis]);
        }
        area[w->surface] += edge[0] * edge[1];
    }
    free(walls.wall);
    murk_fds_run_destroy(run);
}

/* Both meshes together are a hall of 8 x 4 x 4 m. */
static void test_empty_hall(void)
{
    double area[SURFACES];
    write_run(" 0", " 0 0", " 0", "");
    measure(area, 0);
    CHECK_NEAR(area[WALL], 2 * 16 + 4 * 32, 1e-12);
    /* Two openings, one of them of half a wall, and a vent of another
     * surface. */
    write_run(" 0",
              " 3 0\n 0 0 0 4 0 2 1 3\n 0 4 0 0 0 4 2 3\n 0 4 0 4 0 0 3 2\n"
              " 0 0 0 4 0 2 -99 2\n 0 4 0 0 0 4 -99 2\n 0 4 0 4 0 0 8 -2\n",
              " 0", "");
    measure(area, 0);
    CHECK_NEAR(area[WALL], 2 * 16 + 4 * 32 - 8 - 16 - 16, 1e-12);
    CHECK_NEAR(area[LATER], 16, 1e-12);
    CHECK_NEAR(area[OPEN], 0, 0);
    /* A vent whose first cells along both axes differ. */
    write_run(" 0", " 1 0\n 0 2 3 4 0 0 3 2\n 0 2 3 4 0 0 8 -2\n", " 0", "");
    measure(area, 0);
    CHECK_NEAR(area[LATER], 2, 1e-12);
}

/* Far from the origin the same: each mesh is the neighbour of the other, not a
 * mesh with outer walls. */
static void test_far_away(void)
{
    static const char *const near[] = {"TRNX\n 0\n 0 0.\n 1 4.\n",
                                       "TRNX\n 0\n 0 4.\n 1 8.\n"},
                             *const far[] = {"TRNX\n 0\n 0 9000.\n 1 9004.\n",
                                             "TRNX\n 0\n 0 9004.\n 1 9008.\n"};
    double area[SURFACES];
    for (int i = 0; i < 2; ++i) {
        const char *const *x = i ? far : near;
        char text[8192];
        snprintf(text, sizeof text,
                 "%sGRID one\n 1 4 4 0\n%s%sGRID two\n 1 4 4 0\n%s%s", HEAD,
                 x[0], LINES, x[1], LINES);
        write_bytes(path, text, strlen(text));
        measure(area, 0);
        CHECK_NEAR(area[WALL], 2 * 16 + 4 * 32, 1e-9);
    }
}

/* A block of 2 x 2 x 2 m across both meshes, on the floor. */
static void test_blocks(void)
{
    double area[SURFACES];
    write_run(" 1\n 3 4 1 3 0 2 1 1 1 1 1 1 1\n 3 4 1 3 0 2 -1 -1", " 0 0",
              " 1\n 4 6 1 3 0 2 1 1 1 1 1 1 2\n 0 1 1 3 0 2 -1 -1", "");
    measure(area, 0);
    /* Four sides of 2 m height: 1 + 2 m along x twice, 2 m along y twice; the
     * top of the part in mesh 2 is LATER. Below is floor no more. */
    CHECK_NEAR(area[BLOCK], 2 * 3 * 2 + 2 * 2 * 2 + 1 * 2, 1e-12);
    CHECK_NEAR(area[LATER], 2 * 2, 1e-12);
    CHECK_NEAR(area[WALL], 2 * 16 + 4 * 32 - 3 * 2, 1e-12);
    /* Where two obstructions overlap, the later counts. */
    write_run(" 2\n 1 3 1 3 1 3 1 1 1 1 1 1 1\n 1 3 1 3 2 3 2 2 2 2 2 2 2\n"
              " 1 3 1 3 1 3 -1 -1\n 1 3 1 3 2 3 -1 -1",
              " 0 0", " 0", "");
    measure(area, 0);
    CHECK_NEAR(area[BLOCK], 4 + 4 * 2, 1e-12);
    CHECK_NEAR(area[LATER], 4 + 4 * 2, 1e-12);
}

/* A plate has one face, and is not drawn inside of a block. */
static void test_plates(void)
{
    double area[SURFACES];
    write_run(" 1\n 2 2 0 4 0 3 1 4 4 4 4 4 4\n 2 2 0 4 0 3 -1 -1", " 0 0",
              " 0", "");
    measure(area, 0);
    CHECK_NEAR(area[SHEET], 12, 1e-12);
    write_run(" 2\n 2 2 0 4 0 3 1 4 4 4 4 4 4\n 1 3 1 3 1 3 2 1 1 1 1 1 1\n"
              " 2 2 0 4 0 3 -1 -1\n 1 3 1 3 1 3 -1 -1",
              " 0 0", " 0", "");
    measure(area, 0);
    CHECK_NEAR(area[BLOCK], 24, 1e-12);
    CHECK_NEAR(area[SHEET], 12 - 4, 1e-12);
}

/* At the border of meshes of unlike cells the finer one draws, whichever side
 * is solid; a plate there, which both meshes list, is drawn once. The cells of
 * mesh 1 are 1 m2 at the border, so are those of mesh 2: mesh 2 is rewritten
 * with cells of 2 m along y and z. */
static void test_unlike_meshes(void)
{
    static const char *const coarse =
        "TRNY\n 0\n 0 0.\n 1 2.\n 2 4.\nTRNZ\n 0\n 0 0.\n 1 2.\n 2 4.\n";
    char text[8192];
    double area[SURFACES];
    /* A coarse solid cell behind four fine faces, of which one is solid, too.
     */
    snprintf(text, sizeof text,
             "%sSURFDEF\n LATER\nGRID one\n 4 4 4 0\n"
             "TRNX\n 0\n 0 0.\n 1 1.\n 2 2.\n 3 3.\n 4 4.\n%s"
             "OBST\n 1\n 3 4 0 1 0 1 1 4 4 4 4 4 4\n 3 4 0 1 0 1 -1 -1\n"
             "VENT\n 0 0\nGRID two\n 2 2 2 0\nTRNX\n 0\n 0 4.\n 1 6.\n 2 "
             "8.\n%sOBST\n 1\n 4 6 0 2 0 2 1 1 1 1 1 1 1\n 0 1 0 1 0 1 -1 "
             "-1\nVENT\n 0 0\n",
             HEAD, LINES, coarse);
    write_bytes(path, text, strlen(text));
    measure(area, 0);
    /* BLOCK: three quarters of the side at x = 4, that at x = 6, two at y = 2
     * and z = 2; SHEET: the small cell's sides at x = 3, y = 1 and z = 1. */
    CHECK_NEAR(area[BLOCK], 3 + 4 + 2 * 4, 1e-12);
    CHECK_NEAR(area[SHEET], 3, 1e-12);
    /* SURFDEF gives outer walls LATER: those of the hall less what the
     * obstructions cover. */
    CHECK_NEAR(area[WALL], 0, 0);
    CHECK_NEAR(area[LATER], 2 * 16 + 4 * 32 - 2 * (4 + 1), 1e-12);
    write_run(" 1\n 4 4 0 4 0 3 1 4 4 4 4 4 4\n 4 4 0 4 0 3 -1 -1", " 0 0",
              " 1\n 4 4 0 4 0 3 1 4 4 4 4 4 4\n 0 0 0 4 0 3 -1 -1", "");
    measure(area, 0);
    CHECK_NEAR(area[SHEET], 12, 1e-12);
    /* Of the plate mesh 2 lists a part alone, with another surface. */
    write_run(" 1\n 4 4 0 4 0 3 1 4 4 4 4 4 4\n 4 4 0 4 0 3 -1 -1", " 0 0",
              " 1\n 4 4 1 3 1 2 1 1 1 1 1 1 1\n 0 0 1 3 1 2 -1 -1", "");
    measure(area, 0);
    CHECK_NEAR(area[SHEET], 12 - 2, 1e-12);
    CHECK_NEAR(area[BLOCK], 2, 1e-12);
}

/* Obstructions and vents come and go. */
static void test_events(void)
{
    double area[SURFACES];
    write_run(" 2\n 1 3 1 3 1 3 1 1 1 1 1 1 1\n 0 1 0 1 3 4 2 2 2 2 2 2 2\n"
              " 1 3 1 3 1 3 -1 -1\n 0 1 0 1 3 4 -1 -1",
              " 1 0\n 0 0 0 4 0 2 1 3\n 0 0 0 4 0 2 -99 2\n", " 0",
              "HIDE_OBST 1\n 1 10.\nSHOW_OBST 1\n 2 5.\nSHOW_OBST 1\n 1 30.\n"
              "OPEN_VENT 1\n 1 20.\n");
    static const struct {
        double time_s, block, later, wall;
    } want[] = {{0, 24, 0, 160},
                {5, 24, 3, 157},
                {10, 0, 3, 157},
                {20, 0, 3, 149},
                {30, 24, 3, 149}};
    for (size_t i = 0; i < sizeof want / sizeof *want; ++i) {
        measure(area, want[i].time_s);
        CHECK_NEAR(area[BLOCK], want[i].block, 1e-12);
        CHECK_NEAR(area[LATER], want[i].later, 1e-12);
        CHECK_NEAR(area[WALL], want[i].wall, 1e-12);
    }
}

/* Events name their mesh. */
static void test_events_of_a_mesh(void)
{
    double area[SURFACES];
    write_run(" 1\n 1 3 1 3 1 3 1 1 1 1 1 1 1\n 1 3 1 3 1 3 -1 -1", " 0 0",
              " 1\n 4 6 1 3 0 2 1 2 2 2 2 2 2\n 0 1 1 3 0 2 -1 -1",
              "HIDE_OBST 2\n 1 10.\n");
    measure(area, 9);
    CHECK(area[LATER] > 0);
    measure(area, 11);
    CHECK_NEAR(area[LATER], 0, 0);
    CHECK_NEAR(area[BLOCK], 24, 1e-12);
}

static void refuses(const char *text, const char *problem, const char *line)
{
    murk_fds_run *run = NULL;
    murk_error err = {0};
    write_bytes(path, text, strlen(text));
    CHECK(murk_fds_run_read(&run, path, "test", &err) == MURK_BAD_FILE);
    CHECK(run == NULL);
    CHECK_MENTIONS(err.text, problem);
    CHECK_MENTIONS(err.where, line);
}

static void test_refused(void)
{
    refuses("", "has no GRID", "test");
    refuses("CHID\n run\nOBST\n 0\n", "before the first GRID", "test:3");
    refuses("GRID a\n 2 0 2\n", "number of cells is 0", "test:2");
    refuses("GRID a\n 1 1 1\nTRNX\n 0\n 0 0.\n 1 0.\n", "must rise", "test:6");
    refuses("GRID a\n 1 1 1\nTRNX\n 0\n 0 0.\n", "ends within", "test:5");
    refuses("GRID a\n 1 1 1\nTRNX\n 0\n 0 0.\n 1 1.\nTRNZ\n 0\n 0 0.\n 1 "
            "1.\nSURFACE\n A\n",
            "misses grid lines (a)", "test");
    refuses("GRID a\n 1 1 1\nOBST\n 1\n 0 1 0 1 0 1 1 9 9\n", "too few",
            "test:5");
    refuses("GRID a\n 1 1 1\nSMOKF3D 1 8700.\n ../a.s3d\n SOOT DENSITY\n r\n "
            "k\nTRNX\n 0\n 0 0.\n 1 1.\nTRNY\n 0\n 0 0.\n 1 1.\nTRNZ\n 0\n 0 "
            "0.\n 1 1.\nSURFACE\n A\n",
            "must lie in the folder", "test:3");
}

int main(void)
{
    const int file = mkstemp(path);
    CHECK(file >= 0);
    close(file);
    test_empty_hall();
    test_far_away();
    test_blocks();
    test_plates();
    test_unlike_meshes();
    test_events();
    test_events_of_a_mesh();
    test_refused();
    unlink(path);
    return check_done();
}
