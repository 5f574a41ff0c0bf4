/* A picture of a camera of the scene: a channel as an array, and a file. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_picture *picture = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_world_create(&world, scene, &error), &error);
    const murk_picture_options options = {
        .size = sizeof options, .camera = "door", .method = MURK_METHOD_PATHS};
    const murk_image_options images = {.size = sizeof images, .png = true};
    must(murk_picture_check(world, &options, "door.exr", &images, NULL, &error),
         &error);
    /* Paths need no light; the method of maps takes that of the world. */
    must(murk_picture_render(&picture, world, NULL, &options, &error), &error);
    murk_array radiance = {.size = sizeof radiance};
    must(murk_picture_array(picture, "radiance.0", &radiance, &error), &error);
    const float *pixel = radiance.data;
    size_t bright = 0;
    for (size_t i = 0; i < radiance.shape[0] * radiance.shape[1]; ++i) {
        bright += pixel[i] > 0;
    }
    printf("%zu rows of %zu pixels, most of them bright: %s\n",
           radiance.shape[0], radiance.shape[1], bright > 384 ? "yes" : "no");
    /* Write the file, and door.png beside it. */
    const murk_fields *fields = NULL;
    double samples = 0;
    must(murk_picture_save(picture, "door.exr", &images, NULL, &fields, &error),
         &error);
    must(murk_fields_double(fields, "samples", &samples, &error), &error);
    printf("%.0f samples of each pixel\n", samples);
    murk_picture_destroy(picture);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * 24 rows of 32 pixels, most of them bright: yes
 * 4 samples of each pixel
 */
