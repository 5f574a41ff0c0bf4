/* The table of laws: name, description, function, parameters with allowed
 * ranges, and the words that a law uses. */
#include "preset/laws.h"

#include <string.h>

#define BIT(word) (1u << MURK_WORD_##word)

static const murk_law LAWS[] = {
    {"kruse", "extinction by visibility, Kruse 1962", murk_law_kruse,
     .parameter = {{"albedo", 0, 1}}, .needs = BIT(VISIBILITY)},
    {"kim", "extinction by visibility, Kim 2001", murk_law_kim,
     .parameter = {{"albedo", 0, 1}}, .needs = BIT(VISIBILITY)},
    {"rayleigh", "dry air, Bodhaine et al. 1999", murk_law_rayleigh,
     .needs = BIT(PRESSURE) | BIT(TEMPERATURE)},
    {"angstrom", "extinction by a power of wavelength, Angstrom 1964",
     murk_law_angstrom,
     .parameter = {{"extinction_per_m", 0, 1e6},
                   {"at_nm", 1, 1e5},
                   {"exponent", -4, 4},
                   {"albedo", 0, 1}}},
    {"rain_power", "attenuation by a power of the rain rate",
     murk_law_rain_power,
     .parameter = {{"rays", 0, 1}, {"db_per_km", 0, 100}, {"power", 0, 2}},
     .needs = BIT(RAIN)},
    {"marshall_palmer", "large drops by rain rate, Marshall & Palmer 1948",
     murk_law_marshall_palmer, .parameter = {{"rays", 0, 1}},
     .needs = BIT(RAIN)},
    {"water", "water by itself, Pope & Fry 1997 and Zhang et al. 2009",
     murk_law_water, .needs = BIT(TEMPERATURE), .may = BIT(SALINITY)},
    {"water_morel", "water by itself, Pope & Fry 1997 and Morel 1974",
     murk_law_water_morel, .may = BIT(SALINITY)},
    {"chlorophyll", "particles of the open ocean by chlorophyll",
     murk_law_chlorophyll, .needs = BIT(CHLOROPHYLL)},
    {"cdom", "dissolved organic matter, exponential", murk_law_cdom,
     .needs = BIT(CDOM)},
    {"case_1", "open ocean by chlorophyll, by the attenuation of daylight",
     murk_law_case_1, .needs = BIT(CHLOROPHYLL)},
    {"sediment", "mineral particles by mass, Babin et al. 2003",
     murk_law_sediment, .needs = BIT(SEDIMENT)},
    {"in_green", "what is in water, known at one wavelength", murk_law_in_green,
     .parameter = {{"absorption_per_m", 0, 1e3},
                   {"scattering_per_m", 0, 1e3},
                   {"at_nm", 380, 727.5},
                   {"absorption_slope_per_nm", 0, 1},
                   {"scattering_power", -4, 4}},
     .needs = BIT(TEMPERATURE), .may = BIT(SALINITY) | BIT(BEAM_ATTENUATION)},
    {"diffuse_attenuation",
     "what is in water, by the attenuation of daylight, Kirk 1984",
     murk_law_diffuse_attenuation,
     .parameter = {{"scattering_per_m", 0, 1e3},
                   {"at_nm", 1, 1e5},
                   {"scattering_power", -4, 4},
                   {"sun_zenith_deg", 0, 89}},
     .by_table = true, .needs = BIT(TEMPERATURE), .may = BIT(SALINITY)},
    {"droplets", "water droplets of the sizes that droplet_shape says, by Mie",
     murk_law_droplets, .needs = BIT(DROPLET_SHAPE) | BIT(DROPLETS),
     .may = BIT(LIQUID_WATER)},
    {"gamma_droplets",
     "water droplets of sizes r^a exp(-b r^c), r in um, by Mie",
     murk_law_gamma_droplets,
     .parameter = {{"a", 0, 40}, {"b", 1e-9, 1e9}, {"c", .1, 6}},
     .needs = BIT(DROPLETS), .may = BIT(LIQUID_WATER)},
};

const murk_law *murk_law_find(const char *name)
{
    for (size_t i = 0; i < sizeof LAWS / sizeof *LAWS; ++i) {
        if (strcmp(LAWS[i].name, name) == 0) {
            return &LAWS[i];
        }
    }
    return NULL;
}
