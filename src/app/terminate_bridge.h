/* The end of the program where a C++ library throws and nobody catches. */
#ifndef MURK_APP_TERMINATE_BRIDGE_H
#define MURK_APP_TERMINATE_BRIDGE_H

#ifdef __cplusplus
extern "C" {
#endif

/* From now on, what would abort the program with the C++ runtime's own text is
 * one line on standard error and exit code 1. May be called before the
 * constructors of libraries. */
void murk_terminate_install(void);

#ifdef __cplusplus
}
#endif

#endif
