/* The version of murk, as programs, results and pages state it. */
#ifndef MURK_BASE_VERSION_H
#define MURK_BASE_VERSION_H

#define MURK_VERSION "0.1.0"

#endif
