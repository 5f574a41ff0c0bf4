/* The program murk, without main(), so that murk-mpi is the same program. */
#ifndef MURK_APP_PROGRAM_H
#define MURK_APP_PROGRAM_H

/* Runs a command line, argv[argc] as of main(); returns the exit code. With
 * ranks (base/ranks.h) all ranks call it with the same words. */
int murk_program(int argc, char **argv);

#endif
