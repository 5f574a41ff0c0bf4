/* The lights of a scene as murk check reports them: power, the position of sun
 * and moon, irradiance, and the share of the light from outside that the media
 * of the domain absorb or scatter before it meets a surface or water. */
#include "overview/parts.h"

#include "results/summary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/daylight_parts.h"
#include "base/path.h"
#include "world/daylight_loss.h"
#include "world/units.h"

/* Declared and integrated flux that differ by less agree: files round. */
#define AGREES 5e-4

static void print_time(const murk_stage *stage)
{
    char text[MURK_TIME_SIZE];
    const murk_scene_site *site = &stage->scene->site;
    if (site->has_time) {
        murk_time_print(text, site->unix_s, site->zone_min);
        murk_print("time        %s\n", text);
    }
}

/* The irradiance of a light of the sky, summed over the bands, in the units of
 * the scene. */
static double irradiance_of(const murk_stage *stage, size_t light)
{
    const murk_scene_desc *scene = stage->scene;
    const murk_source *of = murk_sources_get(stage->lights, light);
    double sum = 0;
    for (int b = 0; b < scene->bands; ++b) {
        sum += of->power_w.band[b] *
               murk_units_per_watt(scene->units, stage, light, b);
    }
    return sum;
}

/* Prints the share of the irradiance on the line above that the media of the
 * domain absorb or scatter. The weather is part of that irradiance already, so
 * fog in the scene may dim the light a second time. */
static void print_taken(double share)
{
    if (share > 0) {
        murk_print("            the domain's media take %.3g %% of this again, "
                   "before a surface or water\n",
                   100 * share);
    }
}

/* That share of n lights, of which `first` is the first; 0 if it is not
 * known. */
static double taken_of(const murk_stage *stage, size_t first, size_t n)
{
    double sum = 0, all = 0;
    for (size_t i = first; i < first + n; ++i) {
        const murk_daylight_loss taken = murk_daylight_loss_of(stage, i);
        const double irradiance = stage->sky[i].irradiance_w_per_m2;
        sum += taken.is_known ? taken.share * irradiance : 0;
        all += irradiance;
    }
    return all > 0 ? sum / all : 0;
}

/* The power of all lights together, in the unit of a quantity. */
static double power_of(const murk_stage *stage, murk_quantity quantity)
{
    const size_t bands = (size_t)stage->scene->bands;
    double sum = 0;
    for (size_t c = 0; c < murk_sources_channels(stage->lights); ++c) {
        sum +=
            murk_sources_channel_power_w(stage->lights, c) *
            murk_units_per_watt(quantity, stage, c / bands, (int)(c % bands));
    }
    return sum;
}

static void print_power(const murk_stage *stage)
{
    const murk_quantity quantity = stage->scene->units;
    murk_print("lights      %zu, %.6g W", murk_sources_count(stage->lights),
               murk_sources_power_w(stage->lights));
    if (quantity != MURK_RADIOMETRIC) {
        murk_print(" or %.6g %s", power_of(stage, quantity),
                   murk_units_of(quantity).power);
    }
    murk_print(" together\n");
}

/* ---- luminaires ---- */

/* The number of lights that come from the same item of the scene file, of which
 * `light` is the first; 0 if it is not the first. */
static size_t lamps_of_item(const murk_scene_desc *scene, size_t light)
{
    const murk_scene_light *l = scene->lights;
    size_t n = 0;
    while (light + n < scene->n_lights && l[light + n].item == l[light].item) {
        ++n;
    }
    return light > 0 && l[light - 1].item == l[light].item ? 0 : n;
}

/* The opening by words: "a disc of .1 m", "0.3 x 0.6 m (C0, C90)". */
static void describe_aperture(char *out, size_t size,
                              const murk_luminaire *lamp)
{
    if (lamp->aperture == MURK_APERTURE_POINT) {
        snprintf(out, size, "a point");
    } else if (lamp->aperture == MURK_APERTURE_DISC) {
        snprintf(out, size, "a disc of %.4g m", lamp->along_c0_m);
    } else {
        snprintf(out, size, "%.4g m along C0, %.4g m along C90",
                 lamp->along_c0_m, lamp->along_c90_m);
    }
    if (lamp->aperture != MURK_APERTURE_POINT && lamp->height_m > 0) {
        const size_t n = strlen(out);
        snprintf(out + n, size - n, ", luminous sides of %.4g m",
                 lamp->height_m);
    }
}

/* Prints the file of a luminaire: format, symmetry, flux against the declared
 * one, opening, and the flux that the scene has in place of that of the file.
 */
static void print_luminaire(const murk_scene_light *l, size_t number,
                            size_t lamps)
{
    const murk_luminaire *lamp = l->luminaire;
    const double lumens = murk_intensity_lumens(lamp->intensity);
    char aperture[120];
    describe_aperture(aperture, sizeof aperture, lamp);
    murk_print("luminaire   %zu", number);
    if (lamps > 1) {
        murk_print("..%zu", number + lamps - 1);
    }
    murk_print(", %s: %s, type %s, %s, %zu x %zu angles\n",
               murk_path_name(l->file), lamp->format,
               murk_luminaire_type_name(lamp->type),
               murk_luminaire_symmetry_name(lamp->symmetry), lamp->horizontals,
               lamp->verticals);
    /* The flux. */
    murk_print("            %.6g lm by the intensities, up to %.6g cd; ",
               lumens, murk_intensity_max_candela(lamp->intensity));
    if (isnan(lamp->declared_lumens)) {
        murk_print("the file declares no flux\n");
    } else {
        const double more = lamp->declared_lumens / lumens - 1;
        murk_print("the file declares %.6g lm", lamp->declared_lumens);
        if (more >= 1) {
            murk_print(", %.3g times as much", more + 1);
        } else if (fabs(more) > AGREES) {
            murk_print(", %.3g %% %s", 100 * fabs(more),
                       more > 0 ? "more" : "less");
        }
        murk_print("\n");
    }
    if (l->lumens > 0 && l->lumens != lumens) {
        murk_print("            %.6g lm in this scene%s\n", l->lumens,
                   l->has_lumens ? ", by lumens" : ", by the TILT data");
    }
    murk_print("            luminous area: %s%s\n", aperture,
               l->has_size ? "" : "; size: point, so it has no extent here");
}

static void print_luminaires(const murk_scene_desc *scene)
{
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const size_t lamps = lamps_of_item(scene, i);
        if (scene->lights[i].luminaire && lamps > 0) {
            print_luminaire(&scene->lights[i], i, lamps);
        }
    }
}

/* ---- lights of the sky ---- */

static void print_body(const murk_scene_light *l, const murk_sky_facts *facts)
{
    if (isfinite(facts->elevation_deg)) {
        murk_print("; %s at azimuth %.2f, elevation %.2f degrees",
                   l->type == MURK_SOURCE_MOON ? "moon" : "sun",
                   facts->azimuth_deg, facts->elevation_deg);
    }
    murk_print("\n");
}

/* Prints the parts of a light of type daylight, of which `first` is the first:
 * the irradiances of all patches and of all places of the sun. */
static void print_daylight(const murk_stage *stage, size_t first, size_t n)
{
    const murk_scene_light *l = &stage->scene->lights[first];
    double sky = 0, sun = 0;
    for (size_t i = 0; i < n; ++i) {
        double *sum = l[i].type == MURK_SOURCE_SKY ? &sky : &sun;
        *sum += irradiance_of(stage, first + i);
    }
    const char *unit = murk_units_of(stage->scene->units).irradiance;
    murk_print("light       %zu..%zu, daylight: sun in %zu places %.4g %s, sky "
               "in %d patches %.4g %s in the bands",
               first, first + n - 1, n - MURK_SKY_PATCHES, sun, unit,
               MURK_SKY_PATCHES, sky, unit);
    print_body(l, &stage->sky[first]);
    print_taken(taken_of(stage, first, n));
}

void murk_overview_print_lights(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    print_power(stage);
    print_luminaires(scene);
    print_time(stage);
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_sky_facts *facts = &stage->sky[i];
        const murk_scene_light *l = &scene->lights[i];
        /* Lamps have a line only when they are off. */
        if (!murk_scene_light_is_of_sky(l)) {
            if (!facts->is_on) {
                murk_print("light       %zu, %s: off\n", i,
                           murk_source_type_name(l->type));
            }
            continue;
        }
        if (l->part > 0) { /* one line for all parts */
            const size_t parts = lamps_of_item(scene, i);
            if (parts > 0) {
                print_daylight(stage, i, parts);
            }
            continue;
        }
        /* Lights of the sky: irradiance and direction. */
        murk_print("light       %zu, %s: %.4g %s in the bands", i,
                   murk_source_type_name(l->type), irradiance_of(stage, i),
                   murk_units_of(scene->units).irradiance);
        print_body(l, facts);
        print_taken(taken_of(stage, i, 1));
    }
}

static void add_taken(cJSON *item, const murk_stage *stage, size_t light)
{
    const int bands = stage->world.bands;
    const murk_daylight_loss taken = murk_daylight_loss_of(stage, light);
    if (!taken.is_known) {
        cJSON_AddNullToObject(item, "taken_again");
        return;
    }
    cJSON *object = cJSON_AddObjectToObject(item, "taken_again");
    murk_json_number(object, "share", taken.share);
    murk_json_numbers(object, "optical_depth", taken.optical_depth.band, bands);
    murk_json_numbers(object, "transmittance", taken.transmittance.band, bands);
}

/* Adds the table of intensities of the file: symmetries unfolded, with all
 * factors of the file, before lumens, power_w and TILT data; a list of values
 * by vertical angle for each horizontal angle. */
static void add_intensities(cJSON *item, const murk_intensity *table)
{
    const murk_intensity_angles angles = murk_intensity_angles_of(table);
    const int n = (int)angles.verticals;
    cJSON *object = cJSON_AddObjectToObject(item, "intensities");
    murk_json_numbers(object, "vertical_deg", angles.vertical_deg, n);
    murk_json_numbers(object, "horizontal_deg", angles.horizontal_deg,
                      (int)angles.horizontals);
    cJSON *planes = cJSON_AddArrayToObject(object, "candela");
    for (size_t h = 0; h < angles.horizontals; ++h) {
        cJSON *plane = cJSON_CreateArray();
        for (int v = 0; v < n; ++v) {
            cJSON_AddItemToArray(
                plane,
                cJSON_CreateNumber(murk_intensity_at_angles(
                    table, angles.vertical_deg[v], angles.horizontal_deg[h])));
        }
        cJSON_AddItemToArray(planes, plane);
    }
}

static void add_luminaire(cJSON *item, const murk_scene_light *l, size_t number,
                          size_t lamps)
{
    static const char *const shapes[] = {[MURK_APERTURE_POINT] = "point",
                                         [MURK_APERTURE_RECT] = "rect",
                                         [MURK_APERTURE_DISC] = "disc"};
    const murk_luminaire *lamp = l->luminaire;
    murk_json_number(item, "light", (double)number);
    murk_json_number(item, "lamps", (double)lamps);
    cJSON_AddStringToObject(item, "file", murk_path_name(l->file));
    cJSON_AddStringToObject(item, "format", lamp->format);
    cJSON_AddStringToObject(item, "name", lamp->name);
    cJSON_AddStringToObject(item, "photometric_type",
                            murk_luminaire_type_name(lamp->type));
    cJSON_AddStringToObject(item, "symmetry",
                            murk_luminaire_symmetry_name(lamp->symmetry));
    murk_json_number(item, "horizontal_angles", (double)lamp->horizontals);
    murk_json_number(item, "vertical_angles", (double)lamp->verticals);
    /* Not a number becomes null: flux that the file does not declare, and flux
     * of a luminaire whose watts are given. */
    murk_json_number(item, "file_lumens",
                     murk_intensity_lumens(lamp->intensity));
    murk_json_number(item, "declared_lumens", lamp->declared_lumens);
    murk_json_number(item, "max_candela",
                     murk_intensity_max_candela(lamp->intensity));
    murk_json_number(item, "lumens", l->lumens > 0 ? l->lumens : NAN);
    murk_json_number(item, "tilt_factor", l->tilt_factor);
    murk_json_number(item, "input_w", lamp->input_w);
    cJSON_AddStringToObject(item, "luminous_area", shapes[lamp->aperture]);
    murk_json_number(item, "along_c0_m", lamp->along_c0_m);
    murk_json_number(item, "along_c90_m", lamp->along_c90_m);
    murk_json_number(item, "height_m", lamp->height_m);
    add_intensities(item, lamp->intensity);
}

/* Adds "luminaires", one item for each item of the scene file; nothing if there
 * are none. */
static void add_luminaires(cJSON *lights, const murk_scene_desc *scene)
{
    cJSON *list = NULL;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const size_t lamps = lamps_of_item(scene, i);
        if (scene->lights[i].luminaire && lamps > 0) {
            list = list ? list : cJSON_AddArrayToObject(lights, "luminaires");
            add_luminaire(murk_json_item(list), &scene->lights[i], i, lamps);
        }
    }
}

void murk_overview_json_lights(cJSON *root, const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    /* All lights together, also in the units of the scene. */
    const murk_units units = murk_units_of(scene->units);
    cJSON *lights = cJSON_AddObjectToObject(root, "lights");
    murk_json_number(lights, "count",
                     (double)murk_sources_count(stage->lights));
    murk_json_number(lights, "power_w", murk_sources_power_w(stage->lights));
    if (scene->units != MURK_RADIOMETRIC) {
        char key[40];
        snprintf(key, sizeof key, "power_%s", units.suffix);
        murk_json_number(lights, key, power_of(stage, scene->units));
    }
    add_luminaires(lights, scene);
    /* Each light, with its place in the sky. */
    cJSON *list = cJSON_AddArrayToObject(lights, "sky");
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_sky_facts *facts = &stage->sky[i];
        cJSON *item = murk_json_item(list);
        murk_json_number(item, "light", (double)i);
        cJSON_AddStringToObject(item, "type",
                                murk_source_type_name(scene->lights[i].type));
        cJSON_AddBoolToObject(item, "on", facts->is_on);
        murk_json_number(item, "azimuth_deg", facts->azimuth_deg);
        murk_json_number(item, "elevation_deg", facts->elevation_deg);
        murk_json_number(item, "irradiance_w_per_m2",
                         facts->irradiance_w_per_m2);
        if (isfinite(facts->irradiance_w_per_m2)) {
            murk_json_number(item, "irradiance", irradiance_of(stage, i));
            cJSON_AddStringToObject(item, "unit", units.irradiance);
        } else {
            cJSON_AddNullToObject(item, "irradiance");
            cJSON_AddNullToObject(item, "unit");
        }
        add_taken(item, stage, i);
    }
}
