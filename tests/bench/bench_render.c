/* Case render: a picture of the smoke hall by maps, 640 x 480 pixels, 16
 * samples each, of 1e6 photons, by the clock from the program's start to its
 * end: scene read, light traced, kernels laid, image written. Reference: the
 * ceiling that is stated for it, on 2 processors.
 *
 *   bench_render [MURK]     build/murk where it is not given */
#include "base/progress.h"

#include <spawn.h>
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

#define CEILING_S 60.

#define IMAGE "build/bench/render.exr"

extern char **environ;

int main(int argc, char **argv)
{
    char *const arguments[] = {argc > 1 ? argv[1] : "build/murk",
                               "render",
                               "scenes/smoke-hall.yaml",
                               "--camera",
                               "door",
                               "--pixels",
                               "640x480",
                               "--samples",
                               "16",
                               "--emit",
                               "1e6",
                               "-o",
                               IMAGE,
                               "--quiet",
                               NULL};
    /* Run the program as a user does, and time the whole process. */
    const double begun_s = murk_clock_s();
    pid_t child;
    int ended = -1;
    if (posix_spawn(&child, arguments[0], NULL, NULL, arguments, environ) ||
        waitpid(child, &ended, 0) != child || ended != 0) {
        fprintf(stderr, "bench_render: %s render failed\n", arguments[0]);
        return 1;
    }
    const double seconds = murk_clock_s() - begun_s;
    printf("{\"case\": \"render\", \"value\": %.4g, \"unit\": \"s\", "
           "\"reference\": \"stated ceiling on 2 processors\", "
           "\"reference_value\": %g, \"ratio\": %.4g, \"threads\": %ld}\n",
           seconds, CEILING_S, seconds / CEILING_S,
           sysconf(_SC_NPROCESSORS_ONLN));
    return 0;
}
