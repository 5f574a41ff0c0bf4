/* murk-reader: imports meshes, and reads, makes and writes grids, for programs
 * with threads that use the library. The files that it reads may be hostile.
 * The library starts murk-reader with a request on standard input and reads the
 * answer from a pipe (base/program.h); it is of no use by hand. */
#include "base/program.h"
#include "base/subprocess.h"
#include "geometry/import.h"
#include "medium/grid_jobs.h"

int main(void)
{
    static const murk_subprocess_job *const jobs[] = {
        &murk_import_job,    &murk_import_fds_job, &murk_grid_read_job,
        &murk_grid_make_job, &murk_grid_write_job, &murk_grid_fds_job};
    murk_parcel request;
    if (!murk_program_request(&request, MURK_PROGRAM_READER)) {
        return 2;
    }
    murk_subprocess_serve(&request, MURK_PROGRAM_ANSWER, jobs,
                          sizeof jobs / sizeof *jobs);
}
