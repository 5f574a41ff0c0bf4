/* Ranges of free keys from the key table (scene/keys.h) and from the words of
 * presets. */
#include "calibrate/key_range.h"

#include "preset/check_words.h"
#include "scene/presets.h"

#include <math.h>
#include <string.h>

/* Limits of the key table from this size on only catch typing errors. */
#define SLIP_OF_THE_PEN 1e9
#define OFF_THE_END     1e-3 /* distance from a limit that may not be reached */

/* A key whose range is 0 to at least this value is a scale: relative changes
 * matter. Albedo, index of refraction, temperature and wind are not scales. */
#define SCALE_FROM 1000

static void from_row(murk_key_range *out, const murk_key *row)
{
    const bool is_any = row->min == 0 && row->max == 0;
    out->lower = is_any || row->min <= -SLIP_OF_THE_PEN ? -INFINITY : row->min;
    out->upper = is_any || row->max >= SLIP_OF_THE_PEN ? INFINITY : row->max;
    out->is_log = !is_any && row->min >= 0 && row->max >= SCALE_FROM;
    if (row->above && !out->is_log) {
        out->lower += OFF_THE_END;
    }
    if (row->below) {
        out->upper -= OFF_THE_END;
    }
}

/* Narrows the range by that of the preset, which knows the words that it uses.
 */
static murk_status from_preset(murk_key_range *out, const murk_key_place *place,
                               const char *name, const char *where,
                               murk_error *err)
{
    /* Only words of a medium with a preset. */
    const int word = murk_word_find(name);
    const murk_yaml *preset =
        place->medium ? murk_yaml_get(place->medium, "preset") : NULL;
    murk_preset *read = NULL;
    if (word < 0 || !preset || preset->kind != MURK_YAML_SCALAR) {
        return MURK_OK;
    }
    /* Read the preset. */
    const murk_status status =
        murk_presets_read(&read, preset->text, where, err);
    if (status) {
        return status;
    }
    const murk_preset_word range =
        murk_preset_word_of(read, (murk_word_id)word);
    const size_t k = place->list ? place->index : 0;
    if (range.is_known && k < MURK_WORD_NUMBERS_MAX) {
        out->lower = fmax(out->lower, range.min[k]);
        out->upper = fmin(out->upper, range.max[k]);
    }
    murk_preset_destroy(read);
    return MURK_OK;
}

/* The last part of the path is the name of the key. */
murk_status murk_key_range_of(murk_key_range *out, const murk_key_place *place,
                              const char *path, const char *where,
                              murk_error *err)
{
    char name[64] = "";
    size_t end = place->put, start = end;
    while (start > 0 && path[start - 1] != '.') {
        --start;
    }
    if (end - start < sizeof name) {
        memcpy(name, path + start, end - start);
    }
    from_row(out, place->item ? place->item : place->row);
    out->is_log = out->is_log && place->value > 0;
    return from_preset(out, place, name, where, err);
}
