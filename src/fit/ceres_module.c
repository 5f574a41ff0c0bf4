/* Loads the module with the bridge to Ceres and Eigen when the first fit calls
 * one of its functions. */
#include "base/program.h"
#include "fit/ceres_bridge.h"

const murk_ceres *murk_ceres_load(murk_error *err)
{
    static murk_module module = {.file = "murk-ceres.so",
                                 .symbol = "murk_ceres_functions"};
    return murk_module_load(&module, "fit", err);
}
