/* murk against its reference numbers: the program behind tools/validate and
 * the ctest entries physics/validate-GROUP (quick form) and
 * nightly/validate-GROUP.
 *
 *   validate [--quick] [--seed N] [--threads N] [--csv FILE] [CASE...]
 *   validate [--csv FILE] --join FILE...
 *
 * --join traces nothing: its rows, their forms and their one seed are those of
 * earlier runs' --csv files.
 *
 * Markdown goes to standard output, progress to standard error. Exit: 0 all
 * within the limit, 1 not, 2 usage. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
#include "cases/groups.h"

typedef struct group {
    const char *name;
    void (*run)(validation *v);
} group;

#define X(name) {#name, cases_##name},
static const group groups[] = {VALIDATION_GROUPS(X)};
#undef X

#define GROUPS (sizeof groups / sizeof groups[0])

static int usage(const char *what)
{
    fprintf(
        stderr,
        "validate: %s\nusage: validate [--quick] [--seed N] [--threads N] "
        "[--csv FILE] [GROUP | GROUP/PART-OF-CASE ...]\n       validate [--csv "
        "FILE] --join FILE...\n"
        "groups:",
        what);
    for (size_t i = 0; i < GROUPS; ++i) {
        fprintf(stderr, " %s", groups[i].name);
    }
    fprintf(stderr, "\n");
    return 2;
}

/* True where the wanted word names the group, alone or before a slash. */
static bool names_group(const char *word, const char *name)
{
    const size_t length = strlen(name);
    return strncmp(word, name, length) == 0 &&
           (word[length] == '\0' || word[length] == '/');
}

static bool is_wanted(const validation_settings *s, const char *name)
{
    for (size_t i = 0; i < s->n_wanted; ++i) {
        if (names_group(s->wanted[i], name)) {
            return true;
        }
    }
    return s->n_wanted == 0;
}

static bool is_known(const char *word)
{
    for (size_t i = 0; i < GROUPS; ++i) {
        if (names_group(word, groups[i].name)) {
            return true;
        }
    }
    return false;
}

static bool reads_number(const char *text, unsigned long min, unsigned long max,
                         unsigned long *out)
{
    char *end = NULL;
    errno = 0;
    *out = text ? strtoul(text, &end, 10) : 0;
    return text && *text >= '0' && *text <= '9' && *end == '\0' && errno == 0 &&
           *out >= min && *out <= max;
}

static int write_csv(const validation *v, const char *path)
{
    FILE *file = fopen(path, "w");
    if (!file) {
        fprintf(stderr, "validate: cannot write %s: %s\n", path,
                strerror(errno));
        return 1;
    }
    validation_csv(v, file);
    const bool failed = ferror(file);
    if (fclose(file) != 0 || failed) {
        fprintf(stderr, "validate: cannot write %s\n", path);
        return 1;
    }
    return 0;
}

typedef struct options {
    validation_settings settings;
    const char *csv; /* NULL: none */
    bool joins;      /* words name files, else cases */
    const char *const *word;
    size_t words;
} options;

/* Returns 0, or the exit status. */
static int read_options(options *o, int argc, char **argv)
{
    /* Options come first; --join ends them. */
    bool names_seed = false;
    int i = 1;
    for (; i < argc && !o->joins && strncmp(argv[i], "--", 2) == 0; ++i) {
        unsigned long number = 0;
        if (strcmp(argv[i], "--quick") == 0) {
            o->settings.is_quick = true;
        } else if (strcmp(argv[i], "--join") == 0) {
            o->joins = true;
        } else if (strcmp(argv[i], "--seed") == 0) {
            if (!reads_number(argv[++i], 0, UINT32_MAX, &number)) {
                return usage("--seed needs 0..4294967295");
            }
            o->settings.seed = (uint32_t)number;
            names_seed = true;
        } else if (strcmp(argv[i], "--threads") == 0) {
            if (!reads_number(argv[++i], 1, 1024, &number)) {
                return usage("--threads needs 1..1024");
            }
            o->settings.threads = (unsigned)number;
        } else if (strcmp(argv[i], "--csv") == 0) {
            o->csv = argv[++i];
            if (!o->csv) {
                return usage("--csv needs a file");
            }
        } else {
            return usage("no such option");
        }
    }
    /* Remaining words are files to join, or cases. */
    o->word = (const char *const *)argv + i;
    o->words = (size_t)(argc - i);
    if (!o->joins) {
        o->settings.wanted = o->word;
        o->settings.n_wanted = o->words;
    }
    /* Refuse options that joined files determine, and unknown cases. */
    if (o->joins && (o->settings.is_quick || names_seed)) {
        return usage("--join takes form and seed from its files");
    }
    for (size_t k = 0; k < o->settings.n_wanted; ++k) {
        if (!is_known(o->word[k])) {
            return usage(o->word[k]);
        }
    }
    return 0;
}

static void run(validation *v, const options *o)
{
    for (size_t k = 0; k < o->words && o->joins; ++k) {
        validation_join(v, o->word[k]);
    }
    for (size_t k = 0; k < GROUPS && !o->joins; ++k) {
        if (is_wanted(&o->settings, groups[k].name)) {
            validation_group(v, groups[k].name);
            groups[k].run(v);
        }
    }
}

int main(int argc, char **argv)
{
    options o = {.settings = {.threads = murk_pool_processors(), .seed = 1}};
    const int status = read_options(&o, argc, argv);
    if (status) {
        return status;
    }
    validation *v = validation_create(&o.settings);
    run(v, &o);
    validation_markdown(v, stdout);
    int exit_code = validation_passed(v) ? 0 : 1;
    if (o.csv && write_csv(v, o.csv)) {
        exit_code = 1;
    }
    validation_destroy(v);
    return exit_code;
}
