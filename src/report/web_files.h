/* The files under src/report/web/, of which pages are made. */
#ifndef MURK_REPORT_WEB_FILES_H
#define MURK_REPORT_WEB_FILES_H

#include "base/built_in.h"

extern const murk_built_in murk_web_files;

#endif
