/* Reads and checks the options of pictures and of their files. */
#include "api/picture_options.h"

#include <math.h>

/* The largest absolute value of the exposure of a PNG [stops], as of the option
 * --exposure. */
#define EXPOSURE_MAX 100

/* Checks that both sides are given or none, and that they and the samples are
 * within their ranges. */
static murk_status check_numbers(const murk_picture_options *all,
                                 murk_error *err)
{
    const bool has_none = all->width == 0 && all->height == 0;
    const bool are_sides =
        all->width - 1 < MURK_PICTURE_SIDE_MAX &&
        all->height - 1 < MURK_PICTURE_SIDE_MAX &&
        (uint64_t)all->width * all->height <= MURK_PIXELS_MAX;
    if (!has_none && !are_sides) {
        return murk_call_bad_argument(
            err, "options",
            "width x height is %zu x %zu, must be 0 x 0, or each 1..%d and "
            "%llu pixels together at most",
            all->width, all->height, MURK_PICTURE_SIDE_MAX,
            (unsigned long long)MURK_PIXELS_MAX);
    }
    return all->samples <= MURK_SAMPLES_MAX
               ? MURK_OK
               : murk_call_bad_argument(
                     err, "options", "samples is %llu, must be 0..%d",
                     (unsigned long long)all->samples, MURK_SAMPLES_MAX);
}

murk_status murk_picture_options_read(murk_viewpoint_request *request,
                                      const murk_rendering_method **method,
                                      const murk_world *world,
                                      const murk_picture_options *options,
                                      murk_error *err)
{
    murk_picture_options all = {0};
    murk_status status = murk_options_copy(&all, sizeof all, options, "options",
                                           "murk_picture_options", err);
    if (!status) {
        status = check_numbers(&all, err);
    }
    if (status) {
        return status;
    }
    /* The method, and sensors that fit the world. */
    if ((unsigned)all.method >= MURK_RENDERING_METHODS) {
        return murk_call_bad_argument(
            err, "options", "method is %d, must be 0..%d", (int)all.method,
            MURK_RENDERING_METHODS - 1);
    }
    if (all.sensors && all.sensors->world != world) {
        return murk_call_bad_argument(err, "options",
                                      "sensors are of another world");
    }
    if (all.sensors && all.sensors->n == 0) {
        return murk_call_bad_argument(err, "options",
                                      "sensors are an empty list, must be 1 "
                                      "or more");
    }
    *method = &murk_rendering_methods[all.method];
    *request = (murk_viewpoint_request){.camera = all.camera,
                                        .from_sensor = all.from_sensor,
                                        .pixels = {all.width, all.height},
                                        .samples = all.samples};
    if (all.sensors) {
        request->sensor = all.sensors->pose;
        request->sensors = all.sensors->n;
        request->sensors_file = all.sensors->path;
    }
    return MURK_OK;
}

murk_status murk_image_options_read(murk_image_options *all,
                                    const murk_image_options *images,
                                    murk_error *err)
{
    *all = (murk_image_options){0};
    const murk_status status = murk_options_copy(
        all, sizeof *all, images, "png", "murk_image_options", err);
    if (status) {
        return status;
    }
    if (all->has_exposure && !(fabs(all->exposure_stops) <= EXPOSURE_MAX)) {
        return murk_call_bad_argument(
            err, "png", "exposure_stops is %g, must be %d..%d",
            all->exposure_stops, -EXPOSURE_MAX, EXPOSURE_MAX);
    }
    if ((unsigned)all->scale > MURK_SCALE_LOG) {
        return murk_call_bad_argument(err, "png", "scale is %d, must be 0..%d",
                                      (int)all->scale, (int)MURK_SCALE_LOG);
    }
    /* The range must ascend, and a logarithm needs values above 0. */
    const double low = all->range[0], high = all->range[1];
    const bool ascends = isfinite(low) && isfinite(high) && low < high;
    const bool is_log = all->scale == MURK_SCALE_LOG;
    return all->has_range && (!ascends || (is_log && !(low > 0)))
               ? murk_call_bad_argument(
                     err, "png",
                     "range is %g to %g, must be two numbers, the first less "
                     "than the second%s",
                     low, high, is_log ? " and above 0" : "")
               : MURK_OK;
}
