/* The man pages of section 1, in roff's man macros, from the tables that parse
 * the command line and make --help. */
#include "app/command_notes.h"
#include "app/help_text.h"
#include "app/option_table.h"
#include "app/options.h"
#include "results/version.h"

#include <ctype.h>
#include <string.h>

static const char *const format_pages[] = {
    "murk-scene",   "murk-study", "murk-data",  "murk-media",
    "murk-results", "murk-light", "murk-matrix"};
static const char *const format_texts[] = {"the scene file: every key",
                                           "the study file, and table.csv",
                                           "the readings that fit takes",
                                           "presets, tables and grids of media",
                                           "every result file",
                                           "the photon maps",
                                           "coverage matrices"};

/* Escaped: backslashes, hyphens (which are then those of options), and what
 * would begin a request. */
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

static void line(FILE *to, const char *text)
{
    put(to, text);
    fputc('\n', to);
}

static void bold(FILE *to, const char *text)
{
    fputs("\\fB", to);
    put(to, text);
    fputs("\\fR", to);
}

static void tagged(FILE *to, const char *tag, const char *text)
{
    fputs(".TP\n", to);
    bold(to, tag);
    fputc('\n', to);
    line(to, text);
}

static void option(FILE *to, const murk_option *o)
{
    fputs(".TP\n", to);
    if (o->other) {
        bold(to, o->other);
        fputs(", ", to);
    }
    bold(to, o->name);
    if (o->argument) {
        fputs(" \\fI", to);
        put(to, o->argument);
        fputs("\\fR", to);
    }
    fputc('\n', to);
    line(to, o->help);
}

/* command NULL: those of all commands. */
static void options(FILE *to, const char *command, bool of_it_alone)
{
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *o = &murk_option_table[i];
        const bool is_own = o->commands != NULL;
        if (o->help && is_own == of_it_alone &&
            (!command || murk_option_belongs(o, command))) {
            option(to, o);
        }
    }
}

static void examples(FILE *to, const murk_note_pair *example)
{
    if (!example->name) {
        return;
    }
    fputs(".SH EXAMPLES\n", to);
    for (size_t i = 0; example->name; ++example, ++i) {
        fputs(i > 0 ? ".PP\n" : "", to);
        line(to, example->text);
        fputs(".PP\n.RS 4\n.nf\n", to);
        line(to, example->name);
        fputs(".fi\n.RE\n", to);
    }
}

static void codes(FILE *to)
{
    fputs(".SH EXIT STATUS\n", to);
    tagged(to, "0", "Done.");
    tagged(to, "1", "The run failed, or ran out of memory.");
    tagged(to, "2", "Bad input or usage; nothing was written.");
    tagged(to, "130", "Interrupted.");
    tagged(to, "141",
           "Done, but standard output was closed before its end, as by "
           "head(1). Result files are whole.");
    fputs(".PP\n", to);
    line(to, murk_help_messages);
}

static void head(FILE *to, const char *page, const char *summary)
{
    fputs(".TH ", to);
    for (const char *c = page; *c; ++c) {
        fputc(toupper((unsigned char)*c), to);
    }
    fprintf(to, " 1 %s \"murk %s\" \"User Commands\"\n.ad l\n.nh\n.SH NAME\n",
            murk_version_date(), MURK_VERSION);
    put(to, page);
    fputs(" \\- ", to);
    line(to, summary);
    fputs(".SH SYNOPSIS\n", to);
}

static void see(FILE *to, const char *page, size_t length, int section,
                const char *after)
{
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)length, page);
    fputs(".BR ", to);
    put(to, name);
    fprintf(to, " (%d)%s\n", section, after);
}

static void see_also(FILE *to, const murk_command *self,
                     const murk_command_notes *notes)
{
    fputs(".SH SEE ALSO\n", to);
    see(to, "murk", 4, 1, ",");
    for (const char *f = notes->formats; *f; f += strspn(f, " ")) {
        const size_t length = strcspn(f, " ");
        see(to, f, length, 5, ",");
        f += length;
    }
    /* All other commands, with a comma after each but the last. */
    const char *before = NULL;
    for (size_t i = 0; i < murk_commands_count; ++i) {
        char page[64];
        if (&murk_commands[i] == self) {
            continue;
        }
        if (before) {
            snprintf(page, sizeof page, "murk-%s", before);
            see(to, page, strlen(page), 1, ",");
        }
        before = murk_commands[i].name;
    }
    if (before) {
        char page[64];
        snprintf(page, sizeof page, "murk-%s", before);
        see(to, page, strlen(page), 1, "");
    }
}

static void command_page(FILE *to, const murk_command *command)
{
    const murk_command_notes *notes = murk_command_notes_of(command->name);
    char page[64];
    snprintf(page, sizeof page, "murk-%s", command->name);
    head(to, page, command->summary);
    /* Synopsis and description. */
    bold(to, "murk ");
    bold(to, command->name);
    fputs(" \\fI", to);
    put(to, command->arguments);
    fputs("\\fR [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n", to);
    line(to, command->text);
    /* Options: those of the command, then those of every command. */
    fputs(".SH OPTIONS\n", to);
    options(to, command->name, true);
    fputs(".SS Of every command\n", to);
    options(to, command->name, false);
    /* Files and examples. */
    if (notes->file[0].name) {
        fputs(".SH FILES\n", to);
        for (const murk_note_pair *f = notes->file; f->name; ++f) {
            tagged(to, f->name, f->text);
        }
        fputs(".PP\n", to);
        line(to, murk_help_files);
    }
    examples(to, notes->example);
    codes(to);
    see_also(to, command, notes);
}

static void program_page(FILE *to)
{
    head(to, "murk",
         "light in fog, smoke, rain and water, and where sensors see it");
    fputs("\\fBmurk\\fR \\fICOMMAND\\fR \\fISCENE\\fR [\\fIOPTIONS\\fR]\n"
          ".SH DESCRIPTION\n",
          to);
    /* The commands. */
    line(to, murk_help_about);
    fputs(".SH COMMANDS\nEach has a page of its own.\n", to);
    for (size_t i = 0; i < murk_commands_count; ++i) {
        const murk_command *c = &murk_commands[i];
        fputs(".TP\n", to);
        bold(to, "murk ");
        bold(to, c->name);
        fputs(" \\fI", to);
        put(to, c->arguments);
        fputs("\\fR\n", to);
        put(to, c->summary);
        fprintf(to, ":\n.BR murk\\-%s (1)\n", c->name);
    }
    /* Options of every command, and formats of files. */
    fputs(
        ".SH OPTIONS\nWhat follows \\-\\- is no option, as a file named \\-x. "
        "Those of every command:\n",
        to);
    options(to, NULL, false);
    fputs(".SH FILES\n", to);
    for (size_t i = 0; i < sizeof format_pages / sizeof *format_pages; ++i) {
        fputs(".TP\n", to);
        see(to, format_pages[i], strlen(format_pages[i]), 5, "");
        line(to, format_texts[i]);
    }
    fputs(".PP\n", to);
    line(to, murk_help_files);
    /* Environment, examples and codes. */
    fputs(".SH ENVIRONMENT\n", to);
    tagged(to, "TERM",
           "Where it is dumb or not set, progress is told in whole lines, of "
           "which there are few, as it is where --progress always writes to a "
           "file.");
    fputs(".PP\n", to);
    line(to, "murk writes no colours, with NO_COLOR or without.");
    examples(to, murk_command_notes_of("place")->example);
    codes(to);
    fputs(".SH SEE ALSO\n", to);
    see(to, "murk-place", 10, 1, ",");
    see(to, "murk-scene", 10, 5, ",");
    see(to, "murk-results", 12, 5, "");
}

void murk_man_print(FILE *to, const murk_command *command)
{
    if (command) {
        command_page(to, command);
    } else {
        program_page(to);
    }
}
