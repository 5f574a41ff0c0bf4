/* Extinction coefficients from a NetCDF file that follows the CF conventions:
 * fields over three axes of space, each with a coordinate variable, and one of
 * time at most, in any order.
 *
 * Source: Eaton and others, NetCDF Climate and Forecast (CF) Metadata
 * Conventions 1.8 (2020); Stephens, J. Atmos. Sci. 35 (1978) 2123. */
#ifndef MURK_NETCDF_READ_H
#define MURK_NETCDF_READ_H

#include "base/field_blocks.h"
#include "medium/netcdf_request.h"

/* Reads one block. The caller frees its arrays. Fails with MURK_BAD_FILE or
 * MURK_BAD_VALUE at request->where, or with MURK_NO_MEMORY. */
murk_status murk_netcdf_read(murk_field_head *head, murk_field_block *block,
                             const murk_netcdf_request *request,
                             murk_error *err);

#endif
