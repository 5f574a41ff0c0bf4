/* The kernel of transport/score_lanes.c, which includes this file once for each
 * vector instruction set.
 *
 * The includer defines:
 *   WIDTH              the number of lanes in a register
 *   TARGET             the attribute of functions
 *   NAMED()            names of the set
 *   TRUTHS             the type of a condition in all lanes: a mask, or bits
 *   LESS(a, b)         the condition a < b
 *   NOT_LESS(a, b)     the condition a >= b, false for NaN
 *   DIFFER(a, b)       the condition a != b
 *   LESS_WHOLE(a, b)   the condition a < b of integers
 *   EQUAL_WHOLE(a, b)  the condition a == b of integers
 *   BOTH(c, d)         c and d
 *   BUT(c, d)          c and not d
 *   NEITHER(c, d)      neither c nor d
 *   AND(c, a)          a where the condition c is true, else 0
 *   INCREASED(c, a, b) a + b where the condition c is true, else a
 *   CHOSEN(c, a, b)    a where the condition c is true, else b
 *   MASK_OF(c)         -1 where the condition c is true, else 0
 *   PRODUCT(a, b)      the product of the lower halves of integers
 *   LOWER(a, b)        a < b ? a : b
 *   HIGHER(a, b)       a > b ? a : b
 *   ROUNDED_DOWN(a)    for numbers from 0 to 2^51
 *   EVEN_PAIRS(a, b)   elements 0, 2, ... of a and b in turn
 *   ODD_PAIRS(a, b)    elements 1, 3, ... of a and b in turn
 *   LOADED(base, at)   the entries at base + at[0], base + at[2], ...
 *   ANY(c)             true if the condition is true in some lane
 *   LARGEST(a)         the largest element of a
 *
 * The operations are those of transport/score_grid.c in the same order. In each
 * round all photons of a register fly on to the next face between cells, until
 * the photon that crosses most faces has come to the end. A photon that has
 * arrived flies on by 0 m, which adds nothing. The kernel is written in vectors
 * because compilers do not turn loops with so many conditions into vector
 * instructions. */
#ifdef WIDTH

#define VECTOR NAMED(vector)
#define MASK   NAMED(mask)
#define WORDS  NAMED(words)
#define AXIS   NAMED(axis)
#define KERNEL TARGET static inline __attribute__((always_inline)) void

/* One axis of the grid, in all lanes. */
typedef struct NAMED(grid_axis) {
    VECTOR low_m, cells_per_m, size, stride;
    MASK up, down; /* the stride to the next cell in both directions */
} NAMED(grid_axis);

/* The grid. */
typedef struct NAMED(grid) {
    NAMED(grid_axis) x, y, z;
    VECTOR first, per_m;
    MASK spare; /* the list that is written in lanes without a segment */
} NAMED(grid);

/* One axis of the segments; the unit of `at` and of faces is a cell. */
typedef struct AXIS {
    VECTOR at, per_pace;    /* start; metres per cell */
    VECTOR face, step, end; /* the face ahead, the step to the next one, and
                             * the face after the last one to cross */
    VECTOR first, crossed;  /* the cell of the start; the number of faces */
    MASK stride;            /* of the cell number, to the next cell ahead */
    TRUTHS is_within;       /* both ends lie in the grid */
} AXIS;

KERNEL NAMED(set_up)(NAMED(grid_axis) * axis, double low_m, double cells_per_m,
                     uint32_t size, uint32_t stride)
{
    const VECTOR zero = {0};
    const MASK none = {0};
    *axis = (NAMED(grid_axis)){.low_m = zero + low_m,
                               .cells_per_m = zero + cells_per_m,
                               .size = zero + size,
                               .stride = zero + stride,
                               .up = none + (int64_t)stride,
                               .down = none - (int64_t)stride};
}

KERNEL NAMED(set_out)(AXIS *axis, const NAMED(grid_axis) * grid,
                      const double *position, const double *direction,
                      VECTOR length_m)
{
    VECTOR from, along;
    memcpy(&from, position, sizeof from);
    memcpy(&along, direction, sizeof along);
    const VECTOR at = (from - grid->low_m) * grid->cells_per_m;
    const VECTOR pace = along * grid->cells_per_m;
    const VECTOR to = at + pace * length_m;
    /* The cells of both ends: numbers without use if a segment is not within.
     */
    const VECTOR first = ROUNDED_DOWN(at), last = ROUNDED_DOWN(to);
    /* The faces between them. */
    const TRUTHS is_up = LESS(first, last);
    const VECTOR zero = {0}, one = zero + 1, up = AND(is_up, one);
    *axis = (AXIS){.at = at,
                   .per_pace = 1 / pace,
                   .face = first + up,
                   .step = CHOSEN(is_up, one, -one),
                   .end = last + up,
                   .first = first,
                   .crossed = (VECTOR)((MASK)(last - first) & INT64_MAX),
                   .stride = WHOLE_CHOSEN(is_up, grid->up, grid->down),
                   .is_within = BOTH(NOT_LESS(LOWER(at, to), zero),
                                     LESS(HIGHER(at, to), grid->size))};
}

/* The length at which the face is met; infinite after the last face. */
KERNEL NAMED(meet)(VECTOR *next_m, const AXIS *axis)
{
    *next_m = CHOSEN(DIFFER(axis->face, axis->end),
                     (axis->face - axis->at) * axis->per_pace,
                     (VECTOR){0} + INFINITY);
}

/* Segments of WIDTH lanes; those that are not within are left out. */
KERNEL NAMED(score_some)(TRUTHS *is_left_out, const NAMED(grid) * grid,
                         const murk_lane_segments *segments,
                         murk_lane_lists *lists, size_t lane)
{
    const murk_lane_rays *const from = segments->from;
    /* The segments in units of cells. */
    VECTOR whole_m, quanta;
    memcpy(&whole_m, &segments->length_m[lane], sizeof whole_m);
    memcpy(&quanta, &from->quanta[lane], sizeof quanta);
    const VECTOR quanta_per_m = quanta * grid->per_m;
    AXIS x, y, z;
    NAMED(set_out)(&x, &grid->x, &from->x[lane], &from->dx[lane], whole_m);
    NAMED(set_out)(&y, &grid->y, &from->y[lane], &from->dy[lane], whole_m);
    NAMED(set_out)(&z, &grid->z, &from->z[lane], &from->dz[lane], whole_m);
    const VECTOR zero = {0};
    const TRUTHS is_flown = LESS(zero, whole_m);
    const TRUTHS is_within =
        BOTH(BOTH(x.is_within, y.is_within), BOTH(z.is_within, is_flown));
    *is_left_out = BUT(is_flown, is_within);
    const VECTOR length_m = AND(is_within, whole_m);
    MASK cell = WHOLE(x.first + y.first * grid->y.stride +
                      z.first * grid->z.stride + grid->first);
    /* The faces to cross, and the largest number of them. */
    const VECTOR crossed = AND(is_within, x.crossed + y.crossed + z.crossed);
    const double faces = LARGEST(crossed);
    /* The first entry of each segment: the last one of the list, if that is of
     * the same cell, else a new one. */
    MASK last;
    memcpy(&last, &lists->last[lane], sizeof last);
    char *const entries = (char *)lists->entries;
    VECTOR even = LOADED(entries, &lists->last[lane]),
           odd = LOADED(entries, &lists->last[lane + 1]);
    const TRUTHS is_same = EQUAL_WHOLE(cell, ODD_PAIRS(even, odd));
    VECTOR carried = AND(is_same, EVEN_PAIRS(even, odd));
    const MASK entry = (MASK){0} + (int64_t)sizeof(murk_score_entry);
    const MASK first = WHOLE_CHOSEN(
        is_within, WHOLE_CHOSEN(is_same, last, last + entry), grid->spare);
    last = WHOLE_CHOSEN(
        is_within, first + WHOLE(crossed) * (int64_t)sizeof(murk_score_entry),
        last);
    memcpy(&lists->last[lane], &last, sizeof last);
    char *at[WIDTH];
    for (size_t i = 0; i < WIDTH; ++i) {
        at[i] = entries + first[i];
    }
    /* Fly, until the photon that crosses most faces has arrived. What others
     * write until then is beyond the end of their lists. */
    VECTOR t = zero;
    VECTOR next_x, next_y, next_z, after_x, after_y, after_z;
    NAMED(meet)(&next_x, &x);
    NAMED(meet)(&next_y, &y);
    NAMED(meet)(&next_z, &z);
    x.face += x.step;
    y.face += y.step;
    z.face += z.step;
    for (int left = (int)faces;; --left) {
        /* The nearest face: of faces at the same length that of z, then that of
         * y. A photon that has arrived has no face ahead: which axis is chosen
         * does not matter then. */
        const VECTOR next_yz = LOWER(next_y, next_z);
        const VECTOR met = LOWER(next_x, next_yz);
        const TRUTHS is_x = LESS(next_x, next_yz);
        const TRUTHS is_y = BUT(LESS(next_y, next_z), is_x);
        const TRUTHS is_z = NEITHER(is_x, is_y);
        /* The length up to the face, or to the end. */
        const VECTOR until = LOWER(met, length_m), reached = HIGHER(until, t);
        const VECTOR value = carried + (reached - t) * quanta_per_m;
        t = reached;
        carried = zero;
        /* Write the entries. */
        even = EVEN_PAIRS(value, (VECTOR)cell);
        odd = ODD_PAIRS(value, (VECTOR)cell);
        for (size_t i = 0; i < WIDTH; ++i) {
            memcpy(at[i],
                   (const murk_score_entry *)(i % 2 ? &odd : &even) + i / 2,
                   sizeof(murk_score_entry));
            at[i] += sizeof(murk_score_entry);
        }
        if (left == 0) {
            break;
        }
        /* Enter the next cell. The face after the next one of each axis is
         * computed in advance, which shortens the chain of operations from
         * round to round. */
        NAMED(meet)(&after_x, &x);
        NAMED(meet)(&after_y, &y);
        NAMED(meet)(&after_z, &z);
        next_x = CHOSEN(is_x, after_x, next_x);
        next_y = CHOSEN(is_y, after_y, next_y);
        next_z = CHOSEN(is_z, after_z, next_z);
        x.face = INCREASED(is_x, x.face, x.step);
        y.face = INCREASED(is_y, y.face, y.step);
        z.face = INCREASED(is_z, z.face, z.step);
        cell += WHOLE_CHOSEN(is_x, x.stride,
                             WHOLE_CHOSEN(is_y, y.stride, z.stride));
    }
}

TARGET static void NAMED(score)(const murk_lattice *lattice,
                                const murk_lane_segments *segments,
                                murk_lane_lists *lists)
{
    const double *const k = lattice->cells_per_m;
    const uint32_t *const n = lattice->size;
    NAMED(grid)
    grid = {.first = (VECTOR){0} + lattice->first,
            .per_m = (VECTOR){0} + lattice->per_m,
            .spare = (MASK){0} + lists->spare};
    NAMED(set_up)(&grid.x, lattice->box.min.x, k[0], n[0], 1);
    NAMED(set_up)(&grid.y, lattice->box.min.y, k[1], n[1], n[0]);
    NAMED(set_up)(&grid.z, lattice->box.min.z, k[2], n[2], n[0] * n[1]);
    for (size_t lane = 0; lane < segments->n; lane += WIDTH) {
        TRUTHS is_left_out;
        NAMED(score_some)(&is_left_out, &grid, segments, lists, lane);
        const MASK left_out = MASK_OF(is_left_out);
        for (size_t i = 0; ANY(is_left_out) && i < WIDTH; ++i) {
            if (left_out[i]) {
                score_one(lattice, segments, lists, lane + i);
            }
        }
    }
}

TARGET static void NAMED(select)(murk_lane_segments *segments,
                                 const murk_lane_lists *lists,
                                 const double *meets, const double *distance_m)
{
    for (size_t lane = 0; lane < segments->n; lane += WIDTH) {
        VECTOR met, length_m;
        MASK last, limit;
        memcpy(&met, &meets[lane], sizeof met);
        memcpy(&length_m, &distance_m[lane], sizeof length_m);
        memcpy(&last, &lists->last[lane], sizeof last);
        memcpy(&limit, &lists->limit[lane], sizeof limit);
        const MASK is_scored = (met != 0) & (last < limit);
        length_m = (VECTOR)(is_scored & (MASK)length_m);
        memcpy(&segments->is_scored[lane], &is_scored, sizeof is_scored);
        memcpy(&segments->length_m[lane], &length_m, sizeof length_m);
    }
}

/* Adds carries to the upper halves: of the entries whose offsets are at[0],
 * at[2], ..., two integers each, the sum and that of the squares. */
TARGET static void NAMED(carry)(murk_tally_bin *high, const uint64_t *at,
                                MASK is_carried)
{
    for (size_t i = 0; i < WIDTH; i += 2) {
        murk_tally_bin *const bin = &high[at[i] / sizeof *high];
        murk_wide_carry_alone(&bin->sum, is_carried[i] ? 1 : 0);
        murk_wide_carry_alone(&bin->squares, is_carried[i + 1] ? 1 : 0);
    }
}

/* Adds the values and squares of WIDTH / 2 entries, whose offsets are at[0],
 * at[2], ..., to the lower halves. */
KERNEL NAMED(add_half)(murk_tally_bin *low, murk_tally_bin *high,
                       const uint64_t *at, MASK values)
{
    const MASK before = (MASK)LOADED((const char *)low, (const int64_t *)at);
    const MASK after = (MASK)((WORDS)before + (WORDS)values);
    for (size_t i = 0; i < WIDTH; i += 2) {
        memcpy((char *)low + at[i], (const int64_t *)&after + i, sizeof *low);
    }
    /* A sum without a sign that is less than one of the terms has carried. */
    const MASK sign = (MASK){0} + INT64_MIN;
    const TRUTHS carries = LESS_WHOLE(after ^ sign, before ^ sign);
    if (ANY(carries)) {
        NAMED(carry)(high, at, MASK_OF(carries));
    }
}

TARGET static void NAMED(add)(murk_tally_bin *low, murk_tally_bin *high,
                              const murk_score_entry *entry, size_t n)
{
    const size_t whole_registers = n - n % WIDTH;
    for (size_t i = 0; i < whole_registers; i += WIDTH) {
        VECTOR first, second;
        memcpy(&first, &entry[i], sizeof first);
        memcpy(&second, &entry[i + WIDTH / 2], sizeof second);
        const VECTOR half = (VECTOR){0} + 0.5;
        const MASK value =
            WHOLE(ROUNDED_DOWN(EVEN_PAIRS(first, second) + half));
        /* The square of a value above 2^32 needs 128 bits. */
        const TRUTHS is_large = LESS_WHOLE((MASK){0} + UINT32_MAX, value);
        if (ANY(is_large)) {
            murk_score_add_entries(low, high, &entry[i], WIDTH);
            continue;
        }
        const VECTOR square = (VECTOR)PRODUCT(value, value);
        NAMED(add_half)
        (low, high, &entry[i].cell, (MASK)EVEN_PAIRS((VECTOR)value, square));
        NAMED(add_half)
        (low, high, &entry[i + WIDTH / 2].cell,
         (MASK)ODD_PAIRS((VECTOR)value, square));
    }
    murk_score_add_entries(low, high, &entry[whole_registers],
                           n - whole_registers);
}

#undef WIDTH
#undef TARGET
#undef PRODUCT
#undef LESS_WHOLE
#undef NAMED
#undef TRUTHS
#undef LESS
#undef NOT_LESS
#undef DIFFER
#undef EQUAL_WHOLE
#undef BOTH
#undef BUT
#undef NEITHER
#undef AND
#undef INCREASED
#undef CHOSEN
#undef MASK_OF
#undef LARGEST
#undef LOWER
#undef HIGHER
#undef ROUNDED_DOWN
#undef EVEN_PAIRS
#undef ODD_PAIRS
#undef LOADED
#undef ANY
#undef VECTOR
#undef MASK
#undef WORDS
#undef AXIS
#undef KERNEL

#endif
