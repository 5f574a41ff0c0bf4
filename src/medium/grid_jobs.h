/* Work on grids in a subprocess, as jobs of murk_subprocess_do(). */
#ifndef MURK_MEDIUM_GRID_JOBS_H
#define MURK_MEDIUM_GRID_JOBS_H

#include "base/subprocess.h"

extern const murk_subprocess_job murk_grid_read_job, /* medium/grid.c */
    murk_grid_make_job,                              /* medium/grid.c */
    murk_grid_fds_job,                               /* medium/grid_fds.c */
    murk_grid_write_job;                             /* medium/grid_write.c */

#endif
