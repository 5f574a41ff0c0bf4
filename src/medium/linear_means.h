/* The means of the field in several cells that a ray crosses, side by side in
 * vectors (a vector extension of gcc and clang): a function named MURK_MEANS
 * for the instruction set MURK_MEANS_TARGET. Included once for each set, by
 * linear_integral.c only, because neither compiler lowers vectors for the set
 * of the function into which it inlines.
 *
 * Every element goes through the same operations of IEEE 754, which are not
 * fused (-ffp-contract=off), so all sets give the same bits. */
#ifdef MURK_MEANS

#define MURK_MEANS_INLINE \
    MURK_MEANS_TARGET static inline __attribute__((always_inline))
#define MURK_MEANS_JOIN_(a, b) a##_##b
#define MURK_MEANS_JOIN(a, b)  MURK_MEANS_JOIN_(a, b)
#define NAMED(name)            MURK_MEANS_JOIN(MURK_MEANS, name)

/* The larger of x and 0. */
MURK_MEANS_INLINE void NAMED(raise_to_0)(numbers *x)
{
    *x = (numbers)((masks)*x & (*x > 0));
}

MURK_MEANS_INLINE void NAMED(clamp01)(numbers *x)
{
    const numbers one = {1, 1, 1, 1};
    NAMED(raise_to_0)(x);
    const masks is_less = *x < one;
    *x = (numbers)(((masks)*x & is_less) | ((masks)one & ~is_less));
}

MURK_MEANS_INLINE uint64_t NAMED(load_two)(const float *from)
{
    uint64_t two;
    memcpy(&two, from, sizeof two);
    return two;
}

/* The values at two corners, one above the other along z, of four cells. */
MURK_MEANS_INLINE void NAMED(load_column)(const float *const *corner,
                                          size_t offset, numbers *low,
                                          numbers *high)
{
    const singles a = (singles)(words){NAMED(load_two)(corner[0] + offset),
                                       NAMED(load_two)(corner[1] + offset)};
    const singles b = (singles)(words){NAMED(load_two)(corner[2] + offset),
                                       NAMED(load_two)(corner[3] + offset)};
    *low = MURK_MEANS_WIDEN(__builtin_shufflevector(a, b, 0, 2, 4, 6));
    *high = MURK_MEANS_WIDEN(__builtin_shufflevector(a, b, 1, 3, 5, 7));
}

/* For the group of cells from `first` on: mean of the field, density = scale *
 * mean + offset, and depth = density * length.
 *
 * The middle of the segment is at (x, y, z) in the cell, and (dx, dy, dz) leads
 * from one end of the segment to the other. The field on the segment is a
 * cubic, so the mean is the value in the middle plus 1/24 of the second
 * derivative, which follows from the mixed derivatives of the field. */
MURK_MEANS_INLINE void NAMED(group)(cells *c, size_t first,
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
    NAMED(load_column)(corner, LEAF_Y, &high0, &high1);
    NAMED(load_column)(corner, LEAF_X, &low_x0, &low_x1);
    NAMED(load_column)(corner, LEAF_X + LEAF_Y, &high_x0, &high_x1);
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
    NAMED(raise_to_0)(&mean);
    const numbers density = sum->scale * mean + sum->offset;
    const numbers depth = density * length;
    memcpy(&c->mean[first], &mean, sizeof mean);
    memcpy(&c->density[first], &density, sizeof density);
    memcpy(&c->depth[first], &depth, sizeof depth);
}

/* The same for all cells of the list. */
MURK_MEANS_TARGET static void MURK_MEANS(cells *c, const double direction[3],
                                         const tally *sum)
{
    for (size_t first = 0; first < c->n; first += GROUP) {
        NAMED(group)(c, first, direction, sum);
    }
}

#undef MURK_MEANS_INLINE
#undef NAMED
#undef MURK_MEANS_JOIN
#undef MURK_MEANS_JOIN_
#undef MURK_MEANS
#undef MURK_MEANS_TARGET
#undef MURK_MEANS_WIDEN

#endif
