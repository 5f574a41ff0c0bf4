/* How messages name places that are no files. */
#ifndef MURK_BASE_PLACE_H
#define MURK_BASE_PLACE_H

/* How the place of a value begins that a call of the library sets: "set
 * KEY=VALUE". */
#define MURK_SET_MARK "set "

#endif
