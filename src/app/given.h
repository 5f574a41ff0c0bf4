/* A command line as arguments of the library: the scene with its keys, and how
 * results are saved. */
#ifndef MURK_APP_GIVEN_H
#define MURK_APP_GIVEN_H

#include "app/options.h"

/* Sets the keys that options give. */
murk_status murk_given_keys(murk_scene *scene, const murk_options *options,
                            murk_error *err);

/* Reads the scene and sets the keys that options give. With --light, the seed
 * and the number of photons are those of the file unless the command line gives
 * them, because light of another seed or number of photons is refused. */
murk_status murk_given_scene(murk_scene **out, const murk_options *options,
                             murk_error *err);

/* The light of a world: from the file of --light, or traced. */
murk_status murk_given_light(murk_light **out, murk_world *world,
                             const murk_options *options, murk_error *err);

/* How the results of the command are saved. Call murk_given_save_end() also
 * after a failure. */
typedef struct murk_given_save {
    murk_save_options options;
    char *exports, *asked; /* of the options, owned */
} murk_given_save;

murk_status murk_given_save_begin(murk_given_save *out,
                                  const murk_options *options, murk_error *err);
void murk_given_save_end(murk_given_save *save);

#endif
