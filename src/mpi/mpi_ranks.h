/* Ranks (base/ranks.h) by MPI. */
#ifndef MURK_MPI_MPI_RANKS_H
#define MURK_MPI_MPI_RANKS_H

#include "base/ranks.h"

typedef struct murk_mpi murk_mpi;

/* Starts MPI, and the thread of rank 0 that deals items out. Called once,
 * before anything else of MPI. NULL when out of memory or if MPI cannot be used
 * with threads, with a line on standard error. Fails otherwise as MPI does: the
 * processes of all ranks end. */
murk_mpi *murk_mpi_begin(int *argc, char ***argv);

const murk_ranks *murk_mpi_ranks(const murk_mpi *mpi);

/* Ends MPI; collective. NULL is fine. */
void murk_mpi_end(murk_mpi *mpi);

#endif
