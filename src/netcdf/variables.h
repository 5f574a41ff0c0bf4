/* Internal: variables of a NetCDF file with their units, numbers as they are
 * stored, and the axes of a field. */
#ifndef MURK_NETCDF_VARIABLES_H
#define MURK_NETCDF_VARIABLES_H

#include "base/status.h"
#include "medium/netcdf_request.h"

#include <stdbool.h>
#include <stddef.h>

enum {
    MURK_NETCDF_X,
    MURK_NETCDF_Y,
    MURK_NETCDF_Z,
    MURK_NETCDF_TIME,
    MURK_NETCDF_AXES
};

/* Dimensions of a variable: the four axes, and others of length 1 (a choice).
 */
#define MURK_NETCDF_DIMENSIONS 6

typedef struct murk_netcdf_axis {
    int dimension; /* of the file; -1: the variable has none */
    size_t n;
    double *at;        /* [n], in metres, degrees or seconds, rising */
    double *bound;     /* [2 n], CF bounds; NULL: none */
    bool is_falling;   /* the file has the values from high to low */
    bool is_degrees;   /* longitudes or latitudes */
    bool is_above_sea; /* heights that count from the sea */
    /* The part of the dimension that is read. Coordinates of the file are
     * counted as they rise; at[0] is the one of number `first`, and after that
     * of number cycle - 1 comes number 0. */
    size_t length, first, cycle;
} murk_netcdf_axis;

/* An open file, and what was asked of it. */
typedef struct murk_netcdf_reader {
    int file;
    const murk_netcdf_request *request;
    murk_error *err;
    murk_netcdf_axis axis[MURK_NETCDF_AXES]; /* murk_netcdf_release_axes() */
    size_t missing; /* values that are missing in the file */
    size_t beyond;  /* values beyond the range of a law */
    size_t below;   /* values that are slightly below 0 and count as 0 */
} murk_netcdf_reader;

/* A row of a table of units; the last row has the name NULL. */
typedef struct murk_netcdf_unit {
    const char *name;
    double factor;
} murk_netcdf_unit;

/* Fails with `name` (NULL: none) and `text` at request->where. */
murk_status murk_netcdf_bad(const murk_netcdf_reader *r, murk_status status,
                            const char *text, const char *name);

/* Finds a variable by the name that the user gave, or, if the name is NULL, by
 * its standard name. Fails with MURK_BAD_VALUE and a list of the fields. */
murk_status murk_netcdf_find_variable(const murk_netcdf_reader *r,
                                      const char *name, const char *standard,
                                      int *out);

/* The factor from the unit of a variable, which must be in the table, as
 * "g m-3" in the form of "g m^-3" and "g m**-3"; otherwise MURK_BAD_VALUE. */
murk_status murk_netcdf_unit_of(const murk_netcdf_reader *r, int variable,
                                const murk_netcdf_unit *table, double *factor);

/* Unpacks n numbers of a variable; those that are missing or not valid become
 * NAN. */
void murk_netcdf_unpack_values(const murk_netcdf_reader *r, int variable,
                               double *value, size_t n);

/* Reads the axes of a variable, which must have X, Y and Z, and T at most, in
 * full length.
 * Fails with MURK_BAD_FILE, MURK_BAD_VALUE or MURK_NO_MEMORY. */
murk_status murk_netcdf_read_axes(murk_netcdf_reader *r, int variable);

/* Frees the arrays of all axes and marks the axes as not there. */
void murk_netcdf_release_axes(murk_netcdf_reader *r);

#endif
