/* The files that Assimp may open: regular ones, for reading. A pipe or device
 * named in a mesh cannot make the reader wait. */
#ifndef MURK_GEOMETRY_IMPORT_FILES_H
#define MURK_GEOMETRY_IMPORT_FILES_H

#include <assimp/cfileio.h>

struct aiFileIO murk_import_files(void);

#endif
