/* Planted defects, each of which a sanitizer must report. They show that the
 * sanitized unit tests can fail (tests/sanitize/caught.sh).
 *
 *   defects overflow | leak | undefined | race */
#include <limits.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#define NUMBERS 8

/* Volatile, so that the compiler cannot see the defects and warn of them. */
static volatile int outside = NUMBERS;
static volatile int largest = INT_MAX;

static int overflow(void)
{
    int *numbers = calloc((size_t)outside, sizeof *numbers);
    if (!numbers) {
        return 0;
    }
    numbers[outside] = 1;
    const int sum = numbers[0] + numbers[1];
    free(numbers);
    return sum;
}

static int leak(void)
{
    char *volatile lost = malloc(NUMBERS);
    lost = NULL;
    return lost != NULL;
}

static int undefined(void)
{
    const int sum = largest + 1;
    return sum == 0;
}

static int shared_count;

static void *count(void *unused)
{
    (void)unused;
    for (int i = 0; i < NUMBERS; ++i) {
        ++shared_count;
    }
    return NULL;
}

static int race(void)
{
    pthread_t other;
    if (pthread_create(&other, NULL, count, NULL) == 0) {
        count(NULL);
        pthread_join(other, NULL);
    }
    return shared_count < 0;
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        int (*run)(void);
    } defects[] = {{"overflow", overflow},
                   {"leak", leak},
                   {"undefined", undefined},
                   {"race", race}};
    for (size_t i = 0; argc == 2 && i < sizeof defects / sizeof *defects; ++i) {
        if (strcmp(argv[1], defects[i].name) == 0) {
            return defects[i].run();
        }
    }
    return 0; /* caught.sh asks for a failure */
}
