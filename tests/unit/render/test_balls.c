/* Which balls hold a point, against looking at each of them. */
#include "render/balls.h"

#include "base/rng.h"
#include "check.h"

#include <stdlib.h>

typedef struct seen {
    size_t n, last;
    double squares;
    bool is_ordered;
} seen;

static void see(void *context, size_t ball, double square)
{
    seen *s = context;
    s->is_ordered = s->is_ordered && (s->n == 0 || ball > s->last);
    s->last = ball;
    s->squares += square;
    ++s->n;
}

static void test_as_looking_at_each(size_t n)
{
    /* Random balls of many sizes. */
    murk_ball_extent *ball = calloc(n + 1, sizeof *ball);
    for (size_t i = 0; i < n; ++i) {
        const murk_random4 u = murk_random(1, MURK_TEST, i, 0, 0);
        ball[i] = (murk_ball_extent){
            .center = {(float)u.u[0], (float)u.u[1], (float)u.u[2]},
            .radius = (float)(0.3 * u.u[3] * u.u[3])};
        for (int axis = 0; axis < 3; ++axis) {
            ball[i].reach[axis] = ball[i].radius;
        }
    }
    murk_balls *balls = NULL;
    murk_error err = {0};
    CHECK(murk_balls_create(&balls, ball, n, &err) == MURK_OK);
    /* At random points, the tree finds the balls that a test of each ball
     * finds, in rising order. */
    size_t all = 0;
    for (uint64_t k = 0; k < 200; ++k) {
        const murk_random4 u = murk_random(2, MURK_TEST, k, 0, 0);
        const float p[3] = {(float)u.u[0], (float)u.u[1], (float)u.u[2]};
        size_t want = 0;
        double squares = 0;
        for (size_t i = 0; i < n; ++i) {
            double square = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const double d = (double)(ball[i].center[axis] - p[axis]) /
                                 (double)ball[i].radius;
                square += d * d;
            }
            want += square < 1;
            squares += square < 1 ? square : 0;
        }
        seen s = {.is_ordered = true};
        murk_balls_at(balls, murk_vec(u.u[0], u.u[1], u.u[2]), see, &s);
        CHECK(s.n == want && s.is_ordered);
        CHECK_NEAR(s.squares, squares, 1e-5 * (double)n);
        all += want;
    }
    /* Enough balls were found, and none at a point that is not a number. */
    CHECK(n < 16 || all > n);
    seen none = {.is_ordered = true};
    murk_balls_at(balls, murk_vec(NAN, 0, 0), see, &none);
    CHECK(none.n == 0);
    murk_balls_destroy(balls);
    free(ball);
}

int main(void)
{
    const size_t counts[] = {0, 1, 15, 16, 17, 300, 5000};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; ++i) {
        test_as_looking_at_each(counts[i]);
    }
    return check_done();
}
