/* The version of the library, and the texts of status codes. */
#include "example.h"

int main(void)
{
    int major = 0, minor = 0;
    sscanf(murk_version(), "%d.%d", &major, &minor);
    const bool is_older =
        major < MURK_VERSION_MAJOR ||
        (major == MURK_VERSION_MAJOR && minor < MURK_VERSION_MINOR);
    printf("the library is older than the header: %s\n",
           is_older ? "yes" : "no");
    printf("%s\n", murk_status_text(MURK_BAD_FILE));
    printf("%s\n", murk_status_text((murk_status)99));
    return 0;
}

/* Prints:
 *
 * the library is older than the header: no
 * a file is missing or malformed
 * unknown status
 */
