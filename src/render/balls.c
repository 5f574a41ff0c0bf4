/* A hierarchy of axis-parallel boxes over balls, sixteen to a group, so that
 * one wide comparison tests a group. The balls that hold a point are found by
 * descending into the boxes that hold it. */
#include "render/balls.h"

#include "photonmap/range_test.h"

#include <stdlib.h>

/* The largest number of levels of boxes: 8 levels hold 16^9 = 2^36 balls, and
 * maps have fewer than 2^32 records. */
#define LEVELS_MAX 8

/* Alignment of the boxes in bytes: the size of the largest vector register. */
#define ALIGNMENT 64

/* Sixteen balls by coordinate; an unused one contains no point. */
typedef struct sixteen {
    float center[3][MURK_WIDE], per_square[MURK_WIDE];
} sixteen;

struct murk_balls {
    const murk_range_test *test;
    size_t n;
    sixteen *ball;   /* [groups of 16 balls] */
    unsigned levels; /* of boxes; the last level is one group */
    murk_bounds *bounds[LEVELS_MAX];
};

static size_t groups_of(size_t n)
{
    return (n + MURK_WIDE - 1) / MURK_WIDE;
}

static void empty_bounds(murk_bounds *bounds, size_t groups)
{
    for (size_t g = 0; g < groups; ++g) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int i = 0; i < MURK_WIDE; ++i) {
                bounds[g].min[axis][i] = INFINITY;
                bounds[g].max[axis][i] = -INFINITY;
            }
        }
    }
}

static void widen(murk_bounds *bounds, size_t box, int axis, float min,
                  float max)
{
    murk_bounds *b = &bounds[box / MURK_WIDE];
    const size_t i = box % MURK_WIDE;
    b->min[axis][i] = fminf(b->min[axis][i], min);
    b->max[axis][i] = fmaxf(b->max[axis][i], max);
}

static void fill(murk_balls *b, const murk_ball_extent *ball)
{
    /* The balls themselves, and a box around each sixteen of them. Bounds are
     * widened by one float step, so that rounding loses no point. */
    for (size_t i = 0; i < groups_of(b->n) * MURK_WIDE; ++i) {
        sixteen *s = &b->ball[i / MURK_WIDE];
        const size_t k = i % MURK_WIDE;
        s->per_square[k] = INFINITY; /* contains no point */
        for (int axis = 0; axis < 3 && i < b->n; ++axis) {
            const float c = ball[i].center[axis], r = ball[i].reach[axis];
            s->center[axis][k] = c;
            s->per_square[k] = 1 / (ball[i].radius * ball[i].radius);
            widen(b->bounds[0], i / MURK_WIDE, axis,
                  nextafterf(c - r, -INFINITY), nextafterf(c + r, INFINITY));
        }
    }
    /* Each box of a higher level encloses sixteen boxes of the level below. */
    size_t n = groups_of(b->n);
    for (unsigned level = 1; level < b->levels; ++level) {
        for (size_t i = 0; i < n; ++i) {
            const murk_bounds *from = &b->bounds[level - 1][i / MURK_WIDE];
            for (int axis = 0; axis < 3; ++axis) {
                widen(b->bounds[level], i / MURK_WIDE, axis,
                      from->min[axis][i % MURK_WIDE],
                      from->max[axis][i % MURK_WIDE]);
            }
        }
        n = groups_of(n);
    }
}

murk_status murk_balls_create(murk_balls **out, const murk_ball_extent *ball,
                              size_t n, murk_error *err)
{
    unsigned n_tests;
    const murk_range_test *const *tests = murk_range_tests(&n_tests);
    murk_balls *b = calloc(1, sizeof *b);
    bool is_there = b != NULL;
    /* Allocate the balls and one level of boxes after the other, up to a
     * single group. */
    if (is_there && n > 0) {
        b->test = tests[n_tests - 1];
        b->n = n;
        b->ball = calloc(groups_of(n), sizeof *b->ball);
        is_there = b->ball != NULL;
        for (size_t bounds = groups_of(n); is_there;
             bounds = groups_of(bounds)) {
            const size_t groups = groups_of(bounds);
            murk_bounds *level =
                aligned_alloc(ALIGNMENT, groups * sizeof *level);
            is_there = level != NULL;
            if (is_there) {
                empty_bounds(level, groups);
                b->bounds[b->levels++] = level;
            }
            if (groups == 1) {
                break;
            }
        }
    }
    if (!is_there) {
        murk_balls_destroy(b);
        return murk_no_memory(err, "render", "for the kernels of %zu photons",
                              n);
    }
    /* Fill the levels. */
    if (n > 0) {
        fill(b, ball);
    }
    *out = b;
    return MURK_OK;
}

void murk_balls_destroy(murk_balls *balls)
{
    if (balls) {
        for (unsigned level = 0; level < balls->levels; ++level) {
            free(balls->bounds[level]);
        }
        free(balls->ball);
        free(balls);
    }
}

double murk_balls_memory_for(double n)
{
    double bytes = sizeof(murk_balls) + ceil(n / MURK_WIDE) * sizeof(sixteen);
    for (double bounds = ceil(n / MURK_WIDE); bounds > 0;) {
        const double groups = ceil(bounds / MURK_WIDE);
        bytes += groups * sizeof(murk_bounds);
        bounds = groups > 1 ? groups : 0;
    }
    return bytes;
}

typedef struct asking {
    const murk_balls *balls;
    murk_query_sphere point; /* a ball of radius 0 */
    murk_balls_visit visit;
    void *context;
} asking;

static void test_sixteen(const asking *a, size_t group)
{
    const sixteen *s = &a->balls->ball[group];
    const float x = a->point.center[0], y = a->point.center[1],
                z = a->point.center[2];
    float square[MURK_WIDE];
    for (int i = 0; i < MURK_WIDE; ++i) {
        const float dx = s->center[0][i] - x, dy = s->center[1][i] - y,
                    dz = s->center[2][i] - z;
        square[i] = ((dx * dx + dy * dy) + dz * dz) * s->per_square[i];
    }
    for (size_t i = 0; i < MURK_WIDE; ++i) {
        if (square[i] < 1) {
            a->visit(a->context, group * MURK_WIDE + i, (double)square[i]);
        }
    }
}

static void search_group(const asking *a, unsigned level, size_t group)
{
    uint32_t whole;
    uint32_t met = a->balls->test->bounds(a->balls->bounds[level] + group,
                                          &a->point, &whole);
    for (; met; met &= met - 1) {
        const size_t box = group * MURK_WIDE + (unsigned)__builtin_ctz(met);
        if (level > 0) {
            search_group(a, level - 1, box);
        } else {
            test_sixteen(a, box);
        }
    }
}

void murk_balls_at(const murk_balls *balls, murk_vec3 point,
                   murk_balls_visit visit, void *context)
{
    const asking a = {
        .balls = balls,
        .point = {{(float)point.x, (float)point.y, (float)point.z}, 0},
        .visit = visit,
        .context = context};
    const float *c = a.point.center;
    if (balls->levels > 0 && isfinite(c[0]) && isfinite(c[1]) &&
        isfinite(c[2])) {
        search_group(&a, balls->levels - 1, 0);
    }
}
