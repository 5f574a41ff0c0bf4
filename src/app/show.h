/* The results of a command on standard output. */
#ifndef MURK_APP_SHOW_H
#define MURK_APP_SHOW_H

#include "app/options.h"

/* True if the summary of results is printed. */
bool murk_shows_summary(const murk_options *options);

/* Prints the fields of a save as the options ask for: the main JSON, or its
 * summary with the lines of times and files; NULL: nothing. */
void murk_show(const murk_options *options, const murk_fields *saved);

/* Fails with MURK_INTERRUPTED if the search for the plan was asked to finish
 * (app/terminal.h): the plan is valid, but a longer search may find a better
 * one. */
murk_status murk_show_check_search(const murk_fields *plan, murk_error *err);

/* Prints the lines of a list of texts. */
void murk_show_lines(const murk_fields *saved, const char *list);

/* The parts of murk_show(): JSON or summary; the lines of times and files below
 * a summary; and of these the line of times. */
void murk_show_results(const murk_options *options, const murk_fields *saved);
void murk_show_run(const murk_options *options, const murk_fields *saved);
void murk_show_times(const murk_fields *saved);

#endif
