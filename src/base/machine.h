/* The memory that the machine can give, and the memory that the process uses.
 */
#ifndef MURK_BASE_MACHINE_H
#define MURK_BASE_MACHINE_H

#include <stddef.h>

/* The unit of sizes of memory that users give: MiB. */
#define MURK_BYTES_PER_MB 1048576.0

/* The memory that is available without swapping [bytes]: the smallest of
 * MemAvailable of /proc/meminfo, the limit on the address space of this
 * process, and what its control groups leave (base/memory_group.h). INFINITY if
 * there is none of these. */
double murk_machine_memory_bytes(void);

/* The limit on the address space of this process [bytes]; INFINITY without. */
double murk_machine_address_bytes(void);

/* The largest resident memory of this process so far [bytes]; NAN if unknown.
 */
double murk_machine_peak_bytes(void);

/* Gives the pages that lie wholly within [memory, memory + bytes) back to the
 * machine. The block, from malloc(), stays allocated, and its content is lost.
 * Without effect where the operating system has no such call. */
void murk_machine_drop(void *memory, size_t bytes);

/* Asks the operating system to use huge pages for memory that has not been
 * written yet, so that it gives the pages in few steps. Without effect where
 * the system has no such call or no such pages. */
void murk_machine_use_huge_pages(void *memory, size_t bytes);

/* Asks the operating system to use huge pages for the memory, which has been
 * written, so that scattered reads need fewer translations of addresses.
 * Without effect where the system has no such call or no such pages. */
void murk_machine_join_pages(void *memory, size_t bytes);

/* Gives memory that was freed, and that the C library keeps for later blocks,
 * back to the machine. Without effect where the C library has no such call. */
void murk_machine_trim(void);

#endif
