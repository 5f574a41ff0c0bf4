/* The man pages of section 1, in roff's man macros, from the tables that parse
 * the command line and make --help. */
#include "app/field.h"
#include "app/help.h"
#include "app/lookup.h"

#include <ctype.h>
#include <stdarg.h>
#include <string.h>

static const struct {
    const char *page, *text;
} formats[] = {{"murk-scene", "the scene file: every key"},
               {"murk-study", "the study file, and table.csv"},
               {"murk-data", "the readings that fit takes"},
               {"murk-media", "presets, tables and grids of media"},
               {"murk-results", "every result file"},
               {"murk-light", "the photon maps"},
               {"murk-matrix", "coverage matrices"}};

static const struct {
    const char *code, *text;
} codes[] = {{"0", "Done."},
             {"1", "The run failed, or ran out of memory."},
             {"2", "Bad input or usage; nothing was written."},
             {"130",
              "Interrupted. If place was searching for the plan, the plan "
              "so far was written. Repeats of place and rows of a study "
              "that are done were written, too; else nothing."},
             {"141", "Done, but standard output was closed before its end, as "
                     "by head(1). Result files are whole."}};

/* Prints text with backslashes and hyphens escaped (hyphens are those of
 * options), and with a guard before characters that would begin a request. */
static void put(FILE *to, const char *text)
{
    if (*text == '.' || *text == '\'') {
        fputs("\\&", to);
    }
    for (; *text; ++text) {
        if (*text == '\\') {
            fputs("\\e", to);
        } else if (*text == '-') {
            fputs("\\-", to);
        } else {
            fputc(*text, to);
        }
    }
}

/* Prints roff as it stands, with the next text, escaped, for each '@'. */
static void roff(FILE *to, const char *words, ...)
{
    va_list texts;
    va_start(texts, words);
    for (; *words; ++words) {
        if (*words == '@') {
            put(to, va_arg(texts, const char *));
        } else {
            fputc(*words, to);
        }
    }
    va_end(texts);
}

/* Prints the options of every command, or those that only some have, among them
 * the command. */
static void options(FILE *to, const char *command, bool of_every)
{
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *o = &murk_option_table[i];
        if (!o->help || of_every != !o->commands ||
            !murk_option_belongs(o, command)) {
            continue;
        }
        fputs(".TP\n", to);
        if (o->other) {
            roff(to, "\\fB@\\fR, ", o->other);
        }
        roff(to, "\\fB@\\fR", o->name);
        if (o->argument) {
            roff(to, " \\fI@\\fR", o->argument);
        }
        roff(to, "\n@\n", o->help);
    }
}

static void examples(FILE *to, const murk_note_pair *example)
{
    const char *before = ".SH EXAMPLES\n";
    for (; example->name; ++example) {
        fputs(before, to);
        roff(to, "@\n.PP\n.RS 4\n.nf\n@\n.fi\n.RE\n", example->text,
             example->name);
        before = ".PP\n";
    }
}

static void exit_status(FILE *to)
{
    fputs(".SH EXIT STATUS\n", to);
    for (size_t i = 0; i < sizeof codes / sizeof *codes; ++i) {
        roff(to, ".TP\n\\fB@\\fR\n@\n", codes[i].code, codes[i].text);
    }
    roff(to, ".PP\n@\n", murk_help_messages);
}

/* The head of a page. version: the fields of that name. */
static void head(FILE *to, const murk_fields *version, const char *page,
                 const char *summary)
{
    fputs(".TH ", to);
    for (const char *c = page; *c; ++c) {
        fputc(toupper((unsigned char)*c), to);
    }
    fprintf(to, " 1 %s \"murk %s\" \"User Commands\"\n.ad l\n.nh\n",
            murk_field_text(version, "date"), murk_version());
    roff(to, ".SH NAME\n@ \\- @\n.SH SYNOPSIS\n", page, summary);
}

static void see_also(FILE *to, const murk_command *self)
{
    fputs(".SH SEE ALSO\n.BR murk (1),\n", to);
    for (const char *f = self->formats; *f; f += strspn(f, " ")) {
        char page[64];
        const size_t length = strcspn(f, " ");
        snprintf(page, sizeof page, "%.*s", (int)length, f);
        roff(to, ".BR @ (5),\n", page);
        f += length;
    }
    /* All other commands, with a comma after each but the last. */
    const char *before = "";
    for (size_t i = 0; i < murk_commands_count; ++i) {
        if (&murk_commands[i] != self) {
            fputs(before, to);
            roff(to, ".BR murk\\-@ (1)", murk_commands[i].name);
            before = ",\n";
        }
    }
    fputs("\n", to);
}

static void command_page(FILE *to, const murk_fields *version,
                         const murk_command *command)
{
    char page[64];
    snprintf(page, sizeof page, "murk-%s", command->name);
    head(to, version, page, command->summary);
    roff(to,
         "\\fBmurk \\fR\\fB@\\fR \\fI@\\fR [\\fIOPTIONS\\fR]\n"
         ".SH DESCRIPTION\n@\n",
         command->name, command->arguments, command->text);
    /* Options: those of the command, then those of every command. */
    fputs(".SH OPTIONS\n", to);
    options(to, command->name, false);
    fputs(".SS Of every command\n", to);
    options(to, command->name, true);
    /* Files and examples. */
    if (command->file[0].name) {
        fputs(".SH FILES\n", to);
        for (const murk_note_pair *f = command->file; f->name; ++f) {
            roff(to, ".TP\n\\fB@\\fR\n@\n", f->name, f->text);
        }
        roff(to, ".PP\n@\n", murk_help_files);
    }
    examples(to, command->example);
    exit_status(to);
    see_also(to, command);
}

static void program_page(FILE *to, const murk_fields *version)
{
    head(to, version, "murk",
         "light in fog, smoke, rain and water, and where sensors see it");
    roff(to,
         "\\fBmurk\\fR \\fICOMMAND\\fR \\fISCENE\\fR [\\fIOPTIONS\\fR]\n"
         ".SH DESCRIPTION\n@\n",
         murk_help_about);
    /* The commands. */
    fputs(".SH COMMANDS\nEach has a page of its own.\n", to);
    for (size_t i = 0; i < murk_commands_count; ++i) {
        const murk_command *c = &murk_commands[i];
        roff(to, ".TP\n\\fBmurk \\fR\\fB@\\fR \\fI@\\fR\n@", c->name,
             c->arguments, c->summary);
        fprintf(to, ":\n.BR murk\\-%s (1)\n", c->name);
    }
    /* Options of every command, and formats of files. */
    fputs(
        ".SH OPTIONS\nWhat follows \\-\\- is no option, as a file named \\-x. "
        "Those of every command:\n",
        to);
    options(to, NULL, true);
    fputs(".SH FILES\n", to);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; ++i) {
        roff(to, ".TP\n.BR @ (5)\n@\n", formats[i].page, formats[i].text);
    }
    roff(to, ".PP\n@\n", murk_help_files);
    /* Environment, examples and exit codes. */
    roff(
        to,
        ".SH ENVIRONMENT\n.TP\n\\fBMURK_MEMORY_MB\\fR\n@\n"
        ".TP\n\\fBTMPDIR\\fR\n@\n.TP\n\\fBTERM\\fR\n@\n.PP\n"
        "murk writes no colours, with NO_COLOR or without.\n",
        "Memory for the records of a photon map, in MiB; records beyond it lie "
        "in a scratch file. Default: seven tenths of the free memory.",
        "The folder of scratch files, else /var/tmp; not a file system in "
        "memory.",
        "Where it is dumb or not set, progress is told in whole lines, of "
        "which there are few, as it is where --progress always writes to a "
        "file.");
    examples(to, murk_command_find("place")->example);
    exit_status(to);
    fputs(".SH SEE ALSO\n.BR murk\\-place (1),\n.BR murk\\-scene (5),\n"
          ".BR murk\\-results (5)\n",
          to);
}

murk_status murk_man_print(FILE *to, const murk_command *command,
                           murk_error *err)
{
    murk_lookup lookup;
    const murk_status status = murk_lookup_begin(&lookup, "version", err);
    if (!status && command) {
        command_page(to, lookup.fields, command);
    } else if (!status) {
        program_page(to, lookup.fields);
    }
    murk_lookup_end(&lookup);
    return status;
}
