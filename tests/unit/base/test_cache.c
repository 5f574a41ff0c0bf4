/* What is kept is found again, whole, by any number of threads; what is too
 * much makes room. Deterministic. */
#include "base/cache.h"
#include "base/pool.h"
#include "check.h"

#include <stdlib.h>

static bool holds(murk_cache *cache, double key, double want)
{
    size_t size = 0;
    double *found = murk_cache_find(cache, &key, sizeof key, &size);
    const bool is_it = found && size == sizeof want && *found == want;
    free(found);
    return is_it;
}

static void put(murk_cache *cache, double key, double value)
{
    murk_cache_put(cache, &key, sizeof key, &value, sizeof value);
}

static void test_what_is_put_is_found(void)
{
    static murk_cache cache = MURK_CACHE_NONE;
    CHECK(!holds(&cache, 1, 10));
    put(&cache, 1, 10);
    put(&cache, 2, 20);
    CHECK(holds(&cache, 1, 10) && holds(&cache, 2, 20));
    CHECK(!holds(&cache, 3, 30));
    put(&cache, 1, 11); /* there already */
    CHECK(holds(&cache, 1, 10) && cache.n == 2);
    const float half = 1;
    size_t size;
    CHECK(murk_cache_find(&cache, &half, sizeof half, &size) == NULL);
}

static void test_the_oldest_entry_is_dropped(void)
{
    static murk_cache cache = MURK_CACHE_NONE;
    for (int i = 0; i < MURK_CACHE_MAX; ++i) {
        put(&cache, i, 2 * i);
    }
    CHECK(holds(&cache, 0, 0)); /* so 1 is the oldest */
    put(&cache, -1, 5);
    CHECK(cache.n == MURK_CACHE_MAX);
    CHECK(holds(&cache, 0, 0) && holds(&cache, -1, 5) && !holds(&cache, 1, 2));
}

static void test_bytes_are_bounded(void)
{
    static murk_cache cache = MURK_CACHE_NONE;
    const size_t large = MURK_CACHE_BYTES_MAX / 3;
    char *bytes = calloc(MURK_CACHE_BYTES_MAX, 1);
    for (double key = 0; key < 5; ++key) {
        murk_cache_put(&cache, &key, sizeof key, bytes, large);
        CHECK(cache.bytes <= MURK_CACHE_BYTES_MAX);
    }
    CHECK(cache.n == 2);
    const double key = 9;
    murk_cache_put(&cache, &key, sizeof key, bytes, MURK_CACHE_BYTES_MAX);
    CHECK(cache.n == 2);
    free(bytes);
}

static murk_cache shared = MURK_CACHE_NONE;
static bool went_well[64];

static void use(void *context, uint64_t batch)
{
    (void)context;
    went_well[batch] = true;
    for (int i = 0; i < 300; ++i) {
        const double key = (double)((batch + (uint64_t)i) % 200);
        size_t size;
        double *found = murk_cache_find(&shared, &key, sizeof key, &size);
        went_well[batch] &= !found || *found == key * key;
        free(found);
        put(&shared, key, key * key);
    }
}

static void test_threads_find_whole_values(void)
{
    murk_pool_run(5, 64, use, NULL);
    for (size_t i = 0; i < 64; ++i) {
        CHECK(went_well[i]);
    }
}

int main(void)
{
    test_what_is_put_is_found();
    test_the_oldest_entry_is_dropped();
    test_bytes_are_bounded();
    test_threads_find_whole_values();
    return check_done();
}
