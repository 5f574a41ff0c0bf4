/* Reads NetCDF files as rectilinear grids, by the program murk-netcdf. */
#include "medium/grid.h"

#include "medium/grid_internal.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/* Larger limits for a compressed file: a choice. */
#define COMPRESSION 16

static const murk_subprocess_job job = {
    .name = MURK_NETCDF_JOB,
    .pack = murk_netcdf_pack,
    .program = MURK_NETCDF_PROGRAM,
    .needs = "NetCDF files are read by the program murk-netcdf: install the "
             "package murk-netcdf, or build murk with libnetcdf-dev"};

murk_subprocess_limits murk_grid_netcdf_limits(const char *path)
{
    struct stat facts = {0};
    char magic[3] = "";
    FILE *file = stat(path, &facts) == 0 && S_ISREG(facts.st_mode)
                     ? fopen(path, "rb")
                     : NULL;
    const bool is_classic =
        file && fread(magic, 1, 3, file) == 3 && memcmp(magic, "CDF", 3) == 0;
    if (file) {
        fclose(file);
    }
    const uint64_t bytes = (uint64_t)facts.st_size;
    murk_subprocess_limits limits =
        murk_subprocess_limits_for(is_classic ? bytes : COMPRESSION * bytes);
    if (is_classic) {
        murk_grid_limit_memory(&limits, bytes);
    }
    return limits;
}

murk_status murk_grid_read_netcdf(murk_grid **out, const char *path,
                                  const murk_netcdf_asked *asked,
                                  const char *where, murk_error *err)
{
    char place[sizeof err->where];
    snprintf(place, sizeof place, "%s: %s", where, path);
    murk_netcdf_request request = {
        .path = path, .where = place, .asked = *asked};
    const murk_subprocess_limits limits = murk_grid_netcdf_limits(path);
    return murk_grid_read_field(out, &job, &request, &limits, place, err);
}
