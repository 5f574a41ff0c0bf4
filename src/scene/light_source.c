/* Reads photometric files and spectra of lamps, converts a luminous flux to
 * watts, spreads power over the bands, and expands arrays of lamps and
 * daylight. */
#include "scene/light_source.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/daylight_parts.h"
#include "base/photometry.h"
#include "luminaire/photometric_file.h"
#include "scene/table.h"

#define DEG (180 / MURK_PI) /* degrees in a radian */

/* Wavelengths of a spectrum [nm], and the largest number of rows. */
#define NM_MIN   1.0
#define NM_MAX   1e7
#define ROWS_MAX 100000
#define COLUMNS  "wavelength_nm and power_per_nm"

/* ---- files ---- */

/* Reads the photometric file, or takes the contents from an earlier light that
 * names the same file. */
static murk_status read_luminaire(murk_key_reader *walk,
                                  murk_scene_light *light)
{
    for (const murk_scene_light *l = walk->scene->lights; l < light; ++l) {
        if (l->luminaire && strcmp(l->file, light->file) == 0) {
            light->luminaire = murk_luminaire_share(l->luminaire);
            return light->luminaire ? MURK_OK : murk_walk_no_memory(walk);
        }
    }
    return murk_luminaire_read(&light->luminaire, light->file, walk->err);
}

/* Checks that wavelengths rise and that there is power. */
static murk_status check_spectrum(const murk_table *csv, const double *nm,
                                  const double *power, murk_error *err)
{
    char where[320];
    double sum = 0;
    for (size_t i = 0; i < csv->rows; ++i) {
        snprintf(where, sizeof where, "%.290s:%d", csv->path, csv->line[i]);
        if (!(nm[i] >= NM_MIN && nm[i] <= NM_MAX) ||
            (i > 0 && !(nm[i] > nm[i - 1]))) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "wavelength_nm is %g, must be %g..%g nm and rise",
                             nm[i], NM_MIN, NM_MAX);
        }
        if (!(power[i] >= 0 && power[i] <= 1e30)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "power_per_nm is %g, must be 0..1e30", power[i]);
        }
        sum += power[i];
    }
    return csv->rows >= 2 && csv->rows <= ROWS_MAX && sum > 0
               ? MURK_OK
               : murk_fail(err, MURK_BAD_FILE, csv->path,
                           "%zu rows with power, must be 2..%d, and not all 0",
                           sum > 0 ? csv->rows : 0, ROWS_MAX);
}

static murk_status read_spectrum(murk_lamp_spectrum **out, const char *path,
                                 murk_error *err)
{
    murk_table *csv = NULL;
    double *nm = NULL, *power = NULL;
    murk_status status = murk_table_read(&csv, path, err);
    if (!status) {
        status =
            murk_table_read_column(csv, "wavelength_nm", COLUMNS, &nm, err);
    }
    if (!status) {
        status =
            murk_table_read_column(csv, "power_per_nm", COLUMNS, &power, err);
    }
    if (!status) {
        status = check_spectrum(csv, nm, power, err);
    }
    if (!status) {
        status =
            murk_lamp_spectrum_create(out, 0, csv->rows, nm, power, path, err);
        nm = power = NULL; /* they belong to the spectrum */
    }
    free(nm);
    free(power);
    murk_table_destroy(csv);
    return status;
}

static murk_status read_files(murk_key_reader *walk, murk_scene_light *light)
{
    murk_status status = MURK_OK;
    if (light->file) {
        status = read_luminaire(walk, light);
    }
    if (!status && light->spectrum_file) {
        status =
            read_spectrum(&light->spectrum, light->spectrum_file, walk->err);
    } else if (!status && light->temperature_k > 0) {
        status =
            murk_lamp_spectrum_create(&light->spectrum, light->temperature_k, 0,
                                      NULL, NULL, light->where, walk->err);
    }
    return status;
}

/* ---- power ---- */

/* The shares of the bands in the spectrum, in any unit: integrals, or the
 * values at the wavelengths of bands without edges. */
static murk_spectrum shares_of(const murk_scene_desc *scene,
                               const murk_lamp_spectrum *spectrum)
{
    murk_spectrum out = {{0}};
    for (int b = 0; b < scene->bands; ++b) {
        out.band[b] =
            scene->has_edges
                ? murk_lamp_spectrum_integral(spectrum, scene->band_edge_nm[b],
                                              scene->band_edge_nm[b + 1])
                : murk_lamp_spectrum_at(spectrum, scene->band_nm[b]);
    }
    return out;
}

static void scale(murk_spectrum *out, double factor, int bands)
{
    for (int b = 0; b < bands; ++b) {
        out->band[b] *= factor;
    }
}

/* Spreads the total over the bands by the spectrum of the light. */
static murk_status spread(murk_key_reader *walk, const murk_yaml *map,
                          murk_scene_light *light)
{
    const int bands = walk->scene->bands;
    murk_spectrum share = shares_of(walk->scene, light->spectrum);
    double all = 0, total = 0;
    for (int b = 0; b < bands; ++b) {
        all += share.band[b];
        total += light->power_w.band[b];
    }
    if (!(all > 0)) {
        return murk_walk_fail(walk, map,
                              "its spectrum has no power in the bands");
    }
    scale(&share, total / all, bands);
    light->power_w = share;
    return MURK_OK;
}

/* Sets the power of a luminaire from light->lumens. */
static murk_status use_lumens(murk_key_reader *walk, const murk_yaml *map,
                              murk_scene_light *light)
{
    const murk_scene_desc *scene = walk->scene;
    if (!light->spectrum) {
        light->power_w = murk_spectrum_flat(
            light->lumens / MURK_LUMEN_PER_WATT / scene->bands, scene->bands);
        return MURK_OK;
    }
    /* The lumens that the shares stand for, as watts. */
    murk_spectrum share = shares_of(scene, light->spectrum);
    double all =
        scene->has_edges ? murk_lamp_spectrum_lumens(light->spectrum) : 0;
    for (int b = 0; b < scene->bands && !scene->has_edges; ++b) {
        all += share.band[b] * MURK_LUMEN_PER_WATT *
               murk_luminous_efficiency(scene->band_nm[b]);
    }
    if (!(all > 0)) {
        return murk_walk_fail(walk, map,
                              scene->has_edges
                                  ? "its spectrum has no visible light, so "
                                    "lumens give no power: must have power_w"
                                  : "its spectrum has no visible light at the "
                                    "wavelengths of the bands, so lumens give "
                                    "no power: must have power_w");
    }
    scale(&share, light->lumens / all, scene->bands);
    light->power_w = share;
    return MURK_OK;
}

/* The angle between the aim and straight down. */
static double tilt_deg(murk_vec3 aim)
{
    return atan2(hypot(aim.x, aim.y), -aim.z) * DEG;
}

murk_status murk_light_source_read(murk_key_reader *walk, const murk_yaml *map,
                                   murk_scene_light *light)
{
    light->item = (size_t)(light - walk->scene->lights);
    const murk_status status = read_files(walk, light);
    if (status) {
        return status;
    }
    const murk_yaml *power = murk_yaml_get(
        map, light->type == MURK_SOURCE_DIRECTIONAL ? "irradiance_w_per_m2"
                                                    : "power_w");
    if (power && light->has_lumens) {
        return murk_walk_fail(walk, map,
                              "has power_w and lumens, must have one of them");
    }
    const murk_luminaire *lamp = light->luminaire;
    if (lamp) {
        light->tilt_factor =
            murk_luminaire_tilt_factor(lamp, tilt_deg(light->direction));
    }
    if (lamp && !power) {
        if (!light->has_lumens) {
            light->lumens =
                light->tilt_factor * murk_intensity_lumens(lamp->intensity);
        }
        return use_lumens(walk, map, light);
    }
    /* A list has the power of each band. */
    return light->spectrum && power && power->kind == MURK_YAML_SCALAR
               ? spread(walk, map, light)
               : MURK_OK;
}

/* ---- arrays ---- */

/* The lights that a light of the scene file stands for: the lamps of an array,
 * or the parts of daylight. */
static size_t lights_of(const murk_scene_light *light)
{
    const size_t *count = light->array.count;
    if (light->type == MURK_SOURCE_DAYLIGHT) {
        murk_sun_places places;
        murk_sun_places_make(&places, light->site.latitude_deg);
        return MURK_SKY_PATCHES + places.n;
    }
    return count[0] > 0 ? count[0] * count[1] : 1;
}

/* Makes a light the part of daylight of a number: first the patches of the sky,
 * then the places of the sun. */
static void become_part(murk_scene_light *light, size_t number)
{
    const bool is_patch = number < MURK_SKY_PATCHES;
    light->type = is_patch ? MURK_SOURCE_SKY : MURK_SOURCE_SUN;
    light->part = 1 + number - (is_patch ? 0 : MURK_SKY_PATCHES);
}

static murk_vec3 place_in_array(const murk_scene_light *first, size_t number)
{
    const murk_scene_array *a = &first->array;
    const double i = (double)(number / a->count[1]),
                 j = (double)(number % a->count[1]);
    return murk_along(murk_along(first->position, i, a->step1), j, a->step2);
}

/* Copies a light: a lamp to the place of a number of its array, daylight to the
 * part of a number. */
static bool copy_lamp(murk_scene_light *out, const murk_scene_light *first,
                      size_t number)
{
    const size_t bytes = first->portals * sizeof *first->portal;
    *out = *first;
    if (first->type == MURK_SOURCE_DAYLIGHT) {
        become_part(out, number);
    } else {
        out->position = place_in_array(first, number);
    }
    out->portal = bytes > 0 ? malloc(bytes) : NULL;
    if (out->portal) {
        memcpy(out->portal, first->portal, bytes);
    }
    out->file = first->file ? strdup(first->file) : NULL;
    out->spectrum_file =
        first->spectrum_file ? strdup(first->spectrum_file) : NULL;
    out->luminaire =
        first->luminaire ? murk_luminaire_share(first->luminaire) : NULL;
    out->spectrum = murk_lamp_spectrum_share(first->spectrum);
    return !(first->file && !out->file) &&
           !(first->spectrum_file && !out->spectrum_file) &&
           !(first->luminaire && !out->luminaire) &&
           !(bytes > 0 && !out->portal);
}

static void release_copies(murk_scene_light *copy, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        free(copy[i].portal);
        free(copy[i].file);
        free(copy[i].spectrum_file);
        murk_luminaire_destroy(copy[i].luminaire);
        murk_lamp_spectrum_destroy(copy[i].spectrum);
    }
    free(copy);
}

/* Makes copy[]: all lamps of arrays and parts of daylight but the first of
 * each, in order. Returns NULL when out of memory. */
static murk_scene_light *copy_all(const murk_scene_desc *scene, size_t copies)
{
    murk_scene_light *copy = calloc(copies, sizeof *copy);
    size_t n = 0;
    for (size_t i = 0; i < scene->n_lights && copy; ++i) {
        const murk_scene_light *light = &scene->lights[i];
        for (size_t k = 1; k < lights_of(light); ++k) {
            if (!copy_lamp(&copy[n++], light, k)) {
                release_copies(copy, n);
                return NULL;
            }
        }
    }
    return copy;
}

murk_status murk_light_arrays_expand(murk_key_reader *walk,
                                     murk_scene_desc *scene)
{
    size_t all = 0;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        all += lights_of(&scene->lights[i]);
    }
    const size_t copies = all - scene->n_lights;
    if (copies == 0) {
        return MURK_OK;
    }
    if (all > MURK_SCENE_LIGHTS_MAX) {
        murk_walk_enter(walk, "lights");
        return murk_walk_fail(walk, murk_yaml_get(walk->root, "lights"),
                              "%zu lights with the lamps of arrays and the "
                              "parts of daylight, must be at "
                              "most %d",
                              all, MURK_SCENE_LIGHTS_MAX);
    }
    murk_scene_light *copy = copy_all(scene, copies);
    murk_scene_light *longer =
        copy ? realloc(scene->lights, all * sizeof *longer) : NULL;
    if (!longer) {
        release_copies(copy, copy ? copies : 0);
        return murk_walk_no_memory(walk);
    }
    /* Merge lights and copies from the last to the first. */
    size_t to = all, next = copies;
    for (size_t i = scene->n_lights; i-- > 0;) {
        const size_t lamps = lights_of(&longer[i]);
        const murk_scene_light first = longer[i];
        for (size_t k = 1; k < lamps; ++k) {
            longer[--to] = copy[--next];
        }
        longer[--to] = first;
        if (first.type == MURK_SOURCE_DAYLIGHT) {
            become_part(&longer[to], 0);
        }
    }
    free(copy);
    scene->lights = longer;
    scene->n_lights = all;
    return MURK_OK;
}

void murk_light_source_sign(FILE *out, const murk_scene_desc *scene)
{
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_scene_light *light = &scene->lights[i];
        if (light->luminaire) {
            uint64_t sum[2];
            murk_intensity_checksum(light->luminaire->intensity, sum);
            fprintf(out, "luminaire %zu: %016" PRIx64 "%016" PRIx64 " %.17g\n",
                    i, sum[1], sum[0], light->tilt_factor);
        }
    }
}
