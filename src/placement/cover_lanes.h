/* The number of covers that one pass over the rows evaluates. */
#ifndef MURK_PLACEMENT_COVER_LANES_H
#define MURK_PLACEMENT_COVER_LANES_H

/* 16 clarities fill a vector register of AVX2. */
#define MURK_COVER_LANES 16

#endif
