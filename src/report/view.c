/* The view in space of the report: its section. */
#include "report/html.h"
#include "report/scene.h"
#include "report/view_data.h"

#include <math.h>

static void write_switch(FILE *to, const char *value, const char *text,
                         bool is_on)
{
    fprintf(to, "<label><input type=\"checkbox\" value=\"%s\"%s> %s</label>\n",
            value, is_on ? " checked" : "", text);
}

static bool any_photons(const murk_report_scene *s, bool in_volume)
{
    for (size_t i = 0; i < s->states; ++i) {
        const murk_plan_points *points = &s->state[i].points;
        /* surface photons are first */
        if (points->n > 0 &&
            points->point[in_volume ? points->n - 1 : 0].is_volume ==
                in_volume) {
            return true;
        }
    }
    return false;
}

static bool any_sensors(const murk_report_scene *s)
{
    for (size_t i = 0; i < s->states; ++i) {
        if (s->state[i].sensors > 0) {
            return true;
        }
    }
    return false;
}

static bool any_surfaces(const murk_report_scene *s)
{
    const murk_surfaces_facts facts =
        s->stage ? murk_surfaces_describe(s->stage->surfaces)
                 : (murk_surfaces_facts){0};
    return facts.triangles + facts.spheres > 0;
}

/* Sky and air have no place. */
static bool has_targets(const murk_report_scene *s)
{
    return s->scene && s->scene->placement.targets.given;
}

const char *murk_report_point_name(const murk_report_scene *scene)
{
    return has_targets(scene) ? "target" : "stored photon";
}

static bool any_lamps(const murk_scene_desc *scene)
{
    for (size_t i = 0; scene && i < scene->n_lights; ++i) {
        if (murk_source_type_group(scene->lights[i].type) != MURK_SOURCE_DOME) {
            return true;
        }
    }
    return false;
}

static void write_media_switches(FILE *to, const murk_view_data *data)
{
    bool is_there = false, is_uneven = false;
    for (size_t i = 0; i < data->medias; ++i) {
        const murk_view_media *m = &data->media[i];
        is_there = is_there || m->cell;
        is_uneven = is_uneven || (m->cell && !m->is_even);
    }
    if (is_there) {
        /* an even one says little beside what else there is */
        const bool is_all = !any_surfaces(data->scene) &&
                            !any_photons(data->scene, false) &&
                            !any_photons(data->scene, true);
        write_switch(to, "cloud", "media as a cloud", is_uneven || is_all);
        write_switch(to, "level", "media where their extinction is", false);
        fputs("<label><input type=\"range\" aria-label=\"extinction\" "
              "id=\"view-level\" min=\"2\" "
              "max=\"98\" step=\"2\" value=\"50\"> "
              "<output id=\"view-level-said\"></output></label>\n",
              to);
    }
}

/* Only what there is something of. */
static void write_switches(FILE *to, const murk_view_data *data)
{
    const murk_report_scene *s = data->scene;
    fputs("<fieldset class=\"switches\"><legend>Shown</legend>\n", to);
    if (any_surfaces(s)) {
        write_switch(to, "surfaces", "surfaces", true);
    }
    if (any_photons(s, false)) {
        write_switch(to, "surface-photons",
                     has_targets(s) ? "targets on surfaces"
                                    : "photons on surfaces",
                     true);
    }
    if (any_photons(s, true)) {
        write_switch(to, "volume-photons",
                     has_targets(s) ? "targets in the volume"
                                    : "photons in media",
                     true);
    }
    if (any_sensors(s)) {
        write_switch(to, "sensors", "sensors", true);
        write_switch(to, "ranges", "ranges and views", true);
    }
    if (any_lamps(s->scene)) {
        write_switch(to, "lamps", "lamps and sun", true);
    }
    if (s->stops > 0) {
        write_switch(to, "path", "the path", true);
    }
    if (s->readings > 0) {
        write_switch(to, "readings", "readings", true);
    }
    write_switch(to, "axes", "axes in metres", true);
    write_media_switches(to, data);
    fputs("</fieldset>\n", to);
}

static void write_choices(FILE *to, const murk_report_scene *s)
{
    fputs("<div class=\"switches\">\n", to);
    if (s->states > 1) {
        fputs("<label>shown for <select id=\"view-state\">", to);
        for (size_t i = 0; i < s->states; ++i) {
            fprintf(to, "<option value=\"%zu\">", i);
            murk_page_text(to, s->state[i].name);
            fputs("</option>", to);
        }
        fputs("</select></label>\n", to);
    }
    if (any_sensors(s)) { /* the script fills it */
        fputs("<label>picked sensor <select id=\"view-sensor\">"
              "</select></label>\n",
              to);
    }
    fputs("<button type=\"button\" value=\"corner\">from a corner</button>\n"
          "<button type=\"button\" value=\"above\">from above</button>\n"
          "<button type=\"button\" value=\"side\">from the side</button>\n"
          "<button type=\"button\" value=\"nearer\" aria-label=\"nearer\">+"
          "</button>\n"
          "<button type=\"button\" value=\"farther\" aria-label=\"farther\">"
          "\xe2\x88\x92</button>\n"
          "</div>\n",
          to);
}

/* ---- notes ---- */

static void note_photons(FILE *to, const murk_report_scene *s)
{
    unsigned long long stored = 0, shown = 0;
    for (size_t i = 0; i < s->states; ++i) {
        stored += s->state[i].points.photons;
        shown += s->state[i].points.n;
    }
    if (shown < stored) {
        fprintf(to, "Of %llu %ss%s %llu are here, evenly chosen. ", stored,
                murk_report_point_name(s),
                s->states > 1 ? " of all conditions" : "", shown);
    }
    if (s->states < s->states_asked) {
        fprintf(to, "The first %zu of %zu plans can be chosen. ", s->states,
                s->states_asked);
    }
}

static void note_media(FILE *to, const murk_view_data *data)
{
    double max = 0;
    for (size_t i = 0; i < data->medias; ++i) {
        max = fmax(max, data->media[i].max_per_m);
    }
    if (max > 0) {
        fputs("Media: extinction in the first band, at most ", to);
        murk_page_number(to, max);
        fputs(" per m; cells are coarser than in the simulation. ", to);
    }
}

static void write_notes(FILE *to, const murk_view_data *data)
{
    fputs("<p class=\"note\">", to);
    note_photons(to, data->scene);
    if (data->mesh.is_coarse) {
        fprintf(to,
                "Of %zu triangles %zu are shown: surfaces are coarser here "
                "than in the simulation. ",
                data->mesh.asked, data->mesh.triangles);
    }
    note_media(to, data);
    const murk_stage *stage = data->scene->stage;
    const bool has_sensors = any_sensors(data->scene);
    if (has_sensors && stage && stage->world.domain.is_periodic) {
        fputs("The scene repeats at its sides in x and y: what a sensor sees "
              "across a side is drawn where it lies in here. ",
              to);
    }
    if (data->scene->is_study) {
        fputs("Surfaces, lamps and media are those of the study's base scene. ",
              to);
    }
    fprintf(to,
            "<span class=\"interactive\">Drag to turn, scroll to go nearer, "
            "with two fingers or the right button to move. With the picture in "
            "focus: arrow keys turn, + and \xe2\x88\x92 go nearer and away%s."
            "</span></p>\n",
            has_sensors ? ", N and P pick the next and previous sensor, Escape "
                          "none"
                        : "");
}

/* ---- the section ---- */

static murk_status write_section(FILE *to, const murk_view_data *data,
                                 murk_error *err)
{
    fputs("<div id=\"view\" hidden>\n<div class=\"interactive\">\n", to);
    write_choices(to, data->scene);
    write_switches(to, data);
    fputs("</div>\n<canvas id=\"view-canvas\" tabindex=\"0\" role=\"img\" "
          "aria-label=\"The scene in space; the drawings and tables say the "
          "same\"></canvas>\n"
          "<p class=\"legend\" id=\"view-key\"></p>\n"
          "<p class=\"picked\" id=\"view-picked\" role=\"status\"></p>\n",
          to);
    write_notes(to, data);
    fputs("</div>\n", to);
    return murk_view_data_write(to, data, err);
}

murk_status murk_report_view(FILE *to, const murk_report_scene *scene,
                             murk_error *err)
{
    murk_view_data data = {0};
    if (!murk_report_has_view(scene)) {
        return MURK_OK;
    }
    murk_status status = murk_view_data_make(&data, scene, err);
    if (!status) {
        status = write_section(to, &data, err);
    }
    murk_view_data_release(&data);
    return status;
}
