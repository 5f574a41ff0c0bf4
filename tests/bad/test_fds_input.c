/* Broken files of fire simulations: cut off anywhere, with flipped bits and
 * with hostile words, in the .smv file and in the data. Whatever they are:
 * values that are sane, or one line of error, within bounded time, and the
 * program goes on. The files are parsed in this process, so a crash ends the
 * test. Deterministic. usage: test_fds_input [FILES], 1000 if left out. */
#include "base/log.h"
#include "base/progress.h"
#include "base/rng.h"
#include "broken.h"
#include "check.h"
#include "fds/extinction.h"
#include "fds/geom.h"
#include "fds/walls.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

#define FROM "scenes/fds/"

/* The last files, a slice of mesh 1 and two triangles, are made here; so are
 * the lines about them and about events that are added to the .smv file. */
static const char *const names[] = {"atrium.smv", "atrium_1_1.s3d",
                                    "atrium_2_1.s3d", "slice.sf", "pipe.ge"};
#define NAMES (sizeof names / sizeof *names)

static char folder[] = "/tmp/murk-fds-XXXXXX";
static broken_bytes whole[NAMES];

static void path_of(char *out, size_t size, size_t i)
{
    snprintf(out, size, "%s/%s", folder, names[i]);
}

static const char *const MORE =
    "\nHIDE_OBST 1\n 1 10.\nSHOW_OBST 1\n 1 30.\nCLOSE_VENT 2\n 1 20.\n"
    "SLCC 1 # STRUCTURED & 0 24 0 24 0 16 ! 1 1\n slice.sf\n SOOT VISIBILITY\n"
    " S\n m\nGEOM      1\n pipe.ge\n";

/* A slice of 25 x 25 x 17 values at two times. */
static broken_bytes make_slice(void)
{
    const uint32_t label = 30, nodes[] = {24, 0, 24, 0, 24, 0, 16, 24},
                   values = 25 * 25 * 17, size = 4 * values, four = 4;
    broken_bytes b = {calloc(1, 200 + 2 * (size + 20)), 0};
    CHECK(b.at != NULL);
    /* Three labels, the nodes, then the frames. */
    for (int i = 0; i < 3; ++i) {
        memcpy(b.at + b.size, &label, 4);
        memset(b.at + b.size + 4, 'A', label);
        memcpy(b.at + b.size + 4 + label, &label, 4);
        b.size += 8 + label;
    }
    memcpy(b.at + b.size, nodes, sizeof nodes);
    b.size += sizeof nodes;
    for (int frame = 0; frame < 2; ++frame) {
        const float time_s = 50 * (float)frame;
        memcpy(b.at + b.size, &four, 4);
        memcpy(b.at + b.size + 4, &time_s, 4);
        memcpy(b.at + b.size + 8, &four, 4);
        memcpy(b.at + b.size + 12, &size, 4);
        b.size += 16;
        for (uint32_t i = 0; i < values; ++i) {
            const float visibility_m = 1 + (float)(i % 30);
            memcpy(b.at + b.size, &visibility_m, 4);
            b.size += 4;
        }
        memcpy(b.at + b.size, &size, 4);
        b.size += 4;
    }
    return b;
}

/* A record of n words. */
static void put_words(broken_bytes *b, const void *words, uint32_t n)
{
    const uint32_t length = 4 * n;
    memcpy(b->at + b->size, &length, 4);
    memcpy(b->at + b->size + 4, words, length);
    memcpy(b->at + b->size + 4 + length, &length, 4);
    b->size += 8 + length;
}

static broken_bytes make_geom(void)
{
    static const int32_t one = 1, version = 2, head[3] = {0, 0, 1},
                         sizes[3] = {4, 2, 0}, corners[6] = {1, 2, 3, 4, 3, 2},
                         surfaces[2] = {1, 0};
    static const float time_s = 0, textures[12] = {0},
                       vertices[12] = {1, 1, 1, 2, 1, 1, 1, 2, 1, 2, 2, 1};
    broken_bytes b = {malloc(1000), 0};
    CHECK(b.at != NULL);
    put_words(&b, &one, 1);
    put_words(&b, &version, 1);
    put_words(&b, head, 3);
    put_words(&b, &time_s, 1);
    put_words(&b, sizes, 3);
    put_words(&b, vertices, 12);
    put_words(&b, corners, 6);
    put_words(&b, surfaces, 2);
    put_words(&b, textures, 12);
    return b;
}

static broken_bytes load(const char *name)
{
    char path[128];
    snprintf(path, sizeof path, FROM "%s", name);
    return broken_load(path);
}

static void check_error(murk_status status, const murk_error *err)
{
    CHECK(status == MURK_BAD_FILE || status == MURK_BAD_VALUE ||
          status == MURK_NO_MEMORY);
    CHECK(strncmp(err->where, "bad.yaml:1:1", 12) == 0);
    broken_check_refusal(err);
}

static void check_field(const murk_fds_asked *asked, bool *is_read)
{
    char path[128];
    path_of(path, sizeof path, 0);
    murk_fds_field *field = NULL;
    murk_error err = {0};
    const murk_status status =
        murk_fds_field_read(&field, path, asked, "bad.yaml:1:1", &err);
    if (status) {
        check_error(status, &err);
        CHECK(field == NULL);
        *is_read = false;
    }
    /* Whatever was read is finite and 0 or more. */
    for (size_t b = 0; field && b < field->n; ++b) {
        const murk_field_block *block = &field->block[b];
        const size_t more = block->has_nodes ? 1 : 0;
        const size_t n = (block->cells[0] + more) * (block->cells[1] + more) *
                         (block->cells[2] + more);
        bool are_sane = true;
        for (size_t i = 0; i < n; ++i) {
            are_sane =
                are_sane && block->value[i] >= 0 && isfinite(block->value[i]);
        }
        CHECK(are_sane);
    }
    murk_fds_field_destroy(field);
}

/* Reads the smoke, the slice and the walls. True if all are read. */
static bool survives(void)
{
    char path[128];
    const double start_s = murk_clock_s();
    static const double first = 1;
    const murk_fds_asked smoke = {.time_s = 25},
                         slice = {.quantity = MURK_FDS_VISIBILITY,
                                  .mesh = &first,
                                  .n_meshes = 1,
                                  .time_s = 25};
    bool are_read = true;
    check_field(&smoke, &are_read);
    check_field(&slice, &are_read);
    murk_fds_run *run = NULL;
    murk_error err = {0};
    /* The walls. */
    path_of(path, sizeof path, 0);
    murk_status walls_status =
        murk_fds_run_read(&run, path, "bad.yaml:1:1", &err);
    if (!walls_status) {
        murk_fds_walls walls;
        murk_fds_geom geom;
        CHECK(murk_fds_walls_find(&walls, run, 25));
        free(walls.wall);
        walls_status =
            murk_fds_geom_read(&geom, run, path, "bad.yaml:1:1", &err);
        murk_fds_geom_release(&geom);
    }
    if (walls_status) {
        check_error(walls_status, &err);
    }
    murk_fds_run_destroy(run);
    CHECK(murk_clock_s() - start_s < BROKEN_SLOWEST_S);
    return are_read && !walls_status;
}

/* Changes one file: cuts it off, flips bits, replaces a word of four bytes, or
 * a number of a text by another one. */
static void change(uint32_t i, unsigned char *copy, size_t *size)
{
    static const char *const hostile[] = {"-1",   "0",   "99999999999", "1e308",
                                          "-1e9", "nan", "1048575",     ""};
    const murk_random4 r = murk_random(11, MURK_TEST, i, 0, 0);
    uint32_t word[4];
    murk_random_words(11, MURK_TEST, i, 1, 0, word);
    const size_t at = murk_random_below(word[0], (uint32_t)*size);
    /* One of four kinds of change. */
    if (r.u[0] < 0.2) {
        *size = at;
    } else if (r.u[0] < 0.6) {
        broken_flip(copy, *size, 11, i, 2, i % 8 + 1);
    } else if (r.u[0] < 0.8 && at + 4 <= *size) {
        const uint32_t worst[] = {0xffffffff, 0x7fffffff, 0x80000000, 0x100000};
        memcpy(copy + at, &worst[word[1] & 3], 4);
    } else {
        const char *text = hostile[word[1] & 7];
        const size_t n = strlen(text);
        if (at + n <= *size) {
            memcpy(copy + at, text, n);
        }
    }
}

int main(int argc, char **argv)
{
    const uint32_t files = argc > 1 ? (uint32_t)atol(argv[1]) : 1000;
    char path[128];
    CHECK(mkdtemp(folder) != NULL);
    for (size_t i = 0; i < NAMES; ++i) {
        whole[i] = i < 3 ? load(names[i]) : i == 3 ? make_slice() : make_geom();
        if (i == 0) {
            whole[0].at = realloc(whole[0].at, whole[0].size + strlen(MORE));
            CHECK(whole[0].at != NULL);
            memcpy(whole[0].at + whole[0].size, MORE, strlen(MORE));
            whole[0].size += strlen(MORE);
        }
        path_of(path, sizeof path, i);
        write_bytes(path, whole[i].at, whole[i].size);
    }
    CHECK(survives());
    uint32_t refused = 0;
    for (uint32_t i = 0; i < files; ++i) {
        /* Six of ten changes are in the .smv file. */
        const size_t which = i % 10 < 6 ? 0 : i % 10 - 5;
        size_t size = whole[which].size;
        unsigned char *copy = malloc(size);
        CHECK(copy != NULL);
        memcpy(copy, whole[which].at, size);
        change(i, copy, &size);
        path_of(path, sizeof path, which);
        write_bytes(path, copy, size);
        refused += !survives();
        write_bytes(path, whole[which].at, whole[which].size);
        free(copy);
    }
    CHECK(refused > files / 4);
    CHECK(broken_peak_kb() < BROKEN_MAX_KB);
    for (size_t i = 0; i < NAMES; ++i) {
        path_of(path, sizeof path, i);
        unlink(path);
        free(whole[i].at);
    }
    rmdir(folder);
    return check_done();
}
