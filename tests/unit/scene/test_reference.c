/* The reference (doc/reference) and the table of keys say the same: every key
 * with the values that it takes and its default; and the example of a scene is
 * one. Nothing here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "reference.h"
#include "scene/keys.h"
#include "scene/value.h"
#include "scene_files.h"

static char *reference;

/* A line of the text that begins so and holds that part. */
static bool has_line(const char *begin, const char *part)
{
    for (const char *at = reference; (at = strstr(at, begin)); ++at) {
        const size_t length = strcspn(at, "\n");
        const char *found = strstr(at, part);
        if ((at == reference || at[-1] == '\n') && found &&
            found < at + length) {
            return true;
        }
    }
    return false;
}

static void check_keys(const murk_keys *keys)
{
    for (const murk_key *key = keys->key; key->name; ++key) {
        char begin[400], part[64], allowed[MURK_ALLOWED_SIZE];
        murk_value_allowed(key, allowed);
        snprintf(begin, sizeof begin, "| `%s` | %s | ", key->name, allowed);
        snprintf(part, sizeof part, key->preset ? " | `%s` | " : "%s",
                 key->preset ? key->preset : "");
        const bool is_said = has_line(begin, part);
        if (!is_said) {
            printf("%s of a %s is not in the reference as it is\n", key->name,
                   keys->noun);
        }
        CHECK(is_said);
        if (key->keys) {
            check_keys(key->keys);
        }
    }
}

static void test_the_example_is_a_scene(void)
{
    const char *fence = strstr(reference, "```yaml\nmurk: 1\n");
    const char *end = fence ? strstr(fence + 8, "```") : NULL;
    CHECK(end != NULL);
    if (!end) {
        return;
    }
    murk_scene_desc *scene = NULL;
    murk_error err = {0};
    write_bytes("fog.yaml", fence + 8, (size_t)(end - fence - 8));
    CHECK(murk_scene_desc_read(&scene, "fog.yaml", NULL, 0, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    murk_scene_desc_destroy(scene);
}

int main(void)
{
    reference = reference_read();
    if (!reference) {
        return check_done();
    }
    check_keys(&murk_scene_keys);
    CHECK(!has_line("| `seed` | a whole number, 0..5 | ", "")); /* teeth */
    if (folder_enter()) {
        test_the_example_is_a_scene();
        folder_leave((const char *const[]){"fog.yaml", NULL});
    }
    free(reference);
    return check_done();
}
