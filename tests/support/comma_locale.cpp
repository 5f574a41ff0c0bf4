/* Preloaded into the program (LD_PRELOAD): a host program that has set the
 * locale MURK_TEST_LOCALE for C and C++, here one with a decimal comma. Without
 * that locale, or if it has no comma, the program ends with 77: the test would
 * show nothing. */
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <locale>
#include <unistd.h>

__attribute__((constructor)) static void set_locale()
{
    const char *name = std::getenv("MURK_TEST_LOCALE");
    if (!name) {
        return;
    }
    try {
        std::locale::global(std::locale(name));
    } catch (...) {
        _exit(77);
    }
    char shown[16];
    std::snprintf(shown, sizeof shown, "%.2f", 12.75);
    if (std::strcmp(shown, "12,75") != 0) {
        _exit(77);
    }
}
