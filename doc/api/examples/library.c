/* The version of the library, and the texts of status codes. */
#include "example.h"

#include <string.h>

int main(void)
{
    const int major = atoi(murk_version());
    printf("the library fits the header: %s\n",
           major == MURK_VERSION_MAJOR ? "yes" : "no");
    printf("%s\n", murk_status_text(MURK_BAD_FILE));
    printf("%s\n", murk_status_text((murk_status)99));
    return 0;
}

/* Prints:
 *
 * the library fits the header: yes
 * a file is missing or malformed
 * unknown status
 */
