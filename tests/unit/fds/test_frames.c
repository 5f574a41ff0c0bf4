/* Frames of .s3d and .sf files, written here in both byte orders: values,
 * choice and mean of frames, a last frame that is cut off, records that are
 * divided, and files that are refused. Conversions into extinction against the
 * formulas. */
#include "check.h"
#include "fds/extinction.h"
#include "fds/frames.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static char folder[] = "/tmp/murk-fds-XXXXXX";

static unsigned char file[65536];
static size_t size;
static bool is_swapped;

static void put_word(uint32_t word)
{
    word = is_swapped ? __builtin_bswap32(word) : word;
    memcpy(&file[size], &word, sizeof word);
    size += sizeof word;
}

static void put_float(float value)
{
    uint32_t word;
    memcpy(&word, &value, sizeof word);
    put_word(word);
}

static void put_bytes(const unsigned char *bytes, uint32_t n)
{
    put_word(n);
    memcpy(&file[size], bytes, n);
    size += n;
    put_word(n);
}

/* The beginning of a file with nodes 0 to n along each axis. */
static void begin(bool is_smoke3d, const uint32_t n[3])
{
    size = 0;
    if (!is_smoke3d) {
        for (int label = 0; label < 3; ++label) {
            put_bytes((const unsigned char *)"ABCDEFGHIJKLMNOPQRSTUVWXYZabcd",
                      30);
        }
    }
    put_word(is_smoke3d ? 32 : 24);
    if (is_smoke3d) {
        put_word(1);
        put_word(0);
    }
    for (int axis = 0; axis < 3; ++axis) {
        put_word(0);
        put_word(n[axis]);
    }
    put_word(is_smoke3d ? 32 : 24);
}

static void put_time(float time_s)
{
    put_word(4);
    put_float(time_s);
    put_word(4);
}

static void put_smoke(float time_s, const unsigned char *code, uint32_t n,
                      uint32_t values)
{
    put_time(time_s);
    put_word(8);
    put_word(values);
    put_word(n);
    put_word(8);
    put_bytes(code, n);
}

static void put_slice(float time_s, const float *value, uint32_t n)
{
    put_time(time_s);
    put_word(4 * n);
    for (uint32_t i = 0; i < n; ++i) {
        put_float(value[i]);
    }
    put_word(4 * n);
}

static void save(const char *name)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    write_bytes(path, file, size);
}

/* A run of one mesh, 1 x 1 x 2 cells of .5 x 1 x (1 and 2) m, with one data
 * file. */
static void save_smv(const char *data)
{
    char path[128], text[1024];
    snprintf(path, sizeof path, "%s/run.smv", folder);
    snprintf(text, sizeof text,
             "SURFACE\n WALL\n 1 1\n 0 1\n null\nGRID one\n 1 1 2 0\n"
             "TRNX\n 0\n 0 0.\n 1 0.5\nTRNY\n 0\n 0 0.\n 1 1.\n"
             "TRNZ\n 0\n 0 0.\n 1 1.\n 2 3.\n%s",
             data);
    write_bytes(path, text, strlen(text));
}

static murk_status read_field(murk_fds_field **out, murk_fds_quantity quantity,
                              double time_s, murk_error *err)
{
    char path[128];
    snprintf(path, sizeof path, "%s/run.smv", folder);
    const murk_fds_asked asked = {.quantity = quantity, .time_s = time_s};
    *out = NULL;
    *err = (murk_error){0};
    return murk_fds_field_read(out, path, &asked, "test", err);
}

static const char *const SMOKE =
    "SMOKF3D 1 8700.\n a.s3d\n SOOT DENSITY\n rho\n kg/m3\n";

static double of_byte(double byte)
{
    return -log(1 - byte / 254) / 0.5;
}

static void test_smoke(bool swapped)
{
    static const unsigned char first[] = {255, 0, 11, 100},
                               second[] = {255, 10, 10, 254, 200};
    const uint32_t n[3] = {1, 1, 2};
    murk_fds_field *f = NULL;
    murk_error err;
    is_swapped = swapped;
    begin(true, n);
    put_smoke(1, first, sizeof first, 12);
    put_smoke(3, second, sizeof second, 12);
    put_smoke(5, second, sizeof second, 12);
    size -= 3; /* the last frame is cut off */
    save("a.s3d");
    save_smv(SMOKE);
    CHECK(read_field(&f, MURK_FDS_SOOT_DENSITY, 1, &err) == MURK_OK);
    if (f) {
        CHECK(f->n == 1 && f->block[0].has_nodes && f->is_rounded);
        CHECK(f->weight == 0 && f->capped == 0);
        CHECK_NEAR((double)f->block[0].value[11], of_byte(100), 1e-6);
        CHECK(f->block[0].value[0] == 0);
        CHECK(f->block[0].edge[2][2] == 3 && f->block[0].cells[2] == 2);
        CHECK_NEAR(f->step_per_m, of_byte(1), 1e-8);
    }
    murk_fds_field_destroy(f);
    /* Between both frames; a byte of 254 is at least that of 253.5. */
    CHECK(read_field(&f, MURK_FDS_SOOT_DENSITY, 1.5, &err) == MURK_OK);
    if (f) {
        CHECK_NEAR((double)f->block[0].value[0], 0.25 * of_byte(10), 1e-6);
        CHECK_NEAR((double)f->block[0].value[10], 0.25 * of_byte(253.5), 1e-6);
        CHECK_NEAR((double)f->block[0].value[11],
                   0.75 * of_byte(100) + 0.25 * of_byte(200), 1e-6);
        CHECK(f->capped == 1 && f->weight == 0.25);
        CHECK_NEAR(f->capped_per_m, of_byte(253.5), 1e-6);
    }
    murk_fds_field_destroy(f);
    /* A time as a user reads it, with seven digits. */
    CHECK(read_field(&f, MURK_FDS_SOOT_DENSITY, 3.000002, &err) == MURK_OK);
    CHECK(f && f->weight == 0 && f->frame_s[0] == 3);
    murk_fds_field_destroy(f);
    CHECK(read_field(&f, MURK_FDS_SOOT_DENSITY, 3.1, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "must be 1 to 3 s");
    CHECK(read_field(&f, MURK_FDS_EXTINCTION, 1, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "has no extinction in a space");
}

static void test_slices(void)
{
    const uint32_t n[3] = {1, 1, 2};
    float value[12], k[12];
    murk_fds_field *f = NULL;
    murk_error err;
    is_swapped = false;
    for (int i = 0; i < 12; ++i) {
        value[i] = (float)(i + 1) * 1e-4F;
        k[i] = 30 / (float)(1 + i % 4);
    }
    begin(false, n);
    put_slice(0, value, 12);
    save("b.sf");
    begin(false, n);
    put_slice(0, k, 12);
    save("c.sf");
    /* A slice comes before bytes, and takes the mass extinction of these. */
    save_smv("SMOKF3D 1 5000.\n a.s3d\n SOOT DENSITY\n rho\n kg/m3\n"
             "SLCF 1 # STRUCTURED & 0 1 0 1 0 2 ! 1 0\n b.sf\n SOOT DENSITY\n "
             "rho\n kg/m3\n");
    CHECK(read_field(&f, MURK_FDS_SOOT_DENSITY, 0, &err) == MURK_OK);
    if (f) {
        CHECK_NEAR((double)f->block[0].value[5], 5000 * 6e-4, 1e-6);
        CHECK(!f->is_rounded && f->mass_extinction == 5000);
    }
    murk_fds_field_destroy(f);
    /* Values of cells: the first layer along each axis is left out. */
    save_smv("SLCC 1 # STRUCTURED & 0 1 0 1 0 2 ! 1 1\n b.sf\n SOOT EXTINCTION "
             "COEFFICIENT\n K\n 1/m\n");
    CHECK(read_field(&f, MURK_FDS_EXTINCTION, 0, &err) == MURK_OK);
    if (f) {
        CHECK(!f->block[0].has_nodes);
        CHECK(f->block[0].value[0] == value[7]);
        CHECK(f->block[0].value[1] == value[11]);
    }
    murk_fds_field_destroy(f);
    /* Slightly negative is rounding, more is refused. */
    value[3] = -1e-8F;
    begin(false, n);
    put_slice(0, value, 12);
    save("b.sf");
    save_smv("SLCF 1 # STRUCTURED & 0 1 0 1 0 2 ! 1 0\n b.sf\n SOOT DENSITY\n "
             "rho\n kg/m3\n");
    CHECK(read_field(&f, MURK_FDS_SOOT_DENSITY, 0, &err) == MURK_OK);
    CHECK(f && f->block[0].value[3] == 0);
    murk_fds_field_destroy(f);
    value[3] = -1e-4F;
    begin(false, n);
    put_slice(0, value, 12);
    save("b.sf");
    CHECK(read_field(&f, MURK_FDS_SOOT_DENSITY, 0, &err) == MURK_BAD_FILE);
    CHECK_MENTIONS(err.text, "extinctions from -0.87");
    /* Visibility, cut at 30 m in three nodes. */
    save_smv("SLCF 1 # STRUCTURED & 0 1 0 1 0 2 ! 1 0\n c.sf\n SOOT "
             "VISIBILITY\n S\n m\n");
    CHECK(read_field(&f, MURK_FDS_VISIBILITY, 0, &err) == MURK_OK);
    if (f) {
        CHECK_NEAR((double)f->block[0].value[3], 3 / 7.5, 1e-7);
        CHECK(f->capped == 3);
        CHECK_NEAR(f->capped_per_m, 0.1, 1e-7);
    }
    murk_fds_field_destroy(f);
    /* A plane fills no space. */
    save_smv("SLCF 1 # STRUCTURED & 0 1 0 1 1 1 ! 1 0\n c.sf\n SOOT "
             "VISIBILITY\n S\n m\n");
    CHECK(read_field(&f, MURK_FDS_VISIBILITY, 0, &err) == MURK_BAD_VALUE);
}

/* Divides the records of the file into subrecords of at most `max` bytes, as
 * compilers divide those of 2 GB and more: a negative length before the bytes
 * if another subrecord follows, behind them if one came before. */
static void divide(uint32_t max)
{
    static unsigned char whole[sizeof file];
    const size_t n = size;
    memcpy(whole, file, n);
    size = 0;
    for (size_t at = 0; at < n;) {
        uint32_t length;
        memcpy(&length, whole + at, 4);
        length = is_swapped ? __builtin_bswap32(length) : length;
        for (uint32_t from = 0; from == 0 || from < length;) {
            const uint32_t part = length - from < max ? length - from : max;
            put_word(from + part < length ? -part : part);
            memcpy(&file[size], whole + at + 4 + from, part);
            size += part;
            put_word(from > 0 ? -part : part);
            from += part > 0 ? part : 1;
        }
        at += 8 + length;
    }
}

static void test_divided_records(bool swapped)
{
    const uint32_t n[3] = {1, 1, 2};
    unsigned char code[36];
    float value[12];
    murk_fds_field *f = NULL;
    murk_error err;
    is_swapped = swapped;
    for (unsigned char i = 0; i < 12; ++i) {
        code[3 * i] = 255;
        code[3 * i + 1] = 100 + i;
        code[3 * i + 2] = 1;
        value[i] = 0.125F * (float)(i + 1);
    }
    begin(true, n);
    put_smoke(1, code, sizeof code, 12);
    put_smoke(2, code, sizeof code, 12);
    divide(32); /* the first record, of 32 bytes, is whole */
    save("a.s3d");
    save_smv(SMOKE);
    CHECK(read_field(&f, MURK_FDS_SOOT_DENSITY, 2, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    for (int i = 0; f && i < 12; ++i) {
        CHECK_NEAR((double)f->block[0].value[i], of_byte(100 + i), 1e-6);
    }
    murk_fds_field_destroy(f);
    /* Two subrecords of values; the third frame is cut off in them. */
    begin(false, n);
    put_slice(0, value, 12);
    value[0] = 7;
    put_slice(1, value, 12);
    put_slice(2, value, 12);
    divide(30);
    size -= 2;
    save("b.sf");
    save_smv("SLCF 1 # STRUCTURED & 0 1 0 1 0 2 ! 1 0\n b.sf\n SOOT EXTINCTION "
             "COEFFICIENT\n K\n 1/m\n");
    CHECK(read_field(&f, MURK_FDS_EXTINCTION, 1, &err) == MURK_OK);
    CHECK(f && f->block[0].value[0] == 7 && f->block[0].value[11] == 1.5F);
    murk_fds_field_destroy(f);
    CHECK(read_field(&f, MURK_FDS_EXTINCTION, 2, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "must be 0 to 1 s");
    /* Behind the bytes the sign tells of the subrecord before. */
    begin(false, n);
    put_slice(0, value, 12);
    divide(30);
    size -= 4;
    put_word(48 - 30); /* must be negative */
    save("b.sf");
    CHECK(read_field(&f, MURK_FDS_EXTINCTION, 0, &err) == MURK_BAD_FILE);
    CHECK_MENTIONS(err.text, "malformed");
}

static void refuses(const char *problem)
{
    murk_fds_field *f = NULL;
    murk_error err;
    save("a.s3d");
    CHECK(read_field(&f, MURK_FDS_SOOT_DENSITY, 1, &err) == MURK_BAD_FILE);
    CHECK_MENTIONS(err.text, problem);
    CHECK_MENTIONS(err.where, "a.s3d");
}

static void test_refused(void)
{
    static const unsigned char code[] = {255, 0, 12}, less[] = {255, 0, 11},
                               more[] = {255, 0, 13};
    const uint32_t n[3] = {1, 1, 2}, other[3] = {1, 1, 3};
    is_swapped = false;
    save_smv(SMOKE);
    size = 0;
    refuses("does not begin");
    begin(true, n);
    refuses("no whole frame");
    put_smoke(1, less, sizeof less, 12);
    refuses("too few or too many values");
    begin(true, n);
    put_smoke(1, more, sizeof more, 12);
    refuses("too few or too many values");
    begin(true, n);
    put_smoke(1, code, sizeof code, 12);
    put_smoke(1, code, sizeof code, 12);
    refuses("not later than the one before");
    begin(true, other);
    put_smoke(1, code, sizeof code, 16);
    refuses("has nodes 0 to 3 along z, must be 0 to 2");
}

int main(void)
{
    CHECK(mkdtemp(folder) != NULL);
    test_smoke(false);
    test_smoke(true);
    test_slices();
    test_divided_records(false);
    test_divided_records(true);
    test_refused();
    static const char *const names[] = {"run.smv", "a.s3d", "b.sf", "c.sf"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        unlink(path);
    }
    rmdir(folder);
    return check_done();
}
