/* path.ply: an explorer's path for viewers; its layout is in
 * results/explore.h. */
#ifndef MURK_RESULTS_PATH_PLY_H
#define MURK_RESULTS_PATH_PLY_H

#include "results/results.h"

murk_status murk_add_path_ply(murk_results *results,
                              const murk_scene_desc *scene,
                              const murk_explore *explore, double size_m,
                              murk_error *err);

#endif
