/* Changes of bytes for tests of broken files (tests/support/broken.h). */
#include "broken.h"

#include "base/rng.h"
#include "check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

long broken_peak_kb(void)
{
    struct rusage used;
    CHECK(getrusage(RUSAGE_SELF, &used) == 0);
    return used.ru_maxrss;
}

broken_bytes broken_load(const char *path)
{
    broken_bytes b = {NULL, 0};
    FILE *from = fopen(path, "rb");
    CHECK(from != NULL);
    if (from) {
        fseek(from, 0, SEEK_END);
        b.size = (size_t)ftell(from);
        rewind(from);
        b.at = malloc(b.size + 1);
        CHECK(b.at && fread(b.at, 1, b.size, from) == b.size);
        fclose(from);
    }
    return b;
}

void broken_flip(unsigned char *bytes, size_t among, uint32_t seed,
                 uint64_t file, uint32_t first, uint32_t flips)
{
    for (uint32_t k = 0; k < flips; ++k) {
        uint32_t word[4];
        murk_random_words(seed, MURK_TEST, file, first + k, 0, word);
        bytes[murk_random_below(word[0], (uint32_t)among)] ^=
            (unsigned char)(1u << (word[1] & 7));
    }
}

void broken_replace(char *text, size_t size, uint32_t seed, uint64_t i,
                    bool is_meant, const char *meant, size_t n)
{
    for (uint32_t k = 0; k <= i % 4; ++k) {
        uint32_t word[4];
        murk_random_words(seed, MURK_TEST, i, k, 0, word);
        const uint32_t at = murk_random_below(word[0], (uint32_t)size);
        text[at] = is_meant ? meant[murk_random_below(word[1], (uint32_t)n)]
                            : (char)(word[1] & 0xff);
    }
}

void broken_noise(char *out, size_t size, uint32_t seed, uint64_t file)
{
    for (uint32_t k = 0; k + 4 <= size; k += 4) {
        uint32_t word[4];
        murk_random_words(seed, MURK_TEST, file, k, 0, word);
        memcpy(out + k, word, 4);
    }
}

void broken_check_refusal(const murk_error *err)
{
    CHECK(err->text[0] != '\0');
    CHECK(!strchr(err->text, '\n') && !strchr(err->where, '\n'));
}
