/* Memory of the machine as the operating system reports it: /proc/meminfo and
 * the limits and usage of the process. */
#include "base/machine.h"

#include <math.h>
#include <stdio.h>
#include <sys/resource.h>

double murk_machine_memory_bytes(void)
{
    double bytes = INFINITY;
    FILE *file = fopen("/proc/meminfo", "r");
    if (file) {
        char line[128];
        double kilobytes = 0;
        while (fgets(line, sizeof line, file)) {
            if (sscanf(line, "MemAvailable: %lf kB", &kilobytes) == 1) {
                bytes = kilobytes * 1024;
            }
        }
        fclose(file);
    }
    struct rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
        bytes = fmin(bytes, (double)limit.rlim_cur);
    }
    return bytes;
}

double murk_machine_peak_bytes(void)
{
    struct rusage usage;
    return getrusage(RUSAGE_SELF, &usage) == 0 ? (double)usage.ru_maxrss * 1024
                                               : NAN;
}
