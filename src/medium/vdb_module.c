/* Loads the module with the bridge to OpenVDB, and keeps the table of its
 * functions for the jobs that call them. */
#include "base/program.h"
#include "medium/vdb_bridge.h"

#include <stdatomic.h>

static murk_module module = {.file = "murk-openvdb.so",
                             .symbol = "murk_vdb_functions"};

murk_status murk_vdb_prepare(const char *where, murk_error *err)
{
    return murk_module_load(&module, where, err) ? MURK_OK : MURK_RUN_FAILED;
}

const murk_vdb *murk_vdb_now(void)
{
    return atomic_load(&module.loaded);
}
