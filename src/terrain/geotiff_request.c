/* Requests to the program murk-gdal, and the facts of a file. */
#include "terrain/geotiff_request.h"

#include "base/cache.h"
#include "base/file.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static void pack(murk_parcel *to, const void *context)
{
    const murk_geotiff_request *r = context;
    murk_parcel_put_text(to, r->path);
    murk_parcel_put_text(to, r->where);
    murk_parcel_put(to, &r->asked, sizeof r->asked);
}

murk_status murk_geotiff_unpack(murk_geotiff_request *out, murk_parcel *from,
                                murk_error *err)
{
    murk_geotiff_request r = {.path = murk_parcel_take_text(from),
                              .where = murk_parcel_take_text(from)};
    const murk_geotiff_asked *asked = murk_parcel_take(from, sizeof *asked);
    if (from->is_short || !r.path || !r.where || !asked) {
        return murk_fail(err, MURK_RUN_FAILED, "", "malformed request");
    }
    r.asked = *asked;
    *out = r;
    return MURK_OK;
}

const murk_subprocess_job murk_geotiff_job = {
    .name = MURK_GDAL_JOB,
    .pack = pack,
    .program = MURK_GDAL_PROGRAM,
    .needs = "GeoTIFF files are read by the program murk-gdal: install the "
             "package murk-gdal, or build murk with libgdal-dev"};

/* The largest grid takes some 8 s on a processor of 2020, however well the file
 * is compressed; a slower one may take twice as long. */
#define LARGEST_S 16

murk_subprocess_limits murk_geotiff_limits(uint64_t file_bytes)
{
    murk_subprocess_limits limits = murk_subprocess_limits_for(file_bytes);
    limits.seconds += LARGEST_S;
    return limits;
}

bool murk_geotiff_is_same(const murk_geotiff_asked *a,
                          const murk_geotiff_asked *b)
{
    bool is_same = a->error_m == b->error_m && a->band == b->band &&
                   a->unit_m == b->unit_m && a->has_nodata == b->has_nodata &&
                   (!a->has_nodata || a->nodata == b->nodata) &&
                   a->has_within == b->has_within &&
                   a->altitude_m == b->altitude_m &&
                   a->frame.latitude_deg == b->frame.latitude_deg &&
                   a->frame.longitude_deg == b->frame.longitude_deg &&
                   a->frame.north[0] == b->frame.north[0] &&
                   a->frame.north[1] == b->frame.north[1];
    for (int i = 0; i < 4 && a->has_within; ++i) {
        is_same = is_same && a->within_m[i] == b->within_m[i];
    }
    return is_same;
}

bool murk_terrain_facts_take(murk_terrain_facts *out,
                             const unsigned char **bytes, size_t *size)
{
    if (*size < sizeof *out) {
        return false;
    }
    memcpy(out, *bytes, sizeof *out);
    *bytes += sizeof *out;
    *size -= sizeof *out;
    out->unit_from[sizeof out->unit_from - 1] = '\0';
    out->crs[sizeof out->crs - 1] = '\0';
    /* A malformed file may have taken over the program. */
    for (char *c = out->crs; *c; ++c) {
        *c = (unsigned char)*c < ' ' || (unsigned char)*c > '~' ? '?' : *c;
    }
    return fabs(out->latitude_deg) <= 90 && fabs(out->longitude_deg) <= 360 &&
           out->columns > 0 && out->rows > 0 && out->error_m >= 0 &&
           isfinite(out->low_m) && isfinite(out->high_m) &&
           isfinite(out->spacing_m[0]) && isfinite(out->spacing_m[1]);
}

/* ---- the facts of a file ---- */

murk_status murk_geotiff_facts(murk_terrain_facts *out, const char *path,
                               const char *where, murk_error *err)
{
    static murk_cache cache = MURK_CACHE_NONE;
    char place[sizeof err->where];
    struct stat is;
    snprintf(place, sizeof place, "%s: %s", where, path);
    if (stat(path, &is) != 0) {
        return murk_fail(err, MURK_BAD_FILE, where, "cannot read %s: %s", path,
                         strerror(errno));
    }
    if (!S_ISREG(is.st_mode)) {
        return murk_fail(err, MURK_BAD_FILE, where, "%s is not a regular file",
                         path);
    }
    const murk_file_identity key = murk_file_identity_of(&is);
    size_t size = 0;
    murk_terrain_facts *found =
        murk_cache_find(&cache, &key, sizeof key, &size);
    if (found) {
        *out = *found;
        free(found);
        return MURK_OK;
    }
    /* Ask the program. */
    murk_geotiff_request request = {
        .path = path, .where = place, .asked = {.band = 1}};
    const murk_subprocess_limits limits =
        murk_geotiff_limits((uint64_t)is.st_size);
    unsigned char *bytes = NULL;
    murk_status status = murk_subprocess_do(&bytes, &size, &murk_geotiff_job,
                                            &request, &limits, place, err);
    const unsigned char *from = bytes;
    if (!status && (!murk_terrain_facts_take(out, &from, &size) || size > 0)) {
        status = murk_fail(err, MURK_BAD_FILE, place,
                           "%s is malformed: its reader lost count", path);
    }
    free(bytes);
    if (!status) {
        murk_cache_put(&cache, &key, sizeof key, out, sizeof *out);
    }
    return status;
}
