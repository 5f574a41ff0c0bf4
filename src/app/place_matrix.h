/* `murk place --matrix`: a coverage matrix in place of a scene. */
#ifndef MURK_APP_PLACE_MATRIX_H
#define MURK_APP_PLACE_MATRIX_H

#include "app/options.h"

murk_status murk_place_matrix(const murk_options *options, murk_error *err);

#endif
