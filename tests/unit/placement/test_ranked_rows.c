/* Unknown environments with different memories for rows, and with the parts of
 * rows that searches need: plan, bound and counts are the same for any memory,
 * threads and answers in parts, and only the number of rows asked of the
 * problem differs. Fixed seeds: nothing here is random. */
#include "placement/place.h"

#include "check.h"
#include "made_up.h"
#include "placement/ranked_rows.h"

#include <stdatomic.h>

/* A problem that counts the rows that it gives, and answers in parts. */
typedef struct counted {
    const made_up *m;
    murk_problem problem;
    atomic_uint whole, parts, given_up;
} counted;

static void counted_row(void *context, unsigned worker, size_t candidate,
                        murk_sparse_row *row)
{
    counted *c = context;
    atomic_fetch_add(&c->whole, 1);
    made_up_row((void *)(uintptr_t)c->m, worker, candidate, row);
}

/* The entries that are needed, and no others; gives up when it may. */
static bool counted_part(void *context, unsigned worker, size_t candidate,
                         const murk_row_need *need, murk_sparse_row *row)
{
    counted *c = context;
    const made_up *m = c->m;
    uint32_t *photon = m->photon + worker * m->problem.photons;
    uint16_t *clarity = m->seen_clarity + worker * m->problem.photons;
    atomic_fetch_add(&c->parts, 1);
    made_up_row((void *)(uintptr_t)m, worker, candidate, row);
    /* Take the needed entries out of the whole row. */
    size_t n = 0;
    uint64_t max = 0;
    for (size_t k = 0; k < row->seen; ++k) {
        const uint32_t i = photon[k];
        if (need->entry_max[i] > 0) {
            max += need->entry_max[i];
            clarity[n] = clarity[k];
            photon[n++] = i;
        }
    }
    row->seen = n;
    if (max < need->gain_min) {
        atomic_fetch_add(&c->given_up, 1);
        row->seen = 0;
        return false;
    }
    return true;
}

static void count_rows(counted *c, const made_up *m, bool has_parts)
{
    memset(c, 0, sizeof *c);
    c->m = m;
    c->problem = m->problem;
    c->problem.context = c;
    c->problem.get_row = counted_row;
    c->problem.get_part = has_parts ? counted_part : NULL;
}

static bool same_result(const murk_place_result *a, const murk_place_result *b)
{
    return a->count == b->count && a->value == b->value &&
           a->upper == b->upper && a->ceiling == b->ceiling &&
           a->evaluations == b->evaluations && a->queries == b->queries &&
           a->restarts == b->restarts && a->is_work_cut == b->is_work_cut &&
           a->curve_points == b->curve_points &&
           memcmp(a->curve, b->curve, a->curve_points * sizeof *a->curve) ==
               0 &&
           memcmp(a->sensor, b->sensor, a->count * sizeof *a->sensor) == 0;
}

/* Candidates in three clusters, and so many in the first one that they fill the
 * first chunk of a scan: while another sensor stands there, they add less than
 * the moved sensor, and candidates of the last cluster cannot add more. */
typedef struct cluster {
    size_t candidates, photons; /* of the clusters up to this one */
    double share;               /* of the pairs that are seen */
} cluster;
static const cluster clusters[] = {
    {150, 60, .9}, {170, 85, .7}, {400, 100, .3}};
#define CANDIDATES 400
#define PHOTONS    100
#define KINDS      4

/* A made-up problem of a kind: binary, with clarities, with two views that
 * count, or with detection probabilities. */
static made_up *of_kind(int kind, unsigned threads)
{
    made_up *m = made_up_create(5, PHOTONS, CANDIDATES, 1, kind == 0 ? 1 : 9, 3,
                                threads);
    m->problem.redundancy = kind == 2 ? 2 : 1;
    m->problem.combining =
        kind == 3 ? MURK_COMBINE_INDEPENDENT : MURK_COMBINE_CLEAREST;
    /* Keep a share of the pairs within clusters. */
    for (uint32_t j = 0; j < CANDIDATES; ++j) {
        const cluster *at = clusters;
        while (j >= at->candidates) {
            ++at;
        }
        for (uint32_t i = 0; i < PHOTONS; ++i) {
            uint32_t word[4];
            murk_random_words(5, MURK_TEST, i, j, 2, word);
            const size_t first = at > clusters ? at[-1].photons : 0;
            if (i < first || i >= at->photons ||
                word[0] >= at->share * 0x1p32) {
                m->clarity[j * PHOTONS + i] = 0;
            }
        }
    }
    return m;
}

/* No memory, memory for some rows, memory for all; each with one thread and
 * with two, each with and without parts. */
static void test_memory_changes_nothing(murk_place_method method)
{
    static const uint64_t memory[] = {0, 512, MURK_ROW_MEMORY};
    unsigned given_up = 0;
    for (int kind = 0; kind < KINDS; ++kind) {
        murk_place_result first = {0};
        for (int k = 0; k < 12; ++k) {
            const unsigned threads = k % 2 ? 2 : 1;
            made_up *m = of_kind(kind, threads);
            counted c;
            count_rows(&c, m, k / 2 % 2);
            murk_place_desc desc = murk_place_defaults();
            desc.method = method;
            desc.count = 4;
            desc.restarts = 2;
            desc.row_memory = memory[k / 4];
            murk_place_result r = {0};
            murk_error err = {0};
            CHECK(!murk_place_sensors(&r, &c.problem, NULL, &desc, &err));
            CHECK(r.value == made_up_value(m, r.sensor, r.count));
            CHECK(k == 0 || same_result(&first, &r));
            /* Rows asked for: all that do not need a look are those of an empty
             * plan; with all rows remembered one for each candidate. */
            const unsigned looks = c.whole + c.parts;
            CHECK(desc.row_memory == MURK_ROW_MEMORY
                      ? looks == CANDIDATES
                      : looks > CANDIDATES && looks <= r.queries);
            CHECK(c.problem.get_part || c.parts == 0);
            given_up += c.given_up;
            if (k == 0) {
                first = r;
            } else {
                murk_place_release(&r);
            }
            made_up_destroy(m);
        }
        murk_place_release(&first);
    }
    /* Greedy needs all gains, the others only the largest. */
    CHECK((given_up > 0) == (method != MURK_PLACE_GREEDY));
}

/* The rows asked of the problem do not depend on threads either. */
static void test_looks_are_the_same_for_any_threads(void)
{
    unsigned looks[2], given_up[2];
    for (unsigned threads = 1; threads <= 2; ++threads) {
        made_up *m = of_kind(1, threads);
        counted c;
        count_rows(&c, m, true);
        murk_place_desc desc = murk_place_defaults();
        desc.count = 4;
        desc.row_memory = 512;
        murk_place_result r = {0};
        murk_error err = {0};
        CHECK(!murk_place_sensors(&r, &c.problem, NULL, &desc, &err));
        looks[threads - 1] = c.whole + c.parts;
        given_up[threads - 1] = c.given_up;
        murk_place_release(&r);
        made_up_destroy(m);
    }
    CHECK(looks[0] == looks[1]);
    CHECK(given_up[0] == given_up[1]);
}

/* A limit on work ends a search in an unknown environment, too, at the same
 * place for any memory. */
static void test_work_is_limited(void)
{
    murk_place_result of[2] = {{0}};
    for (int k = 0; k < 2; ++k) {
        made_up *m = of_kind(1, 2);
        murk_place_desc desc = murk_place_defaults();
        desc.count = 4;
        desc.row_memory = k ? MURK_ROW_MEMORY : 0;
        desc.search_work = UINT64_C(1024) * 500;
        murk_error err = {0};
        CHECK(!murk_place_sensors(&of[k], &m->problem, NULL, &desc, &err));
        CHECK(of[k].is_work_cut && of[k].count == 4);
        CHECK(of[k].value == made_up_value(m, of[k].sensor, 4));
        CHECK(of[k].upper >= of[k].value);
        made_up_destroy(m);
    }
    CHECK(same_result(&of[0], &of[1]));
    murk_place_release(&of[0]);
    murk_place_release(&of[1]);
}

/* The cached rows are the first ones by rank that fit together, in whatever
 * order they are offered. */
static void test_the_first_by_rank_remain(void)
{
    enum { N = 50, MAX = 1000 };
    for (uint32_t seed = 0; seed < 20; ++seed) {
        murk_ranked_rows r;
        murk_ranked ranked[N];
        size_t bytes[N];
        murk_error err = {0};
        CHECK(!murk_ranked_rows_init(&r, N, MAX, &err));
        for (uint32_t k = 0; k < N; ++k) {
            uint32_t word[4];
            murk_random_words(seed, MURK_TEST, k, 0, 0, word);
            const uint32_t j = (7 * k + seed) % N; /* the order of the offers */
            ranked[j] = (murk_ranked){word[0] % 20, j};
            bytes[j] = 1 + word[1] % 100;
            const murk_row row = {.memory = malloc(bytes[j]),
                                  .memory_bytes = bytes[j]};
            murk_ranked_rows_offer(&r, ranked[j], &row);
        }
        /* By rank, until the memory is full. */
        qsort(ranked, N, sizeof *ranked, murk_compare_ranked);
        size_t sum = 0, count = 0;
        while (count < N && sum + bytes[ranked[count].candidate] <= MAX) {
            sum += bytes[ranked[count++].candidate];
        }
        CHECK(r.count == count && r.bytes == sum);
        for (size_t k = 0; k < N; ++k) {
            CHECK((r.row[ranked[k].candidate].memory != NULL) == (k < count));
        }
        murk_ranked_rows_release(&r);
    }
}

int main(void)
{
    test_memory_changes_nothing(MURK_PLACE_BEST);
    test_memory_changes_nothing(MURK_PLACE_SPOQ);
    test_memory_changes_nothing(MURK_PLACE_GREEDY);
    test_looks_are_the_same_for_any_threads();
    test_work_is_limited();
    test_the_first_by_rank_remain();
    return check_done();
}
