/* States the build: commit, date and package versions, which
 * cmake/build_header.cmake looks up at every build, and the compiler. */
#include "results/version.h"

#include "murk_build.h" /* made by cmake/build_header.cmake at every build */

/* FreeType is missing: only the drawing of murk check depends on it, and no
 * result. */
const murk_package murk_packages[] = {
    {"embree", MURK_BUILD_EMBREE}, {"openvdb", MURK_BUILD_OPENVDB},
    {"assimp", MURK_BUILD_ASSIMP}, {"libyaml", MURK_BUILD_YAML},
    {"xxhash", MURK_BUILD_XXHASH}, {"libmd", MURK_BUILD_MD},
    {"cjson", MURK_BUILD_CJSON},   {"libnova", MURK_BUILD_NOVA},
    {"ceres", MURK_BUILD_CERES},   {"openexr", MURK_BUILD_OPENEXR},
    {"libpng", MURK_BUILD_PNG},    {"libseccomp", MURK_BUILD_SECCOMP},
};
const size_t murk_packages_count = sizeof murk_packages / sizeof *murk_packages;

const char *murk_version_commit(void)
{
    return MURK_BUILD_COMMIT;
}

const char *murk_version_with_commit(void)
{
    return MURK_VERSION " " MURK_BUILD_COMMIT;
}

const char *murk_version_date(void)
{
    return MURK_BUILD_DATE;
}

const char *murk_version_compiler(void)
{
#ifdef __clang__
    return "clang " __clang_version__;
#else
    return "gcc " __VERSION__;
#endif
}
