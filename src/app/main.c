#include "app/options.h"
#include "app/version.h"
#include "base/interrupt.h"
#include "base/progress.h"

#include <signal.h>
#include <string.h>

static void print_version(void)
{
    printf("murk %s (commit %s, %s)\n", MURK_VERSION, murk_version_commit(),
           murk_version_compiler());
    for (size_t i = 0; i < murk_packages_count; ++i) {
        printf("  %s %s\n", murk_packages[i].name, murk_packages[i].version);
    }
}

static murk_status run(const murk_options *options, murk_error *err)
{
    if (options->wants_version) {
        print_version();
        return MURK_OK;
    }
    if (options->wants_man) {
        murk_man_print(stdout, options->command);
        return MURK_OK;
    }
    if (options->wants_help) {
        murk_help_print(stdout, options->command);
        return MURK_OK;
    }
    return options->command->run(options, err);
}

/* "murk: WHERE: TEXT"; where may be empty. */
static void print_error(const murk_error *err)
{
    murk_progress_hide(); /* what a step that was cut short may have left */
    fprintf(stderr, "murk: %s%s%s\n", err->where, *err->where ? ": " : "",
            err->text);
    murk_progress_show();
}

int main(int argc, char **argv)
{
    /* a closed pipe or a file-size limit is an error to report, not an end */
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    murk_interrupt_install();

    murk_options options;
    murk_error err = {0};
    murk_status status = murk_options_parse(&options, argc, argv, &err);
    if (!status) {
        status = run(&options, &err);
    }
    if (!status && (fflush(stdout) != 0 || ferror(stdout))) {
        status = murk_fail(&err, MURK_RUN_FAILED, "",
                           "cannot write to standard output");
    }
    if (status) {
        /* whatever failed after Ctrl-C failed because of it */
        if (murk_interrupted()) {
            status = MURK_INTERRUPTED;
            err = (murk_error){.text = "interrupted"};
        }
        print_error(&err);
    }
    murk_options_release(&options);
    return murk_status_exit_code(status);
}
