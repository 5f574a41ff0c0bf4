/* The walk of a group of rays through a grid without interpolation
 * (medium/grid_lanes.h), for one set of vector instructions; included by
 * grid_lanes.c once for each set. The rays of a group lie in one vector.
 *
 * The includer defines:
 *   WALK               the name of the function
 *   TARGET             the attribute of the set
 *   WIDTH              the number of rays in a group
 *   NUMBERS, WHOLES    vectors of WIDTH doubles and of WIDTH integers of 64
 *                      bits; the integers are also masks, 0 or -1
 *   SELECT(m, a, b)    a where the mask is -1, b where it is 0
 *   SMALLER(a, b)      a < b ? a : b
 *   BITS(m)            bit k tells whether element k of the mask is -1
 *
 * The operations are those of murk_march_integrate() for each ray. */
#ifdef WALK

TARGET static void WALK(murk_grid_lanes *g, const murk_lane_grid *grid,
                        size_t lane)
{
    const murk_leaf_table *table = grid->leaves;
    const NUMBERS zero = {0};
    const WHOLES none = {0};
    const NUMBERS infinite = zero + INFINITY;
    /* The rays. */
    NUMBERS x, y, z, inverse_x, inverse_y, inverse_z, end, limit, scale, offset;
    LOAD(x);
    LOAD(y);
    LOAD(z);
    LOAD(inverse_x);
    LOAD(inverse_y);
    LOAD(inverse_z);
    LOAD(end);
    LOAD(limit);
    LOAD(scale);
    LOAD(offset);
    /* The ray parameter from face to face, and the difference of the number of
     * a voxel, by axis. */
    const NUMBERS stride_x = MAGNITUDE(inverse_x),
                  stride_y = MAGNITUDE(inverse_y),
                  stride_z = MAGNITUDE(inverse_z);
    const WHOLES down_x = inverse_x < zero, down_y = inverse_y < zero,
                 down_z = inverse_z < zero;
    const WHOLES step_x = (down_x & -128) + 64, step_y = (down_y & -16) + 8,
                 step_z = (down_z & -2) + 1;

    /* The state: the ray is left from `from` on; the leaf, the voxel, and the
     * ray parameters of the faces ahead. */
    NUMBERS from, sum, starts, leaf_x, leaf_y, leaf_z;
    NUMBERS face_x = zero, face_y = zero, face_z = zero;
    WHOLES entry, number, left_x, left_y, left_z;
    LOAD(from);
    LOAD(sum);
    LOAD(starts);
    LOAD(leaf_x);
    LOAD(leaf_y);
    LOAD(leaf_z);
    LOAD_WHOLE(entry);
    LOAD_WHOLE(number);
    LOAD_WHOLE(left_x);
    LOAD_WHOLE(left_y);
    LOAD_WHOLE(left_z);
    const float *leaf[WIDTH];
    const WHOLES no_leaf = none + (int64_t)(uintptr_t)murk_no_leaf;
    WHOLES goes = starts != zero, enters = goes, stops = none, alone = none;
    WHOLES by_x = none, by_y = none, by_z = none; /* leaves through a face */
    NUMBERS value = zero, part_from = zero, part_to = zero; /* of the stop */
    for (;;) {
        if (BITS(enters) != 0) {
            /* The next leaf, and the faces ahead in it:
             * murk_grid_ray_enter_block(). */
#define ENTER(axis, n)                                                      \
    entry += by_##axis & SELECT_WHOLE(down_##axis, none - table->stride[n], \
                                      none + table->stride[n]);             \
    number -= by_##axis & (step_##axis * MURK_LEAF_EDGE);                   \
    left_##axis += by_##axis & MURK_LEAF_EDGE;                              \
    leaf_##axis +=                                                          \
        MASKED(by_##axis, SELECT(down_##axis, zero - MURK_LEAF_EDGE,        \
                                 zero + MURK_LEAF_EDGE));                   \
    const NUMBERS left_of_##axis = NUMBER_OF(left_##axis);                  \
    const NUMBERS cell_##axis =                                             \
        leaf_##axis + SELECT(down_##axis, left_of_##axis - 1,               \
                             MURK_LEAF_EDGE - left_of_##axis);              \
    const NUMBERS face_of_##axis =                                          \
        cell_##axis + SELECT(inverse_##axis > zero, zero + 1, zero);        \
    const NUMBERS reach_##axis =                                            \
        SELECT(inverse_##axis == zero, infinite,                            \
               (face_of_##axis - axis) * inverse_##axis);                   \
    const NUMBERS ahead_##axis = LARGER(reach_##axis, from);                \
    face_##axis = SELECT(enters, ahead_##axis, face_##axis)
            ENTER(x, 0);
            ENTER(y, 1);
            ENTER(z, 2);
            int64_t entries[WIDTH];
            memcpy(entries, &entry, sizeof entries);
            for (size_t k = 0; k < WIDTH; ++k) {
                leaf[k] = table->leaf[entries[k]];
            }
            /* A ray without a leaf is followed alone. */
            WHOLES address;
            memcpy(&address, leaf, sizeof address);
            const WHOLES lacks = enters & (address == no_leaf);
            for (unsigned bits = BITS(lacks); bits != 0; bits &= bits - 1) {
                const size_t k = (size_t)__builtin_ctz(bits);
                const double voxel[3] = {cell_x[k], cell_y[k], cell_z[k]};
                g->from[lane + k] = from[k];
                g->sum[lane + k] = sum[k];
                walk_alone(g, grid->tree, lane + k, voxel);
                alone[k] = -1;
            }
            goes &= ~alone;
        }
        if (BITS(goes) == 0) {
            break;
        }
        /* The densities of the voxels; any for rays that do not walk. */
        int64_t numbers[WIDTH];
        double densities[WIDTH];
        NUMBERS density;
        memcpy(numbers, &number, sizeof numbers);
        for (size_t k = 0; k < WIDTH; ++k) {
            densities[k] = (double)leaf[k][numbers[k] & (MURK_LEAF_VOXELS - 1)];
        }
        memcpy(&density, densities, sizeof density);
        /* Up to the nearest face: add_segment(). */
        const NUMBERS nearest = SMALLER(SMALLER(face_x, face_y), face_z);
        const NUMBERS to = SMALLER(nearest, end);
        const NUMBERS extinction = scale * density + offset;
        const NUMBERS more = sum + extinction * (to - from);
        const WHOLES stop = goes & (more >= limit) & (extinction > zero);
        stops |= stop;
        value = SELECT(stop, density, value);
        part_from = SELECT(stop, from, part_from);
        part_to = SELECT(stop, to, part_to);
        goes &= ~stop;
        sum = SELECT(goes, more, sum);
        /* On to the next voxel, along every axis whose face was reached. Rays
         * that have come to their end are moved, too, without effect. */
        goes &= nearest < end;
        from = to;
        by_x = face_x <= nearest;
        by_y = face_y <= nearest;
        by_z = face_z <= nearest;
        face_x += MASKED(by_x, stride_x);
        face_y += MASKED(by_y, stride_y);
        face_z += MASKED(by_z, stride_z);
        number += (by_x & step_x) + (by_y & step_y) + (by_z & step_z);
        left_x += by_x;
        left_y += by_y;
        left_z += by_z;
        by_x = goes & (left_x == none);
        by_y = goes & (left_y == none);
        by_z = goes & (left_z == none);
        enters = by_x | by_y | by_z;
    }
    /* The places of the stops. */
    const NUMBERS reached =
        part_from + (limit - sum) / (scale * value + offset);
    const NUMBERS place = SMALLER(part_to, reached);
    sum = SELECT(stops, limit, sum);
    const NUMBERS truths = MASKED(stops, zero + 1);
    if (BITS(alone) == 0) {
        STORE(to, place);
        STORE(sum, sum);
        STORE(value, value);
        STORE(stops, truths);
        return;
    }
    for (size_t k = 0; k < WIDTH; ++k) {
        if (alone[k] == 0) {
            g->to[lane + k] = place[k];
            g->sum[lane + k] = sum[k];
            g->value[lane + k] = value[k];
            g->stops[lane + k] = truths[k];
        }
    }
}

#undef ENTER
#undef WALK
#undef TARGET
#undef WIDTH
#undef NUMBERS
#undef WHOLES
#undef SELECT
#undef SMALLER
#undef BITS

#endif
