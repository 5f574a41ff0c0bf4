/* The program murk-mpi: the program murk in several processes, which mpirun
 * starts and which divide the work (base/ranks.h). */
#include "app/program.h"
#include "app/terminate_bridge.h"
#include "base/host.h"
#include "mpi/mpi_ranks.h"

#include <stddef.h>

/* Run before the constructors of libraries, one of which starts threads. */
__attribute__((section(".preinit_array"),
               used)) static void (*const early)(void) = murk_terminate_install;

int main(int argc, char **argv)
{
    murk_mpi *mpi = murk_mpi_begin(&argc, &argv);
    murk_host_now()->ranks = murk_mpi_ranks(mpi);
    const int code = murk_program(argc, argv);
    murk_host_now()->ranks = NULL;
    murk_mpi_end(mpi);
    return code;
}
