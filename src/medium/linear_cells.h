/* The walk of a ray through the cells of a grid and the integral of the field
 * over them: a function named MURK_CELLS for the instruction set
 * MURK_CELLS_TARGET. Included once for each set, by linear_integral.c only,
 * because neither compiler lowers vectors for the set of the function into
 * which it inlines.
 *
 * Every element goes through the same operations of IEEE 754, which are not
 * fused (-ffp-contract=off), so all sets give the same bits. */
#ifdef MURK_CELLS

#define INLINE                 MURK_CELLS_TARGET static inline __attribute__((always_inline))
#define MURK_CELLS_JOIN_(a, b) a##_##b
#define MURK_CELLS_JOIN(a, b)  MURK_CELLS_JOIN_(a, b)
#define NAMED(name)            MURK_CELLS_JOIN(MURK_CELLS, name)

/* ---- means ---- */

INLINE void NAMED(clamp01)(numbers *x)
{
    const numbers zero = {0, 0, 0, 0}, one = {1, 1, 1, 1};
    *x = MURK_CELLS_LARGER(*x, zero);
    *x = MURK_CELLS_SMALLER(*x, one);
}

INLINE uint64_t NAMED(load_two)(const float *from)
{
    uint64_t two;
    memcpy(&two, from, sizeof two);
    return two;
}

/* The values at two corners, one above the other along z, of four cells. */
INLINE void NAMED(load_column)(const float *const *corner, size_t offset,
                               numbers *low, numbers *high)
{
    const singles a = (singles)(words){NAMED(load_two)(corner[0] + offset),
                                       NAMED(load_two)(corner[1] + offset)};
    const singles b = (singles)(words){NAMED(load_two)(corner[2] + offset),
                                       NAMED(load_two)(corner[3] + offset)};
    *low = MURK_CELLS_WIDEN(__builtin_shufflevector(a, b, 0, 2, 4, 6));
    *high = MURK_CELLS_WIDEN(__builtin_shufflevector(a, b, 1, 3, 5, 7));
}

/* For the group of cells from `first` on: mean of the field, density = scale *
 * mean + offset, and depth = density * length.
 *
 * The middle of the segment is at (x, y, z) in the cell, and (dx, dy, dz) leads
 * from one end of the segment to the other. The field on the segment is a
 * cubic, so the mean is the value in the middle plus 1/24 of the second
 * derivative, which follows from the mixed derivatives of the field. */
INLINE void NAMED(compute_means)(cells *c, size_t first,
                                 const double direction[3], const tally *sum)
{
    numbers from, length, x, y, z;
    memcpy(&from, &c->from[first], sizeof from);
    memcpy(&length, &c->to[first], sizeof length);
    memcpy(&x, &c->low[0][first], sizeof x);
    memcpy(&y, &c->low[1][first], sizeof y);
    memcpy(&z, &c->low[2][first], sizeof z);
    length -= from;
    /* The middle of the segment, and the segment as a vector. */
    const numbers middle = from + length * 0.5;
    x = middle * direction[0] - x;
    y = middle * direction[1] - y;
    z = middle * direction[2] - z;
    NAMED(clamp01)(&x);
    NAMED(clamp01)(&y);
    NAMED(clamp01)(&z);
    const numbers bend = (numbers)((masks)length & (length <= sum->longest));
    const numbers dx = bend * direction[0], dy = bend * direction[1];
    const numbers dz = bend * direction[2];
    /* Values v and derivatives by x on the edges along x, 0 and 1 along z. */
    const float *const *corner = &c->corner[first];
    numbers low0, low1, high0, high1, low_x0, low_x1, high_x0, high_x1;
    NAMED(load_column)(corner, 0, &low0, &low1);
    NAMED(load_column)(corner, MURK_CORNER_Y, &high0, &high1);
    NAMED(load_column)(corner, MURK_CORNER_X, &low_x0, &low_x1);
    NAMED(load_column)
    (corner, MURK_CORNER_X + MURK_CORNER_Y, &high_x0, &high_x1);
    low_x0 -= low0;
    low_x1 -= low1;
    high_x0 -= high0;
    high_x1 -= high1;
    low0 += x * low_x0;
    low1 += x * low_x1;
    high0 += x * high_x0;
    high1 += x * high_x1;
    /* Values and derivatives on the faces z = 0 and z = 1. */
    const numbers by_y0 = high0 - low0, by_y1 = high1 - low1;
    const numbers by_xy0 = high_x0 - low_x0, by_xy1 = high_x1 - low_x1;
    const numbers value0 = low0 + y * by_y0, value1 = low1 + y * by_y1;
    const numbers by_x0 = low_x0 + y * by_xy0, by_x1 = low_x1 + y * by_xy1;
    /* The mixed derivatives, and the mean. */
    const numbers xy = by_xy0 + z * (by_xy1 - by_xy0);
    const numbers xz = by_x1 - by_x0, yz = by_y1 - by_y0;
    const numbers second = xy * dx * dy + (xz * dx + yz * dy) * dz;
    numbers mean = value0 + z * (value1 - value0) + second * (1.0 / 12);
    const numbers zero = {0, 0, 0, 0};
    mean = MURK_CELLS_LARGER(mean, zero);
    const numbers density = sum->scale * mean + sum->offset;
    const numbers depth = density * length;
    memcpy(&c->mean[first], &mean, sizeof mean);
    memcpy(&c->density[first], &density, sizeof density);
    memcpy(&c->depth[first], &depth, sizeof depth);
}

/* Adds the integrals over the cells of the list and empties the list. True if
 * the limit is reached in one of them. */
MURK_CELLS_TARGET static bool NAMED(add_cells)(murk_linear *m, cells *c,
                                               tally *sum)
{
    const size_t n = c->n;
    const double limit = sum->limit;
    double reached = sum->reached;
    /* Fill the last group with segments of length 0. */
    for (size_t i = n; i % GROUP > 0; ++i) {
        c->from[i] = c->to[i] = c->to[n - 1];
        c->low[0][i] = c->low[1][i] = c->low[2][i] = 0;
        c->corner[i] = c->corner[n - 1];
    }
    c->n = 0;
    for (size_t first = 0; first < n; first += GROUP) {
        NAMED(compute_means)(c, first, m->ray.direction, sum);
        /* Depths are 0 or more, so no cell of the group reaches the limit if
         * all cells together do not. */
        const double *depth = &c->depth[first];
        double more = reached;
        for (int i = 0; i < GROUP; ++i) {
            more += depth[i];
        }
        if (!(more >= limit)) {
            reached = more;
            continue;
        }
        for (size_t i = first; i < n && i < first + GROUP; ++i) {
            more = reached + c->depth[i];
            if (more >= limit && c->density[i] > 0) {
                sum->reached = reached;
                stop_in_cell(m, c, i, sum);
                return true;
            }
            reached = more;
        }
    }
    sum->reached = reached;
    return false;
}

/* ---- cells of blocks ---- */

/* Lists the cells from block to block, up to the end of the ray or to a block
 * without a leaf of its own: the work of murk_linear_enter(),
 * murk_grid_ray_cross_in_block(), murk_grid_ray_step_in_block() and
 * murk_grid_ray_leave_block(). Cells that contribute nothing are left out. Adds
 * the cells when there are `capacity`. True if the limit is reached. */
INLINE bool NAMED(list_blocks)(murk_linear *m, cells *c, tally *sum,
                               size_t capacity)
{
    murk_grid_ray *r = &m->ray;
    const double end = r->end;
    const axes origin = axes_of(r->origin), inverse = axes_of(r->inverse);
    const axes stride = axes_of(r->stride);
    const axes step = {{r->step[0], r->step[1]}, {r->step[2], r->step[2]}};
    const axes up = {{r->step[0] > 0, r->step[1] > 0},
                     {r->step[2] > 0, r->step[2] > 0}};
    const pair_masks is_parallel_xy = inverse.xy == 0;
    const pair_masks is_parallel_zz = inverse.zz == 0;
    const pair never = {INFINITY, INFINITY};
    const unsigned counts_all = sum->offset != 0;
    const murk_linear_block *block = m->block;
    double from = r->from, to;
    int32_t x = r->at[0], y = r->at[1], z = r->at[2];
    size_t n = c->n;
    bool is_at_end;
    for (;;) {
        /* Enter the block: where the ray reaches the faces ahead. */
        const float *value = murk_linear_values(m->blocks, block);
        const axes at = {{x, y}, {z, z}};
        const pair froms = {from, from};
        axes low = {at.xy - origin.xy, at.zz - origin.zz};
        axes face = {(at.xy + up.xy - origin.xy) * inverse.xy,
                     (at.zz + up.zz - origin.zz) * inverse.zz};
        face.xy = chosen(is_parallel_xy, never, face.xy);
        face.zz = chosen(is_parallel_zz, never, face.zz);
        face.xy = larger(face.xy, froms);
        face.zz = larger(face.zz, froms);
        int64_t place = PLACE_AT(x & 7, y & 7, z & 7);
        for (;;) {
            /* Write the cell to the end of the list, and count it if it
             * contributes. */
            const size_t index = (size_t)place >> 32;
            pair nearest = smaller(face.xy, face.zz);
            nearest = smaller(nearest, (pair){nearest[1], nearest[0]});
            to = murk_smaller(nearest[0], end);
            __builtin_prefetch(&value[index]);
            __builtin_prefetch(&value[index + MURK_CORNER_X]);
            c->corner[n] = &value[index];
            c->low[0][n] = low.xy[0];
            c->low[1][n] = low.xy[1];
            c->low[2][n] = low.zz[0];
            c->from[n] = from;
            c->to[n] = to;
            n += murk_linear_is_filled(block, index) | counts_all;
            is_at_end = nearest[0] >= end;
            if (is_at_end) {
                break;
            }
            /* Advance to the next cell along every axis whose face was
             * reached. */
            from = to;
            const pair_masks is_xy = face.xy <= nearest;
            const pair_masks is_zz = face.zz <= nearest;
            face.xy += (pair)(is_xy & (pair_masks)stride.xy);
            face.zz += (pair)(is_zz & (pair_masks)stride.zz);
            low.xy += (pair)(is_xy & (pair_masks)step.xy);
            low.zz += (pair)(is_zz & (pair_masks)step.zz);
            place += sum->step[step_index(is_xy, is_zz)];
            if (n == capacity) {
                c->n = n;
                if (NAMED(add_cells)(m, c, sum)) {
                    return true;
                }
                n = 0;
            }
            if (is_beyond(place)) {
                break;
            }
        }
        /* The cell beyond the block, and its block. */
        x = block->first[0] + place_x(place);
        y = block->first[1] + place_y(place);
        z = block->first[2] + place_z(place);
        const int32_t first[3] = {x & ~7, y & ~7, z & ~7};
        block = is_at_end ? NULL : murk_linear_block_at(m->blocks, first);
        if (!(block && block->has_leaf)) {
            break;
        }
    }
    /* Store the state. */
    c->n = n;
    r->from = from;
    r->to = to;
    r->at[0] = x;
    r->at[1] = y;
    r->at[2] = z;
    r->is_in_block = false;
    return false;
}

/* murk_linear_integrate(). */
MURK_CELLS_TARGET static bool MURK_CELLS(murk_linear *m, tally *sum)
{
    cells c; /* not initialised as a whole: the list is long */
    c.n = 0;
    const size_t capacity =
        sum->limit < INFINITY ? CELLS_WITH_LIMIT : CELLS_MAX;
    bool stops = false;
    while (!stops && m->ray.to < m->ray.end) {
        m->ray.from = m->ray.to;
        if (murk_linear_enter(m)) {
            stops = NAMED(list_blocks)(m, &c, sum, capacity);
        } else if (sum->offset != 0 || !is_zero(m->corner)) {
            /* The cells of the list come before the segment. */
            stops = (c.n > 0 && NAMED(add_cells)(m, &c, sum)) ||
                    add_segment(m, sum);
        }
    }
    return stops || (c.n > 0 && NAMED(add_cells)(m, &c, sum));
}

#undef INLINE
#undef NAMED
#undef MURK_CELLS_JOIN
#undef MURK_CELLS_JOIN_
#undef MURK_CELLS
#undef MURK_CELLS_TARGET
#undef MURK_CELLS_WIDEN
#undef MURK_CELLS_SMALLER
#undef MURK_CELLS_LARGER

#endif
