/* The range tests of photonmap/range_test.h in vector instructions, written
 * once for all widths. range_test.c includes this file once for each width,
 * without an include guard, and defines before it:
 *
 *   NAME(x)           x with the suffix of this width
 *   TITLE             the name of this width, a string
 *   TARGET            the attribute of functions that use the instructions
 *   VECTOR, LANES     a vector of single-precision numbers, and their number
 *   SPLAT(x)          a vector with x in all lanes
 *   LOAD(p)           LANES numbers from an aligned array
 *   STORE(p, v)       LANES numbers to an array
 *   LARGER(a, b), SMALLER(a, b)
 *                     maximum and minimum, lane by lane
 *   NOT_ABOVE(a, b)   bit i: a <= b in lane i
 *   QUARTERS(p)       loads a photon into each quarter (4 lanes) of the vector,
 *                     unaligned: quarter i holds x, y, z and the next word of
 *                     photon p[4 i]
 *   LOW(a, b), HIGH(a, b)
 *                     the two lower or upper lanes of each quarter of a and b,
 *                     interleaved
 *   PAIRS(a, b, how)  two lanes of each quarter of a, then two of b, chosen by
 *                     the bits of `how` as in _mm_shuffle_ps()
 *
 * Without these definitions the file is empty. */
#ifdef NAME

/* The squared length of each vector. */
TARGET static inline VECTOR NAME(length2)(const VECTOR d[3])
{
    return (d[0] * d[0] + d[1] * d[1]) + d[2] * d[2];
}

/* Offsets along each axis from the center to the nearest and (in magnitude) to
 * the farthest points of boxes i to i + LANES - 1. */
TARGET static inline void NAME(box)(const murk_bounds *bounds,
                                    const float *center, int i, VECTOR near[3],
                                    VECTOR far[3])
{
    for (int a = 0; a < 3; ++a) {
        const VECTOR c = SPLAT(center[a]);
        const VECTOR below = LOAD(bounds->min[a] + i) - c;
        const VECTOR above = c - LOAD(bounds->max[a] + i);
        near[a] = LARGER(LARGER(below, above), SPLAT(0));
        far[a] = SMALLER(below, above);
    }
}

TARGET static void NAME(bounds_distance2)(const murk_bounds *bounds,
                                          const float center[3],
                                          float out[MURK_WIDE])
{
    for (int i = 0; i < MURK_WIDE; i += LANES) {
        VECTOR near[3], far[3];
        NAME(box)(bounds, center, i, near, far);
        STORE(out + i, NAME(length2)(near));
    }
}

TARGET static uint32_t NAME(bounds)(const murk_bounds *bounds,
                                    const murk_query_sphere *ball,
                                    uint32_t *whole)
{
    const VECTOR radius2 = SPLAT(ball->radius2);
    uint32_t met = 0, inside = 0;
    for (int i = 0; i < MURK_WIDE; i += LANES) {
        VECTOR near[3], far[3];
        NAME(box)(bounds, ball->center, i, near, far);
        met |= (uint32_t)NOT_ABOVE(NAME(length2)(near), radius2) << i;
        inside |= (uint32_t)NOT_ABOVE(NAME(length2)(far), radius2) << i;
    }
    *whole = inside;
    return met;
}

/* Loads LANES records, transposes them to three vectors of coordinates, and
 * returns squared distances. */
TARGET static inline VECTOR NAME(photons)(const murk_photon *p,
                                          const VECTOR center[3])
{
    const VECTOR a = QUARTERS(p), b = QUARTERS(p + 1);
    const VECTOR c = QUARTERS(p + 2), d = QUARTERS(p + 3);
    const VECTOR xy01 = LOW(a, b), xy23 = LOW(c, d);
    const VECTOR z01 = HIGH(a, b), z23 = HIGH(c, d);
    const VECTOR off[3] = {PAIRS(xy01, xy23, 0x44) - center[0],
                           PAIRS(xy01, xy23, 0xee) - center[1],
                           PAIRS(z01, z23, 0x44) - center[2]};
    return NAME(length2)(off);
}

/* The last photons that do not fill a vector use the plain version. */
TARGET static void NAME(leaf_distance2)(const murk_photon *photons, uint32_t n,
                                        const float center[3],
                                        float out[MURK_LEAF])
{
    const VECTOR c[3] = {SPLAT(center[0]), SPLAT(center[1]), SPLAT(center[2])};
    uint32_t i = 0;
    for (; i + LANES <= n; i += LANES) {
        STORE(out + i, NAME(photons)(photons + i, c));
    }
    plain_leaf_distance2(photons + i, n - i, center, out + i);
}

TARGET static uint32_t NAME(leaf)(const murk_photon *photons, uint32_t n,
                                  const murk_query_sphere *ball)
{
    if (n < MURK_LEAF) {
        return plain_leaf(photons, n, ball);
    }
    const float *center = ball->center;
    const VECTOR c[3] = {SPLAT(center[0]), SPLAT(center[1]), SPLAT(center[2])};
    const VECTOR radius2 = SPLAT(ball->radius2);
    uint32_t in = 0;
    for (int i = 0; i < MURK_LEAF; i += LANES) {
        in |= (uint32_t)NOT_ABOVE(NAME(photons)(photons + i, c), radius2) << i;
    }
    return in;
}

static const murk_range_test NAME(test) = {TITLE, NAME(bounds), NAME(leaf),
                                           NAME(bounds_distance2),
                                           NAME(leaf_distance2)};

#undef NAME
#undef TITLE
#undef TARGET
#undef VECTOR
#undef LANES
#undef SPLAT
#undef LOAD
#undef STORE
#undef LARGER
#undef SMALLER
#undef NOT_ABOVE
#undef QUARTERS
#undef LOW
#undef HIGH
#undef PAIRS

#endif
