/* What a receiver of progress is told while steps are nested: the step with a
 * known total inside of a search without one, and the text of the search. The
 * wait for a call has no bound but the time limit of the test. */
#include "base/progress.h"
#include "check.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

/* The state of the last call. */
typedef struct heard {
    pthread_mutex_t lock;
    pthread_cond_t wakes;
    uint64_t calls, done, total;
    char step[32], text[64];
} heard;

static void hear(void *user, const murk_progress_facts *facts)
{
    heard *h = user;
    pthread_mutex_lock(&h->lock);
    ++h->calls;
    h->done = facts->done;
    h->total = facts->total;
    snprintf(h->step, sizeof h->step, "%s", facts->step);
    snprintf(h->text, sizeof h->text, "%s", facts->text);
    pthread_cond_signal(&h->wakes);
    pthread_mutex_unlock(&h->lock);
}

/* Waits for two calls, of which the second has begun after this function, and
 * compares the state. */
static void check_reported(heard *h, const char *step, uint64_t done,
                           uint64_t total, const char *text)
{
    pthread_mutex_lock(&h->lock);
    for (const uint64_t end = h->calls + 2; h->calls < end;) {
        pthread_cond_wait(&h->wakes, &h->lock);
    }
    CHECK_TEXT(h->step, step);
    CHECK_TEXT(h->text, text);
    CHECK(h->done == done && h->total == total);
    pthread_mutex_unlock(&h->lock);
}

int main(void)
{
    heard h = {.lock = PTHREAD_MUTEX_INITIALIZER,
               .wakes = PTHREAD_COND_INITIALIZER};
    murk_progress_to(hear, &h);
    /* A search before it has a text, with one, and with light that it needs. */
    murk_progress_begin_group("fit", 0, "steps");
    check_reported(&h, "fit", 0, 0, "");
    murk_progress_text("chi2 %d", 12);
    check_reported(&h, "fit", 0, 0, "chi2 12");
    murk_progress_begin("trace", 10, "photons");
    murk_progress_add(4);
    check_reported(&h, "trace", 4, 10, "chi2 12");
    /* Of two known totals, the outermost. */
    murk_progress_begin("sense", 3, "sensors");
    murk_progress_add(1);
    check_reported(&h, "trace", 4, 10, "chi2 12");
    murk_progress_end();
    murk_progress_end();
    murk_progress_add_to_group(2);
    check_reported(&h, "fit", 2, 0, "chi2 12");
    /* The end is told by this thread. */
    murk_progress_add_to_group(1);
    murk_progress_end();
    CHECK(h.done == 3 && strcmp(h.step, "fit") == 0);
    murk_progress_to(NULL, NULL);
    return check_done();
}
