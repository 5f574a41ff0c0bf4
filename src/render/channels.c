/* The table of channels of a picture: names as in OpenEXR files, titles and
 * units, and the search for a channel by the names that users write. */
#include "render/channels.h"

#include <stdio.h>
#include <string.h>

typedef struct filling {
    murk_channel *list;
    size_t n;
} filling;

static void add(filling *f, const char *name, const char *title,
                const char *unit, murk_channel_kind kind, const float *value)
{
    murk_channel *c = &f->list[f->n++];
    snprintf(c->name, sizeof c->name, "%s", name);
    snprintf(c->title, sizeof c->title, "%s", title);
    c->unit = unit;
    c->kind = kind;
    c->value = value;
}

/* Names a channel of a band: "S0.550nm", "S0.414,5nm"; a point would end the
 * name of the layer. */
static void name_band(char name[MURK_CHANNEL_NAME_SIZE], const char *layer,
                      double nm)
{
    snprintf(name, MURK_CHANNEL_NAME_SIZE, "%s.%.7gnm", layer, nm);
    char *point = strchr(name + strlen(layer) + 1, '.');
    if (point) {
        *point = ',';
    }
}

static void add_of_band(filling *f, const char *layer, const char *title,
                        murk_channel_kind kind, double nm, const float *value)
{
    char name[MURK_CHANNEL_NAME_SIZE], full[MURK_CHANNEL_NAME_SIZE];
    name_band(name, layer, nm);
    snprintf(full, sizeof full, "%s at %.7g nm", title, nm);
    add(f, name, full, kind == MURK_CHANNEL_DEPTH ? "" : "W/m2/sr", kind,
        value);
}

static void add_band(filling *f, const murk_image *p, int b, double nm)
{
    add_of_band(f, "S0", "radiance", MURK_CHANNEL_RADIANCE, nm,
                p ? p->radiance[b] : NULL);
    add_of_band(f, "error", "standard error", MURK_CHANNEL_RADIANCE, nm,
                p ? p->error[b] : NULL);
    add_of_band(f, "surface", "radiance of surfaces", MURK_CHANNEL_RADIANCE, nm,
                p ? p->surface[b] : NULL);
    add_of_band(f, "volume", "radiance of media", MURK_CHANNEL_RADIANCE, nm,
                p ? p->volume[b] : NULL);
    add_of_band(f, "depth", "optical depth", MURK_CHANNEL_DEPTH, nm,
                p ? p->depth[b] : NULL);
}

size_t murk_channels_list(const murk_image *p, int bands, const double *band_nm,
                          bool has_coverage, murk_channel *list)
{
    /* The three colours, their errors and the three coordinates have a row
     * each. */
    static const struct {
        const char *colour, *colour_title, *error, *error_title, *axis,
            *axis_title;
    } of[3] = {{"R", "red", "error.R", "standard error of red", "P.X", "x"},
               {"G", "green", "error.G", "standard error of green", "P.Y", "y"},
               {"B", "blue", "error.B", "standard error of blue", "P.Z", "z"}};
    filling f = {list, 0};
    for (int k = 0; k < 3; ++k) {
        add(&f, of[k].colour, of[k].colour_title, "W/m2/sr",
            MURK_CHANNEL_RADIANCE, p ? p->rgb[k] : NULL);
        add(&f, of[k].error, of[k].error_title, "W/m2/sr",
            MURK_CHANNEL_RADIANCE, p ? p->rgb_error[k] : NULL);
        add(&f, of[k].axis, of[k].axis_title, "m", MURK_CHANNEL_LENGTH,
            p ? p->position[k] : NULL);
    }
    /* The distance, the channels of each band, and the coverage. */
    add(&f, "Z", "distance", "m", MURK_CHANNEL_LENGTH,
        p ? p->distance_m : NULL);
    for (int b = 0; b < bands; ++b) {
        add_band(&f, p, b, band_nm[b]);
    }
    if (has_coverage) {
        add(&f, "coverage.count", "sensors that see it", "", MURK_CHANNEL_COUNT,
            p ? p->seen_by : NULL);
        add(&f, "coverage.clarity", "clearest view", "", MURK_CHANNEL_CLARITY,
            p ? p->clarity : NULL);
    }
    return f.n;
}

int murk_channels_clash(int bands, const double *band_nm)
{
    char name[2][MURK_CHANNEL_NAME_SIZE];
    for (int b = 0; b + 1 < bands; ++b) {
        name_band(name[0], "S0", band_nm[b]);
        name_band(name[1], "S0", band_nm[b + 1]);
        if (strcmp(name[0], name[1]) == 0) {
            return b;
        }
    }
    return -1;
}

/* Normalises a name: "radiance" to S0, a point within the wavelength to a
 * comma. */
static void put_straight(char out[MURK_CHANNEL_NAME_SIZE], const char *wanted)
{
    static const char word[] = "radiance";
    const size_t length = sizeof word - 1;
    const bool is_word = strncmp(wanted, word, length) == 0 &&
                         (!wanted[length] || wanted[length] == '.');
    snprintf(out, MURK_CHANNEL_NAME_SIZE, "%s%s", is_word ? "S0" : "",
             wanted + (is_word ? length : 0));
    char *point = strchr(out, '.');
    while (point && (point = strchr(point + 1, '.'))) {
        *point = ',';
    }
}

const murk_channel *murk_channel_find(const murk_channel *list, size_t n,
                                      const char *wanted)
{
    char name[MURK_CHANNEL_NAME_SIZE];
    put_straight(name, wanted);
    const size_t length = strlen(name);
    const murk_channel *found = NULL;
    size_t of_layer = 0;
    for (size_t i = 0; i < n; ++i) {
        if (strcmp(list[i].name, name) == 0) {
            return &list[i];
        }
        /* channels such as error.R belong to no layer of bands */
        if (strncmp(list[i].name, name, length) == 0 &&
            list[i].name[length] == '.' && strstr(list[i].name, "nm")) {
            found = &list[i];
            ++of_layer;
        }
    }
    return of_layer == 1 ? found : NULL;
}
