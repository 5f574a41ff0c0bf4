/* Rescaled media are those that had the other extinctions from the start. */
#include "check.h"
#include "medium/rescaled.h"

#define MEDIA 3

static murk_medium medium_of(double extinction_per_m)
{
    return (murk_medium){.extinction_per_m =
                             murk_spectrum_flat(extinction_per_m, 2),
                         .albedo = murk_spectrum_flat(0.5, 2)};
}

/* Fog everywhere, smoke in a box, and water that takes the place of both. */
static murk_media *media_with(const double extinction_per_m[MEDIA])
{
    const murk_box domain = {{0, 0, 0}, {4, 4, 4}};
    const murk_affine none = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    const murk_region region[MEDIA] = {
        {.medium = 0, .shape = MURK_REGION_EVERYWHERE, .to_world = none},
        {.medium = 1,
         .shape = MURK_REGION_BOX,
         .box = {{1, 0, 0}, {3, 4, 4}},
         .to_world = none},
        {.medium = 2,
         .shape = MURK_REGION_SPHERE,
         .center = {2, 2, 2},
         .radius_m = 0.5,
         .replaces = true,
         .to_world = none}};
    murk_medium medium[MEDIA];
    murk_media *out = NULL;
    for (int i = 0; i < MEDIA; ++i) {
        medium[i] = medium_of(extinction_per_m[i]);
    }
    CHECK(
        !murk_media_create(&out, medium, MEDIA, region, MEDIA, &domain, NULL));
    return out;
}

static double depth_of(const murk_media *media, murk_vec3 from)
{
    return murk_media_optical_depth(media, 1, 0, from, murk_vec(1, 0, 0), 4);
}

static void test_is_as_if_made_so(void)
{
    static const double first[MEDIA] = {0.5, 0.25, 2};
    static const double other[][MEDIA] = {
        {0.25, 1, 4}, {1, 0, 0}, {0, 0, 3}, {0, 0, 0}};
    murk_media *media = media_with(first);
    for (size_t k = 0; k < sizeof other / sizeof other[0]; ++k) {
        murk_spectrum extinction[MEDIA];
        for (int i = 0; i < MEDIA; ++i) {
            extinction[i] = murk_spectrum_flat(other[k][i], 2);
        }
        murk_media *rescaled = NULL, *made = media_with(other[k]);
        CHECK(!murk_media_rescale(&rescaled, media, extinction, NULL));
        for (double y = 0.1; y < 4; y += 0.3) {
            const murk_vec3 from = {0, y, 2};
            CHECK(depth_of(rescaled, from) == depth_of(made, from));
        }
        CHECK(murk_media_any(rescaled) == murk_media_any(made));
        murk_media_destroy(rescaled);
        murk_media_destroy(made);
    }
    /* 1 m of fog and smoke beyond each other, the ball's 1 m, and the rest */
    CHECK_NEAR(depth_of(media, murk_vec(0, 2, 2)), 2 * 0.5 + 1 * 0.75 + 1 * 2,
               1e-12);
    murk_media_destroy(media);
}

int main(void)
{
    test_is_as_if_made_so();
    return check_done();
}
