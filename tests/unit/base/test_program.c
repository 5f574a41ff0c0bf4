/* Modules beside the library: one is loaded once, and a file that is missing or
 * lacks the object is refused in a line that names it. */
#include "base/program.h"
#include "check.h"

#include <string.h>

static void test_module_is_loaded_once(void)
{
    murk_module module = {.file = "murk-ceres.so",
                          .symbol = "murk_ceres_functions"};
    murk_error err = {0};
    const void *object = murk_module_load(&module, "here", &err);
    CHECK(object && !err.code);
    CHECK(object == module.loaded);
    CHECK(murk_module_load(&module, "here", &err) == object);
}

static void check_refused(const char *file, const char *symbol,
                          const char *text)
{
    murk_module module = {.file = file, .symbol = symbol};
    murk_error err = {0};
    CHECK(!murk_module_load(&module, "here", &err) && !module.loaded);
    CHECK(err.code == MURK_RUN_FAILED);
    CHECK_TEXT(err.where, "here");
    CHECK(strstr(err.text, text));
}

int main(void)
{
    test_module_is_loaded_once();
    check_refused("murk-none.so", "nothing", "murk-none.so is not there");
    check_refused("murk-ceres.so", "nothing", "undefined symbol: nothing");
    return check_done();
}
