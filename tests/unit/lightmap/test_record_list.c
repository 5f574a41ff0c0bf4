/* Lists of records: memory that is reserved, and lists that outgrow it. */
#include "check.h"

#include "lightmap/record_buffers.h"

/* Appends n records, numbered from `first`. */
static void put(murk_record_list *list, uint32_t first, uint32_t n)
{
    for (uint32_t i = first; i < first + n; ++i) {
        const murk_photon photon = murk_photon_make(&(murk_photon_values){
            .position_m = {1, 2, 3}, .power_w = 4, .emitted = i});
        CHECK(!murk_record_list_put(list, &photon, NULL));
    }
}

static bool is_in_order(const murk_record_list *list, uint32_t n)
{
    bool is = list->n == n;
    for (uint32_t i = 0; i < n && is; ++i) {
        is = murk_photon_emitted(&list->photon[i]) == i;
    }
    return is;
}

/* More than a huge page of records, and less than a small page. */
static void test_reserved_memory_stays_in_place(void)
{
    const uint32_t numbers[] = {10, 200000};
    for (size_t k = 0; k < 2; ++k) {
        const uint32_t n = numbers[k];
        murk_record_list list = {.memory_max = 1e9};
        murk_record_list_reserve(&list, (double)n);
        CHECK(list.capacity == n && list.n == 0);
        const murk_photon *place = list.photon;
        put(&list, 0, n);
        CHECK(list.photon == place && list.capacity == n);
        CHECK(is_in_order(&list, n));
        /* A forecast that was too low. */
        put(&list, n, n);
        CHECK(list.capacity > n);
        CHECK(is_in_order(&list, 2 * n));
        murk_record_list_release(&list);
    }
}

static void test_reserved_memory_lies_in_a_scratch_file(void)
{
    murk_record_list list = {.memory_max = 1000};
    murk_record_list_reserve(&list, 1000);
    CHECK(list.block.place == MURK_BLOCK_IN_SCRATCH_FILE);
    put(&list, 0, 1500);
    CHECK(list.block.place == MURK_BLOCK_IN_SCRATCH_FILE);
    CHECK(is_in_order(&list, 1500));
    murk_record_list_release(&list);
}

/* Nothing is reserved: for no records, for more than there is memory, and for a
 * list that has records. */
static void test_a_list_without_reserved_memory_grows(void)
{
    murk_record_list list = {0};
    murk_record_list_reserve(&list, 0);
    CHECK(list.capacity == 0);
    murk_record_list_reserve(&list, 1e17);
    CHECK(list.capacity == 0);
    put(&list, 0, 100);
    const size_t capacity = list.capacity;
    murk_record_list_reserve(&list, 1e6);
    CHECK(list.capacity == capacity);
    CHECK(is_in_order(&list, 100));
    murk_record_list_release(&list);
}

int main(void)
{
    test_reserved_memory_stays_in_place();
    test_reserved_memory_lies_in_a_scratch_file();
    test_a_list_without_reserved_memory_grows();
    return check_done();
}
