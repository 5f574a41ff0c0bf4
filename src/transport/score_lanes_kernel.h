/* The kernel of transport/score_lanes.c, which includes this file once for each
 * vector instruction set: WIDTH is the number of lanes in a register, TARGET
 * the attribute of functions, NAMED() gives names of the set.
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
#define AXIS   NAMED(axis)
#define KERNEL TARGET static inline __attribute__((always_inline)) void

/* Numbers of the lanes; all bits of an element of a mask are equal. */
typedef double VECTOR __attribute__((vector_size(8 * WIDTH)));
typedef int64_t MASK __attribute__((vector_size(8 * WIDTH)));
typedef int32_t NAMED(whole) __attribute__((vector_size(4 * WIDTH)));

#define AND(mask, a) ((VECTOR)((mask) & (MASK)(a)))
#define CHOSEN(mask, a, b) \
    ((VECTOR)(((mask) & (MASK)(a)) | (~(mask) & (MASK)(b))))

/* One axis of the segments; the unit of `at` and of faces is a cell. */
typedef struct AXIS {
    VECTOR at, per_pace;    /* start; metres per cell */
    VECTOR face, step, end; /* the face ahead, the step to the next one, and
                             * the face after the last one to cross */
    VECTOR first, last;     /* the cells of both ends */
    MASK is_within;         /* both ends lie in the grid */
} AXIS;

/* Rounds down numbers from 0 to 2^51. */
KERNEL NAMED(round_down)(VECTOR *x)
{
    const VECTOR rounded = *x + 0x1p52 - 0x1p52;
    *x = rounded - AND(rounded > *x, (VECTOR){0} + 1);
}

KERNEL NAMED(set_out)(AXIS *axis, const double *position,
                      const double *direction, VECTOR length_m, double low,
                      double cells_per_m, double size)
{
    VECTOR from, along;
    memcpy(&from, position, sizeof from);
    memcpy(&along, direction, sizeof along);
    const VECTOR at = (from - low) * cells_per_m;
    const VECTOR pace = along * cells_per_m;
    const VECTOR to = at + pace * length_m;
    /* The cells of both ends; 0 for segments that are not within. */
    const MASK is_within = (at >= 0) & (at < size) & (to >= 0) & (to < size);
    VECTOR first = AND(is_within, at), last = AND(is_within, to);
    NAMED(round_down)(&first);
    NAMED(round_down)(&last);
    /* The faces between them. */
    const MASK is_up = last > first;
    const VECTOR one = (VECTOR){0} + 1, up = AND(is_up, one);
    *axis = (AXIS){.at = at,
                   .per_pace = 1 / pace,
                   .face = first + up,
                   .step = CHOSEN(is_up, one, -one),
                   .end = last + up,
                   .first = first,
                   .last = last,
                   .is_within = is_within};
}

/* The length at which the face ahead is met. */
#define NEXT_M(axis)                  \
    CHOSEN((axis).face != (axis).end, \
           ((axis).face - (axis).at) * (axis).per_pace, infinite)

/* Segments of WIDTH lanes. */
TARGET static void NAMED(score_some)(const murk_lattice *lattice,
                                     const murk_lane_segments *segments,
                                     size_t lane)
{
    const murk_lane_rays *const from = segments->from;
    const double *const k = lattice->cells_per_m;
    const double size[3] = {lattice->size[0], lattice->size[1],
                            lattice->size[2]};
    const murk_vec3 low = lattice->box.min;
    const VECTOR infinite = (VECTOR){0} + INFINITY;
    /* The segments in units of cells. */
    VECTOR length_m, quanta;
    memcpy(&length_m, &segments->length_m[lane], sizeof length_m);
    memcpy(&quanta, &from->quanta[lane], sizeof quanta);
    const VECTOR quanta_per_m = quanta * lattice->per_m;
    AXIS x, y, z;
    NAMED(set_out)
    (&x, &from->x[lane], &from->dx[lane], length_m, low.x, k[0], size[0]);
    NAMED(set_out)
    (&y, &from->y[lane], &from->dy[lane], length_m, low.y, k[1], size[1]);
    NAMED(set_out)
    (&z, &from->z[lane], &from->dz[lane], length_m, low.z, k[2], size[2]);
    const MASK is_within = x.is_within & y.is_within & z.is_within;
    const VECTOR ahead = (x.last - x.first) * x.step +
                         (y.last - y.first) * y.step +
                         (z.last - z.first) * z.step;
    const VECTOR crossed = AND(is_within, ahead);
    const double row = size[0], layer = size[0] * size[1];
    VECTOR cell = x.first + y.first * row + z.first * layer + lattice->first;
    length_m = AND(is_within, length_m);
    /* The last entry of each list. Lanes without a segment, or with one that is
     * not within, have a list without effect. */
    double no_value[WIDTH];
    uint32_t no_cell[WIDTH];
    double *value[WIDTH];
    uint32_t *cells[WIDTH];
    VECTOR last_value = {0}, last_cell = {0};
    MASK last = {0};
    double faces = 0;
    for (size_t i = 0; i < WIDTH; ++i) {
        const murk_score_path *const path = segments->path[lane + i];
        const bool is_scored = path && is_within[i];
        value[i] = is_scored ? path->value : &no_value[i];
        cells[i] = is_scored ? path->cell : &no_cell[i];
        last[i] = is_scored ? (int64_t)path->last : 0;
        last_value[i] = is_scored ? path->value[path->last] : 0;
        last_cell[i] = is_scored ? (int32_t)path->cell[path->last] : 0;
        faces = crossed[i] > faces ? crossed[i] : faces;
    }
    /* Fly, until the photon that crosses most faces has arrived. */
    VECTOR t = {0};
    for (;;) {
        /* The nearest face. A photon that has arrived has no face ahead: which
         * axis is chosen does not matter then. */
        const VECTOR next_x = NEXT_M(x), next_y = NEXT_M(y), next_z = NEXT_M(z);
        const MASK is_x = (next_x < next_y) & (next_x < next_z);
        const MASK is_y = ~is_x & (next_y < next_z);
        const MASK is_z = ~(is_x | is_y);
        const VECTOR met = CHOSEN(is_x, next_x, CHOSEN(is_y, next_y, next_z));
        /* The length up to the face, or to the end. */
        const VECTOR until = CHOSEN(met < length_m, met, length_m);
        const MASK is_on = until > t;
        const VECTOR scored = AND(is_on, (until - t) * quanta_per_m);
        t = CHOSEN(is_on, until, t);
        /* Score in the last entry, if that is of the same cell, else in a new
         * one. */
        const MASK counts = scored > 0, is_same = cell == last_cell;
        last_value =
            CHOSEN(counts, AND(is_same, last_value) + scored, last_value);
        last_cell = CHOSEN(counts, cell, last_cell);
        last -= counts & ~is_same;
        const NAMED(whole) whole =
            __builtin_convertvector(last_cell, NAMED(whole));
        for (size_t i = 0; i < WIDTH; ++i) {
            value[i][last[i]] = last_value[i];
            cells[i][last[i]] = (uint32_t)whole[i];
        }
        if (!(faces > 0)) {
            break;
        }
        --faces;
        /* Enter the next cell. */
        const VECTOR step_x = AND(is_x, x.step), step_y = AND(is_y, y.step),
                     step_z = AND(is_z, z.step);
        x.face += step_x;
        y.face += step_y;
        z.face += step_z;
        cell += step_x + step_y * row + step_z * layer;
    }
    /* The new ends of the lists, and the segments that are not within. */
    for (size_t i = 0; i < WIDTH; ++i) {
        murk_score_path *const path = segments->path[lane + i];
        if (path && is_within[i]) {
            path->last = (size_t)last[i];
        } else if (path) {
            score_one(lattice, segments, lane + i);
        }
    }
}

TARGET static void NAMED(score)(const murk_lattice *lattice,
                                const murk_lane_segments *segments)
{
    for (size_t lane = 0; lane < segments->n; lane += WIDTH) {
        NAMED(score_some)(lattice, segments, lane);
    }
}

#undef WIDTH
#undef TARGET
#undef NAMED
#undef VECTOR
#undef MASK
#undef AXIS
#undef KERNEL
#undef AND
#undef CHOSEN
#undef NEXT_M

#endif
