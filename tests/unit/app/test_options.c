/* Options as people type them: which are taken, with which limits, and which
 * are refused. Nothing here is random. */
#include "app/command_line.h"
#include "base/export_kind.h"
#include "check.h"

#include <stdlib.h>
#include <string.h>

#define WORDS_MAX 24

/* Parses "place s.yaml ..." of words parted by blanks; the status and, in err,
 * the message. */
static murk_status parse(murk_options *out, const char *line, murk_error *err)
{
    static char text[512]; /* options point into it */
    char *words[WORDS_MAX] = {"murk"};
    int n = 1;
    snprintf(text, sizeof text, "%s", line);
    for (char *at = text; *at && n < WORDS_MAX;) {
        words[n++] = at;
        at += strcspn(at, " ");
        if (*at) {
            *at++ = '\0';
        }
    }
    *err = (murk_error){0};
    return murk_options_parse(out, n, words, err);
}

static murk_options taken(const char *line)
{
    murk_options out;
    murk_error err;
    CHECK(parse(&out, line, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return out;
}

static void refused(const char *line, const char *where, const char *says)
{
    murk_options out;
    murk_error err;
    CHECK(parse(&out, line, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, where);
    CHECK_MENTIONS(err.text, says);
    murk_options_release(&out);
}

static void test_defaults(void)
{
    murk_options o = taken("trace s.yaml");
    CHECK_TEXT(o.command->name, "trace");
    CHECK_TEXT(o.input, "s.yaml");
    CHECK(!o.out && !o.light && !o.sensors && !o.matrix && !o.json);
    CHECK(!o.quiet && o.threads >= 1 && o.n_overrides == 0 &&
          !murk_option_text(&o, "--repeat"));
    CHECK(o.progress == MURK_PROGRESS_AUTO);
    murk_options_release(&o);
}

static void test_whole_numbers_and_their_limits(void)
{
    /* Numbers at the limits are read, and overrides keep whole numbers
     * without an exponent. */
    murk_options o = taken("place s.yaml -j 3 --repeat 10000 --emit 1e6");
    CHECK(o.threads == 3 && murk_option_number(&o, "--repeat", 0) == 10000 &&
          o.n_overrides == 1);
    CHECK_TEXT(o.overrides[0].text, "photons.emit=1000000");
    CHECK_TEXT(o.overrides[0].option, "--emit");
    murk_options_release(&o);
    o = taken("trace s.yaml -j256 --seed=4294967295 --store 4294967295");
    CHECK(o.threads == 256);
    CHECK_TEXT(o.overrides[0].text, "seed=4294967295");
    CHECK_TEXT(o.overrides[1].text, "photons.store=4294967295");
    murk_options_release(&o);
    o = taken("replay s.yaml --photon 0 --seed 0");
    CHECK(murk_option_text(&o, "--photon") &&
          murk_option_number(&o, "--photon", 1) == 0);
    murk_options_release(&o);
    o = taken("fit s.yaml --data d.csv --starts 1000 --traces 1 --next 100");
    CHECK(murk_option_number(&o, "--starts", 0) == 1000 &&
          murk_option_number(&o, "--traces", 0) == 1 &&
          murk_option_number(&o, "--next", 0) == 100);
    murk_options_release(&o);
    /* Numbers outside of the limits and other spellings are refused. */
    refused("trace s.yaml -j 0", "--threads", "0, must be a whole number 1..");
    refused("trace s.yaml -j 257", "--threads", "whole number 1..256");
    refused("trace s.yaml --seed 4294967296", "--seed", "0..4294967295");
    refused("trace s.yaml --seed -1", "--seed", "0..4294967295");
    refused("trace s.yaml --seed 1.5", "--seed", "0..4294967295");
    refused("trace s.yaml --emit 0", "--emit", "1..4294967295");
    refused("trace s.yaml --emit 0x10", "--emit", "1..4294967295");
    refused("place s.yaml --repeat 10001", "--repeat", "1..10000");
    refused("place s.yaml --count 1000001", "--count", "1..1000000");
    refused("fit s.yaml --starts 1001", "--starts", "1..1000");
    refused("fit s.yaml --next 101", "--next", "1..100");
    refused("replay s.yaml --photon 4294967295", "--photon", "0..4294967294");
}

static void test_order_and_spelling(void)
{
    /* Options stand before and after the command, and overrides keep their
     * order. */
    murk_options o = taken("-q --out=x place --set a.b=1 s.yaml --set c=2");
    CHECK_TEXT(o.input, "s.yaml");
    CHECK_TEXT(o.out, "x");
    CHECK(o.quiet && o.n_overrides == 2);
    CHECK_TEXT(o.overrides[0].text, "a.b=1");
    CHECK_TEXT(o.overrides[1].text, "c=2");
    CHECK(o.overrides[0].option == NULL);
    murk_options_release(&o);
    /* After -- every word is an input, a single - is the standard input,
     * and help takes a command. */
    o = taken("check -- --format");
    CHECK_TEXT(o.input, "--format");
    CHECK(!o.json);
    murk_options_release(&o);
    o = taken("check --format json --progress never -");
    CHECK(o.json && o.progress == MURK_PROGRESS_NEVER);
    CHECK_TEXT(o.input, "-");
    murk_options_release(&o);
    o = taken("help place");
    CHECK(o.wants_help);
    murk_options_release(&o);
    /* Two inputs, and bad or missing values. */
    refused("check s.yaml t.yaml", "", "one scene at a time, s.yaml is named");
    refused("check --quiet=yes s.yaml", "--quiet", "takes no value");
    refused("check s.yaml --format xml", "--format", "must be text | json");
    refused("check s.yaml --set =1", "--set", "must be KEY=VALUE");
    refused("check s.yaml --set a", "--set", "must be KEY=VALUE");
    refused("check s.yaml --emit", "--emit", "needs a value");
    /* Options of other commands, and a missing input or command. */
    refused("trace s.yaml --light f", "--light", "not an option of murk trace");
    refused("check s.yaml -j2 --light f", "--light",
            "not an option of murk check");
    refused("--light f trace s.yaml", "--light", "not an option of murk trace");
    refused("check", "", "check: no scene");
    refused("report", "", "report: no folder");
    refused("", "", "no command");
}

static void test_exports(void)
{
    murk_options o =
        taken("place s.yaml -o x --export matrix,\tphotons\t,fields");
    CHECK(o.exports ==
          (MURK_EXPORT_MATRIX | MURK_EXPORT_PHOTONS | MURK_EXPORT_FIELDS));
    murk_options_release(&o);
    o = taken("trace s.yaml -o x --export surfaces --voxel 1");
    CHECK(o.exports == MURK_EXPORT_SURFACES);
    murk_options_release(&o);
    refused("place s.yaml -o x --export lp,lps", "--export",
            "\"lps\" is not an export; allowed are matrix, ");
    refused("place s.yaml -o x --export lp,", "--export",
            "\"\" is not an export");
    refused("place s.yaml --export lp", "--export", "needs a folder");
    refused("trace s.yaml -o x --export lp", "--export", "are of murk place");
    refused("place --matrix m -o x --export fields", "--export", "of a scene");
    refused("trace s.yaml -o x --export photons --voxel 1", "--voxel",
            "is of --export fields or surfaces");
    refused("place s.yaml --matrix m", "--matrix", "in place of a scene");
}

static void test_words(void)
{
    murk_options o = taken("fit s.yaml --free a,b --free c --bounds a=1:2");
    CHECK(o.fit.free.n == 3);
    CHECK_TEXT(o.fit.free.word[2], "c");
    CHECK_TEXT(o.fit.bounds.word[0], "a=1:2");
    murk_options_release(&o);
    refused("fit s.yaml --free a,,b", "--free", "with commas between");
}

static void test_pictures(void)
{
    /* All options of a picture. */
    murk_options o = taken("render s.yaml --pixels 640x480 --samples 65536 "
                           "--png --exposure -2.5 --false-colour Z "
                           "--range 1e-3:2 --scale log --method path");
    CHECK(o.render.pixels[0] == 640 && o.render.pixels[1] == 480);
    CHECK(o.render.samples == 65536 && o.render.png);
    CHECK(o.render.has_exposure && o.render.exposure_stops == -2.5);
    CHECK(o.render.range[0] == 1e-3 && o.render.range[1] == 2);
    CHECK(murk_option_number(&o, "--scale", 0) == 1 &&
          murk_option_number(&o, "--method", 0) == 1);
    murk_options_release(&o);
    /* Options that need another option, or exclude a value of another. */
    refused("render s.yaml --false-colour Z --range 0:2 --scale log", "--range",
            "must be above 0 with --scale log");
    refused("render s.yaml --exposure 1", "--exposure", "--png");
    refused("render s.yaml --range 1:2", "--range", "--false-colour");
    refused("render s.yaml --scale log", "--scale", "--false-colour");
    refused("render s.yaml --from-sensor 1", "--from-sensor", "--sensors");
    /* Values that are malformed or out of limits. */
    refused("render s.yaml --pixels 640", "--pixels", "must be WIDTHxHEIGHT");
    refused("render s.yaml --pixels 0x3", "--pixels", "must be WIDTHxHEIGHT");
    refused("render s.yaml --pixels 65537x1", "--pixels", "each 1..65536");
    refused("render s.yaml --pixels 65536x65536", "--pixels", "together");
    refused("render s.yaml --samples 65537", "--samples", "1..65536");
    refused("render s.yaml --exposure 101", "--exposure", "-100..100");
    refused("render s.yaml --range 2:2", "--range", "the first less than");
    refused("render s.yaml --range 2", "--range", "must be LOW:HIGH");
    refused("render s.yaml --range 1:inf", "--range", "must be LOW:HIGH");
}

int main(void)
{
    test_defaults();
    test_whole_numbers_and_their_limits();
    test_order_and_spelling();
    test_exports();
    test_words();
    test_pictures();
    return check_done();
}
