/* The places at which two sets of media differ: rays that meet none of the
 * boxes have the same optical depth in both, in every bit, for grids whose
 * values or whose division into cells differ, with and without a haze around
 * them. Equal media have no boxes. Seeds are fixed. */
#include "base/rng.h"
#include "check.h"
#include "medium/changed_media.h"
#include "medium/grid_internal.h"

#include <stdlib.h>

enum { RAYS = 4000 };

/* A change from the first grid of a pair to the second one. */
typedef enum change {
    NOTHING,
    VALUES,    /* of one leaf */
    AS_TILE,   /* a leaf of one value is a constant cell */
    IN_A_TILE, /* one leaf in a constant cell of 128 voxels */
    CHANGES
} change;

static double draw(uint32_t a, uint32_t b)
{
    uint32_t word[4];
    murk_random_words(1, 0, a, b, 0, word);
    return word[0] * 0x1p-32;
}

static size_t edge_of(change what)
{
    return what == IN_A_TILE ? 136 : 24;
}

/* Grid `which` of a pair, 2 m along each edge. */
static murk_grid *make_grid(change what, int which)
{
    const size_t edge = edge_of(what), size[3] = {edge, edge, edge};
    float *value = malloc(edge * edge * edge * sizeof *value);
    murk_affine place = murk_affine_identity();
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(value);
    /* Values that differ everywhere, but for the leaf or the tile. */
    for (int axis = 0; axis < 3; ++axis) {
        place.matrix[axis][axis] = 2 / (double)edge;
    }
    for (size_t i = 0; i < edge * edge * edge; ++i) {
        const size_t x = i % edge, y = i / edge % edge, z = i / edge / edge;
        const bool in_leaf = x / 8 == 1 && y / 8 == 1 && z / 8 == 1,
                   in_tile = x < 128 && y < 128 && z < 128;
        value[i] = 0.5F + 0.02F * (float)(x + 2 * y + z);
        if (what == IN_A_TILE && in_tile) {
            value[i] = 0.7F;
        }
        if (in_leaf && what != IN_A_TILE) {
            value[i] = what == VALUES && which ? 0.9F : 0.4F;
        } else if (in_leaf && which) {
            value[i] = 0.3F + 0.01F * (float)x;
        }
    }
    const bool as_tiles = what == IN_A_TILE || (what == AS_TILE && which);
    CHECK(murk_grid_make(&grid, size, value, &place, as_tiles, "grid", &err) ==
          MURK_OK);
    free(value);
    return grid;
}

static murk_media *make_media(const murk_grid *grid, int interpolation,
                              bool has_haze)
{
    murk_medium medium[2] = {
        {.grid = grid, .interpolation = (murk_interpolation)interpolation},
        {.grid = NULL}};
    const murk_region region[2] = {
        {.shape = MURK_REGION_GRID, .to_world = murk_affine_identity()},
        {.medium = 1,
         .shape = MURK_REGION_EVERYWHERE,
         .to_world = murk_affine_identity()}};
    const murk_box domain = {{-1, -1, -1}, {3, 3, 3}};
    murk_media *media = NULL;
    murk_error err = {0};
    medium[0].extinction_per_m.band[0] = 1;
    medium[1].extinction_per_m.band[0] = 0.2;
    CHECK(murk_media_create(&media, medium, 2, region, has_haze ? 2 : 1,
                            &domain, &err) == MURK_OK);
    return media;
}

/* The number of rays that meet a box, and of those of the others whose depth
 * differs. */
static void compare_depths(murk_media *const media[2],
                           const murk_box_list *changed, int *met,
                           int *different)
{
    *met = *different = 0;
    for (uint32_t i = 0; i < RAYS; ++i) {
        const murk_vec3 from = {-0.5, 2 * draw(i, 0), 2 * draw(i, 1)},
                        to = {2.5, 2 * draw(i, 2), 2 * draw(i, 3)},
                        along = murk_sub(to, from);
        if (murk_box_list_meet(changed, from, along)) {
            ++*met;
            continue;
        }
        double depth[2];
        for (int k = 0; k < 2; ++k) {
            depth[k] = murk_media_optical_depth(
                media[k], 0, 0, from, murk_unit(along), murk_length(along));
        }
        *different += memcmp(&depth[0], &depth[1], sizeof depth[0]) != 0;
    }
}

static void check_change(change what, int interpolation, bool has_haze)
{
    murk_grid *grid[2] = {make_grid(what, 0), make_grid(what, 1)};
    murk_media *media[2] = {make_media(grid[0], interpolation, has_haze),
                            make_media(grid[1], interpolation, has_haze)};
    murk_box_list changed = {0};
    int met, different;
    murk_changed_media(&changed, media[0], media[1], true);
    murk_box_list_grow(&changed, 1e-5);
    compare_depths(media, &changed, &met, &different);
    CHECK(!changed.are_all && different == 0);
    CHECK((changed.n > 0) == (what != NOTHING));
    /* Some rays pass beside one leaf; without the box their depths differ. */
    if (what == VALUES || what == AS_TILE) {
        CHECK(met > 0 && met < RAYS);
    }
    if (what == VALUES) {
        changed.n = 0;
        compare_depths(media, &changed, &met, &different);
        CHECK(different > RAYS / 50);
    }
    for (int k = 0; k < 2; ++k) {
        murk_media_destroy(media[k]);
        murk_grid_destroy(grid[k]);
    }
}

int main(void)
{
    for (int what = 0; what < CHANGES; ++what) {
        for (int haze = 0; haze < 2; ++haze) {
            check_change((change)what, MURK_NEAREST, haze);
            check_change((change)what, MURK_LINEAR, haze);
        }
    }
    return check_done();
}
