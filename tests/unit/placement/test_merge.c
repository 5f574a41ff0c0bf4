/* Photons that all candidates see alike, put together or not: the same plans,
 * bounds, curves and work, in every bit, by every method and in every way that
 * views combine. */
#include "placement/matrix.h"
#include "placement/merge.h"

#include "check.h"
#include "made_up.h"

#include <string.h>

/* Five photons in a row are seen alike, some with the same weight. */
static made_up *make_alike(uint32_t seed, uint32_t levels, uint32_t weights)
{
    made_up *m = made_up_create(seed, 3000, 20, 0.2, levels, weights, 2);
    for (size_t j = 0; j < m->problem.candidates; ++j) {
        uint16_t *row = m->clarity + j * m->problem.photons;
        for (size_t i = 0; i < m->problem.photons; ++i) {
            row[i] = row[i / 5 * 5];
        }
    }
    return m;
}

static murk_place_result place(const made_up *m, const murk_matrix *matrix,
                               const murk_place_desc *desc)
{
    murk_error err = {0};
    murk_place_result r = {0};
    CHECK(murk_place_sensors(&r, &m->problem, matrix, desc, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return r;
}

static bool same(const murk_place_result *a, const murk_place_result *b)
{
    return a->count == b->count && a->value == b->value &&
           a->upper == b->upper && a->ceiling == b->ceiling &&
           a->whole == b->whole && a->after_presolve == b->after_presolve &&
           a->nodes == b->nodes && a->is_cut == b->is_cut &&
           a->evaluations == b->evaluations && a->restarts == b->restarts &&
           a->curve_points == b->curve_points &&
           memcmp(a->sensor, b->sensor, a->count * sizeof *a->sensor) == 0 &&
           memcmp(a->curve, b->curve, a->curve_points * sizeof *a->curve) == 0;
}

static void check_methods(const made_up *m)
{
    /* Two matrices of one problem; merging leaves fewer photons, and the
     * same pairs. */
    murk_matrix *unmerged = NULL, *merged = NULL;
    murk_error err = {0};
    CHECK(murk_matrix_make(&unmerged, &m->problem, UINT64_MAX, MURK_MERGE_NEVER,
                           &err) == MURK_OK);
    CHECK(murk_matrix_make(&merged, &m->problem, UINT64_MAX, MURK_MERGE_ALWAYS,
                           &err) == MURK_OK);
    CHECK(merged->layout.photons < unmerged->layout.photons);
    CHECK(merged->pairs == unmerged->pairs);
    /* Each method finds the same plan from both, also where branch and
     * bound is cut short. */
    for (int method = 0; method < 4; ++method) {
        for (int is_cut = 0; is_cut < 2; ++is_cut) {
            murk_place_desc desc = murk_place_defaults();
            desc.method = (murk_place_method)method;
            desc.count = 4;
            desc.restarts = 3;
            desc.nodes = is_cut ? 2 : 100000;
            murk_place_result a = place(m, unmerged, &desc);
            murk_place_result b = place(m, merged, &desc);
            CHECK(same(&a, &b));
            murk_place_release(&a);
            murk_place_release(&b);
        }
    }
    murk_matrix_destroy(unmerged);
    murk_matrix_destroy(merged);
}

/* Teeth: where prints of different views are the same, nothing is merged. */
static void test_prints_are_checked(void)
{
    made_up *m = make_alike(1, 1, 1);
    m->clarity[5] = m->clarity[5] ? 0 : MURK_CLEAR;
    check_methods(m); /* one photon less has its like */
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    CHECK(murk_matrix_make(&matrix, &m->problem, UINT64_MAX, MURK_MERGE_NEVER,
                           &err) == MURK_OK);
    _Atomic uint64_t *hash = calloc(m->problem.photons, sizeof *hash);
    CHECK(murk_merge(&matrix->layout, matrix->row, matrix->space, false,
                     &m->problem, hash, false, true, NULL, &err) == MURK_OK);
    CHECK(matrix->layout.photons == m->problem.photons);
    murk_matrix_destroy(matrix);
    made_up_destroy(m);
}

/* Of n photons that all are seen alike those that stay stand for 1, 2, 4, ..
 * each: as many as n has binary digits that are 1. */
static void test_as_few_stay_as_possible(void)
{
    static const uint8_t stay[] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2};
    for (size_t n = 1; n < sizeof stay; ++n) {
        made_up *m = made_up_create(1, n, 2, 1, 1, 1, 1);
        for (size_t i = 0; i < 2 * n; ++i) {
            m->clarity[i] = MURK_CLEAR;
        }
        murk_matrix *matrix = NULL;
        murk_error err = {0};
        CHECK(murk_matrix_make(&matrix, &m->problem, UINT64_MAX,
                               MURK_MERGE_ALWAYS, &err) == MURK_OK);
        CHECK(matrix && matrix->layout.photons == stay[n]);
        murk_matrix_destroy(matrix);
        made_up_destroy(m);
    }
}

/* The rows by slot, of a matrix with merged photons and of one without: each
 * photon has the clarity of its row. */
static void test_rows_by_slot(void)
{
    made_up *m = make_alike(3, 1, 1);
    const murk_problem problem = m->problem;
    m->problem.has_columns = true;
    for (int merging = 0; merging < 2; ++merging) {
        murk_matrix *matrix = NULL;
        murk_error err = {0};
        CHECK(murk_matrix_make(&matrix, &m->problem, UINT64_MAX,
                               merging ? MURK_MERGE_ALWAYS : MURK_MERGE_NEVER,
                               &err) == MURK_OK);
        CHECK(!merging || matrix->layout.photons < problem.photons);
        const size_t slots = murk_matrix_slots(matrix);
        uint16_t *entry = malloc(slots * sizeof *entry + 1),
                 *clarity = malloc(slots * sizeof *clarity + 1);
        uint32_t *slot = malloc(slots * sizeof *slot + 1);
        CHECK(entry && clarity && slot);
        /* Each clarity against that of the problem. */
        size_t different = 0, n;
        for (size_t j = 0; clarity && j < problem.candidates; ++j) {
            CHECK(murk_matrix_list(slot, entry, &n, matrix, j));
            memset(clarity, 0, slots * sizeof *clarity);
            for (size_t k = 0; k < n; ++k) {
                clarity[slot[k]] = entry[k];
            }
            for (uint32_t i = 0; i < problem.photons; ++i) {
                different += clarity[murk_matrix_slot(matrix, i)] !=
                             m->clarity[j * problem.photons + i];
            }
        }
        CHECK(different == 0);
        free(slot);
        free(entry);
        free(clarity);
        murk_matrix_destroy(matrix);
    }
    made_up_destroy(m);
}

/* A problem whose clarities have changed, and what each row was before. The
 * differences are those of the row that a worker got last. */
enum { WORKERS = 8, CHANGED_MAX = 64 };

typedef struct changed_problem {
    const made_up *m;
    const uint16_t *before; /* as m->clarity */
    size_t candidate[WORKERS];
    uint32_t photon[WORKERS][2][CHANGED_MAX];
    uint16_t clarity[WORKERS][2][CHANGED_MAX];
} changed_problem;

static void changed_row(void *context, unsigned worker, size_t candidate,
                        murk_sparse_row *row)
{
    changed_problem *c = context;
    const murk_problem *of = &c->m->problem;
    c->candidate[worker] = candidate;
    of->get_row(of->context, worker, candidate, row);
}

static void changed_entries(void *context, unsigned worker,
                            murk_sparse_row *gone, murk_sparse_row *come)
{
    changed_problem *c = context;
    const size_t photons = c->m->problem.photons,
                 first = c->candidate[worker] * photons;
    const uint16_t *of[] = {c->before + first, c->m->clarity + first};
    murk_sparse_row *out[] = {gone, come};
    for (int k = 0; k < 2; ++k) {
        *out[k] =
            (murk_sparse_row){0, c->photon[worker][k], c->clarity[worker][k]};
        for (uint32_t i = 0; i < photons; ++i) {
            if (of[0][i] != of[1][i] && of[k][i] > 0) {
                CHECK(out[k]->seen < CHANGED_MAX);
                c->photon[worker][k][out[k]->seen] = i;
                c->clarity[worker][k][out[k]->seen++] = of[k][i];
            }
        }
    }
}

/* The hashes of a matrix, computed from those of an earlier one by the entries
 * that differ, are those that are computed from all entries. */
static void test_hashes_of_differences(void)
{
    made_up *m = make_alike(4, 3, 1);
    const size_t photons = m->problem.photons,
                 n = photons * m->problem.candidates;
    uint16_t *before = malloc(n * sizeof *before);
    uint64_t *hash = calloc(photons, sizeof *hash);
    murk_matrix *matrix[3] = {NULL};
    murk_error err = {0};
    m->problem.has_columns = true;
    CHECK(before && hash && m->problem.threads <= WORKERS);
    CHECK(murk_matrix_make(&matrix[0], &m->problem, UINT64_MAX,
                           MURK_MERGE_ALWAYS, &err) == MURK_OK);
    /* One photon more is seen or one less in each row, or otherwise. */
    memcpy(before, m->clarity, n * sizeof *before);
    for (size_t j = 0; j < m->problem.candidates; ++j) {
        uint16_t *at = &m->clarity[j * photons + 37 * j];
        *at = j % 3 == 0 ? 0 : (uint16_t)(*at / 2 + 1);
    }
    CHECK(murk_matrix_make(&matrix[1], &m->problem, UINT64_MAX,
                           MURK_MERGE_ALWAYS, &err) == MURK_OK);
    changed_problem *changed = calloc(1, sizeof *changed);
    murk_problem problem = m->problem;
    *changed = (changed_problem){.m = m, .before = before};
    problem.get_row = changed_row;
    problem.get_differences = changed_entries;
    problem.context = changed;
    problem.earlier_hash = hash;
    for (size_t i = 0; i < photons; ++i) {
        hash[i] = murk_matrix_hashes(matrix[0])[i];
    }
    CHECK(murk_matrix_make(&matrix[2], &problem, UINT64_MAX, MURK_MERGE_ALWAYS,
                           &err) == MURK_OK);
    size_t different = 0, changes = 0;
    for (size_t i = 0; i < photons; ++i) {
        const uint64_t all = murk_matrix_hashes(matrix[1])[i];
        different += murk_matrix_hashes(matrix[2])[i] != all;
        changes += hash[i] != all;
    }
    CHECK(different == 0);
    CHECK(changes > m->problem.candidates / 2);
    for (int k = 0; k < 3; ++k) {
        murk_matrix_destroy(matrix[k]);
    }
    free(changed);
    free(hash);
    free(before);
    made_up_destroy(m);
}

int main(void)
{
    /* Merging itself. */
    test_hashes_of_differences();
    test_as_few_stay_as_possible();
    /* Plans with and without merging, for each mode of combining views. */
    static const struct {
        uint32_t levels, weights;
        murk_combining combining;
        unsigned redundancy;
    } kinds[] = {
        {1, 1, MURK_COMBINE_CLEAREST, 1},
        {1, 3, MURK_COMBINE_CLEAREST, 1},
        {50, 2, MURK_COMBINE_CLEAREST, 1},
        {1, 20, MURK_COMBINE_CLEAREST, 1},
        {1, 2, MURK_COMBINE_CLEAREST, 2},
        {9, 2, MURK_COMBINE_CLEAREST, 3},
        {9, 2, MURK_COMBINE_INDEPENDENT, 1},
        {1, 1, MURK_COMBINE_INDEPENDENT, 1},
    };
    for (size_t kind = 0; kind < sizeof kinds / sizeof kinds[0]; ++kind) {
        made_up *m = make_alike(1, kinds[kind].levels, kinds[kind].weights);
        m->problem.combining = kinds[kind].combining;
        m->problem.redundancy = kinds[kind].redundancy;
        check_methods(m);
        made_up_destroy(m);
    }
    /* Different photons with equal hashes stay apart. */
    test_prints_are_checked();
    test_rows_by_slot();
    return check_done();
}
