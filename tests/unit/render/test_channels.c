/* The names of picture channels that a user may type, and the channel that
 * each name selects. Nothing here is random. */
#include "check.h"
#include "render/channels.h"

static const double NM[2] = {414.5, 650};

static const char *found(int bands, bool has_coverage, const char *wanted)
{
    static murk_channel list[MURK_CHANNELS_MAX];
    const size_t n = murk_channels_list(NULL, bands, NM, has_coverage, list);
    const murk_channel *channel = murk_channel_find(list, n, wanted);
    return channel ? channel->name : "none";
}

static void test_names(void)
{
    CHECK_TEXT(found(2, false, "S0.650nm"), "S0.650nm");
    CHECK_TEXT(found(2, false, "radiance.650nm"), "S0.650nm");
    CHECK_TEXT(found(2, false, "depth.414.5nm"), "depth.414,5nm");
    CHECK_TEXT(found(2, false, "depth.414,5nm"), "depth.414,5nm");
    CHECK_TEXT(found(2, false, "error.G"), "error.G");
    CHECK_TEXT(found(2, false, "Z"), "Z");
    CHECK_TEXT(found(2, true, "coverage.count"), "coverage.count");
}

static void test_a_layer_of_one_band_needs_no_wavelength(void)
{
    CHECK_TEXT(found(1, false, "depth"), "depth.414,5nm");
    CHECK_TEXT(found(1, false, "error"), "error.414,5nm"); /* not error.R */
    CHECK_TEXT(found(1, false, "radiance"), "S0.414,5nm");
    CHECK_TEXT(found(2, false, "depth"), "none");
}

static void test_what_is_none(void)
{
    CHECK_TEXT(found(2, false, "coverage.count"), "none");
    CHECK_TEXT(found(2, true, "coverage"), "none");
    CHECK_TEXT(found(2, false, ""), "none");
    CHECK_TEXT(found(2, false, "radiance.651nm"), "none");
    CHECK_TEXT(found(2, false, "radiances"), "none");
    CHECK_TEXT(found(1, false, "dep"), "none");
}

static void test_every_band_fits(void)
{
    static murk_channel list[MURK_CHANNELS_MAX];
    double nm[MURK_BANDS_MAX];
    for (int b = 0; b < MURK_BANDS_MAX; ++b) {
        nm[b] = 380.123456 + b;
    }
    CHECK(murk_channels_list(NULL, MURK_BANDS_MAX, nm, true, list) ==
          MURK_CHANNELS_MAX);
    CHECK_TEXT(list[10].title, "radiance at 380.1235 nm");
}

static void test_bands_of_one_name(void)
{
    static const double near[] = {550.0001, 550.0002, 600.00001, 600.00002};
    CHECK(murk_channels_clash(1, near) == -1);
    CHECK(murk_channels_clash(3, near) == -1);
    CHECK(murk_channels_clash(4, near) == 2);
}

int main(void)
{
    test_bands_of_one_name();
    test_names();
    test_a_layer_of_one_band_needs_no_wavelength();
    test_what_is_none();
    test_every_band_fits();
    return check_done();
}
