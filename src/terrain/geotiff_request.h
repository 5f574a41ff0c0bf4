/* The request to the program murk-gdal, which reads GeoTIFF files of elevations
 * with the library GDAL, and the facts that it answers. It is a program of its
 * own, so that murk does not need that library.
 *
 * The answer begins with murk_terrain_facts. If a mesh is asked for, the parts
 * of geometry/import.h follow. */
#ifndef MURK_TERRAIN_GEOTIFF_REQUEST_H
#define MURK_TERRAIN_GEOTIFF_REQUEST_H

#include "base/parcel.h"
#include "base/status.h"
#include "base/subprocess.h"
#include "terrain/local_frame.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct murk_geotiff_asked {
    double error_m;  /* largest error of height of the mesh */
    uint64_t band;   /* from 1; 0: the first, if it is not a colour */
    double unit_m;   /* of the heights; 0: as the file says, else 1 m */
    bool has_nodata; /* the value that stands for no height is the next
                      * one; false: as the file says */
    double nodata;
    bool has_within;    /* only the part of the file in the next box */
    double within_m[4]; /* x and y from, x and y to, in the frame */
    bool has_frame;     /* false: only the facts are asked for */
    murk_local_frame frame;
    double altitude_m; /* of z = 0 */
} murk_geotiff_asked;

typedef struct murk_geotiff_request {
    const char *path, *where;
    murk_geotiff_asked asked;
} murk_geotiff_request;

typedef struct murk_terrain_facts {
    double latitude_deg, longitude_deg; /* of the middle of the file */
    uint64_t columns, rows; /* of heights: of the file, or, with a mesh, of the
                             * part that was read; 0: no terrain */
    uint64_t known;         /* heights that are there */
    uint64_t bare;        /* of these, outside of the mesh, because a corner is
                           * missing in each triangle */
    double error_m;       /* largest error of the mesh */
    double low_m, high_m; /* heights above that of z = 0 */
    double spacing_m[2];  /* between columns, and between rows, in the middle */
    double unit_m;
    uint64_t is_depth;  /* 1: the file has depths, of which heights are the
                         * negative; 0: heights */
    char unit_from[16]; /* where the unit comes from: "key", "band", "CRS", or
                         * "none" */
    char crs[128];      /* name of the coordinate reference system */
} murk_terrain_facts;

#define MURK_GDAL_JOB     "geotiff"
#define MURK_GDAL_PROGRAM "murk-gdal"

/* The job whose context is a murk_geotiff_request. */
extern const murk_subprocess_job murk_geotiff_job;

/* The limits of the job for a file of that size. */
murk_subprocess_limits murk_geotiff_limits(uint64_t file_bytes);

/* The other side of the job's pack(); texts are borrowed from the parcel. Fails
 * with MURK_RUN_FAILED. */
murk_status murk_geotiff_unpack(murk_geotiff_request *out, murk_parcel *from,
                                murk_error *err);

/* The facts of a file, without its heights: latitude, longitude, size, spacing
 * and name of the system. They are remembered for the file as it is, because a
 * scene may be read a thousand times. Fails with MURK_BAD_FILE at `where`, and
 * as murk_subprocess_do() does. */
murk_status murk_geotiff_facts(murk_terrain_facts *out, const char *path,
                               const char *where, murk_error *err);

/* Takes the facts from the beginning of an answer, checks them, and advances
 * *bytes and *size; false if they are not sound. */
bool murk_terrain_facts_take(murk_terrain_facts *out,
                             const unsigned char **bytes, size_t *size);

/* True if two requests ask for the same. */
bool murk_geotiff_is_same(const murk_geotiff_asked *a,
                          const murk_geotiff_asked *b);

#endif
