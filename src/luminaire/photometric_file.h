/* Reads photometric files: IES LM-63 of 1986, 1991, 1995, 2002 and 2019, and
 * EULUMDAT.
 *
 * Sources: IES LM-63-02; I. Ashdown, Parsing the IESNA LM-63 Photometric Data
 * File, 1998 (versions 1986 to 1995); the 2019 version from public summaries;
 * EULUMDAT: A. W. Stockmar, EULUMDAT - ein Leuchtendatenformat fuer den
 * europaeischen Beleuchtungsplaner, Tagungsband Licht '90 (1990), in secondary
 * descriptions. */
#ifndef MURK_LUMINAIRE_PHOTOMETRIC_FILE_H
#define MURK_LUMINAIRE_PHOTOMETRIC_FILE_H

#include "luminaire/luminaire.h"

/* Largest size of a photometric file. */
#define MURK_LUMINAIRE_BYTES_MAX 16000000

/* Reads a file; the format is recognised by the contents (a line TILT= is
 * LM-63) and for files with neither by the ending .ies. A file that LM-63's
 * TILT= names must lie beside the file. The caller owns *out. Fails with
 * MURK_BAD_FILE, with file and line, or with MURK_NO_MEMORY. */
murk_status murk_luminaire_read(murk_luminaire **out, const char *path,
                                murk_error *err);

/* As murk_luminaire_read(), from a text of `size` bytes, which a '\0' follows.
 * The text is changed. `path` is the name in messages, and TILT files are
 * looked for beside it. */
murk_status murk_luminaire_parse(murk_luminaire **out, const char *path,
                                 char *text, size_t size, murk_error *err);

#endif
