/* A walk from cell to cell (Amanatides and Woo, Eurographics 1987) on two
 * levels: bricks of 8^3 cells, of which empty ones are passed in one step, and
 * the cells of the others. Within a cell the field is a cubic along the ray,
 * which two Gauss-Legendre points integrate exactly. Single precision, as the
 * bare loop for nearest samples. */
#include "peer_march.h"

#include <math.h>
#include <stdlib.h>

#define BRICK 8

/* Where a ray is on its way through cells of one edge length. */
typedef struct walk {
    int cell[3], step[3];
    float next[3], delta[3]; /* distance of the next side, between sides */
} walk;

bool dense_field_create(dense_field *field, const int size[3])
{
    size_t samples = 1, bricks = 1;
    for (int k = 0; k < 3; ++k) {
        field->size[k] = size[k];
        field->bricks[k] = (size[k] + BRICK - 1) / BRICK;
        samples *= (size_t)size[k];
        bricks *= (size_t)field->bricks[k];
    }
    field->sample = calloc(samples, sizeof *field->sample);
    field->is_occupied = calloc(bricks, sizeof *field->is_occupied);
    return field->sample && field->is_occupied;
}

void dense_field_release(dense_field *field)
{
    free(field->sample);
    free(field->is_occupied);
}

/* A sample is a corner of the cells on both of its sides. */
void dense_field_prepare(dense_field *field)
{
    const int *n = field->size, *m = field->bricks;
    size_t i = 0;
    for (int z = 0; z < n[2]; ++z) {
        for (int y = 0; y < n[1]; ++y) {
            for (int x = 0; x < n[0]; ++x, ++i) {
                for (int side = 0; field->sample[i] != 0 && side < 8; ++side) {
                    const int a = x - (side & 1), b = y - (side >> 1 & 1);
                    const int c = z - (side >> 2);
                    if (a >= 0 && b >= 0 && c >= 0) {
                        field->is_occupied[a / BRICK +
                                           m[0] * (b / BRICK +
                                                   m[1] * (c / BRICK))] = true;
                    }
                }
            }
        }
    }
}

/* Begins at distance t in the cell there, which lies in [low, high] on each
 * axis whatever rounding says. */
static inline walk walk_from(const float origin[3], const float direction[3],
                             float t, int edge, const int low[3],
                             const int high[3])
{
    walk w;
    for (int k = 0; k < 3; ++k) {
        const int at =
            (int)floorf((origin[k] + t * direction[k]) / (float)edge);
        w.cell[k] = at < low[k] ? low[k] : at > high[k] ? high[k] : at;
        w.step[k] = direction[k] < 0 ? -1 : 1;
        const int side = (w.cell[k] + (direction[k] > 0)) * edge;
        const float per = 1 / direction[k];
        w.next[k] =
            direction[k] != 0 ? ((float)side - origin[k]) * per : INFINITY;
        w.delta[k] = (float)edge * fabsf(per);
    }
    return w;
}

static inline int next_axis(const walk *w)
{
    return w->next[0] < w->next[1] ? (w->next[0] < w->next[2] ? 0 : 2)
                                   : (w->next[1] < w->next[2] ? 1 : 2);
}

static inline void walk_on(walk *w, int axis)
{
    w->cell[axis] += w->step[axis];
    w->next[axis] += w->delta[axis];
}

/* The integral in the cell whose first corner is `corner`, from t to `to`. */
static inline float cell_integral(const dense_field *f, const int corner[3],
                                  const float origin[3],
                                  const float direction[3], float t, float to)
{
    const int row = f->size[0], layer = f->size[0] * f->size[1];
    const float *d = f->sample + corner[0] + (size_t)corner[1] * (size_t)row +
                     (size_t)corner[2] * (size_t)layer;
    const float middle = (t + to) / 2, half = (to - t) / 2;
    float sum = 0;
    for (int side = -1; side <= 1; side += 2) {
        const float at = middle + (float)side * half * .57735027f;
        const float x = origin[0] + at * direction[0] - (float)corner[0];
        const float y = origin[1] + at * direction[1] - (float)corner[1];
        const float z = origin[2] + at * direction[2] - (float)corner[2];
        const float a = d[0] + x * (d[1] - d[0]);
        const float b = d[row] + x * (d[row + 1] - d[row]);
        const float *e = d + layer;
        const float g = e[0] + x * (e[1] - e[0]);
        const float h = e[row] + x * (e[row + 1] - e[row]);
        const float low = a + y * (b - a), high = g + y * (h - g);
        sum += low + z * (high - low);
    }
    return half * sum;
}

/* All cells of one brick, from t to `end`. */
static float brick_integral(const dense_field *f, const int brick[3],
                            const float origin[3], const float direction[3],
                            float t, float end)
{
    int low[3], high[3];
    for (int k = 0; k < 3; ++k) {
        low[k] = brick[k] * BRICK;
        high[k] = low[k] + BRICK - 1;
        high[k] = high[k] > f->size[k] - 2 ? f->size[k] - 2 : high[k];
    }
    /* Walk from cell to cell. */
    walk w = walk_from(origin, direction, t, 1, low, high);
    float sum = 0;
    while (t < end) {
        const int axis = next_axis(&w);
        const float to = fminf(w.next[axis], end);
        if (to > t) {
            sum += cell_integral(f, w.cell, origin, direction, t, to);
            t = to;
        }
        walk_on(&w, axis);
        if (w.cell[axis] < low[axis] || w.cell[axis] > high[axis]) {
            break;
        }
    }
    return sum;
}

double dense_field_integral(const dense_field *field, const float origin[3],
                            const float direction[3], float length)
{
    /* Clip the ray to the box of the samples. */
    float t = 0, end = length;
    for (int k = 0; k < 3; ++k) {
        const float per = 1 / direction[k];
        const float a = -origin[k] * per;
        const float b = ((float)(field->size[k] - 1) - origin[k]) * per;
        t = fmaxf(t, fminf(a, b));
        end = fminf(end, fmaxf(a, b));
    }
    if (!(t < end)) {
        return 0;
    }
    /* Walk from brick to brick. */
    const int first[3] = {0, 0, 0}, *m = field->bricks;
    const int last[3] = {m[0] - 1, m[1] - 1, m[2] - 1};
    walk w = walk_from(origin, direction, t, BRICK, first, last);
    double sum = 0;
    while (t < end) {
        const int axis = next_axis(&w);
        const float to = fminf(w.next[axis], end);
        if (to > t &&
            field->is_occupied[w.cell[0] +
                               m[0] * (w.cell[1] + m[1] * w.cell[2])]) {
            sum +=
                (double)brick_integral(field, w.cell, origin, direction, t, to);
        }
        t = fmaxf(t, to);
        walk_on(&w, axis);
        if (w.cell[axis] < 0 || w.cell[axis] > last[axis]) {
            break;
        }
    }
    return sum;
}
