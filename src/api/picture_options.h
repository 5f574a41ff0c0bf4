/* The options of pictures and of their files, as murk.h has them. */
#ifndef MURK_API_PICTURE_OPTIONS_H
#define MURK_API_PICTURE_OPTIONS_H

#include "api/handles.h"
#include "pictures/rendering.h"

/* Sets *method to the method and *request to the viewpoint that the options ask
 * for; NULL: zeros. *request borrows the texts of the options and the list of
 * sensors. Fails as murk_options_copy(), and with MURK_BAD_VALUE if a number is
 * out of range, if there is no such method, or if the list of sensors is empty
 * or of another world. */
murk_status murk_picture_options_read(murk_viewpoint_request *request,
                                      const murk_rendering_method **method,
                                      const murk_world *world,
                                      const murk_picture_options *options,
                                      murk_error *err);

/* Copies the options; NULL: zeros. Fails as murk_options_copy(), and with
 * MURK_BAD_VALUE if a number is out of range or there is no such scale. */
murk_status murk_image_options_read(murk_image_options *out,
                                    const murk_image_options *images,
                                    murk_error *err);

#endif
