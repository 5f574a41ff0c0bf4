/* Scores segments of several photons in a grid (transport/score_lanes.h): the
 * kernel of transport/score_lanes_kernel.h for each vector instruction set. */
#include "transport/score_lanes.h"

#include <math.h>
#include <string.h>

/* Scores the segment of a lane without vectors. */
static void score_one(const murk_lattice *lattice,
                      const murk_lane_segments *segments, size_t i)
{
    const murk_lane_rays *const from = segments->from;
    murk_score_lattice(segments->path[i], lattice,
                       murk_vec(from->x[i], from->y[i], from->z[i]),
                       murk_vec(from->dx[i], from->dy[i], from->dz[i]),
                       segments->length_m[i], from->quanta[i]);
}

#define WIDTH       2 /* numbers in a register of 16 bytes */
#define TARGET      MURK_TARGET_BASELINE
#define NAMED(name) name##_baseline
#include "transport/score_lanes_kernel.h"

#if defined(__x86_64__)
#define WIDTH       4 /* 32 bytes */
#define TARGET      MURK_TARGET_AVX2
#define NAMED(name) name##_avx2
#include "transport/score_lanes_kernel.h"

#define WIDTH       8 /* 64 bytes */
#define TARGET      MURK_TARGET_AVX512
#define NAMED(name) name##_avx512
#include "transport/score_lanes_kernel.h"
#endif

murk_lane_scoring murk_lane_scoring_for(murk_lane_set set)
{
    static const murk_lane_scoring scoring[MURK_LANE_SETS] = {
        [MURK_LANES_BASELINE] = score_baseline,
#if defined(__x86_64__)
        [MURK_LANES_AVX2] = score_avx2,
        [MURK_LANES_AVX512] = score_avx512,
#endif
    };
    return scoring[set];
}
