#include "kinds.h"

const media_kind *const kinds[] = {&kind_fog_bank, &kind_rain_shafts,
                                   &kind_plume, &kind_chlorophyll, &kind_smoke};
const size_t kinds_count = sizeof kinds / sizeof *kinds;

murk_vec3 kind_first_middle(const media_kind *kind, const media_frame *frame)
{
    const double half = frame->voxel_m / 2;
    const double deep = (double)frame->size[2] * frame->voxel_m;
    return murk_vec(half, half, half - (kind->is_water ? deep : 0));
}

void kind_fill(const media_kind *kind, const media_frame *frame, float *value)
{
    const murk_vec3 first = kind_first_middle(kind, frame);
    for (size_t k = 0; k < frame->size[2]; ++k) {
        for (size_t j = 0; j < frame->size[1]; ++j) {
            for (size_t i = 0; i < frame->size[0]; ++i) {
                const murk_vec3 steps =
                    murk_vec((double)i, (double)j, (double)k);
                *value++ = (float)kind->value(
                    frame, murk_along(first, frame->voxel_m, steps));
            }
        }
    }
}
