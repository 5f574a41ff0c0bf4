/* murk-netcdf: reads NetCDF files for murk, in a process of its own
 * (medium/netcdf_request.h). The library starts it; it is of no use by hand. */
#include "netcdf/read.h"

#include "base/program.h"

#include <stdlib.h>

static murk_status read_packed(murk_subprocess *subprocess, murk_parcel *from,
                               murk_error *err)
{
    murk_netcdf_request request;
    murk_field_head head = {.name = ""};
    murk_field_block *block = calloc(1, sizeof *block);
    murk_status status = murk_netcdf_unpack(&request, from, err);
    if (!status && !block) {
        status = murk_no_memory(err, request.where, "for a field");
    }
    if (!status) {
        status = murk_netcdf_read(&head, block, &request, err);
    }
    if (!status) {
        status = murk_field_send(subprocess, &head, block, 1);
    }
    murk_field_blocks_destroy(block, 1);
    return status;
}

int main(void)
{
    static const murk_subprocess_job job = {.name = MURK_NETCDF_JOB,
                                            .work_packed = read_packed};
    static const murk_subprocess_job *const jobs[] = {&job};
    murk_parcel request;
    if (!murk_program_request(&request, MURK_NETCDF_PROGRAM)) {
        return 2;
    }
    /* HDF5 would lock the file, which the confined process may not do. */
    setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
    murk_subprocess_serve(&request, MURK_PROGRAM_ANSWER, jobs, 1);
}
