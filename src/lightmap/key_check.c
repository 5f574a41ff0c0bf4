/* Compares what a file with light belongs to with the scene
 * (lightmap/key_check.h). */
#include "lightmap/key_check.h"

#include <string.h>

/* Length of the line at `text`, within [text, end). */
static int line_length(const char *text, const char *end)
{
    const char *newline = memchr(text, '\n', (size_t)(end - text));
    return (int)((newline ? newline : end) - text);
}

murk_status murk_lightmap_check_text(const murk_section *section,
                                     const char *text, const char *what,
                                     const char *path, murk_error *err)
{
    const char *a = section->bytes, *b = text;
    const char *a_end = a + section->size, *b_end = b + strlen(b);
    while (a < a_end || b < b_end) {
        const int a_length = a < a_end ? line_length(a, a_end) : 0;
        const int b_length = b < b_end ? line_length(b, b_end) : 0;
        if (a_length != b_length || memcmp(a, b, (size_t)a_length) != 0) {
            return murk_fail(err, MURK_BAD_VALUE, path,
                             "made for another %s: it has \"%.*s\", the "
                             "scene has \"%.*s\"",
                             what, a_length, a, b_length, b);
        }
        a += a_length + (a + a_length < a_end);
        b += b_length + (b + b_length < b_end);
    }
    return MURK_OK;
}

murk_status murk_lightmap_check_origin(const murk_section *origin,
                                       const murk_scene_desc *scene,
                                       const char *path, murk_error *err)
{
    murk_vec3 of = {0, 0, 0};
    const murk_vec3 due = scene->origin;
    if (origin && origin->size == sizeof of) {
        memcpy(&of, origin->bytes, sizeof of);
    }
    if (of.x == due.x && of.y == due.y && of.z == due.z) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_BAD_VALUE, path,
                     "its positions count from [%.12g, %.12g, %.12g] m, the "
                     "scene is computed about [%.12g, %.12g, %.12g] m: give "
                     "the scene a domain, or trace its light again",
                     of.x, of.y, of.z, due.x, due.y, due.z);
}
