/* The functions of base/ranks.h, with ranks as threads: sums, arrays that are
 * completed, gathered bytes, joined blocks, failures, items that are dealt out,
 * and the shares of ranks. Exchanges with a defect are noticed. */
#include "base/host.h"
#include "check.h"
#include "thread_ranks.h"

#include <stdatomic.h>
#include <stdlib.h>

enum { WORDS = 6, ITEMS = 1000 };

static const unsigned counts[] = {1, 2, 3, 5, 8};
enum { COUNTS = sizeof counts / sizeof *counts };

/* ---- sums ---- */

/* Each rank r has these words; their sums carry beyond 64 bits. */
static uint64_t word_of(unsigned rank, size_t i)
{
    return i % 2 == 0 ? UINT64_MAX - rank * i : rank + i;
}

typedef struct sums {
    uint64_t plain[THREAD_RANKS_MAX][WORDS], wide[THREAD_RANKS_MAX][WORDS];
} sums;

static murk_status add_up(void *context, unsigned number, murk_error *err)
{
    sums *s = context;
    for (size_t i = 0; i < WORDS; ++i) {
        s->plain[number][i] = s->wide[number][i] = word_of(number, i);
    }
    murk_status status =
        murk_ranks_sum(s->plain[number], WORDS, false, MURK_OK, err);
    status = murk_ranks_sum(s->wide[number], WORDS, true, status, err);
    return murk_ranks_sum(NULL, 0, false, status, err);
}

/* True if all ranks have the sums. */
static bool sums_are_right(unsigned count, thread_ranks_defect defect)
{
    sums s;
    const thread_ranks_end end = thread_ranks_run(count, defect, add_up, &s);
    bool is_right = thread_ranks_succeeded(&end, count);
    for (size_t i = 0; i < WORDS; i += 2) {
        uint64_t low = 0, high = 0, carries = 0;
        for (unsigned r = 0; r < count; ++r) {
            low += word_of(r, i);
            carries += low < word_of(r, i);
            high += word_of(r, i + 1);
        }
        for (unsigned r = 0; r < count; ++r) {
            is_right = is_right && s.plain[r][i] == low &&
                       s.plain[r][i + 1] == high && s.wide[r][i] == low &&
                       s.wide[r][i + 1] == high + carries;
        }
    }
    return is_right;
}

static void test_sums(void)
{
    for (size_t c = 0; c < COUNTS; ++c) {
        CHECK(sums_are_right(counts[c], THREAD_RANKS_SOUND));
    }
    CHECK(!sums_are_right(3, THREAD_RANKS_LOSE_WORDS));
    CHECK(!sums_are_right(3, THREAD_RANKS_LOSE_CARRY));
}

/* ---- arrays that are completed ---- */

/* No multiple of a word. */
enum { BYTES = 8 * 7 + 3 };

typedef struct completed {
    char bytes[THREAD_RANKS_MAX][BYTES + 1];
} completed;

static murk_status complete(void *context, unsigned number, murk_error *err)
{
    char *bytes = ((completed *)context)->bytes[number];
    memset(bytes, 0, BYTES);
    bytes[BYTES] = 77; /* must stay */
    for (uint64_t k = 0; k < murk_ranks_share(BYTES); ++k) {
        const uint64_t i = murk_ranks_item(k);
        bytes[i] = (char)(i + 200);
    }
    murk_status status = murk_ranks_complete(NULL, 0, MURK_OK, err);
    return murk_ranks_complete(bytes, BYTES, status, err);
}

static bool array_is_complete(unsigned count, thread_ranks_defect defect)
{
    completed c;
    const thread_ranks_end end = thread_ranks_run(count, defect, complete, &c);
    bool is_right = thread_ranks_succeeded(&end, count);
    for (unsigned r = 0; r < count; ++r) {
        for (size_t i = 0; i < BYTES; ++i) {
            is_right = is_right && c.bytes[r][i] == (char)(i + 200);
        }
        is_right = is_right && c.bytes[r][BYTES] == 77;
    }
    return is_right;
}

static void test_an_array_is_completed(void)
{
    for (size_t c = 0; c < COUNTS; ++c) {
        CHECK(array_is_complete(counts[c], THREAD_RANKS_SOUND));
    }
    CHECK(!array_is_complete(5, THREAD_RANKS_LOSE_WORDS));
}

/* ---- gathered bytes ---- */

typedef struct gatherings {
    unsigned count;
    murk_gathered all[THREAD_RANKS_MAX];
} gatherings;

/* Rank r gives r * 3 bytes, and nothing if r is odd. */
static size_t size_of(unsigned rank)
{
    return rank % 2 == 0 ? 3 * (size_t)rank : 0;
}

static murk_status gather(void *context, unsigned number, murk_error *err)
{
    gatherings *g = context;
    char bytes[3 * THREAD_RANKS_MAX];
    memset(bytes, 'a' + (int)number, sizeof bytes);
    const size_t size = size_of(number);
    return murk_ranks_gather(&g->all[number], size ? bytes : NULL, size,
                             MURK_OK, err);
}

static bool bytes_are_gathered(unsigned count, thread_ranks_defect defect)
{
    gatherings g = {.count = count};
    const thread_ranks_end end = thread_ranks_run(count, defect, gather, &g);
    bool is_right = thread_ranks_succeeded(&end, count);
    for (unsigned r = 0; r < count; ++r) {
        const murk_gathered *all = &g.all[r];
        is_right = is_right && all->begin[0] == 0;
        for (unsigned from = 0; from < count; ++from) {
            const uint64_t begin = all->begin[from];
            is_right =
                is_right && all->begin[from + 1] - begin == size_of(from);
            for (uint64_t i = begin; i < all->begin[from + 1]; ++i) {
                is_right = is_right && all->bytes[i] == 'a' + (char)from;
            }
        }
        murk_gathered_release(&g.all[r]);
    }
    return is_right;
}

static void test_bytes_are_gathered(void)
{
    for (size_t c = 0; c < COUNTS; ++c) {
        CHECK(bytes_are_gathered(counts[c], THREAD_RANKS_SOUND));
    }
    CHECK(!bytes_are_gathered(3, THREAD_RANKS_FLIP_BIT));
}

/* One rank gives its bytes to itself. */
static void test_a_single_process_gathers_its_own_bytes(void)
{
    murk_gathered all;
    murk_error err = {0};
    CHECK(murk_ranks_gather(&all, "abc", 3, MURK_OK, &err) == MURK_OK);
    CHECK(all.begin[0] == 0 && all.begin[1] == 3);
    CHECK(memcmp(all.bytes, "abc", 3) == 0);
    murk_gathered_release(&all);
}

/* ---- blocks of an array ---- */

enum { BLOCKED = 7 }; /* of some ranks the block is empty */

typedef struct blocks {
    uint32_t item[THREAD_RANKS_MAX][BLOCKED];
} blocks;

static murk_status fill_block(void *context, unsigned number, murk_error *err)
{
    uint32_t *item = ((blocks *)context)->item[number];
    for (uint64_t i = 0; i < BLOCKED; ++i) {
        const bool is_own =
            i >= murk_ranks_begin(BLOCKED) && i < murk_ranks_end(BLOCKED);
        item[i] = is_own ? 100 + (uint32_t)i : 99; /* 99 must be replaced */
    }
    return murk_ranks_join(item, BLOCKED, sizeof *item, MURK_OK, err);
}

/* True if all ranks have all items. */
static bool blocks_are_joined(unsigned count, thread_ranks_defect defect)
{
    blocks b;
    const thread_ranks_end end =
        thread_ranks_run(count, defect, fill_block, &b);
    bool is_right = thread_ranks_succeeded(&end, count);
    for (unsigned r = 0; r < count; ++r) {
        for (uint32_t i = 0; i < BLOCKED; ++i) {
            is_right = is_right && b.item[r][i] == 100 + i;
        }
    }
    return is_right;
}

static void test_blocks_are_joined(void)
{
    for (size_t c = 0; c < COUNTS; ++c) {
        CHECK(blocks_are_joined(counts[c], THREAD_RANKS_SOUND));
    }
    CHECK(!blocks_are_joined(3, THREAD_RANKS_FLIP_BIT));
}

/* ---- failures that a caller tolerates ---- */

/* Rank 1 fails with `status`; then all ranks add a number. */
typedef struct tolerated {
    murk_status status, shared[THREAD_RANKS_MAX];
    uint64_t sum[THREAD_RANKS_MAX];
} tolerated;

static murk_status tolerate(void *context, unsigned number, murk_error *err)
{
    tolerated *t = context;
    const murk_status own = number == 1 && t->status
                                ? murk_fail(err, t->status, "", "lost")
                                : MURK_OK;
    t->shared[number] = murk_ranks_share_failure(own, err);
    t->sum[number] = 1;
    return murk_ranks_sum(&t->sum[number], 1, false, MURK_OK, err);
}

static void test_a_failure_that_is_shared_is_not_final(void)
{
    static const murk_status statuses[] = {MURK_OK, MURK_BAD_VALUE,
                                           MURK_NO_MEMORY};
    for (size_t k = 0; k < 3; ++k) {
        tolerated t = {.status = statuses[k]};
        const thread_ranks_end end =
            thread_ranks_run(3, THREAD_RANKS_SOUND, tolerate, &t);
        const bool is_final = statuses[k] == MURK_NO_MEMORY;
        for (unsigned r = 0; r < 3; ++r) {
            CHECK(t.shared[r] == statuses[k]);
            CHECK(end.status[r] == (is_final ? MURK_NO_MEMORY : MURK_OK));
            CHECK(is_final || t.sum[r] == 3);
        }
    }
}

/* ---- failures ---- */

typedef struct failures {
    unsigned first, second; /* ranks that fail */
    murk_status later[THREAD_RANKS_MAX][5];
    bool changed[THREAD_RANKS_MAX];
} failures;

/* Two ranks fail before a sum; then each rank tries all collective functions.
 */
static murk_status fail(void *context, unsigned number, murk_error *err)
{
    failures *f = context;
    murk_status status = MURK_OK;
    uint64_t word[2] = {number + 1, 7};
    murk_gathered all;
    murk_deal deal;
    if (number == f->first || number == f->second) {
        status =
            murk_fail(err, number == f->first ? MURK_BAD_FILE : MURK_RUN_FAILED,
                      "rank", "%u has failed", number);
    }
    murk_status *later = f->later[number];
    later[0] = murk_ranks_sum(word, 2, true, status, err);
    later[1] = murk_ranks_agree(MURK_OK, err);
    later[2] = murk_ranks_gather(&all, word, sizeof word, MURK_OK, err);
    later[3] = murk_ranks_complete(word, sizeof word, MURK_OK, err);
    later[4] = murk_ranks_deal(&deal, MURK_OK, err);
    f->changed[number] = word[0] != number + 1 || word[1] != 7;
    murk_gathered_release(&all);
    return later[0];
}

static void test_the_first_failure_reaches_all(void)
{
    failures f = {.first = 1, .second = 3};
    const thread_ranks_end end =
        thread_ranks_run(5, THREAD_RANKS_SOUND, fail, &f);
    for (unsigned r = 0; r < 5; ++r) {
        CHECK(end.status[r] == MURK_BAD_FILE);
        CHECK_TEXT(end.error[r].text, "1 has failed");
        CHECK_TEXT(end.error[r].where, "rank");
        CHECK(!f.changed[r]);
        for (size_t i = 0; i < 5; ++i) {
            CHECK(f.later[r][i] == MURK_BAD_FILE);
        }
    }
}

/* A rank that returns early is heard of at the next exchange of the others. */
static murk_status return_early(void *context, unsigned number, murk_error *err)
{
    uint64_t word = 1;
    (void)context;
    if (number == 2) {
        return murk_fail(err, MURK_RUN_FAILED, "", "no more");
    }
    return murk_ranks_sum(&word, 1, false, MURK_OK, err);
}

static void test_an_early_return_ends_all(void)
{
    const thread_ranks_end end =
        thread_ranks_run(3, THREAD_RANKS_SOUND, return_early, NULL);
    for (unsigned r = 0; r < 3; ++r) {
        CHECK(end.status[r] == MURK_RUN_FAILED);
        CHECK_TEXT(end.error[r].text, "no more");
    }
}

/* ---- items ---- */

typedef struct dealt {
    _Atomic unsigned times[2][ITEMS]; /* of two deals in succession */
} dealt;

static murk_status take_all(void *context, unsigned number, murk_error *err)
{
    dealt *d = context;
    murk_status status = MURK_OK;
    (void)number;
    for (size_t round = 0; round < 2 && !status; ++round) {
        murk_deal deal;
        status = murk_ranks_deal(&deal, status, err);
        for (uint64_t i = 0; !status && (i = murk_ranks_take(&deal)) < ITEMS;) {
            atomic_fetch_add(&d->times[round][i], 1);
        }
    }
    return status;
}

static bool items_are_dealt_once(unsigned count, thread_ranks_defect defect)
{
    dealt *d = calloc(1, sizeof *d);
    const thread_ranks_end end = thread_ranks_run(count, defect, take_all, d);
    bool is_right = thread_ranks_succeeded(&end, count);
    for (size_t i = 0; i < ITEMS; ++i) {
        is_right = is_right && d->times[0][i] == 1 && d->times[1][i] == 1;
    }
    free(d);
    return is_right;
}

static void test_each_item_is_dealt_once(void)
{
    for (size_t c = 0; c < COUNTS; ++c) {
        CHECK(items_are_dealt_once(counts[c], THREAD_RANKS_SOUND));
    }
    CHECK(!items_are_dealt_once(2, THREAD_RANKS_DEAL_TWICE));
}

/* ---- shares ---- */

enum { SHARED_MAX = 40 };

typedef struct shares {
    unsigned owned[THREAD_RANKS_MAX][SHARED_MAX + 1][SHARED_MAX + 1];
    bool is_wrong[THREAD_RANKS_MAX];
} shares;

static murk_status list_shares(void *context, unsigned number, murk_error *err)
{
    shares *s = context;
    (void)err;
    for (uint64_t n = 0; n <= SHARED_MAX; ++n) {
        uint64_t before = 0;
        for (uint64_t k = 0; k < murk_ranks_share(n); ++k) {
            const uint64_t item = murk_ranks_item(k);
            if (item >= n || !murk_ranks_owns(item) ||
                (k > 0 && item <= before)) {
                s->is_wrong[number] = true;
                break;
            }
            before = item;
            ++s->owned[number][n][item];
        }
    }
    /* A host that leaves its ranks owns all items, until it returns. */
    const murk_ranks *ranks = murk_ranks_leave();
    s->is_wrong[number] = s->is_wrong[number] || murk_ranks_count() != 1 ||
                          murk_ranks_share(9) != 9 || !murk_ranks_owns(1);
    murk_ranks_return(ranks);
    s->is_wrong[number] = s->is_wrong[number] || murk_ranks_number() != number;
    return MURK_OK;
}

/* Shares need no exchange, so a table of ranks without functions serves. Each
 * of n items belongs to the rank that finds it among its own. */
static void test_shares_of_hundreds_of_ranks(void)
{
    enum { ITEMS_MANY = 1000, RANKS_MANY = 300 };
    murk_ranks ranks = {.count = RANKS_MANY};
    const murk_ranks *before = murk_host_now()->ranks;
    murk_host_now()->ranks = &ranks;
    size_t found = 0;
    for (ranks.number = 0; ranks.number < RANKS_MANY; ++ranks.number) {
        const uint64_t share = murk_ranks_share(ITEMS_MANY);
        CHECK(share >= ITEMS_MANY / RANKS_MANY &&
              share <= ITEMS_MANY / RANKS_MANY + 1);
        for (uint64_t k = 0; k < share; ++k) {
            found += murk_ranks_item(k) < ITEMS_MANY &&
                     murk_ranks_owner(murk_ranks_item(k)) == ranks.number;
        }
    }
    CHECK(found == ITEMS_MANY);
    murk_host_now()->ranks = before;
}

/* Of each column of a grid that is a power of two wide, each of 2 or 4 ranks
 * gets a fair share. 200 items are 50 +- 6 for a rank of 4, and 5 standard
 * deviations less are 19; a column that belongs to one rank has 0 for another.
 */
static void test_columns_of_a_grid_are_shared(void)
{
    murk_ranks ranks = {.count = 0};
    const murk_ranks *before = murk_host_now()->ranks;
    murk_host_now()->ranks = &ranks;
    for (ranks.count = 2; ranks.count <= 4; ranks.count += 2) {
        for (uint64_t width = 2; width <= 64; width *= 2) {
            for (uint64_t column = 0; column < width; ++column) {
                unsigned of_rank[4] = {0};
                for (uint64_t row = 0; row < 200; ++row) {
                    ++of_rank[murk_ranks_owner(row * width + column)];
                }
                for (unsigned r = 0; r < ranks.count; ++r) {
                    CHECK(of_rank[r] >= 19);
                }
            }
        }
    }
    murk_host_now()->ranks = before;
}

static void test_shares_cover_all_items_once(void)
{
    for (unsigned count = 1; count <= THREAD_RANKS_MAX; ++count) {
        shares *s = calloc(1, sizeof *s);
        bool is_right = true;
        thread_ranks_run(count, THREAD_RANKS_SOUND, list_shares, s);
        for (uint64_t n = 0; n <= SHARED_MAX; ++n) {
            for (uint64_t i = 0; i < n; ++i) {
                unsigned owners = 0;
                for (unsigned r = 0; r < count; ++r) {
                    owners += s->owned[r][n][i];
                }
                is_right = is_right && owners == 1;
            }
        }
        for (unsigned r = 0; r < count; ++r) {
            is_right = is_right && !s->is_wrong[r];
        }
        CHECK(is_right);
        free(s);
    }
}

/* ---- equal bytes ---- */

typedef struct texts {
    const char *of[THREAD_RANKS_MAX];
    bool is_same[THREAD_RANKS_MAX];
} texts;

/* Compares the texts of all ranks, then fails if they differ. */
static murk_status compare_texts(void *context, unsigned number,
                                 murk_error *err)
{
    texts *t = context;
    const char *own = t->of[number];
    const murk_status status =
        murk_ranks_compare(&t->is_same[number], own, strlen(own), MURK_OK, err);
    return murk_ranks_check_same("text", own, strlen(own), status, err);
}

static void test_other_bytes_of_a_rank_are_noticed(void)
{
    texts t = {.of = {"fog", "fog", "fog", "fig"}};
    thread_ranks_end end =
        thread_ranks_run(3, THREAD_RANKS_SOUND, compare_texts, &t);
    CHECK(thread_ranks_succeeded(&end, 3));
    CHECK(t.is_same[0] && t.is_same[2]);
    end = thread_ranks_run(4, THREAD_RANKS_SOUND, compare_texts, &t);
    for (unsigned r = 0; r < 4; ++r) {
        CHECK(!t.is_same[r]);
        CHECK(end.status[r] == MURK_RUN_FAILED);
        CHECK_TEXT(end.error[r].text, "rank 3 has another text than rank 0");
    }
}

/* ---- dealing that ends early ---- */

/* Ranks take items until one of them takes item 5. */
static murk_status take_until_5(void *context, unsigned number, murk_error *err)
{
    uint64_t *last = context; /* [ranks] */
    murk_deal deal;
    const murk_status status = murk_ranks_deal(&deal, MURK_OK, err);
    for (uint64_t i = 0; !status && (i = murk_ranks_take(&deal)) < 1000000;) {
        last[number] = i > last[number] ? i : last[number];
        if (i == 5) {
            murk_ranks_take_no_more(&deal);
        }
    }
    return status;
}

static void test_no_item_is_dealt_after_the_end(void)
{
    uint64_t last[THREAD_RANKS_MAX] = {0};
    thread_ranks_end end =
        thread_ranks_run(1, THREAD_RANKS_SOUND, take_until_5, last);
    CHECK(thread_ranks_succeeded(&end, 1) && last[0] == 5);
    /* Several ranks may take some items before they hear of the end. */
    end = thread_ranks_run(3, THREAD_RANKS_SOUND, take_until_5, last);
    CHECK(thread_ranks_succeeded(&end, 3));
    CHECK(last[0] < 999999 && last[1] < 999999 && last[2] < 999999);
    /* A process without ranks. */
    murk_error err = {0};
    last[0] = 0;
    CHECK(take_until_5(last, 0, &err) == MURK_OK && last[0] == 5);
}

int main(void)
{
    test_sums();
    test_an_array_is_completed();
    test_bytes_are_gathered();
    test_a_single_process_gathers_its_own_bytes();
    test_blocks_are_joined();
    test_a_failure_that_is_shared_is_not_final();
    test_the_first_failure_reaches_all();
    test_an_early_return_ends_all();
    test_each_item_is_dealt_once();
    test_shares_cover_all_items_once();
    test_shares_of_hundreds_of_ranks();
    test_columns_of_a_grid_are_shared();
    test_other_bytes_of_a_rank_are_noticed();
    test_no_item_is_dealt_after_the_end();
    return check_done();
}
