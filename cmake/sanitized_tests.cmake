# Quick tests under the sanitizers: a few rooms that need no C++ package are
# compiled once more with a sanitizer, and some of their unit tests run with
# them. tools/check address and thread run all tests of a sanitized program.
#
# Most of the cost of the first kind is compiling, that of the second running.
#
# murk_sanitized(KIND LEVEL -O ROOMS ROOM... TESTS ROOM/NAME...) makes the ctest entries
# sanitize/KIND-ROOM-NAME, and murk_caught(KIND DEFECT REPORT) the entry
# sanitize/KIND-catches-DEFECT, of a planted defect that must be reported.

# Where the kernel lays out memory in a way that the sanitizer of this gcc does
# not know, nothing can be said.
set(murk_sanitizer_refusal "Sanitizer: (unexpected memory mapping|Shadow memory range interleaves)")

function(murk_sanitized_program target kind)
    add_executable(${target} ${ARGN})
    target_link_libraries(${target} PRIVATE murk_sanitized_${kind})
endfunction()

function(murk_sanitized_entry name)
    add_test(NAME sanitize/${name} COMMAND ${ARGN} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    set_tests_properties(sanitize/${name} PROPERTIES LABELS sanitize TIMEOUT 300
        SKIP_REGULAR_EXPRESSION "${murk_sanitizer_refusal}")
endfunction()

function(murk_sanitized kind)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "LEVEL" "ROOMS;TESTS")
    set(library murk_sanitized_${kind})
    add_library(${library} STATIC tests/support/check.c tests/support/thread_ranks.c)
    foreach(room ${arg_ROOMS})
        get_target_property(files murk_${room} SOURCES)
        target_sources(${library} PRIVATE ${files})
        add_dependencies(${library} murk_${room}) # which makes the files that are built in
    endforeach()
    murk_room_flags(${library})
    target_compile_options(${library} PUBLIC ${murk_sanitizer_${kind}} ${arg_LEVEL})
    target_link_options(${library} PUBLIC ${murk_sanitizer_${kind}})
    target_include_directories(${library} PUBLIC tests/support)
    target_link_libraries(${library} PUBLIC murk_flags m Threads::Threads PkgConfig::XXHASH PkgConfig::MD
        PkgConfig::SECCOMP PkgConfig::YAML)
    foreach(test ${arg_TESTS})
        get_filename_component(room ${test} DIRECTORY)
        get_filename_component(name ${test} NAME)
        set(target test_sanitize_${kind}_${room}_${name})
        murk_sanitized_program(${target} ${kind} tests/unit/${room}/test_${name}.c)
        murk_sanitized_entry(${kind}-${room}-${name} ${target})
    endforeach()
    murk_sanitized_program(defects_${kind} ${kind} tests/sanitize/defects.c)
endfunction()

function(murk_caught kind defect report)
    murk_sanitized_entry(${kind}-catches-${defect} tests/sanitize/caught.sh
        $<TARGET_FILE:defects_${kind}> ${defect} "${report}")
endfunction()

murk_sanitized(address LEVEL -O0 ROOMS base preset luminaire weather terrain scene
    TESTS base/subprocess base/file base/staging luminaire/luminaire scene/conditions scene/refusals scene/table scene/yaml)
murk_caught(address overflow "AddressSanitizer: heap-buffer-overflow")
murk_caught(address leak "LeakSanitizer: detected memory leaks")
murk_caught(address undefined "runtime error: signed integer overflow")

murk_sanitized(thread LEVEL -O1 ROOMS base photonmap TESTS base/pool base/progress base/ranks
    photonmap/map_threads)
murk_caught(thread race "ThreadSanitizer: data race")
