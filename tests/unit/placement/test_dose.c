/* Doses: what they are worth, for every clarity and every dose. Nothing is
 * random but fixed seeds. */
#include "placement/dose.h"

#include "base/rng.h"
#include "check.h"

static murk_doses doses;

static double chance_of(uint32_t dose)
{
    return -expm1(-(double)dose / MURK_DOSE_ONE);
}

static void test_one_view_is_worth_its_clarity(void)
{
    int off = 0;
    for (uint32_t p = 0; p <= MURK_CLEAR; ++p) {
        off += murk_dose_worth(&doses, doses.of[p]) != p;
        off += p > 0 && doses.of[p] <= doses.of[p - 1];
    }
    CHECK(off == 0);
    CHECK(doses.of[0] == 0);
    CHECK(doses.of[MURK_CLEAR] == MURK_DOSE_FULL);
}

static void test_worth_is_monotone_and_near(void)
{
    int falls = 0, off = 0, finer = 0;
    uint16_t before = 0;
    for (uint32_t dose = 0; dose <= MURK_DOSE_FULL; ++dose) {
        const uint16_t now = murk_dose_worth(&doses, dose);
        falls += now < before;
        before = now;
        if (dose % 13 == 0 || dose > MURK_DOSE_FULL - 1000) {
            const double above = MURK_CLEAR * chance_of(dose) - now;
            off += !(above > -.008 && above < MURK_WORTH_ERROR);
            finer += !(above > 0 && above < MURK_WORTH_ERROR - .1);
        }
    }
    CHECK(falls == 0);
    CHECK(off == 0);
    CHECK(finer > 0); /* it is no better than it says */
}

/* -ln(1 - p), rounded down, and the dose: never less. */
static void test_logarithms(void)
{
    int off = 0;
    for (uint32_t p = 0; p < MURK_CLEAR; ++p) {
        const double exact = -log1p(-(double)p / MURK_CLEAR) * MURK_DOSE_ONE;
        off += !(doses.below[p] <= exact && doses.below[p] > exact - 1.1);
        off += doses.of[p] < doses.below[p];
    }
    CHECK(off == 0);
    CHECK(doses.below[MURK_CLEAR] == MURK_DOSE_FULL);
}

static uint32_t draw(uint32_t i, uint32_t slot, uint32_t below)
{
    uint32_t word[4];
    murk_random_words(1, MURK_TEST, i, 0, slot, word);
    return murk_random_below(word[0], below);
}

/* Against the product of chances. A dose may be .126 clarities above its
 * chance (rounded up: the chord, and a unit where a clarity is steepest). */
static void test_sums_are_products(void)
{
    int off = 0, without = 0;
    for (uint32_t k = 0; k < 20000; ++k) {
        const uint32_t n = 1 + draw(k, 0, 6);
        uint32_t dose = 0;
        double miss = 1;
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t p = draw(k, 1 + i, k % 2 ? MURK_CLEAR : 3000);
            dose = murk_dose_add(dose, doses.of[p]);
            miss *= 1 - (double)p / MURK_CLEAR;
        }
        const double above =
            MURK_CLEAR * (1 - miss) - murk_dose_worth(&doses, dose);
        off += !(above > -.126 * n && above < MURK_WORTH_ERROR);
        without += fabs(above) > .5;
    }
    CHECK(off == 0);
    CHECK(without > 0);
}

/* Rounding alone may make a gain grow as others join: by 1 and 2, not more. */
static void test_gains_grow_by_no_more_than_the_slack(void)
{
    int max = 0;
    for (uint32_t k = 0; k < 400000; ++k) {
        const uint32_t d = doses.of[draw(k, 0, k % 2 ? 20 : 2000)];
        const uint32_t few = draw(k, 1, MURK_DOSE_ONE / 4);
        const uint32_t many = few + draw(k, 2, 64);
        const int now = murk_dose_worth(&doses, murk_dose_add(many, d)) -
                        murk_dose_worth(&doses, many);
        const int then = murk_dose_worth(&doses, murk_dose_add(few, d)) -
                         murk_dose_worth(&doses, few);
        max = now - then > max ? now - then : max;
    }
    printf("a gain grows by %d at most\n", max);
    CHECK(max >= 1); /* or no slack were needed */
    CHECK(max <= MURK_WORTH_SLACK);
}

int main(void)
{
    murk_doses_fill(&doses);
    test_one_view_is_worth_its_clarity();
    test_worth_is_monotone_and_near();
    test_logarithms();
    test_sums_are_products();
    test_gains_grow_by_no_more_than_the_slack();
    return check_done();
}
