// murk.h in C++17: the header is included, linked and used.
#include <murk.h>

#include <cstdio>
#include <cstring>
#include <memory>

int main()
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = nullptr;
    if (murk_context_create(&context, nullptr, &error)) {
        std::fprintf(stderr, "%s\n", error.text);
        return 1;
    }
    std::unique_ptr<murk_context, void (*)(murk_context *)> owner(
        context, murk_context_destroy);
    murk_scene *scene = nullptr;
    if (murk_scene_create(&scene, context, &error)) {
        return 1;
    }
    std::unique_ptr<murk_scene, void (*)(murk_scene *)> scene_owner(
        scene, murk_scene_destroy);
    /* An empty scene has no lights, which the check says. */
    const bool is_refused = murk_scene_check(scene, &error) == MURK_BAD_VALUE &&
                            std::strstr(error.text, "lights");
    return is_refused ? 0 : 1;
}
