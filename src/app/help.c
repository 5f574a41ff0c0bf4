/* Prints the help of the program and of each command, from the tables of
 * commands and options. */
#include "app/help.h"

#include <stdbool.h>
#include <string.h>

/* The longest line, within the 80 columns of a terminal; the column at which
 * the text of an option begins; and the indent of the lines of an example
 * command after the first. */
#define WIDTH             78
#define INDENT            24
#define INDENT_OF_COMMAND 5

const char murk_help_about[] =
    "murk simulates light in fog, smoke, rain and water, and places sensors in "
    "it. Photons meet surfaces and media and are stored in photon maps; SPOQ "
    "finds the sensors that see the most of them through occlusion and "
    "attenuation.";

const char murk_help_messages[] =
    "An error is one line: \"murk: FILE:LINE:COLUMN: KEY: "
    "found, allowed, unit\".";

const char murk_help_files[] =
    "Files are written under a temporary name, "
    "flushed and renamed, the command's main JSON last: a run that is killed "
    "leaves the old results or none.";

static const char codes[] =
    "0 done; 1 the run failed; 2 bad input or usage; 130 interrupted; 141 "
    "standard output was closed before its end.";

/* Prints text in lines of WIDTH, the later ones indented; `at` is the column
 * that is reached already. */
static void wrap(FILE *to, const char *text, size_t at, size_t indent)
{
    const char *between = "";
    while (*text) {
        const size_t word = strcspn(text, " ");
        if (*between && at + 1 + word > WIDTH) {
            fprintf(to, "\n%*s", (int)indent, "");
            at = indent;
            between = "";
        }
        fprintf(to, "%s%.*s", between, (int)word, text);
        at += strlen(between) + word;
        between = " ";
        text += word;
        text += strspn(text, " ");
    }
    fputc('\n', to);
}

/* Prints the options of a command; of NULL those that all commands have. */
static void print_options(FILE *to, const char *command)
{
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if (!option->help || !murk_option_belongs(option, command)) {
            continue;
        }
        const char *other = option->other, *argument = option->argument;
        const int end = fprintf(to, "  %s%s%s%s%s", other ? other : "",
                                other ? ", " : "", option->name,
                                argument ? " " : "", argument ? argument : "");
        if (end < INDENT) {
            fprintf(to, "%*s", INDENT - end, "");
        } else {
            fprintf(to, "\n%*s", INDENT, "");
        }
        wrap(to, option->help, INDENT, INDENT);
    }
}

/* Bytes of the word at `text`: up to a blank that is not in quotes. */
static size_t quoted_word_length(const char *text)
{
    size_t n = 0;
    bool is_quoted = false;
    for (; text[n] && (is_quoted || text[n] != ' '); ++n) {
        is_quoted ^= text[n] == '\'';
    }
    return n;
}

/* Prints a command in lines of WIDTH that a shell reads as one: "\" ends each
 * but the last. */
static void print_command(FILE *to, const char *text)
{
    size_t at = (size_t)fprintf(to, " ");
    while (*text) {
        const size_t word = quoted_word_length(text);
        if (at > INDENT_OF_COMMAND && at + 1 + word + 2 > WIDTH) {
            at = (size_t)fprintf(to, " \\\n%*s", INDENT_OF_COMMAND, "") - 3;
        }
        at += (size_t)fprintf(to, " %.*s", (int)word, text);
        text += word;
        text += strspn(text, " ");
    }
    fputc('\n', to);
}

static void print_examples(FILE *to, const murk_note_pair *example)
{
    if (example->name) {
        fputs("\nexamples:\n", to);
    }
    for (; example->name; ++example) {
        print_command(to, example->name);
        fprintf(to, "%6s", "");
        wrap(to, example->text, 6, 6);
    }
}

void murk_help_print(FILE *to, const murk_command *command)
{
    /* The help of one command. */
    if (command) {
        fprintf(to, "usage: murk %s %s [OPTIONS]\n\n", command->name,
                command->arguments);
        wrap(to, command->text, 0, 0);
        fputs("\noptions:\n", to);
        print_options(to, command->name);
        print_examples(to, command->example);
        fprintf(to, "\nmore: man murk-%s\n", command->name);
        return;
    }
    /* The help of the program. */
    fputs("usage: murk COMMAND SCENE [OPTIONS]\n\n", to);
    wrap(to, murk_help_about, 0, 0);
    fputs("\ncommands:\n", to);
    for (size_t i = 0; i < murk_commands_count; ++i) {
        fprintf(to, "  %-8s %s\n", murk_commands[i].name,
                murk_commands[i].summary);
    }
    fputs("\noptions of every command (murk COMMAND --help: all of one):\n",
          to);
    print_options(to, NULL);
    fputs("\nexit codes: ", to);
    wrap(to, codes, 12, 0);
    wrap(to, murk_help_messages, 0, 0);
    fputs("\nmore: man murk, man murk-COMMAND, man murk-scene\n", to);
}
