/* Computations in a process of their own, and in the calling process: messages
 * come in order, a failure is passed on, with or without a message, and
 * warnings of the receiver are those of the caller. Nothing here is random. */
#include "base/host.h"
#include "base/interrupt.h"
#include "base/isolated.h"
#include "base/log.h"
#include "check.h"

#include <string.h>

static murk_status fails_silently(murk_isolated *process, void *context,
                                  murk_error *err)
{
    (void)process;
    (void)context;
    (void)err;
    return MURK_BAD_VALUE;
}

static murk_status fails(murk_isolated *process, void *context, murk_error *err)
{
    (void)process;
    (void)context;
    return murk_fail(err, MURK_BAD_FILE, "a.yaml", "too %s", "short");
}

static murk_status succeeds(murk_isolated *process, void *context,
                            murk_error *err)
{
    const bool is_subprocess = murk_isolated_is_subprocess(process);
    (void)context;
    murk_warn_to(NULL);
    const murk_status status = murk_isolated_send(process, "ab", 2, err);
    return status
               ? status
               : murk_isolated_send(process, is_subprocess ? "c" : "d", 1, err);
}

/* The text of all messages. */
static murk_status append(void *context, const char *bytes, size_t size,
                          murk_error *err)
{
    CHECK(bytes[size] == '\0');
    (void)err;
    strcat(context, bytes);
    murk_warn("", "a warning of the receiver");
    return MURK_OK;
}

static murk_status refuses(void *context, const char *bytes, size_t size,
                           murk_error *err)
{
    (void)context;
    (void)bytes;
    (void)size;
    return murk_fail(err, MURK_RUN_FAILED, "disk", "full");
}

static int warnings;

static void count_warning(const char *where, const char *text)
{
    (void)where;
    (void)text;
    ++warnings;
}

static const murk_isolated_job ending_well = {.work = succeeds},
                               ending_badly = {.work = fails},
                               ending_silently = {.work = fails_silently};

static void test_mode(murk_importing importing, const char *expected)
{
    char text[8] = "";
    murk_error err = {0};
    murk_host_now()->importing = importing;
    murk_warn_to(count_warning);
    warnings = 0;
    CHECK(!murk_isolated_do(&ending_well, NULL, "1", append, text, &err));
    CHECK_TEXT(text, expected);
    murk_warn("", "a warning of the caller");
    CHECK(warnings == 3 && err.code == MURK_OK);
    CHECK(murk_isolated_do(&ending_badly, NULL, "1", append, text, &err) ==
          MURK_BAD_FILE);
    CHECK_TEXT(err.where, "a.yaml");
    CHECK_TEXT(err.text, "too short");
    err = (murk_error){0};
    CHECK(murk_isolated_do(&ending_silently, NULL, "1", append, text, &err) ==
          MURK_BAD_VALUE);
    CHECK(err.code == MURK_BAD_VALUE && err.text[0] != '\0');
    err = (murk_error){0};
    CHECK(murk_isolated_do(&ending_well, NULL, "1", refuses, NULL, &err) ==
          MURK_RUN_FAILED);
    CHECK_TEXT(err.text, "full");
}

static void test_no_program(void)
{
    murk_error err = {0};
    murk_host *host = murk_host_now();
    CHECK(!murk_isolated_check(&err)); /* the host does not ask for it */
    host->importing = MURK_IMPORT_STARTS;
    host->reader = "nowhere/murk-reader";
    CHECK(murk_isolated_check(&err) == MURK_RUN_FAILED);
    CHECK(strstr(err.text, "nowhere/murk-rows") != NULL);
}

/* What was computed after a request to stop may be incomplete. */
static void test_interrupt(void)
{
    char text[8] = "";
    murk_error err = {0};
    murk_host_now()->importing = MURK_IMPORT_IN_PROCESS;
    murk_interrupt_request();
    CHECK(murk_isolated_do(&ending_well, NULL, "1", append, text, &err) ==
          MURK_INTERRUPTED);
    CHECK_TEXT(text, "");
}

int main(void)
{
    test_mode(MURK_IMPORT_FORKS, "abc");
    test_mode(MURK_IMPORT_IN_PROCESS, "abd");
    test_no_program();
    test_interrupt();
    return check_done();
}
