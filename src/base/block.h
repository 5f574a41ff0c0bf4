/* A block of memory that may be larger than the memory of the machine, and that
 * ranks on one machine can share.
 *
 * A block comes from malloc(), or lies in a file that is mapped into memory: in
 * a scratch file (base/scratch_file.h) if it is larger than the caller allows,
 * so that the operating system moves pages that are not in use to the disk; or,
 * if ranks share it, in a nameless file in memory. Both kinds of file vanish
 * with the last process that has mapped them. A block that is in a scratch file
 * stays there. */
#ifndef MURK_BASE_BLOCK_H
#define MURK_BASE_BLOCK_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum murk_block_place {
    MURK_BLOCK_ON_HEAP, /* from malloc() */
    MURK_BLOCK_IN_MEMORY_FILE,
    MURK_BLOCK_IN_SCRATCH_FILE
} murk_block_place;

/* All members 0: an empty block. */
typedef struct murk_block {
    void *bytes; /* aligned as by malloc(); NULL if the block is empty */
    size_t size;
    bool is_for_ranks; /* a block that is not in a scratch file is in a file in
                        * memory; set while the block is empty */
    murk_block_place place;
    int fd; /* of the file, if there is one */
} murk_block;

/* The memory that large blocks may take [bytes] before they are in a scratch
 * file: MURK_MEMORY_MB of the environment in MiB, if that is a number that is
 * not negative, or else seven tenths of the memory that the machine has free,
 * which leaves some for what grows with the blocks. */
double murk_block_memory_bytes(void);

/* A block with memory from malloc(), which the block then owns. */
murk_block murk_block_of(void *bytes, size_t size);

/* Changes the size. The content remains, up to the smaller size; what is added
 * is undefined. The bytes may move. A block larger than memory_max bytes is put
 * in a scratch file. Fails, with the block unchanged, with MURK_NO_MEMORY, or
 * with MURK_RUN_FAILED if the disk is full. */
murk_status murk_block_resize(murk_block *block, size_t size, double memory_max,
                              murk_error *err);

void murk_block_release(murk_block *block); /* the block is then empty */

/* What another process of the same user on this machine needs in order to have
 * the memory of a block that is in a file: plain bytes, to be sent. */
typedef struct murk_block_address {
    uint64_t process, fd, size, place;
    uint64_t device, inode; /* of the file, as a check */
} murk_block_address;

murk_block_address murk_block_address_of(const murk_block *block);

/* Makes a block that has the memory of that with the address, which must not be
 * released or change its size meanwhile. An empty block if that is empty. Fails
 * with MURK_NO_MEMORY, also if the block is of a process that this one must not
 * look into. */
murk_status murk_block_open(murk_block *out, const murk_block_address *address,
                            murk_error *err);

/* Gives the ranks of a machine the block of the first of them, whatever their
 * own blocks were: the same memory, whose size must not change afterwards.
 * Without ranks, and for the only rank of a machine, the block stays as it is.
 * Collective (base/ranks.h). Fails with MURK_NO_MEMORY. */
murk_status murk_ranks_share_block(murk_block *block, murk_status status,
                                   murk_error *err);

#endif
