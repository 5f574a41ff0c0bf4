/* Two contexts in two threads: each receives its own messages and none of the
 * other, also those that threads of the library write. */
#include "check.h"
#include "murk.h"

#include <pthread.h>
#include <stdatomic.h>

#define ROUNDS 8

/* A thread with a context, whose scene has a name that its warnings contain. */
typedef struct side {
    const char *name, *seed, *of_other;
    murk_context *context;
    _Atomic int own, foreign;
    int failed; /* calls; CHECK() counts in variables that threads share */
} side;

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry: [{rect: {corner_m: [0, 0, 0], edge1_m: [4, 0, 0], "
    "edge2_m: [0, 4, 0]}}]\n"
    "materials: {default: {diffuse: 0.5}}\n"
    "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n"
    "photons: {emit: 2000}\n";

static void hear(void *user, bool is_warning, const char *where,
                 const char *text)
{
    side *s = user;
    (void)is_warning;
    const bool is_foreign =
        strstr(where, s->of_other) || strstr(text, s->of_other);
    s->own += !is_foreign;
    s->foreign += is_foreign;
}

static void *work(void *user)
{
    side *s = user;
    for (int i = 0; i < ROUNDS; ++i) {
        murk_scene *scene = NULL;
        murk_world *world = NULL;
        murk_light *light = NULL;
        s->failed +=
            !!murk_scene_parse(&scene, s->context, scene_text, s->name, NULL);
        s->failed += !!murk_scene_set(scene, "seed", s->seed, NULL);
        s->failed += !!murk_world_create(&world, scene, NULL);
        s->failed += !!murk_light_trace(&light, world, NULL);
        murk_light_destroy(light);
        murk_world_destroy(world);
        murk_scene_destroy(scene);
    }
    return NULL;
}

int main(void)
{
    static side sides[2] = {{.name = "west", .seed = "1", .of_other = "east"},
                            {.name = "east", .seed = "2", .of_other = "west"}};
    pthread_t thread[2];
    for (int i = 0; i < 2; ++i) {
        const murk_context_options options = {.size = sizeof options,
                                              .threads = 2,
                                              .log = hear,
                                              .user = &sides[i]};
        CHECK(!murk_context_create(&sides[i].context, &options, NULL));
        CHECK(pthread_create(&thread[i], NULL, work, &sides[i]) == 0);
    }
    for (int i = 0; i < 2; ++i) {
        pthread_join(thread[i], NULL);
        /* The warning of light that escapes names the scene. */
        CHECK(sides[i].own >= ROUNDS && sides[i].foreign == 0);
        CHECK(sides[i].failed == 0);
        murk_context_destroy(sides[i].context);
    }
    return check_done();
}
