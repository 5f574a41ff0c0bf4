/* A matrix under other weights is the matrix that would have been made with
 * them: same plans, values and bounds, for rows of every kind. The seeds are
 * fixed: nothing here is random. */
#include "placement/place.h"

#include "check.h"
#include "made_up.h"

#define PHOTONS    2000
#define CANDIDATES 40
#define MATRIX_MAX ((uint64_t)1 << 32)

/* Each candidate sees one photon in `parts` groups of 125 alone, so that most
 * words of its row are empty. */
static void separate(made_up *m, size_t parts)
{
    for (size_t j = 0; j < CANDIDATES; ++j) {
        for (size_t i = 0; i < PHOTONS; ++i) {
            if (parts > 1 && (i / 125) % parts != j % parts) {
                m->clarity[j * PHOTONS + i] = 0;
            }
        }
    }
}

static murk_place_result place(const murk_problem *problem,
                               const murk_matrix *matrix)
{
    murk_place_desc desc = murk_place_defaults();
    desc.count = 3;
    desc.nodes = 200;
    desc.restarts = 3;
    murk_place_result out = {0};
    murk_error err = {0};
    CHECK(murk_place_sensors(&out, problem, matrix, &desc, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return out;
}

/* Of a block of photons, or scaled block by block, or each its own. */
static void draw_weights(uint32_t *weight, const made_up *m, uint32_t seed,
                         int direction)
{
    for (uint32_t i = 0; i < PHOTONS; ++i) {
        uint32_t word[4];
        murk_random_words(seed, MURK_TEST, i, 3, 5, word);
        const uint32_t block = i < 850 ? 0 : i < 1400 ? 1 : 2;
        weight[i] = direction == 0   ? (block == 1 ? m->weight[i] : 0)
                    : direction == 1 ? m->weight[i] * (1 + 5 * block)
                                     : word[0] % 1000;
    }
}

static void compare(uint32_t seed, size_t parts, uint32_t levels,
                    uint32_t weights, int direction, murk_combining combining,
                    unsigned redundancy)
{
    made_up *m =
        made_up_create(seed, PHOTONS, CANDIDATES, .5, levels, weights, 1);
    separate(m, parts);
    m->problem.combining = combining;
    m->problem.redundancy = redundancy;
    murk_matrix *first = NULL, *other = NULL, *fresh = NULL;
    murk_error err = {0};
    uint32_t weight[PHOTONS];
    draw_weights(weight, m, seed, direction);
    CHECK(!murk_matrix_create(&first, &m->problem, MATRIX_MAX, &err) &&
          !murk_matrix_reweigh(&other, first, weight, &err));
    murk_problem problem = m->problem;
    problem.weight = weight;
    CHECK(!murk_matrix_create(&fresh, &problem, MATRIX_MAX, &err));
    murk_place_result a = place(&problem, other), b = place(&problem, fresh);
    CHECK(a.value == b.value && a.ceiling == b.ceiling && a.whole == b.whole);
    CHECK(a.count == b.count && a.upper >= a.value);
    for (size_t k = 0; k < a.count && k < b.count; ++k) {
        CHECK(a.sensor[k] == b.sensor[k]);
    }
    const murk_place_result before = place(&m->problem, first);
    CHECK(before.value != a.value); /* or the weights changed nothing */
    murk_place_release(&a);
    murk_place_release(&b);
    murk_place_result c = before;
    murk_place_release(&c);
    murk_matrix_destroy(other);
    murk_matrix_destroy(fresh);
    murk_matrix_destroy(first);
    made_up_destroy(m);
}

int main(void)
{
    uint32_t seed = 40;
    for (size_t parts = 1; parts <= 16; parts *= 4) {
        for (uint32_t levels = 1; levels <= 40; levels += 39) {
            for (int direction = 0; direction < 3; ++direction) {
                /* photons of one weight side by side, and as they come */
                compare(seed++, parts, levels, 3, direction,
                        MURK_COMBINE_CLEAREST, 1);
                compare(seed++, parts, levels, 3000, direction,
                        MURK_COMBINE_CLEAREST, 1);
            }
        }
    }
    compare(seed++, 4, 40, 3, 1, MURK_COMBINE_CLEAREST, 2);
    compare(seed++, 4, 40, 3, 1, MURK_COMBINE_INDEPENDENT, 0);
    return check_done();
}
