/* YAML text becomes a tree with places, or one line that says why not.
 * Nothing here is random. */
#include <stdlib.h>

#include "base/words.h"
#include "check.h"
#include "scene/yaml.h"

static murk_yaml *parse(const char *text, murk_error *err)
{
    murk_yaml *root = NULL;
    *err = (murk_error){0};
    murk_yaml_parse(&root, text, strlen(text), "a.yaml", err);
    return root;
}

#define CHECK_REFUSES(input, want_where, want_text)         \
    do {                                                    \
        murk_error err_;                                    \
        murk_yaml *root_ = parse((input), &err_);           \
        CHECK(root_ == NULL && err_.code == MURK_BAD_FILE); \
        CHECK_TEXT(err_.where, want_where);                 \
        CHECK_TEXT(err_.text, want_text);                   \
        murk_yaml_destroy(root_);                           \
    } while (0)

static void test_places(void)
{
    murk_error err;
    murk_yaml *root = parse("a: 1\nb:\n  - {c: x}\n  - \"2\"\n", &err);
    CHECK(root && root->kind == MURK_YAML_MAP && root->n == 2);
    const murk_yaml *a = murk_yaml_get(root, "a");
    const murk_yaml *b = murk_yaml_get(root, "b");
    CHECK(a->line == 1 && a->column == 4 && a->key_column == 1);
    CHECK(b->kind == MURK_YAML_LIST && b->n == 2);
    CHECK(b->line == 3 && b->column == 3 && b->key_line == 2);
    const murk_yaml *c = murk_yaml_get(b->child[0], "c");
    CHECK(c->line == 3 && c->column == 9);
    double number = 0;
    CHECK(murk_yaml_number(a, &number) && number == 1);
    CHECK(!murk_yaml_number(b->child[1], &number)); /* quoted: a text */
    CHECK(murk_yaml_get(root, "z") == NULL);
    CHECK(murk_yaml_get(a, "z") == NULL);
    murk_yaml_destroy(root);
}

static void test_aliases_are_copies(void)
{
    murk_error err;
    murk_yaml *root = parse("a: &x {k: 1}\nb: *x\n", &err);
    CHECK(root != NULL);
    const murk_yaml *b = root ? murk_yaml_get(root, "b") : NULL;
    CHECK(b && b->line == 2 && b->n == 1);
    CHECK(b && b != murk_yaml_get(root, "a"));
    murk_yaml_destroy(root);
}

static void test_booleans_and_nulls(void)
{
    murk_error err;
    murk_yaml *root = parse("[true, false, yes, \"true\", ~, null, ]", &err);
    bool fact = false;
    CHECK(murk_yaml_bool(root->child[0], &fact) && fact);
    CHECK(murk_yaml_bool(root->child[1], &fact) && !fact);
    CHECK(!murk_yaml_bool(root->child[2], &fact));
    CHECK(!murk_yaml_bool(root->child[3], &fact));
    CHECK(murk_yaml_is_null(root->child[4]));
    CHECK(murk_yaml_is_null(root->child[5]));
    CHECK(!murk_yaml_is_null(root->child[0]));
    murk_yaml_destroy(root);
}

static void test_refusals(void)
{
    /* Empty files, and constructs of YAML that are not allowed. */
    CHECK_REFUSES("", "a.yaml", "empty, must be YAML");
    CHECK_REFUSES("# nothing\n", "a.yaml", "empty, must be YAML");
    CHECK_REFUSES("a: 1\nb: 2\na: 3\n", "a.yaml:3:1",
                  "a is given twice, first in line 1");
    CHECK_REFUSES("a: !!str 1\n", "a.yaml:1:4",
                  "a tag (tag:yaml.org,2002:str) is not allowed");
    CHECK_REFUSES("a: &x {k: 1}\nb: {<<: *x}\n", "a.yaml:2:5",
                  "a merge key (<<) is not allowed, write its keys out");
    CHECK_REFUSES("a: 1\n---\nb: 2\n", "a.yaml:2:1",
                  "a second document, must be only one");
    CHECK_REFUSES("a: &x [*x]\n", "a.yaml:1:8",
                  "an alias inside its own anchor");
    /* Text that is not plain UTF-8. */
    CHECK_REFUSES("a: 1\nb: \"\\0\"\n", "a.yaml:2:4",
                  "a NUL character, must be text");
    CHECK_REFUSES("a: 1\nb: \xC0\xAF\n", "a.yaml:2:4",
                  "byte 0xC0, must be UTF-8 text");
    CHECK_REFUSES("a: \xED\xA0\x80\n", "a.yaml:1:4",
                  "byte 0xED, must be UTF-8 text");
    CHECK_REFUSES("a: \x01\n", "a.yaml:1:4",
                  "control character 0x01, must be text");
    /* Keys that are lists, and broken syntax. */
    CHECK_REFUSES("? [a]\n: 1\n", "a.yaml:1:3",
                  "not a key, must be a plain text");
    CHECK_REFUSES("a: [1, 2\nb: 3\n", "a.yaml:2:2",
                  "not YAML: did not find expected ',' or ']'");

    /* A NUL byte in the file. */
    murk_error err = {0};
    murk_yaml *root = NULL;
    CHECK(murk_yaml_parse(&root, "a: 1\nb: \0c\n", 11, "a.yaml", &err) ==
          MURK_BAD_FILE);
    CHECK_TEXT(err.where, "a.yaml:2:4");
    CHECK_TEXT(err.text, "control character 0x00, must be text");
}

static void test_depth_is_limited(void)
{
    char text[200];
    memset(text, '[', 64);
    memset(text + 64, ']', 64);
    text[128] = '\0';
    murk_error err;
    murk_yaml *root = parse(text, &err);
    CHECK(root != NULL);
    murk_yaml_destroy(root);
    memset(text, '[', 65);
    text[65] = '\0';
    CHECK_REFUSES(text, "a.yaml:1:65",
                  "nested too deep, must be at most 64 levels");
}

static void test_words(void)
{
    static const char *const known[] = {"albedo", "extinction_per_m", "phase"};
    CHECK_TEXT(murk_words_meant("albdo", known, 3), "albedo");
    CHECK_TEXT(murk_words_meant("abledo", known, 3), "albedo");
    CHECK_TEXT(murk_words_meant("extinction", known, 3), "extinction_per_m");
    CHECK(murk_words_meant("colour", known, 3) == NULL);
    CHECK(murk_words_meant("", known, 3) == NULL);
    char shown[8];
    murk_words_show(shown, sizeof shown, "a\nb");
    CHECK_TEXT(shown, "a\\nb");
    murk_words_show(shown, sizeof shown, "\033[J");
    CHECK_TEXT(shown, "\\x1b[J"); /* just fits */
    murk_words_show(shown, sizeof shown, "ab\033[J");
    CHECK_TEXT(shown, "ab...");
    murk_words_show(shown, sizeof shown, "abcd\xC3\xA9xyz");
    CHECK_TEXT(shown, "abcd..."); /* not through the middle of a letter */
    murk_words_show(shown, sizeof shown, "abc\xC3\xA9xyz");
    CHECK_TEXT(shown, "abc...");
}

/* A long path keeps its end, a long option its beginning. */
static void test_long_names_are_cut(void)
{
    char name[400], place[256], want[256];
    memset(name, 'p', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    memcpy(name + sizeof name - 8, "/f.yaml", 7);
    murk_yaml node = {.source = name, .line = 3, .column = 4};
    murk_yaml_place(&node, place, sizeof place);
    snprintf(want, sizeof want, "...%s:3:4", name + sizeof name - 1 - 117);
    CHECK_TEXT(place, want);
    memcpy(name, "--set a\nb=", 10);
    murk_yaml_place(&node, place, sizeof place);
    CHECK(strncmp(place, "--set a\\nb=ppp", 14) == 0);
    CHECK(strlen(place) == 121); /* one for the escape */
    CHECK_TEXT(place + 116, "pp...");
}

int main(void)
{
    test_long_names_are_cut();
    test_places();
    test_aliases_are_copies();
    test_booleans_and_nulls();
    test_refusals();
    test_depth_is_limited();
    test_words();
    return check_done();
}
