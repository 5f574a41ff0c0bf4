/* Reads NetCDF files as rectilinear grids, by the program murk-netcdf. */
#include "medium/grid.h"

#include "medium/grid_internal.h"

#include <stdio.h>
#include <sys/stat.h>

/* Bytes of values for a byte of a compressed file: a choice. */
#define COMPRESSION 16

static const murk_subprocess_job job = {
    .name = MURK_NETCDF_JOB,
    .pack = murk_netcdf_pack,
    .program = MURK_NETCDF_PROGRAM,
    .needs = "NetCDF files are read by the program murk-netcdf: install the "
             "package murk-netcdf, or build murk with libnetcdf-dev"};

murk_subprocess_limits murk_grid_netcdf_limits(uint64_t file_bytes)
{
    murk_subprocess_limits limits =
        murk_subprocess_limits_for(COMPRESSION * file_bytes);
    murk_grid_limit_memory(&limits, file_bytes);
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
    struct stat facts;
    const murk_subprocess_limits limits = murk_grid_netcdf_limits(
        stat(path, &facts) == 0 ? (uint64_t)facts.st_size : 0);
    return murk_grid_read_field(out, &job, &request, &limits, place, err);
}
