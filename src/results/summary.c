/* Collects the lines of the summary in a list, which goes into the main JSON,
 * and shows them later; and lines that several commands print. */
#include "results/summary.h"

#include "base/machine.h"

static void append(void *list, const char *line)
{
    cJSON_AddItemToArray(list, cJSON_CreateString(line));
}

cJSON *murk_print_collect(murk_print_results *print, const void *of)
{
    cJSON *list = cJSON_CreateArray();
    murk_print_into(append, list, print, of);
    return list;
}

void murk_print_time(const murk_run_facts *run, const char *other,
                     double other_s)
{
    const struct {
        const char *name;
        double seconds;
    } part[] = {{"load", run->load_s},   {"trace", run->trace_s},
                {"maps", run->map_s},    {"sense", run->sense_s},
                {"place", run->place_s}, {other ? other : "", other_s}};
    murk_print("time        %.2f s", run->total_s);
    const char *between = ": ";
    for (size_t i = 0; i < sizeof part / sizeof *part; ++i) {
        if (part[i].seconds >= .005) {
            murk_print("%s%s %.2f", between, part[i].name, part[i].seconds);
            between = ", ";
        }
    }
    murk_print("; memory %.2g GB\n", murk_machine_peak_bytes() / 1e9);
}

void murk_print_more(size_t n, const char *folder, const char *file)
{
    if (n <= MURK_PRINTED_ROWS) {
        return;
    }
    if (folder) {
        murk_print("            ... and %zu more in %s/%s\n",
                   n - MURK_PRINTED_ROWS, folder, file);
    } else {
        murk_print("            ... and %zu more; -o DIR writes all to %s\n",
                   n - MURK_PRINTED_ROWS, file);
    }
}
