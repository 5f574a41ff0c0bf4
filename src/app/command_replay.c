/* murk replay: traces one photon of a scene again, by its number, and shows
 * each event. */
#include "app/given.h"
#include "app/show.h"
#include "base/print.h"

#include <stdio.h>

#define PATH_SIZE 64 /* of "events.12.direction_out.0" and its like */

/* The path of a field of event i. */
typedef struct event_path {
    char text[PATH_SIZE];
} event_path;

static event_path path_of(size_t i, const char *name)
{
    event_path path;
    snprintf(path.text, sizeof path.text, "events.%zu.%s", i, name);
    return path;
}

static double number_of(const murk_fields *replay, size_t i, const char *name)
{
    double value = 0;
    (void)murk_fields_double(replay, path_of(i, name).text, &value, NULL);
    return value;
}

/* The text of a field of event i; "" if the event has no such field. */
static const char *text_of(const murk_fields *replay, size_t i,
                           const char *name)
{
    const char *text = "";
    (void)murk_fields_string(replay, path_of(i, name).text, &text, NULL);
    return text;
}

/* Prints a row for each event. Names may be as wide as a line, so they have
 * lines of their own. */
static void print_events(const murk_fields *replay)
{
    static const char *const column[] = {
        "position_m.0",    "position_m.1",    "position_m.2", "direction_out.0",
        "direction_out.1", "direction_out.2", "path_m"};
    static const int digits[] = {3, 3, 3, 4, 4, 4, 3},
                     width[] = {9, 9, 9, 7, 7, 7, 9};
    murk_print("event kind            x m       y m       z m  direction "
               "out            path m\n");
    const size_t n = murk_fields_length(replay, "events");
    for (size_t i = 0; i < n; ++i) {
        murk_print("%5.0f %-9s", number_of(replay, i, "number"),
                   text_of(replay, i, "kind"));
        for (size_t k = 0; k < sizeof column / sizeof *column; ++k) {
            murk_print(" %*.*f", width[k], digits[k],
                       number_of(replay, i, column[k]));
        }
        murk_print("\n");
        const char *name = text_of(replay, i, "partner"),
                   *outcome = text_of(replay, i, "outcome");
        if (*name) {
            murk_print("%6s%s%s%s\n", "", name, *outcome ? ": " : "", outcome);
        }
    }
}

murk_status murk_command_replay(const murk_options *options, murk_error *err)
{
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_given_save save = {.exports = NULL};
    const murk_fields *replay = NULL;
    if (!murk_option_text(options, "--photon")) {
        return murk_fail(err, MURK_BAD_VALUE, "", "replay needs --photon N");
    }
    /* The scene, its world, and the options of the results. */
    murk_status status = murk_given_scene(&scene, options, err);
    if (!status) {
        status = murk_world_create(&world, scene, err);
    }
    if (!status) {
        status = murk_given_save_begin(&save, options, err);
    }
    if (!status) {
        status =
            murk_world_replay(world, murk_option_number(options, "--photon", 0),
                              &save.options, &replay, err);
    }
    /* The events as JSON or as rows. */
    if (!status && options->json) {
        murk_print_json(murk_fields_json(replay));
    } else if (!status && murk_shows_summary(options)) {
        print_events(replay);
    }
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_given_save_end(&save);
    return status;
}
