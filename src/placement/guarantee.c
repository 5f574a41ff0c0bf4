#include "placement/guarantee.h"

static const char *of_budget(const murk_rulebook *book)
{
    /* Shown for a budget alone: no count that could end greedy before. */
    const bool is_alone = !book->has_min && !book->has_caps &&
                          !book->has_conflicts &&
                          book->max_sensors == book->candidates;
    return is_alone ? ".405" : "none";
}

const char *murk_guarantee(const murk_rulebook *book)
{
    static const char *const of_extendible[2][2][2] = {
        /* [spacing][sites][classes] */
        {{"1 - (1 - 1/n)^n", "1/2"}, {"1/2", "1/3"}},
        {{"1/13", "1/14"}, {"1/14", "1/15"}}};
    if (!book) {
        return of_extendible[0][0][0];
    }
    if (book->has_budget) {
        return of_budget(book);
    }
    if (book->constraints->conflict_first) {
        return "none";
    }
    return of_extendible[book->constraints->spacing_m > 0][book->site != NULL]
                        [book->has_min || book->has_caps];
}
