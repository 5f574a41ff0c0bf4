/* Air, fog, rain and smoke by the words of presets. */
#include "scene/presets.h"
#include "library/library.h"

#include <math.h>
#include <stdlib.h>

/* Extinction [1/m] at a wavelength; NaN where the preset is refused. */
static double extinction(const char *name, int word, double value, double nm)
{
    const murk_preset_bands bands = {1, &nm, NULL};
    murk_words words = {{0}, {{0}}};
    murk_preset_result result = {0};
    murk_preset *preset = NULL;
    double out = NAN;
    if (word >= 0) {
        words.given[word] = true;
        words.value[word][0] = value;
    }
    if (!murk_presets_read(&preset, name, "", NULL) &&
        !murk_preset_evaluate(&result, preset, &words, &bands, "", NULL)) {
        out = result.extinction_per_m.band[0];
    }
    murk_preset_result_release(&result);
    murk_preset_destroy(preset);
    return out;
}

/* A reference file's numbers, row by row; texts and comments are left out. */
static bool next_row(FILE *file, double *number, int n)
{
    char line[600];
    while (fgets(line, sizeof line, file)) {
        char *at = line;
        int found = 0;
        while (found < n) {
            char *end;
            number[found] = strtod(at, &end);
            if (end == at) {
                break;
            }
            ++found;
            at = *end == ',' ? end + 1 : end;
        }
        if (found == n) {
            return true;
        }
    }
    return false;
}

static FILE *open_reference(murk_library *library, const char *path)
{
    FILE *file = fopen(path, "r");
    if (!file) {
        murk_library_row(library, path, "", 0, NAN, 0, "the file is missing",
                         path);
    }
    return file;
}

static void compare_visibility(murk_library *library)
{
    FILE *file = open_reference(
        library, "tests/physics/reference/fso_visibility_models.csv");
    murk_library_title(library, "Fog and haze by visibility",
                       "Extinction by the laws of Kruse and Kim.");
    double row[9];
    while (file && next_row(file, row, 9)) {
        for (int law = 0; law < 2; ++law) {
            char quantity[80];
            snprintf(quantity, sizeof quantity, "fog/%s, %g km, %g nm",
                     law ? "kim" : "kruse", row[0], row[1]);
            murk_library_row(library, quantity, "1/km", row[4 + law],
                             1000 * extinction(law ? "fog/kim" : "fog/kruse",
                                               MURK_WORD_VISIBILITY,
                                               1000 * row[0], row[1]),
                             5.5e-7, "last digit printed",
                             law ? "Kim et al. 2001" : "Kruse et al. 1962");
        }
    }
    if (file) {
        fclose(file);
    }
}

static void compare_air(murk_library *library)
{
    FILE *file =
        open_reference(library, "tests/physics/reference/rayleigh_air.csv");
    murk_library_title(library, "Clean air",
                       "Scattering at 288.15 K and 1013.25 hPa.");
    double row[7];
    while (file && next_row(file, row, 7)) {
        char quantity[80];
        snprintf(quantity, sizeof quantity, "air/rayleigh, %g nm", row[0]);
        murk_library_row(library, quantity, "1/m", row[4],
                         extinction("air/rayleigh", -1, 0, row[0]),
                         6e-6 * row[4], "last digit printed",
                         "Bodhaine et al. 1999");
    }
    if (file) {
        fclose(file);
    }
}

static void compare_rain(murk_library *library)
{
    /* Each preset with the column of the reference that holds the same law. */
    static const struct {
        const char *preset, *source;
        int column;
    } law[] = {
        {"rain/carbonneau", "Carbonneau & Wisely 1998 (second hand)", 1},
        {"rain/itu-r", "ITU-R P.1814-1, shape 0 (second hand)", 4},
        {"rain/marshall-palmer", "Marshall & Palmer 1948", 7},
    };
    /* A line of the reference holds a rain rate and the attenuation by each
     * law. */
    FILE *file =
        open_reference(library, "tests/physics/reference/rain_models.csv");
    murk_library_title(library, "Rain", "Attenuation by rain rate.");
    double row[9];
    while (file && next_row(file, row, 9)) {
        for (size_t i = 0; i < sizeof law / sizeof *law; ++i) {
            char quantity[80];
            snprintf(quantity, sizeof quantity, "%s, %g mm/h", law[i].preset,
                     row[0]);
            /* Turn the extinction per metre into dB/km. */
            murk_library_row(
                library, quantity, "dB/km", row[law[i].column],
                1e4 / log(10) *
                    extinction(law[i].preset, MURK_WORD_RAIN, row[0], 850),
                5.5e-6, "last digit printed", law[i].source);
        }
    }
    if (file) {
        fclose(file);
    }
}

static void compare_smoke(murk_library *library)
{
    murk_library_title(library, "Smoke",
                       "Extinction by mass, red light of 633 nm.");
    murk_library_row(library, "smoke/flaming, 1 g/m3", "1/m", 8.7,
                     extinction("smoke/flaming", MURK_WORD_SOOT, 1, 633), 1.1,
                     "the source's 95 %", "Mulholland & Croarkin 2000");
    murk_library_row(library, "smoke/smouldering over flaming", "", 4.4 / 7.6,
                     extinction("smoke/smouldering", MURK_WORD_SOOT, 1, 633) /
                         extinction("smoke/flaming", MURK_WORD_SOOT, 1, 633),
                     4.4 / 7.6 * 1.1 / 8.7, "the flaming one's 95 %",
                     "Seader & Einhorn 1977 (second hand)");
}

void murk_library_presets(murk_library *library)
{
    compare_visibility(library);
    compare_air(library);
    compare_rain(library);
    compare_smoke(library);
}
