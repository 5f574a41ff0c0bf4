/* Photometric files with numbers lost, doubled or swapped, cut off, with bytes
 * changed, and noise: all that are not whole are refused in one line that names
 * the file, and all that are read are read as an independent plain reader reads
 * them. Deterministic. Argument: the number of files with changed bytes (1,000;
 * at night 100,000). */
#include "base/log.h"
#include "base/number.h"
#include "base/progress.h"
#include "base/rng.h"
#include "broken.h"
#include "check.h"
#include "luminaire/photometric_file.h"

#include <stdlib.h>

#define TEXT_MAX  4000
#define WORDS_MAX 400

static const char IES[] =
    "IESNA:LM-63-2002\n[TEST] 7\n[LUMINAIRE] Made up\nTILT=NONE\n"
    "2 900 1.5 4 3 1 2 .3 .6 .05\n.9 1 40\n0 25 60 90\n0 45 90\n"
    "100 80 30 1\n100 70 45 2\n100 99 12 3\n";

static const char TILTED[] =
    "A label\nanother label\nTILT=INCLUDE\n1\n3\n0 45 90\n1 .9 .8\n"
    "1 -1 2 3 2 2 1 -.5 0 0\n1 .95 60\n-90 0 90\n0 90\n1 40 7\n3 60 9\n";

static const char LDT[] =
    "Maker\n1\n2\n8\n45\n3\n45\nreport\nlamp\nnumber\nfile\ndate\n600\n300\n100"
    "\n500\n0\n10\n10\n10\n10\n99.5\n80\n1.1\n0\n1\n2\nLED\n1500\nwhite\n80\n22"
    "\n.1\n.2\n.3\n.4\n.5\n.6\n.7\n.8\n.85\n.9\n0\n45\n90\n135\n180\n225\n270\n"
    "315\n0\n45\n90\n100\n50\n5\n100\n60\n6\n100\n70\n7\n100\n80\n8\n100\n90\n9"
    "\n";

static const char *const FILES[] = {IES, TILTED, LDT};
static const char *const NAMES[] = {"a.ies", "b.ies", "c.ldt"};
enum { N_FILES = 3 };

static int read_well, refused;

/* ---- the plain reader of LM-63 ---- */

/* Checks the table of a file that was read against the words of the text: all
 * of them count, and each intensity is that at the angles of the file. */
static void check_table(const murk_luminaire *lamp, char *text)
{
    double word[WORDS_MAX];
    size_t n = 0;
    char *rest = NULL;
    for (char *w = strtok_r(text, " \t\r\n\v\f,", &rest); w && n < WORDS_MAX;
         w = strtok_r(NULL, " \t\r\n\v\f,", &rest)) {
        CHECK(murk_number_parse(w, &word[n]));
        ++n;
    }
    CHECK(n > 13 && n < WORDS_MAX);
    const size_t verticals = (size_t)word[3], planes = (size_t)word[4];
    CHECK(n == 13 + verticals + planes + verticals * planes);
    const double scale = word[2] * word[10] * word[11];
    const double *v = word + 13, *h = v + verticals, *cd = h + planes;
    for (size_t p = 0; p < planes; ++p) {
        for (size_t i = 0; i < verticals; ++i) {
            const double want = scale * cd[p * verticals + i];
            const double got =
                murk_intensity_at_angles(lamp->intensity, v[i], h[p]);
            CHECK(fabs(got - want) <= 1e-9 * want);
        }
    }
}

/* The words behind a line TILT=NONE; NULL: the text has none such, or ends with
 * the mark of DOS. */
static char *words_of(char *text, size_t size)
{
    char *tilt = strstr(text, "\nTILT=NONE\n");
    return tilt && strlen(text) == size && !strchr(text, '\x1a') &&
                   strncmp(text, "IESNA:LM-63-2002\n", 17) == 0
               ? tilt + strlen("\nTILT=NONE\n")
               : NULL;
}

/* ---- one file ---- */

static murk_status try_text(const char *name, const char *bytes, size_t size)
{
    char text[TEXT_MAX + 1], copy[TEXT_MAX + 1];
    murk_luminaire *lamp = NULL;
    murk_error err = {0};
    memcpy(text, bytes, size);
    memcpy(copy, bytes, size);
    text[size] = copy[size] = '\0';
    const murk_status status =
        murk_luminaire_parse(&lamp, name, text, size, &err);
    if (status) {
        ++refused;
        CHECK(lamp == NULL);
        CHECK(status == MURK_BAD_FILE);
        broken_check_refusal(&err);
        CHECK(strncmp(err.where, name, strlen(name)) == 0 ||
              strstr(err.where, "TILT") || strchr(err.where, '/') == NULL);
        return status;
    }
    /* A file that is read has light, and a size. */
    ++read_well;
    const double lumens = murk_intensity_lumens(lamp->intensity);
    CHECK(lumens > 0 && isfinite(lumens));
    CHECK(isfinite(murk_intensity_max_candela(lamp->intensity)));
    CHECK(lamp->along_c0_m >= 0 && lamp->along_c90_m >= 0);
    const murk_vec3 d = murk_intensity_draw(lamp->intensity, .3, .7);
    CHECK(fabs(murk_length(d) - 1) < 1e-12);
    char *words = words_of(copy, size);
    if (words) {
        check_table(lamp, words);
    }
    murk_luminaire_destroy(lamp);
    return status;
}

/* ---- changes of whole words and lines, every one of them ---- */

typedef enum edit { LOSE, DOUBLE, SWAP, CUT, JOIN, EDITS } edit;

/* Edits word `which` of the part of a text behind `from`; words are those
 * between blanks, in EULUMDAT whole lines. Returns false if there is no such
 * word. */
static bool edit_word(char *out, const char *text, const char *from,
                      const char *blanks, size_t which, edit how)
{
    /* Find the word and the next one. */
    const char *at = from + strspn(from, blanks);
    for (size_t i = 0; i < which && *at; ++i) {
        at += strcspn(at, blanks);
        at += strspn(at, blanks);
    }
    const size_t length = strcspn(at, blanks);
    const char *next = at + length + strspn(at + length, blanks);
    const size_t next_length = strcspn(next, blanks);
    if (!*at || (how >= SWAP && !*next)) {
        return false;
    }
    const int head = (int)(at - text);
    switch (how) {
    case LOSE:
        snprintf(out, TEXT_MAX, "%.*s%s", head, text, next);
        break;
    case DOUBLE:
        snprintf(out, TEXT_MAX, "%.*s%.*s%c%s", head, text, (int)length, at,
                 blanks[0], at);
        break;
    case SWAP:
        snprintf(out, TEXT_MAX, "%.*s%.*s%c%.*s%c%s", head, text,
                 (int)next_length, next, blanks[0], (int)length, at, blanks[0],
                 next + next_length + (next[next_length] != '\0'));
        break;
    case CUT:
        snprintf(out, TEXT_MAX, "%.*s", head, text);
        break;
    default:
        snprintf(out, TEXT_MAX, "%.*s%.*s%s", head, text, (int)length, at,
                 next);
        break;
    }
    return true;
}

/* A number or line that is lost, doubled, joined to the next, or with all that
 * follows cut off is refused, whichever it is. Swapped ones are refused where
 * they are angles, and counted elsewhere. */
static void test_edits(void)
{
    static const char *const first[] = {"2 900", "1\n3\n", "Maker"};
    char text[TEXT_MAX + 1];
    for (int f = 0; f < N_FILES; ++f) {
        const char *from = strstr(FILES[f], first[f]);
        const char *blanks = f == 2 ? "\n" : " \n";
        for (int how = LOSE; how < EDITS; ++how) {
            size_t accepted = 0, n = 0;
            while (edit_word(text, FILES[f], from, blanks, n, (edit)how)) {
                const bool is_read = !try_text(NAMES[f], text, strlen(text));
                if (is_read && how != SWAP) {
                    printf("%s: edit %d of word %zu is read\n", NAMES[f], how,
                           n);
                }
                accepted += is_read;
                ++n;
            }
            CHECK(n > 20);
            CHECK(how == SWAP || accepted == 0);
        }
    }
}

/* Swapped angles fall instead of rising. */
static void test_swapped_angles(void)
{
    static const struct {
        int file;
        const char *from, *to;
    } known[] = {{0, "0 25 60 90", "0 60 25 90"},
                 {0, "\n0 45 90\n", "\n45 0 90\n"},
                 {1, "0 45 90\n1 .9", "0 90 45\n1 .9"},
                 {1, "-90 0 90", "0 -90 90"},
                 {2, "\n90\n135\n", "\n135\n90\n"},
                 {2, "315\n0\n45\n", "315\n45\n0\n"}};
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
        char text[TEXT_MAX + 1];
        const char *file = FILES[known[i].file];
        const char *at = strstr(file, known[i].from);
        snprintf(text, sizeof text, "%.*s%s%s", (int)(at - file), file,
                 known[i].to, at + strlen(known[i].from));
        CHECK(try_text(NAMES[known[i].file], text, strlen(text)) != MURK_OK);
    }
}

/* ---- changed bytes ---- */

static void test_changed_bytes(uint64_t files)
{
    static const char bytes[] = " \n\r\t,.-+0123456789eE=[]TILT#\x1a";
    double slowest_s = 0;
    for (uint64_t i = 0; i < files; ++i) {
        const char *file = FILES[i % N_FILES];
        char text[TEXT_MAX];
        size_t size = strlen(file);
        memcpy(text, file, size);
        /* One to four bytes replaced, inserted, or removed with those behind.
         */
        for (uint32_t k = 0; k <= i / N_FILES % 4; ++k) {
            uint32_t word[4];
            murk_random_words(17, MURK_TEST, i, k, 0, word);
            const size_t at = murk_random_below(word[0], (uint32_t)size);
            const char by =
                word[3] % 8
                    ? bytes[murk_random_below(word[1], sizeof bytes - 1)]
                    : (char)word[1];
            const uint32_t kind = word[2] % 4;
            const size_t gone = kind == 3 ? word[2] / 4 % 30 : 1;
            if (kind == 1) { /* insert */
                memmove(text + at + 1, text + at, size - at);
                ++size;
            }
            if (kind < 2 || at + gone >= size) {
                text[at] = by;
            } else {
                memmove(text + at, text + at + gone, size - at - gone);
                size -= gone;
            }
        }
        const double start_s = murk_clock_s();
        try_text(NAMES[i % N_FILES], text, size);
        slowest_s = fmax(slowest_s, murk_clock_s() - start_s);
    }
    printf("%llu files: %d read, %d refused so far; slowest %.3g s\n",
           (unsigned long long)files, read_well, refused, slowest_s);
    CHECK(slowest_s < BROKEN_SLOWEST_S);
    CHECK(read_well > 0 && refused > 0);
}

static void test_noise(void)
{
    char noise[2000];
    for (uint64_t i = 0; i < 60; ++i) {
        broken_noise(noise, sizeof noise, 18, i);
        CHECK(try_text(NAMES[i % N_FILES], noise, sizeof noise) != MURK_OK);
    }
    CHECK(try_text("a.ies", "", 0) != MURK_OK);
    CHECK(try_text("a.ldt", "\n", 1) != MURK_OK);
}

/* ---- large files ---- */

/* Sixteen megabytes of one byte, of short words, and a header that asks for the
 * largest table. */
static void test_too_large(void)
{
    static const char head[] = "IESNA91\nTILT=NONE\n1 1 1 ";
    static const char *const counts[] = {"100000 100000 1 1 0 0 0 1 1 1\n",
                                         "1000 900 1 1 0 0 0 1 1 1\n"};
    const size_t size = MURK_LUMINAIRE_BYTES_MAX;
    /* Read each file. */
    const double start_s = murk_clock_s();
    char *text = malloc(size + 1);
    CHECK(text != NULL);
    for (int i = 0; i < 6; ++i) {
        murk_luminaire *lamp = NULL;
        murk_error err = {0};
        size_t used = 0;
        if (i < 2) {
            used = (size_t)snprintf(text, 100, "%s%s", head, counts[i]);
        }
        memset(text + used, i % 3 ? '\n' : '7', size - used);
        for (size_t k = used; k < size && i % 2; k += 2) {
            text[k] = '1';
        }
        text[size] = '\0';
        CHECK(murk_luminaire_parse(&lamp, i < 3 ? "a.ies" : "a.ldt", text, size,
                                   &err) == MURK_BAD_FILE);
        murk_luminaire_destroy(lamp);
    }
    free(text);
    CHECK(murk_clock_s() - start_s < BROKEN_SLOWEST_S);
}

int main(int argc, char **argv)
{
    murk_warn_to(NULL);
    for (int f = 0; f < N_FILES; ++f) {
        CHECK(try_text(NAMES[f], FILES[f], strlen(FILES[f])) == MURK_OK);
    }
    test_edits();
    test_swapped_angles();
    test_changed_bytes(argc > 1 ? strtoull(argv[1], NULL, 10) : 1000);
    test_noise();
    test_too_large();
    CHECK(broken_peak_kb() < BROKEN_MAX_KB);
    return check_done();
}
