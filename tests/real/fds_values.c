/* Prints values of frames of FDS files for tests/real/fds.py: reads lines "FILE
 * FRAME I J K", or "FILE FRAME" for the number of values, minimum, maximum and
 * sum, and prints the time of the frame and the value or these four. */
#include "fds/frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int print_frame(murk_fds_frames *f, size_t frame, int given,
                       const size_t at[3])
{
    murk_error err = {0};
    float *value = malloc(f->values * sizeof *value);
    if (!value || frame >= f->n ||
        murk_fds_frames_read(f, frame, value, &err)) {
        printf("failed: %s\n", err.text);
        free(value);
        return 1;
    }
    /* One value, or the number of values, smallest, largest and sum. */
    const int32_t *n = f->nodes;
    const size_t row = (size_t)(n[1] - n[0] + 1),
                 sheet = row * (size_t)(n[3] - n[2] + 1);
    if (given == 5) {
        printf("%.9g %.9g\n", (double)f->time_s[frame],
               (double)value[at[2] * sheet + at[1] * row + at[0]]);
    } else {
        double low = INFINITY, high = -INFINITY, sum = 0;
        for (size_t i = 0; i < f->values; ++i) {
            low = fmin(low, (double)value[i]);
            high = fmax(high, (double)value[i]);
            sum += (double)value[i];
        }
        printf("%.9g %zu %.9g %.9g %.12g\n", (double)f->time_s[frame],
               (size_t)f->values, low, high, sum);
    }
    free(value);
    return 0;
}

int main(void)
{
    char line[4096], path[2048];
    size_t frame, at[3] = {0};
    int failures = 0;
    while (fgets(line, sizeof line, stdin)) {
        const int given = sscanf(line, "%2047s %zu %zu %zu %zu", path, &frame,
                                 &at[0], &at[1], &at[2]);
        murk_fds_frames frames;
        murk_error err = {0};
        const bool is_smoke3d = strstr(path, ".s3d") != NULL;
        if (murk_fds_frames_open(&frames, path, is_smoke3d, path, &err)) {
            printf("failed: %s\n", err.text);
            ++failures;
        } else {
            failures += print_frame(&frames, frame, given, at);
        }
        murk_fds_frames_close(&frames);
    }
    return failures > 0;
}
