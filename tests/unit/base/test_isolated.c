/* Computations in a subprocess: a failure is passed on, with or without a
 * message. Nothing here is random. */
#include "base/isolated.h"
#include "check.h"

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
    (void)context;
    return murk_isolated_send(process, "ab", 2, err);
}

static murk_status count(void *context, const char *bytes, size_t size,
                         murk_error *err)
{
    (void)bytes;
    (void)err;
    *(size_t *)context += size;
    return MURK_OK;
}

int main(void)
{
    size_t received = 0;
    murk_error err = {0};
    CHECK(murk_isolated_run(succeeds, NULL, count, &received, &err) == MURK_OK);
    CHECK(received == 2 && err.code == MURK_OK);
    CHECK(murk_isolated_run(fails, NULL, count, &received, &err) ==
          MURK_BAD_FILE);
    CHECK_TEXT(err.where, "a.yaml");
    CHECK_TEXT(err.text, "too short");
    err = (murk_error){0};
    CHECK(murk_isolated_run(fails_silently, NULL, count, &received, &err) ==
          MURK_BAD_VALUE);
    CHECK(err.code == MURK_BAD_VALUE && err.text[0] != '\0');
    return check_done();
}
