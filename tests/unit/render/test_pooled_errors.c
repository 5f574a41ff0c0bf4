/* Pooled errors of pixels: what the window, its edges and its exceptions do.
 * All is arithmetic: no chance of a false alarm. */
#include "check.h"
#include "render/pooled_errors.h"

#include <math.h>
#include <string.h>

#define WIDTH  40
#define HEIGHT 30
#define PIXELS (WIDTH * HEIGHT)
#define MIDDLE (15 * WIDTH + 20)

static uint8_t is_own[PIXELS];
static float error[PIXELS];

static size_t pooled(size_t samples, bool is_round)
{
    static float scratch[PIXELS];
    const murk_pooling pooling = {.width = WIDTH,
                                  .height = HEIGHT,
                                  .samples = samples,
                                  .is_round = is_round,
                                  .is_own = is_own,
                                  .threads = 1};
    return murk_pool_errors(&pooling, error, scratch);
}

static void one_bright_at(size_t at)
{
    memset(is_own, 0, sizeof is_own);
    memset(error, 0, sizeof error);
    error[at] = 3;
}

static double variance_at(size_t at)
{
    return (double)error[at] * (double)error[at];
}

static double all_variance(void)
{
    double sum = 0;
    for (size_t i = 0; i < PIXELS; ++i) {
        sum += variance_at(i);
    }
    return sum;
}

static void test_equal_errors_stay(void)
{
    memset(is_own, 0, sizeof is_own);
    for (size_t i = 0; i < PIXELS; ++i) {
        error[i] = 2;
    }
    CHECK(pooled(16, false) == 0);
    for (size_t i = 0; i < PIXELS; ++i) {
        CHECK_NEAR((double)error[i], 2, 1e-6);
    }
}

/* The window of 2 pixels at 16 samples: weights exp(-r^2 / 8) up to 4 pixels
 * aside, 24.03 in all; beyond, one of 1 + 16 * 24.03 samples is the picture's
 * mean. */
static void test_one_bright_pixel_spreads_and_keeps_its_variance(void)
{
    double line = 1;
    for (int i = 1; i <= 4; ++i) {
        line += 2 * exp(-i * i / 8.0);
    }
    const double weights = line * line, mean = 9.0 / PIXELS;
    const double samples = 16 * weights;
    one_bright_at(MIDDLE);
    CHECK(pooled(16, false) == 81); /* all that it reaches rest on it alone */
    CHECK_NEAR(variance_at(MIDDLE), (16 * 9 + mean) / (samples + 1), 1e-5);
    CHECK_NEAR(variance_at(MIDDLE + 3),
               (16 * 9 * exp(-9 / 8.0) + mean) / (samples + 1), 1e-5);
    CHECK_NEAR(variance_at(MIDDLE + 5 * WIDTH), mean / (samples + 1), 1e-8);
    CHECK_NEAR(all_variance(), 9, 0.02);
}

/* At four times the samples the window is half as wide; at very many there is
 * none. */
static void test_the_window_shrinks_with_samples(void)
{
    one_bright_at(MIDDLE);
    CHECK(pooled(64, false) == 25);
    CHECK_NEAR(all_variance(), 9, 0.02);
    one_bright_at(MIDDLE);
    CHECK(pooled(4096, false) == 0);
    CHECK(error[MIDDLE] == 3 && error[MIDDLE + 1] == 0);
}

static void test_pixels_of_their_own_neither_lend_nor_borrow(void)
{
    one_bright_at(MIDDLE);
    is_own[MIDDLE] = 1;
    pooled(16, false);
    CHECK(error[MIDDLE] == 3 && error[MIDDLE + 1] == 0);
    one_bright_at(MIDDLE);
    is_own[MIDDLE + 1] = 1;
    pooled(16, false);
    CHECK(error[MIDDLE + 1] == 0 && error[MIDDLE + 2] > 0);
}

static void test_round_pictures_have_no_sides(void)
{
    one_bright_at(15 * WIDTH);
    pooled(16, false);
    CHECK(variance_at(15 * WIDTH + WIDTH - 1) < 1e-4);
    one_bright_at(15 * WIDTH);
    pooled(16, true);
    CHECK_NEAR(variance_at(15 * WIDTH + WIDTH - 1), variance_at(15 * WIDTH + 1),
               1e-9);
    CHECK(variance_at(15 * WIDTH + 1) > 0.1);
}

int main(void)
{
    test_equal_errors_stay();
    test_one_bright_pixel_spreads_and_keeps_its_variance();
    test_the_window_shrinks_with_samples();
    test_pixels_of_their_own_neither_lend_nor_borrow();
    test_round_pictures_have_no_sides();
    return check_done();
}
