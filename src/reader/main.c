/* murk-reader: imports meshes, and reads, makes and writes grids, for programs
 * with threads that use the library. The files that it reads may be hostile.
 * The library starts murk-reader with a request on standard input and reads the
 * answer from a pipe (base/reader.h); it is of no use by hand. */
#include "base/reader.h"
#include "base/subprocess.h"
#include "geometry/import.h"
#include "medium/grid_jobs.h"

#include <stdio.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

int main(void)
{
    static const murk_subprocess_job *const jobs[] = {
        &murk_import_job, &murk_grid_read_job, &murk_grid_make_job,
        &murk_grid_write_job};
    struct stat file;
    void *bytes = MAP_FAILED;
    if (fstat(STDIN_FILENO, &file) == 0 && S_ISREG(file.st_mode) &&
        file.st_size > 0) {
        bytes = mmap(NULL, (size_t)file.st_size, PROT_READ, MAP_PRIVATE,
                     STDIN_FILENO, 0);
    }
    if (bytes == MAP_FAILED) {
        fprintf(stderr, "murk-reader: is started by the library murk\n");
        return 2;
    }
    murk_parcel request = {.bytes = bytes, .size = (size_t)file.st_size};
    murk_subprocess_serve(&request, MURK_READER_ANSWER, jobs,
                          sizeof jobs / sizeof *jobs);
}
