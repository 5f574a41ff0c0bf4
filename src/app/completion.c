/* Completion scripts for bash and zsh, from the tables of commands, options and
 * scene keys.
 *
 * A script has two parts. The first is the function _murk_words, which prints
 * the words that may follow an option or a command; it is written from the
 * tables and is the same for both shells. The second, fixed part asks this
 * function and hands the answer to the shell. The word "@files" stands for the
 * names of files and folders, "@keys" for the scene keys and "=". */
#include "app/built_in_files.h"
#include "app/field.h"
#include "app/help.h"
#include "app/lookup.h"

#include <string.h>

static const char for_bash[] =
    "_murk() {\n"
    "    local word=${COMP_WORDS[COMP_CWORD]} "
    "option=${COMP_WORDS[COMP_CWORD-1]}\n"
    "    local command=${COMP_WORDS[1]} words\n"
    "    # bash takes the = of --option=value for a word of its own\n"
    "    if [[ $word == = ]]; then\n"
    "        word=\n"
    "    elif [[ $option == = ]]; then\n"
    "        option=${COMP_WORDS[COMP_CWORD-2]}\n"
    "    fi\n"
    "    ((COMP_CWORD > 1)) || command=\n"
    "    words=$(_murk_words \"$command\" \"$option\" \"$word\")\n"
    "    COMPREPLY=()\n"
    "    case $words in\n"
    "    @files) compopt -o filenames 2>/dev/null\n"
    "        mapfile -t COMPREPLY < <(compgen -f -- \"$word\") ;;\n"
    "    @keys) compopt -o nospace 2>/dev/null\n"
    "        mapfile -t COMPREPLY < <(compgen -S = -W \"$(_murk_keys)\" -- "
    "\"$word\") ;;\n"
    "    *) mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\") ;;\n"
    "    esac\n"
    "}\n"
    "complete -F _murk murk\n";

static const char for_zsh[] =
    "_murk() {\n"
    "    local word=${words[CURRENT]} option=${words[CURRENT-1]} found\n"
    "    local command=${words[2]}\n"
    "    if [[ $word == --*=* ]]; then\n"
    "        option=${word%%=*}\n"
    "        compset -P '*='\n"
    "        word=$PREFIX\n"
    "    fi\n"
    "    (( CURRENT > 2 )) || command=\n"
    "    found=$(_murk_words \"$command\" \"$option\" \"$word\")\n"
    "    case $found in\n"
    "    @files) _files ;;\n"
    "    @keys) compadd -S = -- ${=$(_murk_keys)} ;;\n"
    "    *) compadd -- ${=found} ;;\n"
    "    esac\n"
    "}\n"
    "_murk \"$@\"\n";

/* ---- words from the tables ---- */

/* Prints the shell command that prints the words that may follow an option. For
 * values that a shell cannot know, such as numbers, that command prints
 * nothing. */
static void put_values(FILE *to, const murk_option *option)
{
    const char *argument = option->argument;
    if (option->words) {
        fputs("echo '", to);
        for (size_t i = 0; option->words[i]; ++i) {
            fprintf(to, "%s%s", i ? " " : "", option->words[i]);
        }
        fputs("'", to);
    } else if (strncmp(argument, "KEY=", 4) == 0) {
        fputs("echo @keys", to);
    } else if (strncmp(argument, "KEY", 3) == 0) {
        fputs("_murk_keys", to);
    } else if (strstr(argument, "FILE") || strcmp(argument, "DIR") == 0 ||
               option->part == MURK_OPTION_AS_FILE) {
        fputs("echo @files", to);
    } else {
        fputs(":", to);
    }
}

/* Prints the case of each option that takes a value. */
static void put_options_with_value(FILE *to)
{
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if (!option->help || !option->argument) {
            continue;
        }
        fprintf(to, "    %s%s%s) ", option->name, option->other ? "|" : "",
                option->other ? option->other : "");
        put_values(to, option);
        fputs("\n        return ;;\n", to);
    }
}

static void put_options_of(FILE *to, const char *command)
{
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if (option->help && murk_option_belongs(option, command)) {
            fprintf(to, " %s", option->name);
        }
    }
}

/* Prints the names of the presets, a list in the fields `f`. */
static void put_presets(FILE *to, const murk_fields *f)
{
    for (size_t i = 0; i < murk_field_length(f, "presets"); ++i) {
        fprintf(to, " %s", murk_field_text(f, "presets.%zu.name", i));
    }
}

/* Prints the names of the scenes to start from: those of the files, without
 * the ending. */
static void put_start_scenes(FILE *to)
{
    for (size_t i = 0; i < murk_start_files.n; ++i) {
        const char *file = murk_start_files.file[i].name;
        fprintf(to, " %.*s", (int)strcspn(file, "."), file);
    }
}

/* Prints the paths of all keys. `f` are the fields of the keys of a scene. */
static void put_paths(FILE *to, const murk_fields *f)
{
    for (size_t i = 0; i < murk_field_length(f, "all"); ++i) {
        fprintf(to, " %s", murk_field_text(f, "all.%zu.path", i));
    }
}

/* Prints the words that may follow a command. */
static void put_inputs_of(FILE *to, const murk_command *command,
                          const murk_fields *keys, const murk_fields *presets)
{
    switch (command->input) {
    case MURK_INPUT_SCENE:
    case MURK_INPUT_STUDY:
    case MURK_INPUT_FOLDER:
    case MURK_INPUT_PARTS:
        fputs("@files", to);
        break;
    case MURK_INPUT_PRESET:
        put_presets(to, presets);
        break;
    case MURK_INPUT_START_SCENE:
        put_start_scenes(to);
        break;
    case MURK_INPUT_KEY:
        put_paths(to, keys);
        break;
    case MURK_INPUT_NONE:
        break;
    }
}

/* Prints the paths of keys that --set takes. Keys of list items and of named
 * maps are left out, since their paths hold numbers and names of the scene. */
static void put_keys(FILE *to, const murk_fields *f)
{
    for (size_t i = 0; i < murk_field_length(f, "all"); ++i) {
        char path[MURK_FIELD_PATH_SIZE];
        bool is_settable = false;
        snprintf(path, sizeof path, "all.%zu.is_settable", i);
        (void)murk_fields_bool(f, path, &is_settable, NULL);
        if (is_settable) {
            fprintf(to, " %s", murk_field_text(f, "all.%zu.path", i));
        }
    }
}

/* ---- the script ---- */

static void print_script(FILE *to, bool is_zsh, const murk_fields *keys,
                         const murk_fields *presets)
{
    fprintf(to,
            "%s# Completion of murk for %s, written by murk --completion.\n",
            is_zsh ? "#compdef murk\n" : "", is_zsh ? "zsh" : "bash");
    /* Values of options. */
    fputs("\n# _murk_words COMMAND OPTION WORD: what may stand at WORD, behind "
          "OPTION\n_murk_words() {\n    case $2 in\n",
          to);
    put_options_with_value(to);
    fputs("    esac\n", to);
    /* Options and inputs of each command; without a command, the commands. */
    fputs("    case $1/$3 in\n", to);
    for (size_t i = 0; i < murk_commands_count; ++i) {
        const murk_command *command = &murk_commands[i];
        fprintf(to, "    %s/-*) echo '", command->name);
        put_options_of(to, command->name);
        fprintf(to, "' ;;\n    %s/*) echo '", command->name);
        put_inputs_of(to, command, keys, presets);
        fputs("' ;;\n", to);
    }
    fputs("    */-*) echo '", to);
    put_options_of(to, NULL);
    fputs("' ;;\n    */*) echo '", to);
    for (size_t i = 0; i < murk_commands_count; ++i) {
        fprintf(to, " %s", murk_commands[i].name);
    }
    fputs("' ;;\n    esac\n}\n\n_murk_keys() {\n    echo '", to);
    put_keys(to, keys);
    fprintf(to, "'\n}\n\n%s", is_zsh ? for_zsh : for_bash);
}

murk_status murk_completion_print(FILE *to, bool is_zsh, murk_error *err)
{
    murk_lookup lookup;
    const murk_fields *presets = NULL;
    murk_status status = murk_lookup_begin(&lookup, "scene", err);
    if (!status) {
        status = murk_context_preset(lookup.context, NULL, NULL, NULL, 0, NULL,
                                     &presets, err);
    }
    if (!status) {
        print_script(to, is_zsh, lookup.fields, presets);
    }
    murk_lookup_end(&lookup);
    return status;
}
