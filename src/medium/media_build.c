/* Creates and describes murk_media: checks media and regions, places the
 * regions, finds refractive boundaries; and sums coefficients at a point. Free
 * flight is in free_flight.c, the search for boundaries on a ray in
 * interfaces.c. */
#include "medium/grid_internal.h"
#include "medium/media.h"

#include "base/log.h"
#include "base/position.h"
#include "medium/albedo.h"
#include "medium/media_parts.h"
#include "medium/tree.h"
#include "medium/waves.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Multiplied by any float density the product stays finite in double
 * precision, so that no optical depth is NaN. */
#define EXTINCTION_MAX 1e30

/* Allowed relative deviation of a placement from a similarity: some 1e6
 * times the rounding of double precision. */
#define SIMILAR 1e-9

static const char *place_of(const char *where, const char *otherwise)
{
    return where ? where : otherwise;
}

/* Checks a profile. The range of extinction is that of the media. */
static murk_status check_profile(const murk_profile *profile, const char *where,
                                 murk_error *err)
{
    if (!(profile->n >= 2)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a profile of %zu heights, must be 2 or more",
                         profile->n);
    }
    for (size_t i = 0; i < profile->n; ++i) {
        /* Heights rise; two equal ones in succession are a jump. */
        const double z = profile->z_m[i];
        const bool is_jump = i > 0 && z == profile->z_m[i - 1];
        const bool rises = i == 0 || z > profile->z_m[i - 1] ||
                           (is_jump && (i < 2 || z > profile->z_m[i - 2]));
        if (!(isfinite(z) && rises)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "profile height %zu is %g m, must be finite and "
                             "rising, each given twice at most",
                             i, z);
        }
        for (int band = 0; band < MURK_BANDS_MAX; ++band) {
            const double value = profile->extinction_per_m[i].band[band];
            if (!(value >= 0 && value <= EXTINCTION_MAX)) {
                return murk_fail(err, MURK_BAD_VALUE, where,
                                 "profile extinction %zu is %g (band %d), "
                                 "must be 0..%g [1/m]",
                                 i, value, band, EXTINCTION_MAX);
            }
        }
    }
    /* A jump alone has no thickness. */
    if (!(profile->z_m[0] < profile->z_m[profile->n - 1])) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a profile of one height, %g m, must span a layer",
                         profile->z_m[0]);
    }
    return MURK_OK;
}

/* The negated comparisons also refuse NaN. */
static murk_status check_medium(const murk_medium *medium, murk_error *err)
{
    const char *where = place_of(medium->where, "medium");
    /* Optical properties of each band. */
    for (int band = 0; band < MURK_BANDS_MAX; ++band) {
        const double extinction = medium->extinction_per_m.band[band];
        const double albedo = medium->albedo.band[band];
        if (!(extinction >= 0 && extinction <= EXTINCTION_MAX)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "extinction_per_m is %g (band %d), must be "
                             "0..%g [1/m]",
                             extinction, band, EXTINCTION_MAX);
        }
        if (!(albedo >= 0 && albedo <= 1)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "albedo is %g (band %d), must be 0..1", albedo,
                             band);
        }
        const murk_status status =
            murk_phase_check(&medium->phase[band], band, where, err);
        if (status) {
            return status;
        }
    }
    /* Only one source of density. */
    if (medium->profile && medium->grid) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "has a grid and a profile, must be one of them");
    }
    return medium->profile ? check_profile(medium->profile, where, err)
                           : MURK_OK;
}

static bool is_solid(const murk_box *box)
{
    return murk_is_finite(box->min) && murk_is_finite(box->max) &&
           box->min.x < box->max.x && box->min.y < box->max.y &&
           box->min.z < box->max.z;
}

static murk_status check_region(const murk_region *region,
                                const murk_medium *media, size_t n_media,
                                murk_error *err)
{
    const char *where = place_of(region->where, "region");
    if (region->medium >= n_media) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "medium number %zu, there are %zu", region->medium,
                         n_media);
    }
    /* Shape and grid must fit together. */
    const bool has_grid = media[region->medium].grid != NULL;
    if (has_grid && region->shape == MURK_REGION_EVERYWHERE) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a medium with a grid is nowhere beyond its grid, "
                         "must have a shape or lie where the grid lies");
    }
    if (!has_grid && region->shape == MURK_REGION_GRID) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "this medium has no grid that says where it lies: "
                         "needs a shape");
    }
    /* Index of refraction. */
    if (!(region->ior == 0 ||
          (region->ior >= 1 && region->ior <= MURK_IOR_MAX))) {
        return murk_fail(err, MURK_BAD_VALUE, where, "ior is %g, must be 1..%d",
                         region->ior, MURK_IOR_MAX);
    }
    if (region->ior > 0 && region->shape == MURK_REGION_GRID) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "ior is %g, must be left out: a grid has no boundary "
                         "that bends light",
                         region->ior);
    }
    /* Waves need a half space with an index. */
    if (!(region->mean_square_slope >= 0 &&
          region->mean_square_slope <= MURK_MEAN_SQUARE_SLOPE_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "mean_square_slope is %g, must be 0..%d",
                         region->mean_square_slope, MURK_MEAN_SQUARE_SLOPE_MAX);
    }
    if (region->mean_square_slope > 0 &&
        !(region->shape == MURK_REGION_BELOW && region->ior > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "mean_square_slope is %g, must be left out: only a "
                         "half space with an index has waves",
                         region->mean_square_slope);
    }
    /* Dimensions of the shape. */
    if (region->shape == MURK_REGION_BELOW && !isfinite(region->below_z_m)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "below_z_m is %g m, must be finite",
                         region->below_z_m);
    }
    if (region->shape == MURK_REGION_BOX && !is_solid(&region->box)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "box from (%g, %g, %g) to (%g, %g, %g) m, must be "
                         "finite with min below max",
                         region->box.min.x, region->box.min.y,
                         region->box.min.z, region->box.max.x,
                         region->box.max.y, region->box.max.z);
    }
    if (region->shape == MURK_REGION_SPHERE &&
        !(murk_is_finite(region->center) && region->radius_m > 0 &&
          isfinite(region->radius_m))) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "sphere at (%g, %g, %g) m of radius %g m, must be "
                         "finite and above 0",
                         region->center.x, region->center.y, region->center.z,
                         region->radius_m);
    }
    return MURK_OK;
}

static void warn_outside(const murk_place *place, const murk_box *domain,
                         const char *where)
{
    const murk_box *b = &place->bounds;
    if (b->min.x > b->max.x) {
        return; /* a grid without active voxels: a warning was given when the
                 * grid was read */
    }
    if (b->min.x >= domain->max.x || b->max.x <= domain->min.x ||
        b->min.y >= domain->max.y || b->max.y <= domain->min.y ||
        b->min.z >= domain->max.z || b->max.z <= domain->min.z) {
        murk_warn(where,
                  "the region fills %s to %s m and lies outside of the domain: "
                  "no light meets it",
                  murk_position_show(b->min).text,
                  murk_position_show(b->max).text);
    }
}

/* True if the grid of the medium has no active voxels, or the profile of the
 * medium is 0 at all heights in the band. */
static bool has_no_density(const murk_medium *medium, int band)
{
    if (medium->grid && !murk_grid_rectilinear(medium->grid)) {
        return murk_grid_tree(medium->grid)->n_cells == 0;
    }
    bool is_empty = medium->profile != NULL;
    for (size_t i = 0; is_empty && i < medium->profile->n; ++i) {
        is_empty = !(medium->profile->extinction_per_m[i].band[band] > 0);
    }
    return is_empty;
}

/* Finds the tables for walks through the grid of a place. */
static murk_status find_tables(murk_media *media, murk_place *place,
                               const char *where, murk_error *err)
{
    murk_grid_tables *tables = &media->tables[place->medium];
    const murk_grid *grid = media->media[place->medium].grid;
    murk_status status = MURK_OK;
    if (place->filling == MURK_FILLED_BY_NEAREST) {
        place->leaves = &tables->leaves;
        if (!tables->are_made) {
            tables->leaves =
                murk_leaf_table_made(place->tree, murk_grid_nanovdb(grid));
        }
    } else if (place->filling == MURK_FILLED_BY_LINEAR) {
        place->blocks = &tables->blocks;
        if (!tables->are_made) {
            status = murk_linear_blocks_make(&tables->blocks, place->tree,
                                             where, err);
        }
    }
    tables->are_made = true;
    return status;
}

static murk_status place_all(murk_media *media, const murk_region *regions,
                             size_t n_regions, const murk_box *domain,
                             murk_error *err)
{
    for (size_t i = 0; i < n_regions; ++i) {
        const murk_medium *medium = &media->media[regions[i].medium];
        const char *where = place_of(regions[i].where, "region");
        murk_place *place = &media->places[i];
        if (!murk_place_make(place, &regions[i], medium)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "placement cannot be inverted: scale must be "
                             "above 0 and all numbers finite");
        }
        ++media->n_places;
        const murk_status status = find_tables(media, place, where, err);
        if (status) {
            return status;
        }
        /* A box around the domain, and a region outside of it. */
        place->is_around = place->shape == MURK_REGION_BOX &&
                           !place->is_moved &&
                           murk_box_contains(&place->box, domain->min) &&
                           murk_box_contains(&place->box, domain->max);
        warn_outside(place, domain, where);
        for (int band = 0; band < MURK_BANDS_MAX; ++band) {
            media->in_band[band] |= !has_no_density(medium, band) &&
                                    medium->extinction_per_m.band[band] > 0;
        }
    }
    return MURK_OK;
}

/* True for a similarity. A sheared sphere would be an ellipsoid, for which
 * interfaces.c has no intersection test. */
static bool is_similarity(const murk_affine *a)
{
    const double(*m)[3] = a->matrix;
    double square[3], off = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        square[i] = m[0][i] * m[0][i] + m[1][i] * m[1][i] + m[2][i] * m[2][i];
        off = fmax(off, fabs(m[0][i] * m[0][j] + m[1][i] * m[1][j] +
                             m[2][i] * m[2][j]));
    }
    off = fmax(off,
               fmax(fabs(square[1] - square[0]), fabs(square[2] - square[0])));
    return off <= SIMILAR * square[0];
}

static murk_status boundary_all(murk_media *media, const murk_region *regions,
                                size_t n_regions, const murk_box *domain,
                                murk_error *err)
{
    media->near_m = murk_region_boundary_near(domain);
    for (size_t i = 0; i < n_regions; ++i) {
        if (!(regions[i].ior > 0)) {
            continue;
        }
        if (!murk_region_boundary_make(&media->boundaries[media->n_boundaries],
                                       i, &regions[i], domain) ||
            !is_similarity(&media->boundaries[media->n_boundaries].to_local)) {
            return murk_fail(err, MURK_BAD_VALUE,
                             place_of(regions[i].where, "region"),
                             "a region with an index must keep its shape "
                             "when it is moved: no shear, one scale");
        }
        ++media->n_boundaries;
    }
    return murk_region_boundaries_check(media->boundaries, media->n_boundaries,
                                        regions, domain, err);
}

/* True if one homogeneous medium fills the domain. free_flight.c has a short
 * cut for such media. A photon does not leave the domain, so a box around the
 * domain is as good as a region that is everywhere. */
static bool is_even(const murk_media *media)
{
    const murk_place *only = &media->places[0];
    return media->n_places == 1 &&
           (only->shape == MURK_REGION_EVERYWHERE || only->is_around) &&
           only->filling == MURK_FILLED_EVENLY &&
           !media->media[only->medium].albedo_grid;
}

murk_status murk_media_create(murk_media **out, const murk_medium *media,
                              size_t n_media, const murk_region *regions,
                              size_t n_regions, const murk_box *domain,
                              murk_error *err)
{
    murk_media *made = NULL;
    murk_status status = MURK_OK;
    if (n_media > MURK_MEDIA_MAX || n_regions > MURK_REGIONS_MAX) {
        status =
            murk_fail(err, MURK_BAD_VALUE, "regions",
                      "%zu media in %zu regions, at most %d and %d", n_media,
                      n_regions, MURK_MEDIA_MAX, MURK_REGIONS_MAX);
        goto done;
    }
    /* Check all media and regions. */
    for (size_t i = 0; i < n_media && !status; ++i) {
        status = check_medium(&media[i], err);
    }
    for (size_t i = 0; i < n_regions && !status; ++i) {
        status = check_region(&regions[i], media, n_media, err);
    }
    if (status) {
        goto done;
    }
    /* Reserve memory. */
    made = calloc(1, sizeof *made);
    if (made) {
        made->media = calloc(n_media + 1, sizeof *made->media);
        made->tables = calloc(n_media + 1, sizeof *made->tables);
        made->places = calloc(n_regions + 1, sizeof *made->places);
        made->boundaries = calloc(n_regions + 1, sizeof *made->boundaries);
    }
    if (!made || !made->media || !made->tables || !made->places ||
        !made->boundaries) {
        status = murk_no_memory(err, "regions", "for %zu regions", n_regions);
        goto done;
    }
    /* Place the regions and find their refractive boundaries. */
    made->n_media = n_media;
    if (n_media > 0) {
        memcpy(made->media, media, n_media * sizeof *media);
    }
    status = place_all(made, regions, n_regions, domain, err);
    made->is_even = is_even(made);
    if (!status) {
        status = boundary_all(made, regions, n_regions, domain, err);
    }
    if (status) {
        goto done;
    }
    *out = made;
    made = NULL;
done:
    murk_media_destroy(made);
    return status;
}

static void release_places(murk_media *media)
{
    for (size_t i = 0; media->places && i < media->n_places; ++i) {
        murk_bricks_destroy(media->places[i].bricks);
    }
    for (size_t i = 0; media->tables && i < media->n_media; ++i) {
        murk_leaf_table_release(&media->tables[i].leaves);
        murk_linear_blocks_release(&media->tables[i].blocks);
    }
    free(media->tables);
    free(media->places);
    free(media->boundaries);
}

void murk_media_destroy(murk_media *media)
{
    if (media) {
        if (!media->borrows_places) {
            release_places(media);
        }
        free(media->media);
        free(media);
    }
}

size_t murk_media_count(const murk_media *media)
{
    return media->n_media;
}

const murk_phase *murk_media_phase(const murk_media *media, size_t medium,
                                   int band)
{
    assert(medium < media->n_media);
    return &media->media[medium].phase[band];
}

bool murk_media_any(const murk_media *media)
{
    for (int band = 0; band < MURK_BANDS_MAX; ++band) {
        if (media->in_band[band]) {
            return true;
        }
    }
    return false;
}

/* All media, for sum_at(). */
#define ALL_MEDIA SIZE_MAX

/* Sum over the regions at p of the extinction of one medium or of all, or of
 * the scattering coefficient. A region that replaces others discards the sum of
 * those before it. */
static double sum_at(const murk_media *media, size_t only, int band,
                     murk_inside inside, murk_vec3 p, bool scattered)
{
    double sum = 0;
    for (size_t i = 0; i < media->n_places; ++i) {
        const murk_place *place = &media->places[i];
        const murk_medium *medium = &media->media[place->medium];
        double density;
        if (!murk_place_may_hold(place, i, inside) ||
            !murk_place_density(place, band, p, &density)) {
            continue;
        }
        sum = place->replaces ? 0 : sum;
        if (only == ALL_MEDIA || only == place->medium) {
            sum += density * medium->extinction_per_m.band[band] *
                   (scattered ? murk_albedo_at(medium, place, band, p) : 1);
        }
    }
    return sum;
}

double murk_media_extinction(const murk_media *media, int band,
                             murk_inside inside, murk_vec3 p)
{
    return sum_at(media, ALL_MEDIA, band, inside, p, false);
}

double murk_media_extinction_of(const murk_media *media, size_t medium,
                                int band, murk_inside inside, murk_vec3 p)
{
    return sum_at(media, medium, band, inside, p, false);
}

double murk_media_scattering(const murk_media *media, int band,
                             murk_inside inside, murk_vec3 p)
{
    return sum_at(media, ALL_MEDIA, band, inside, p, true);
}

murk_box murk_media_bounds(const murk_media *media)
{
    murk_box all = murk_box_empty();
    for (size_t i = 0; i < media->n_places; ++i) {
        const murk_place *place = &media->places[i];
        if (place->shape != MURK_REGION_EVERYWHERE &&
            place->shape != MURK_REGION_BELOW &&
            place->bounds.min.x <= place->bounds.max.x) {
            all = murk_box_with(all, place->bounds.min);
            all = murk_box_with(all, place->bounds.max);
        }
    }
    return all;
}
