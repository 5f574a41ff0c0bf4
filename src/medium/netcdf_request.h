/* The request to the program murk-netcdf, which reads NetCDF files with the
 * library netCDF. It is a program of its own, so that murk does not need that
 * library. */
#ifndef MURK_MEDIUM_NETCDF_REQUEST_H
#define MURK_MEDIUM_NETCDF_REQUEST_H

#include "base/parcel.h"
#include "base/status.h"
#include "base/subprocess.h"
#include "terrain/local_frame.h"

#include <stdbool.h>
#include <stddef.h>

/* A law by which a density follows from a variable: linear between points of
 * rising values, constant beyond them; n 0: no law. */
typedef struct murk_netcdf_law {
    size_t n;
    const double *value, *density; /* [n] borrowed */
} murk_netcdf_law;

/* Names are NULL where the user gave none. */
typedef struct murk_netcdf_asked {
    const char *liquid_water;     /* variable; NULL: found by standard name */
    const char *effective_radius; /* variable; NULL: found by standard name */
    const char *variable;       /* another variable: the extinction is the value
                                 * times per_unit; liquid_water and
                                 * effective_radius are not used */
    double effective_radius_um; /* everywhere; 0: the variable */
    double per_unit;            /* [1/m]; with a law the factor before it */
    murk_netcdf_law law;        /* of `variable` */
    double time_s;              /* after the first time of the file */
    bool is_linear;             /* values belong to nodes, else to cells */
    bool has_within;            /* only the part of the file in the next box */
    double within_m[4];         /* x and y from, x and y to */
    bool has_frame;             /* false: axes in degrees are refused */
    murk_local_frame frame;
    double altitude_m; /* of z = 0 above the sea, for axes in degrees */
} murk_netcdf_asked;

typedef struct murk_netcdf_request {
    const char *path, *where;
    murk_netcdf_asked asked;
} murk_netcdf_request;

#define MURK_NETCDF_JOB     "netcdf"
#define MURK_NETCDF_PROGRAM "murk-netcdf"

/* The pack() of the job, whose context is a murk_netcdf_request; and the other
 * side, whose texts are borrowed from the parcel. Fails with MURK_RUN_FAILED.
 */
void murk_netcdf_pack(murk_parcel *to, const void *context);
murk_status murk_netcdf_unpack(murk_netcdf_request *out, murk_parcel *from,
                               murk_error *err);

#endif
