/* The program murk: the command line (app/program.h), in one process. */
#include "app/program.h"
#include "app/terminate_bridge.h"

/* Run before the constructors of libraries, one of which starts threads. */
__attribute__((section(".preinit_array"),
               used)) static void (*const early)(void) = murk_terminate_install;

int main(int argc, char **argv)
{
    return murk_program(argc, argv);
}
