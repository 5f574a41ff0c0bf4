/* Renders a picture by one of the methods: checks maps and memory beforehand,
 * adds the coverage by sensors, and warns of results that mean little. */
#include "pictures/rendering.h"

#include "base/interrupt.h"
#include "base/log.h"
#include "base/machine.h"
#include "base/progress.h"
#include "pictures/coverage.h"
#include "pictures/scene_picture.h"
#include "render/gather.h"

#include <stdio.h>

/* A warning is given if the errors of more than this share of the pixels, and
 * of at least UNSURE_MIN pixels, are unsure (render/render.h). At 16 samples
 * the window over which errors are pooled has some 50 pixels: in a smaller
 * picture errors are unsure for lack of pixels. */
#define UNSURE_SHARE 0.25
#define UNSURE_MIN   50

const murk_rendering_method murk_rendering_methods[MURK_RENDERING_METHODS] = {
    {MURK_BY_MAPS, "maps",
     "maps: shadow rays, and density estimate over later records"},
    {MURK_BY_PATHS, "path", "path: path tracing with shadow rays"},
    {MURK_BY_MAPS_ONLY, "maps-only",
     "maps-only: density estimate over all records"}};

/* ---- checks ---- */

static murk_status check_maps(const murk_rendering *r,
                              const murk_scene_desc *scene, murk_error *err)
{
    static const char *const words[] = {"both", "surface", "volume", "none"};
    const murk_scene_maps maps = scene->photons.maps;
    if (r->method->kind == MURK_BY_PATHS || maps == MURK_SCENE_MAPS_BOTH) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_BAD_VALUE, "photons.maps",
                     "%s, must be both for options->method maps", words[maps]);
}

murk_status murk_rendering_choose(murk_rendering *out,
                                  const murk_rendering_method *method,
                                  const murk_scene_desc *scene,
                                  const murk_viewpoint_request *request,
                                  murk_error *err)
{
    *out = (murk_rendering){.method = method};
    const murk_status status =
        murk_viewpoint_choose(&out->viewpoint, scene, request, err);
    return status ? status : check_maps(out, scene, err);
}

murk_status murk_rendering_check_memory(const murk_rendering *r,
                                        const murk_scene_desc *scene,
                                        const murk_image_options *images,
                                        const murk_traced *light,
                                        murk_error *err)
{
    /* The picture, its files, the coverage by sensors, and the kernels of the
     * maps. */
    const murk_camera *c = &r->viewpoint.camera;
    double wanted =
        murk_render_bytes(c->width, c->height, scene->bands, r->method->kind);
    if (images) {
        wanted += murk_images_bytes(images, c->width, c->height);
    }
    if (r->viewpoint.sensors > 0) {
        wanted += murk_picture_coverage_bytes(c->width, c->height);
    }
    double maps = 0;
    if (light) {
        maps = murk_gather_memory_for(
            (double)murk_photon_map_count(light->surface),
            (double)murk_photon_map_count(light->volume));
    }
    const double spare = murk_machine_memory_bytes();
    if (wanted + maps <= spare) {
        return MURK_OK;
    }
    /* The message names the kernels if there are any. */
    char also[64] = "";
    if (maps > 0) {
        snprintf(also, sizeof also, ", the photons' kernels %.3g GB",
                 maps * 1e-9);
    }
    return murk_fail(err, MURK_NO_MEMORY, r->viewpoint.where,
                     "pixels are %zu x %zu: the picture takes %.3g GB%s, and "
                     "%.3g GB are free",
                     c->width, c->height, wanted * 1e-9, also, spare * 1e-9);
}

/* ---- warnings ---- */

/* Warns if a map has fewer than MURK_GATHER_FEW records with kernels in a band;
 * the message names the map and band with the fewest. A band without such
 * records in a map is no reason for a warning: the scene has no medium, or
 * nothing that scatters or reflects light of the band. */
static void warn_of_few_records(const murk_rendering *r, const double *band_nm)
{
    const murk_image *p = r->image;
    size_t few = MURK_GATHER_FEW, others = 0;
    int band = 0, map = 0;
    /* Find the map and band with the fewest records. */
    for (int m = 0; m < 2; ++m) {
        for (int b = 0; b < p->bands; ++b) {
            const size_t n = p->records[m][b];
            others += n > 0 && n < MURK_GATHER_FEW;
            if (n > 0 && n < few) {
                few = n;
                band = b;
                map = m;
            }
        }
    }
    if (others > 0) {
        char also[48] = "";
        if (others > 1) {
            snprintf(also, sizeof also, " (and %zu more like it)", others - 1);
        }
        murk_warn("photons",
                  "%zu record%s of %.7g nm count%s in the %s map%s, fewer than "
                  "%d: their kernels mean little; emit more photons",
                  few, few == 1 ? "" : "s", band_nm[band], few == 1 ? "s" : "",
                  map ? "volume" : "surface", also, MURK_GATHER_FEW);
    }
}

/* Warns if the errors of many pixels follow from a few bright paths. Such
 * errors are right in the mean over the picture, but not for each pixel. */
static void warn_of_unsure_errors(const murk_rendering *r)
{
    const murk_image *p = r->image;
    const double share =
        (double)p->unsure / ((double)p->width * (double)p->height);
    if (share > UNSURE_SHARE && p->unsure >= UNSURE_MIN) {
        murk_warn("samples",
                  "the errors of %.0f %% of the pixels rest on a few bright "
                  "paths: they hold in the mean, not for one pixel; take more "
                  "than %zu samples, or options->method maps",
                  100 * share, r->viewpoint.samples);
    }
}

/* ---- the picture ---- */

murk_status murk_rendering_run(murk_rendering *r, const murk_stage *stage,
                               const murk_traced *light, unsigned threads,
                               murk_error *err)
{
    const murk_trace trace = murk_stage_trace(stage);
    murk_render render = murk_render_of_stage(
        stage, &trace, r->viewpoint.camera, light, threads);
    render.samples = r->viewpoint.samples;
    render.method = r->method->kind;
    /* Render, then add the coverage by sensors. */
    const double begun_s = murk_clock_s();
    murk_status status = murk_render_run(&r->image, &render, err);
    if (!status && r->viewpoint.sensors > 0 && !murk_interrupted()) {
        status =
            murk_picture_cover(r->image, &r->viewpoint, stage, threads, err);
    }
    r->render_s = murk_clock_s() - begun_s;
    status = status ? status : murk_interrupt_check(err);
    if (!status) {
        warn_of_few_records(r, stage->scene->band_nm);
        warn_of_unsure_errors(r);
    }
    return status;
}

void murk_rendering_release(murk_rendering *rendering)
{
    murk_image_destroy(rendering->image);
    *rendering = (murk_rendering){0};
}
