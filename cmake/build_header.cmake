# Writes murk_build.h (commit, its date, package versions) when it would change, so
# that a new commit rebuilds one file and an unchanged tree none.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
    set(commit unknown)
endif()
execute_process(COMMAND git -C ${SOURCE} log -1 --format=%cs
    OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
    string(TIMESTAMP date "%Y-%m-%d" UTC) # SOURCE_DATE_EPOCH where that is set
endif()
set(text "#define MURK_BUILD_COMMIT \"${commit}\"\n#define MURK_BUILD_DATE \"${date}\"\n")
foreach(pair ${PACKAGES})
    string(REPLACE "=" ";" pair "${pair}")
    list(GET pair 0 name)
    list(GET pair 1 version)
    string(APPEND text "#define MURK_BUILD_${name} \"${version}\"\n")
endforeach()
set(old "")
if(EXISTS ${HEADER})
    file(READ ${HEADER} old)
endif()
if(NOT old STREQUAL text)
    file(WRITE ${HEADER} "${text}")
endif()
