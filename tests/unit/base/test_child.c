/* A child's death, greed or silence becomes one clear error, and nothing
 * else. */
#include "base/child.h"
#include "check.h"

#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

static murk_status sends(murk_child *child, void *context, murk_error *err)
{
    (void)err;
    const char *text = context;
    murk_status status = murk_child_send(child, text, strlen(text));
    return status ? status : murk_child_send(child, "!", 2);
}

static murk_status fails(murk_child *child, void *context, murk_error *err)
{
    (void)child;
    (void)context;
    return murk_fail(err, MURK_BAD_VALUE, "deep.vdb", "density is -1");
}

static murk_status crashes(murk_child *child, void *context, murk_error *err)
{
    (void)child;
    (void)context;
    (void)err;
    raise(SIGKILL);
    return MURK_OK;
}

static murk_status exits(murk_child *child, void *context, murk_error *err)
{
    (void)child;
    (void)context;
    if (!err->status) {
        _exit(3);
    }
    return MURK_OK;
}

static murk_status spins(murk_child *child, void *context, murk_error *err)
{
    (void)child;
    (void)err;
    volatile unsigned *count = context;
    while (*count != 1) { /* counts in twos from 0: never 1 */
        *count += 2;
    }
    return MURK_OK;
}

static murk_status floods(murk_child *child, void *context, murk_error *err)
{
    (void)context;
    (void)err;
    static const char block[65536] = {1};
    for (int i = 0; i < 1000; ++i) {
        if (murk_child_send(child, block, sizeof block)) {
            break;
        }
    }
    return MURK_OK;
}

static murk_error run(murk_child_work work, void *context,
                      const murk_child_limits *limits, unsigned char **bytes,
                      size_t *size)
{
    murk_error err = {0};
    *bytes = NULL;
    *size = 0;
    const murk_status status =
        murk_child_run(bytes, size, work, context, limits, "a.vdb", &err);
    CHECK(status == err.status);
    return err;
}

int main(void)
{
    murk_child_limits limits = murk_child_limits_for(1000);
    CHECK(limits.memory_bytes == 2000000000);
    CHECK(murk_child_limits_for(UINT64_C(1) << 40).memory_bytes == UINT64_C(1)
                                                                       << 43);
    limits.seconds = 1;
    limits.handed_bytes = 1000000;
    unsigned char *bytes;
    size_t size;

    char hello[] = "hello";
    murk_error err = run(sends, hello, &limits, &bytes, &size);
    CHECK(err.status == MURK_OK);
    CHECK(size == 7 && bytes && strcmp((char *)bytes, "hello!") == 0);
    free(bytes);

    err = run(fails, NULL, &limits, &bytes, &size);
    CHECK(err.status == MURK_BAD_VALUE && !bytes);
    CHECK_TEXT(err.where, "deep.vdb");
    CHECK_TEXT(err.text, "density is -1");

    err = run(crashes, NULL, &limits, &bytes, &size);
    CHECK(err.status == MURK_BAD_FILE && !bytes);
    CHECK_TEXT(err.where, "a.vdb");

    err = run(exits, NULL, &limits, &bytes, &size);
    CHECK(err.status == MURK_BAD_FILE && !bytes);
    CHECK_MENTIONS(err.text, "gave up");

    unsigned count = 0;
    err = run(spins, &count, &limits, &bytes, &size);
    CHECK(err.status == MURK_BAD_FILE && !bytes);
    CHECK_MENTIONS(err.text, "takes more than 1 s");

    err = run(floods, NULL, &limits, &bytes, &size);
    CHECK(err.status == MURK_BAD_FILE && !bytes);
    CHECK_MENTIONS(err.text, "holds more than");
    return check_done();
}
