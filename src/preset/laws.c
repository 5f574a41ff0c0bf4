/* The table of laws: name, description, function, parameters with allowed
 * ranges, and the words that a law uses. */
#include "preset/laws.h"

#include <string.h>

#define BIT(word) (1u << MURK_WORD_##word)

const murk_law murk_laws[] = {
    {.name = "kruse",
     .about = "extinction by visibility, Kruse 1962",
     .run = murk_law_kruse,
     .parameter = {{"albedo", 0, 1}},
     .needs = BIT(VISIBILITY)},
    {.name = "kim",
     .about = "extinction by visibility, Kim 2001",
     .run = murk_law_kim,
     .parameter = {{"albedo", 0, 1}},
     .needs = BIT(VISIBILITY)},
    {.name = "rayleigh",
     .about = "dry air, Bodhaine et al. 1999",
     .run = murk_law_rayleigh,
     .needs = BIT(PRESSURE) | BIT(TEMPERATURE)},
    {.name = "angstrom",
     .about = "extinction by a power of wavelength, Angstrom 1964",
     .run = murk_law_angstrom,
     .parameter = {{"extinction_per_m", 0, 1e6},
                   {"at_nm", 1, 1e5},
                   {"exponent", -4, 4},
                   {"albedo", 0, 1}}},
    {.name = "rain_power",
     .about = "attenuation by a power of the rain rate",
     .run = murk_law_rain_power,
     .parameter = {{"rays", 0, 1}, {"db_per_km", 0, 100}, {"power", 0, 2}},
     .needs = BIT(RAIN)},
    {.name = "marshall_palmer",
     .about = "large drops by rain rate, Marshall & Palmer 1948",
     .run = murk_law_marshall_palmer,
     .parameter = {{"rays", 0, 1}},
     .needs = BIT(RAIN)},
    {.name = "water",
     .about = "water by itself, Pope & Fry 1997 and Zhang et al. 2009",
     .run = murk_law_water,
     .needs = BIT(TEMPERATURE),
     .may = BIT(SALINITY)},
    {.name = "water_morel",
     .about = "water by itself, Pope & Fry 1997 and Morel 1974",
     .run = murk_law_water_morel,
     .may = BIT(SALINITY)},
    {.name = "chlorophyll",
     .about = "particles of the open ocean by chlorophyll",
     .run = murk_law_chlorophyll,
     .needs = BIT(CHLOROPHYLL)},
    {.name = "cdom",
     .about = "dissolved organic matter, exponential",
     .run = murk_law_cdom,
     .needs = BIT(CDOM)},
    {.name = "case_1",
     .about = "open ocean by chlorophyll, by the attenuation of daylight",
     .run = murk_law_case_1,
     .needs = BIT(CHLOROPHYLL)},
    {.name = "sediment",
     .about = "mineral particles by mass, Babin et al. 2003",
     .run = murk_law_sediment,
     .needs = BIT(SEDIMENT)},
    {.name = "in_green",
     .about = "what is in water, known at one wavelength",
     .run = murk_law_in_green,
     .parameter = {{"absorption_per_m", 0, 1e3},
                   {"scattering_per_m", 0, 1e3},
                   {"at_nm", 380, 727.5},
                   {"absorption_slope_per_nm", 0, 1},
                   {"scattering_power", -4, 4}},
     .needs = BIT(TEMPERATURE),
     .may = BIT(SALINITY) | BIT(BEAM_ATTENUATION)},
    {.name = "diffuse_attenuation",
     .about = "what is in water, by the attenuation of daylight, Kirk 1984",
     .run = murk_law_diffuse_attenuation,
     .parameter = {{"scattering_per_m", 0, 1e3},
                   {"at_nm", 1, 1e5},
                   {"scattering_power", -4, 4},
                   {"sun_zenith_deg", 0, 89}},
     .by_table = true,
     .needs = BIT(TEMPERATURE),
     .may = BIT(SALINITY)},
    {.name = "droplets",
     .about = "water droplets of the sizes that droplet_shape says, by Mie",
     .run = murk_law_droplets,
     .needs = BIT(DROPLET_SHAPE) | BIT(DROPLETS),
     .may = BIT(LIQUID_WATER)},
    {.name = "gamma_droplets",
     .about = "water droplets of sizes r^a exp(-b r^c), r in um, by Mie",
     .run = murk_law_gamma_droplets,
     .parameter = {{"a", 0, 40}, {"b", 1e-9, 1e9}, {"c", .1, 6}},
     .needs = BIT(DROPLETS),
     .may = BIT(LIQUID_WATER)},
};
const size_t murk_laws_count = sizeof murk_laws / sizeof *murk_laws;

const murk_law *murk_law_find(const char *name)
{
    for (size_t i = 0; i < murk_laws_count; ++i) {
        if (strcmp(murk_laws[i].name, name) == 0) {
            return &murk_laws[i];
        }
    }
    return NULL;
}
