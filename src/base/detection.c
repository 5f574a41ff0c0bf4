/* The table of the modes of detection, made from the list in the header. */
#include "base/detection.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *name;
    unsigned properties;
} ROWS[MURK_DETECTIONS_COUNT] = {
#define ROW(id, name, is) [MURK_DETECTION_##id] = {name, is},
    MURK_DETECTIONS(ROW)};

const char *murk_detection_name(murk_detection detection)
{
    return ROWS[detection].name;
}

bool murk_detection_is(murk_detection detection, unsigned properties)
{
    return (ROWS[detection].properties & properties) == properties;
}

murk_detection_text murk_detection_list(unsigned property, bool has,
                                        const char *separator)
{
    murk_detection_text out = {""};
    for (int i = 0; i < MURK_DETECTIONS_COUNT; ++i) {
        const size_t length = strlen(out.text);
        if (murk_detection_is((murk_detection)i, property) == has) {
            snprintf(out.text + length, sizeof out.text - length, "%s%s",
                     length ? separator : "", ROWS[i].name);
        }
    }
    return out;
}
