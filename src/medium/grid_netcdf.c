/* Reads NetCDF files as rectilinear grids, by the program murk-netcdf. */
#include "medium/grid.h"

#include "medium/grid_internal.h"

#include <stdio.h>

static const murk_subprocess_job job = {
    .name = MURK_NETCDF_JOB,
    .pack = murk_netcdf_pack,
    .program = MURK_NETCDF_PROGRAM,
    .needs = "NetCDF files are read by the program murk-netcdf: install the "
             "package murk-netcdf, or build murk with libnetcdf-dev"};

murk_status murk_grid_read_netcdf(murk_grid **out, const char *path,
                                  const murk_netcdf_asked *asked,
                                  const char *where, murk_error *err)
{
    char place[sizeof err->where];
    snprintf(place, sizeof place, "%s: %s", where, path);
    murk_netcdf_request request = {
        .path = path, .where = place, .asked = *asked};
    return murk_grid_read_field(out, &job, &request, path, place, err);
}
