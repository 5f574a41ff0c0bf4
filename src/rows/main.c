/* murk-rows: runs rows of a study, a group of rows at a time, and chooses plans
 * for all rows, for programs with threads that use the library. The library
 * starts murk-rows with a request on standard input and reads the answer from a
 * pipe (base/program.h); it is of no use by hand. */
#include "base/program.h"
#include "cases/sweep_jobs.h"
#include "results/version.h"

int main(void)
{
    static const murk_isolated_job *const jobs[] = {&murk_sweep_group_job,
                                                    &murk_sweep_choose_job};
    murk_parcel request;
    if (!murk_program_request(&request, MURK_PROGRAM_ROWS)) {
        return 2;
    }
    murk_isolated_serve(&request, MURK_PROGRAM_ANSWER,
                        murk_version_with_commit(), jobs,
                        sizeof jobs / sizeof *jobs);
}
