/* Broken NetCDF files: cut off anywhere, with flipped bits and hostile words.
 * Each is read as murk-netcdf reads it, in a subprocess with its limits: values
 * that are sane or one line of error, within bounded time. Only built where
 * libnetcdf is. Deterministic. usage: netcdf_input [FILES], 200 if left out. */
#include "base/log.h"
#include "base/progress.h"
#include "base/rng.h"
#include "broken.h"
#include "check.h"
#include "medium/grid.h"
#include "medium/grid_internal.h"
#include "netcdf/read.h"
#include "written.h"

#include <netcdf.h>
#include <stdlib.h>
#include <unistd.h>

static char path[] = "/tmp/murk-netcdf-XXXXXX";

/* Writes a file with two times of a field, packed, and its radius, on axes in
 * metres or in degrees. */
static void write_whole(int format, bool has_degrees)
{
    static const char *const names[] = {"t", "z", "y", "x"};
    const char *const units[] = {"seconds since 2000-01-01", "m",
                                 has_degrees ? "degrees_north" : "km",
                                 has_degrees ? "degrees_east" : "m"};
    static const size_t length[] = {2, 5, 4, 6};
    int file, dimension[4], axis[4], water, radius;
    const double scale = 1e-3;
    CHECK(nc_create(path, NC_CLOBBER | format, &file) == NC_NOERR);
    for (int i = 0; i < 4; ++i) {
        CHECK(nc_def_dim(file, names[i], length[i], &dimension[i]) == NC_NOERR);
        CHECK(nc_def_var(file, names[i], NC_DOUBLE, 1, &dimension[i],
                         &axis[i]) == NC_NOERR);
        nc_put_att_text(file, axis[i], "units", strlen(units[i]), units[i]);
    }
    nc_def_var(file, "lwc", NC_SHORT, 4, dimension, &water);
    nc_put_att_text(file, water, "units", 5, "g m-3");
    nc_put_att_double(file, water, "scale_factor", NC_DOUBLE, 1, &scale);
    nc_def_var(file, "reff", NC_FLOAT, 4, dimension, &radius);
    nc_put_att_text(file, radius, "units", 2, "um");
    CHECK(nc_enddef(file) == NC_NOERR);
    /* Coordinates, then values. */
    for (int i = 0; i < 4; ++i) {
        double at[6];
        for (size_t k = 0; k < length[i]; ++k) {
            /* About longitude and latitude 0. */
            const double unit = has_degrees && i > 1 ? 0.01 : 10;
            at[k] = unit * (double)(k * k + k);
        }
        CHECK(nc_put_var_double(file, axis[i], at) == NC_NOERR);
    }
    short content[2 * 5 * 4 * 6];
    float um[2 * 5 * 4 * 6];
    for (int i = 0; i < 240; ++i) {
        content[i] = (short)(i * 7 % 500);
        um[i] = 5 + (float)(i % 11);
    }
    CHECK(nc_put_var_short(file, water, content) == NC_NOERR);
    CHECK(nc_put_var_float(file, radius, um) == NC_NOERR);
    CHECK(nc_close(file) == NC_NOERR);
}

/* A murk_subprocess_work. */
static murk_status read_field(murk_subprocess *to, void *context,
                              murk_error *err)
{
    /* Most of the file, with axes in degrees about its first place. */
    const murk_netcdf_request request = {
        .path = path,
        .where = "bad.yaml:1:1",
        .asked = {.liquid_water = "lwc",
                  .effective_radius = "reff",
                  .per_unit = 1,
                  .time_s = 7,
                  .has_within = true,
                  .within_m = {-1e6, -1e6, 1e6, 1e6},
                  .has_frame = true,
                  .frame = murk_local_frame_at(0.1, 0.1, 0, 1),
                  .is_linear = context != NULL}};
    murk_field_head head = {.name = ""};
    murk_field_block *block = calloc(1, sizeof *block);
    murk_status status =
        block ? murk_netcdf_read(&head, block, &request, err)
              : murk_no_memory(err, request.where, "for a field");
    if (!status) {
        status = murk_field_send(to, &head, block, 1);
    }
    murk_field_blocks_destroy(block, 1);
    return status;
}

/* True if the file gives a grid. */
static bool survives(bool is_linear)
{
    const double start_s = murk_clock_s();
    const murk_subprocess_limits limits = murk_grid_netcdf_limits(path);
    unsigned char *sent = NULL;
    size_t size = 0;
    murk_grid *grid = NULL;
    murk_error err = {0};
    murk_status status =
        murk_subprocess_run(&sent, &size, read_field, is_linear ? path : NULL,
                            &limits, "bad.yaml:1:1", &err);
    if (!status) {
        status = murk_grid_from_field(&grid, sent, size, "bad.yaml:1:1", &err);
    }
    free(sent);
    if (status) {
        CHECK(strncmp(err.where, "bad.yaml:1:1", 12) == 0);
        broken_check_refusal(&err);
        /* A subprocess that died or was slow says so. */
        CHECK(!strstr(err.text, "malformed, or too large"));
    }
    murk_grid_destroy(grid);
    CHECK(murk_clock_s() - start_s < BROKEN_SLOWEST_S);
    return !status;
}

/* Reads `files` broken copies of a file of a format. */
static void test_format(int format, bool has_degrees, uint32_t files)
{
    write_whole(format, has_degrees);
    const broken_bytes whole = broken_load(path);
    const size_t size = whole.size;
    CHECK(size > 1000);
    CHECK(survives(false) && survives(true));
    unsigned char *copy = malloc(size);
    CHECK(copy != NULL);
    uint32_t refused = 0;
    for (uint32_t i = 0; i < files; ++i) {
        const murk_random4 r = murk_random(17, MURK_TEST, i, 0, 0);
        uint32_t word[4];
        memcpy(copy, whole.at, size);
        /* Two thirds of the changes are in the first part, the header. */
        const uint32_t among = (uint32_t)(r.u[1] < 0.67 ? size / 4 : size);
        size_t n = size;
        for (uint32_t k = 0; k <= i % 4; ++k) {
            murk_random_words(17, MURK_TEST, i, 1 + k, 0, word);
            const size_t at = murk_random_below(word[0], among - 4);
            const uint32_t worst[] = {0xffffffff, 0xffffff7f, 0x00000080, 0};
            if (r.u[0] < 0.2) {
                n = at;
            } else if (r.u[0] < 0.6) {
                copy[at] ^= (unsigned char)(1u << (word[1] & 7));
            } else {
                memcpy(copy + at, &worst[word[1] & 3], 4);
            }
        }
        write_bytes(path, copy, n);
        refused += !survives(i % 2 == 0);
    }
    CHECK(refused > files / 8);
    free(copy);
    free(whole.at);
}

int main(int argc, char **argv)
{
    const uint32_t files = argc > 1 ? (uint32_t)atol(argv[1]) : 200;
    const int file = mkstemp(path);
    CHECK(file >= 0);
    close(file);
    (void)murk_warn_quiet(true); /* of fields of zeros */
    test_format(0, false, files - files / 2);
    test_format(0, true, files / 2);
    unlink(path);
    return check_done();
}
