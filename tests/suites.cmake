# What ctest sees of a GoogleTest program: one entry per suite, not one per test. Debian's OpenImageIO brings 250
# libraries, and a program that is linked with it takes about half a second to start.
#
#   nacre_add_suites(TARGET [SINGLE SUITE...] [SWEEP SUITE...] [LABEL NAME] [ENVIRONMENT NAME=VALUE...])
#
# SINGLE  suites whose tests take so long that each is an entry of its own, to be shared among cores
# SWEEP   suites that are labelled `sweep`; all others are `quick`
# LABEL   a label instead of `quick`
#
# Parameterised suites (Prefix/Suite) are found by the name behind the slash. `./run` counts the tests of all suites.
set(NACRE_LIST_SUITES "${CMAKE_CURRENT_LIST_DIR}/list_suites.cmake")

function(nacre_add_suites target)
    cmake_parse_arguments(ARG "" "LABEL" "SINGLE;SWEEP;ENVIRONMENT" ${ARGN})
    if(NOT ARG_LABEL)
        set(ARG_LABEL quick)
    endif()
    set(tests "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
    list(JOIN ARG_SINGLE "|" single)
    list(JOIN ARG_SWEEP "|" sweep)
    list(JOIN ARG_ENVIRONMENT "|" environment)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${NACRE_LIST_SUITES}")
    add_custom_command(TARGET ${target} POST_BUILD VERBATIM
        COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${target}>" "-DOUTPUT=${tests}" "-DLABEL=${ARG_LABEL}"
                "-DSINGLE=${single}" "-DSWEEP=${sweep}" "-DENVIRONMENT=${environment}" -P "${NACRE_LIST_SUITES}")
    set(include "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake")
    file(WRITE "${include}" "if(EXISTS \"${tests}\")\n    include(\"${tests}\")\nelse()\n"
                            "    add_test(${target}_is_not_built ${target}_is_not_built)\nendif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include}")
endfunction()
