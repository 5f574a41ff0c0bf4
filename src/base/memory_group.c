/* Reads the limits of control groups. Each group lies in a folder of the group
 * that contains it, whose limit holds, too, so all folders up to the root are
 * looked at. A container may show its own group as the root. */
#include "base/memory_group.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* The longest line and path: PATH_MAX of Linux. */
#define LINE_SIZE 4096

/* The names of a version of control groups. */
typedef struct version {
    const char *controller; /* in the list of groups */
    const char *folder;     /* below the root */
    const char *limit, *usage;
    const char *inactive, *active; /* keys of memory.stat: pages of files, which
                                    * the system takes back when it is short */
} version;

static const version versions[] = {
    {"memory", "/memory", "memory.limit_in_bytes", "memory.usage_in_bytes",
     "total_inactive_file", "total_active_file"},
    {"", "", "memory.max", "memory.current", "inactive_file", "active_file"},
    {"", "/unified", "memory.max", "memory.current", "inactive_file",
     "active_file"}};

/* The number in a file of a group; NAN if there is none, as for "max". */
static double read_number(const char *folder, const char *name)
{
    char path[LINE_SIZE + 64];
    double value = NAN;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "r");
    if (file) {
        if (fscanf(file, "%lf", &value) != 1) {
            value = NAN;
        }
        fclose(file);
    }
    return value;
}

/* The value of a key of memory.stat; 0 if it is missing. */
static double read_stat(const char *folder, const char *key)
{
    char path[LINE_SIZE + 64], line[256], name[128];
    double value, found = 0;
    snprintf(path, sizeof path, "%s/memory.stat", folder);
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file)) {
        if (sscanf(line, "%127s %lf", name, &value) == 2 &&
            strcmp(name, key) == 0) {
            found = value;
        }
    }
    if (file) {
        fclose(file);
    }
    return found;
}

/* The memory that a group and those around it leave. */
static double left_in(const version *v, const char *root, const char *group)
{
    char folder[LINE_SIZE];
    double left = INFINITY;
    const int base = snprintf(folder, sizeof folder, "%s%s", root, v->folder);
    const int length =
        snprintf(folder, sizeof folder, "%s%s%s", root, v->folder, group);
    bool goes_on = base > 0 && length >= base && length < LINE_SIZE;
    while (goes_on) {
        const double limit = read_number(folder, v->limit);
        const double usage = read_number(folder, v->usage);
        if (limit >= 0 && usage >= 0) {
            left = fmin(left, limit - usage + read_stat(folder, v->inactive) +
                                  read_stat(folder, v->active));
        }
        char *slash = strrchr(folder, '/');
        goes_on = slash && slash - folder >= base;
        if (goes_on) {
            *slash = '\0';
        }
    }
    return fmax(left, 0);
}

/* Splits a line "number:controllers:group"; false if it is another one. */
static bool split_line(char *line, char **controllers, char **group)
{
    char *first = strchr(line, ':');
    char *second = first ? strchr(first + 1, ':') : NULL;
    if (!second) {
        return false;
    }
    *second = '\0';
    *controllers = first + 1;
    *group = second + 1;
    (*group)[strcspn(*group, "\n")] = '\0';
    return true;
}

/* True if a list of controllers, separated by commas, has this one; the empty
 * list is that of version 2. */
static bool has_controller(const char *list, const char *name)
{
    const size_t length = strlen(name);
    bool has = strcmp(list, name) == 0;
    for (const char *at = list; !has && length > 0 && at;) {
        has = strncmp(at, name, length) == 0 &&
              (at[length] == ',' || at[length] == '\0');
        at = strchr(at, ',');
        at = at ? at + 1 : NULL;
    }
    return has;
}

double murk_memory_group_bytes(const char *list, const char *root)
{
    char line[LINE_SIZE];
    double left = INFINITY;
    FILE *file = fopen(list, "r");
    while (file && fgets(line, sizeof line, file)) {
        char *controllers, *group;
        if (!split_line(line, &controllers, &group)) {
            continue;
        }
        for (size_t i = 0; i < sizeof versions / sizeof *versions; ++i) {
            if (has_controller(controllers, versions[i].controller)) {
                left = fmin(left, left_in(&versions[i], root, group));
            }
        }
    }
    if (file) {
        fclose(file);
    }
    return left;
}
