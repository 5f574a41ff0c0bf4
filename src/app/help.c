/* --help and the man page, both from the tables of commands and options. */
#include "app/option_table.h"
#include "app/options.h"
#include "app/version.h"

#include <string.h>

#define WIDTH  78
#define INDENT 24

static const char about[] =
    "murk simulates light in fog, smoke, rain and water, and places sensors in "
    "it. Photons leave the lamps, meet surfaces and media, and are kept in a "
    "surface and a volume photon map; SPOQ finds the sensors that see the most "
    "of them, each weighted by occlusion and attenuation.";

static const char codes[] =
    "0 done; 1 the run failed; 2 bad input or usage; 130 interrupted. Messages "
    "read \"murk: FILE:LINE:COLUMN: KEY: found, allowed, unit\".";

/* Prints text in lines of WIDTH, the later ones indented; `at` is the column
 * that is reached already. */
static void wrap(FILE *to, const char *text, size_t at, size_t indent)
{
    while (*text) {
        const size_t word = strcspn(text, " ");
        if (at + word > WIDTH && at > indent) {
            fprintf(to, "\n%*s", (int)indent, "");
            at = indent;
        }
        fprintf(to, "%.*s", (int)word, text);
        at += word;
        text += word;
        if (*text == ' ') {
            fputc(' ', to);
            ++at;
            ++text;
        }
    }
    fputc('\n', to);
}

static void option_label(char *out, size_t size, const murk_option *option)
{
    snprintf(out, size, "%s%s%s%s%s", option->other ? option->other : "",
             option->other ? ", " : "", option->name,
             option->argument ? " " : "",
             option->argument ? option->argument : "");
}

static void print_options(FILE *to, const char *command)
{
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if (!option->help ||
            (command && !murk_option_belongs(option, command))) {
            continue;
        }
        char label[64];
        option_label(label, sizeof label, option);
        const int n = fprintf(to, "  %-*s", INDENT - 2, label);
        if (n > INDENT) {
            fprintf(to, "\n%*s", INDENT, "");
        }
        wrap(to, option->help, INDENT, INDENT);
    }
}

void murk_help_print(FILE *to, const murk_command *command)
{
    if (command) {
        fprintf(to, "usage: murk %s %s [OPTIONS]\n\n", command->name,
                command->arguments);
        wrap(to, command->text, 0, 0);
        fputs("\noptions:\n", to);
        print_options(to, command->name);
        return;
    }
    fputs("usage: murk COMMAND SCENE [OPTIONS]\n\n", to);
    wrap(to, about, 0, 0);
    fputs("\ncommands:\n", to);
    for (size_t i = 0; i < murk_commands_count; ++i) {
        fprintf(to, "  %-8s %s\n", murk_commands[i].name,
                murk_commands[i].summary);
    }
    fputs("\noptions (murk COMMAND --help: those of one command):\n", to);
    print_options(to, NULL);
    fputs("\nexit codes: ", to);
    wrap(to, codes, 12, 0);
}

/* Text for roff: backslashes and hyphens escaped, no line begins a request. */
static void roff(FILE *to, const char *text)
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
    fputc('\n', to);
}

void murk_man_print(FILE *to)
{
    fprintf(to, ".TH MURK 1 \"\" \"murk %s\" \"User Commands\"\n",
            MURK_VERSION);
    fputs(".SH NAME\nmurk \\- light in fog, smoke, rain and water, and where "
          "sensors see it\n.SH SYNOPSIS\n.B murk\nCOMMAND SCENE [OPTIONS]\n"
          ".SH DESCRIPTION\n",
          to);
    roff(to, about);
    fputs(".SH COMMANDS\n", to);
    for (size_t i = 0; i < murk_commands_count; ++i) {
        fprintf(to, ".TP\n.B murk %s ", murk_commands[i].name);
        roff(to, murk_commands[i].arguments);
        roff(to, murk_commands[i].text);
    }
    fputs(".SH OPTIONS\n", to);
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if (!option->help) {
            continue;
        }
        char label[64];
        option_label(label, sizeof label, option);
        fputs(".TP\n.B ", to);
        roff(to, label);
        roff(to, option->help);
        if (option->commands) {
            fputs(".br\nCommands: ", to);
            roff(to, option->commands);
        }
    }
    fputs(".SH FILES\n", to);
    roff(to, "The scene file's keys, with units, ranges and defaults: "
             "scenes/README.md. Result files are written under a temporary "
             "name, flushed and renamed; the command's main JSON comes last.");
    fputs(".SH EXIT STATUS\n", to);
    roff(to, codes);
}
