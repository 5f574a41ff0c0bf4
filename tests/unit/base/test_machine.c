/* Memory keeps its content when it is joined to huge pages, whether or not the
 * system has such pages, and stays usable when it is dropped. */
#include "base/machine.h"

#include <stdint.h>
#include <stdlib.h>

#include "check.h"

#define WORDS ((size_t)3 << 20) /* 12 MB: several huge pages, and parts */

static void test_joined_pages_keep_their_content(void)
{
    uint32_t *word = malloc(WORDS * sizeof *word);
    CHECK(word);
    for (size_t i = 0; word && i < WORDS; ++i) {
        word[i] = (uint32_t)i * 2654435769u;
    }
    murk_machine_join_pages(word, WORDS * sizeof *word);
    size_t changed = 0;
    for (size_t i = 0; word && i < WORDS; ++i) {
        changed += word[i] != (uint32_t)i * 2654435769u;
    }
    CHECK(changed == 0);
    /* Dropped memory can be written again. */
    murk_machine_drop(word, WORDS * sizeof *word);
    if (word) {
        word[WORDS / 2] = 7;
        CHECK(word[WORDS / 2] == 7);
    }
    free(word);
}

static void test_small_blocks_are_left_alone(void)
{
    char few[16] = "as before";
    murk_machine_join_pages(few, sizeof few);
    murk_machine_join_pages(NULL, 0);
    CHECK(few[0] == 'a' && few[8] == 'e');
}

int main(void)
{
    test_joined_pages_keep_their_content();
    test_small_blocks_are_left_alone();
    return check_done();
}
