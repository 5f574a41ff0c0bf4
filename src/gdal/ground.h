/* The answer to a request: the mesh of the ground in the frame of a scene. */
#ifndef MURK_GDAL_GROUND_H
#define MURK_GDAL_GROUND_H

#include "base/status.h"
#include "base/subprocess.h"
#include "terrain/geotiff_request.h"

/* Reads the file of a request and sends the facts, and, if the request has a
 * frame, the mesh (geometry/import.h). Needs murk_gdal_begin(). Fails with
 * MURK_BAD_FILE or MURK_BAD_VALUE at request->where, with MURK_NO_MEMORY, or as
 * murk_subprocess_send(). */
murk_status murk_gdal_answer(murk_subprocess *to,
                             const murk_geotiff_request *request,
                             murk_error *err);

#endif
