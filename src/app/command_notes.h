/* What --help and the man pages say of a command beside its options: the files
 * that it writes, and examples. */
#ifndef MURK_APP_COMMAND_NOTES_H
#define MURK_APP_COMMAND_NOTES_H

typedef struct murk_note_pair {
    const char *name, *text; /* a file and what it holds; a command line and
                                what it is for */
} murk_note_pair;

/* Entries of a command, with the empty one at the end. */
#define MURK_NOTES_FILES    24
#define MURK_NOTES_EXAMPLES 6

/* Lists end at the first name that is NULL. */
typedef struct murk_command_notes {
    const char *command;
    const char *formats; /* pages of section 5, with spaces between */
    murk_note_pair file[MURK_NOTES_FILES + 1];
    murk_note_pair example[MURK_NOTES_EXAMPLES + 1];
} murk_command_notes;

/* Every command has notes. */
const murk_command_notes *murk_command_notes_of(const char *command);

#endif
