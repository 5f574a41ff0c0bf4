/* A preset's mixture as one table: within the table's tolerance of the sum of
 * its parts, at angles between its nodes, too. No randomness. */
#include "check.h"
#include "medium/phase.h"
#include "world/mixtures.h"

/* The law is straight in log angle and log value between the angles it is
 * summed at, off by 1e-5 there (mixtures.c), and the table by 1e-5 of it. */
#define TOLERANCE (3 * MURK_PHASE_TOLERANCE)

static void test_a_lobe_and_molecules(void)
{
    murk_mixture_part part[] = {
        {.share = .75, .kind = MURK_PHASE_HG, .value = {.85}},
        {.share = .25, .kind = MURK_PHASE_RAYLEIGH}};
    const murk_mixture mixture = {2, part};
    const murk_phase lobe = murk_phase_hg(.85), air = murk_phase_rayleigh();
    murk_phase_table *table = NULL;
    CHECK(murk_mixture_table(&table, &mixture, "", NULL) == MURK_OK);
    if (!table) {
        return;
    }
    for (int i = 0; i < 997; ++i) {
        const double mu = -1 + 2 * (i + .5) / 997;
        const double want = .75 * murk_phase_density(&lobe, mu) +
                            .25 * murk_phase_density(&air, mu);
        CHECK_NEAR(murk_phase_table_density(table, mu), want, TOLERANCE * want);
    }
    CHECK_NEAR(murk_phase_table_facts(table)->mean_cosine, .75 * .85,
               TOLERANCE);
    /* teeth: another share would be seen */
    CHECK(fabs(murk_phase_table_facts(table)->mean_cosine - .76 * .85) >
          100 * TOLERANCE);
    murk_phase_table_destroy(table);
}

/* One table alone stays itself. */
static void test_a_table_alone(void)
{
    double angle[] = {0, 90, 180}, value[] = {3, 1, 2};
    murk_mixture_part part = {.share = 1,
                              .kind = MURK_PHASE_TABLE,
                              .angles = 3,
                              .angle_deg = angle,
                              .phase_per_sr = value};
    const murk_mixture mixture = {1, &part};
    murk_phase_table *table = NULL;
    CHECK(murk_mixture_table(&table, &mixture, "", NULL) == MURK_OK);
    if (table) {
        CHECK_NEAR(murk_phase_table_density(table, 1) /
                       murk_phase_table_density(table, 0),
                   3, 3 * TOLERANCE);
    }
    murk_phase_table_destroy(table);
}

int main(void)
{
    test_a_lobe_and_molecules();
    test_a_table_alone();
    return check_done();
}
