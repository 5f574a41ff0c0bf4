/* The command line: sets up signals, parses the words, runs the command, and
 * turns its status into an exit code (app/program.h). With ranks (base/ranks.h)
 * rank 0 alone prints. */
#include "app/program.h"

#include "app/command_line.h"
#include "app/field.h"
#include "app/help.h"
#include "app/lookup.h"
#include "app/terminal.h"
#include "base/pool.h"
#include "base/ranks.h"

#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What a shell calls the end by SIGPIPE: 128 + 13. */
#define READER_GONE 141

#define VERSION_SIZE 128 /* of a version with the commit */

static murk_status print_version(murk_error *err)
{
    murk_lookup lookup;
    const murk_status status = murk_lookup_begin(&lookup, "version", err);
    if (!status) {
        const murk_fields *f = lookup.fields;
        printf("murk %s (commit %s, %s)\n", murk_version(),
               murk_field_text(f, "commit"), murk_field_text(f, "compiler"));
        for (size_t i = 0; i < murk_field_length(f, "packages"); ++i) {
            const char *name = murk_fields_name(f, "packages", i);
            printf("  %s %s\n", name, murk_field_text(f, "packages.%s", name));
        }
    }
    murk_lookup_end(&lookup);
    return status;
}

static murk_status run_command(murk_options *options, murk_error *err)
{
    murk_status status = murk_page_check(options, err);
    if (!status) {
        status = murk_terminal_begin(options, err);
    }
    if (!status) {
        status = options->command->run(options, err);
    }
    return status ? status : murk_page_write(options, err);
}

/* Fails unless all ranks run the same build of murk with the same words. */
static murk_status check_same(const murk_options *options, murk_error *err)
{
    char version[VERSION_SIZE] = "", *text = NULL;
    size_t size = 0;
    murk_status status = murk_lookup_version(version, sizeof version, err);
    FILE *to = open_memstream(&text, &size);
    if (to) {
        fprintf(to, "%s", version);
        for (size_t i = 0; i < options->repeated.n; ++i) {
            fprintf(to, "\n%s", options->repeated.word[i]);
        }
    }
    if (!to || fclose(to) != 0) {
        status = murk_no_memory(err, "", "for the options");
    }
    status = murk_ranks_check_same("build of murk, or other options,", text,
                                   size, status, err);
    free(text);
    return status;
}

/* Runs a command that ranks divide, in all ranks, or another one in rank 0
 * alone. What the other ranks would print goes nowhere. */
static murk_status run_on_ranks(murk_options *options, murk_error *err)
{
    const bool is_first = murk_ranks_number() == 0;
    murk_status status = MURK_OK;
    if (options->shard.count) {
        status = murk_fail(err, MURK_BAD_VALUE, "--shard",
                           "not with several ranks, which divide the work "
                           "themselves");
    } else if (!is_first && !freopen("/dev/null", "w", stdout)) {
        status =
            murk_fail(err, MURK_RUN_FAILED, "/dev/null", "cannot be opened");
    }
    /* All ranks must run the same command. */
    if (!status) {
        status = check_same(options, err);
    }
    if (status || (!options->command->has_ranks && !is_first)) {
        return status;
    }
    if (options->command->has_ranks) {
        options->quiet |= !is_first;
        options->progress = is_first ? options->progress : MURK_PROGRESS_NEVER;
        murk_ranks_keep_in_first(options->command->ends_in_first);
        return run_command(options, err);
    }
    const murk_ranks *ranks = murk_ranks_leave();
    status = run_command(options, err);
    murk_ranks_return(ranks);
    return status;
}

static murk_status run(murk_options *options, murk_error *err)
{
    options->has_threads = murk_ranks_threads() > 0 || /* those of MPI */
                           (options->command && options->command->holds_worlds);
    if (options->wants_version) {
        return print_version(err);
    }
    if (murk_option_is_given(options, "--completion")) {
        return murk_completion_print(
            stdout, murk_option_number(options, "--completion", 0), err);
    }
    if (options->wants_man) {
        return murk_man_print(stdout, options->command, err);
    }
    if (options->wants_help) {
        murk_help_print(stdout, options->command);
        return MURK_OK;
    }
    return murk_ranks_count() > 1 ? run_on_ranks(options, err)
                                  : run_command(options, err);
}

/* True if standard output is a pipe that nobody reads any more, as after
 * `murk ... | head`: then Linux and POSIX report POLLERR at its writing end. */
static bool is_reader_gone(void)
{
    struct pollfd output = {.fd = STDOUT_FILENO, .events = POLLOUT};
    return poll(&output, 1, 0) > 0 && (output.revents & POLLERR);
}

static int run_program(int argc, char **argv)
{
    /* a file-size limit is an error to report; a closed pipe ends the program
     * at the end alone, so that the results that are asked for are written */
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);

    murk_options options;
    murk_error err = {0};
    murk_status status = murk_options_parse(&options, argc, argv, &err);
    if (!status) {
        status = run(&options, &err);
    }
    if (!status && (fflush(stdout) != 0 || ferror(stdout))) {
        if (is_reader_gone() && murk_ranks_count() == 1) {
            murk_options_release(&options);
            return READER_GONE;
        }
        status = murk_fail(&err, MURK_RUN_FAILED, "",
                           "cannot write to standard output");
    }
    if (status) {
        /* whatever failed after Ctrl-C failed because of it */
        if (murk_terminal_interrupted()) {
            status = MURK_INTERRUPTED;
            err = (murk_error){.text = "interrupted"};
        }
    }
    status = murk_ranks_agree(status, &err);
    if (status) {
        murk_terminal_fail(&options, &err);
    }
    murk_options_release(&options);
    return murk_status_exit_code(status);
}

typedef struct call {
    int argc, exit_code;
    char **argv;
} call;

static void run_call(void *context)
{
    call *c = context;
    c->exit_code = run_program(c->argc, c->argv);
}

int murk_program(int argc, char **argv)
{
    call c = {.argc = argc, .argv = argv};
    murk_pool_run_with_stack(run_call, &c);
    return c.exit_code;
}
