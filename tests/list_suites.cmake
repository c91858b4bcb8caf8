# Asks a GoogleTest program for its suites and writes an entry for each to OUTPUT; see suites.cmake.
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests OUTPUT_VARIABLE listing RESULT_VARIABLE status)
if(NOT status EQUAL 0)
    file(REMOVE "${PROGRAM}")
    message(FATAL_ERROR "${PROGRAM} cannot list its tests (${status}): ${listing}")
endif()

# Suites stand at the beginning of a line and end in a point; their tests are indented. What parameters look like stands
# behind a #, and may hold anything.
string(REGEX REPLACE " *#[^\n]*" "" listing "${listing}")
string(REPLACE "\n" ";" lines "${listing}")
set(suites "")
set(suite "")
foreach(line IN LISTS lines)
    if(line MATCHES "^([^ ]+)\\.$")
        set(listed "${CMAKE_MATCH_1}")
        string(REGEX REPLACE "^.*/([A-Za-z_][A-Za-z0-9_]*)$" "\\1" suite "${listed}")
        list(APPEND suites "${suite}")
        list(APPEND filter_${suite} "${listed}.*")
    elseif(line MATCHES "^  ([^ ]+)$")
        list(APPEND tests_${suite} "${listed}.${CMAKE_MATCH_1}")
    endif()
endforeach()
list(REMOVE_DUPLICATES suites)

# Two programs may have suites of one name, and ctest would give the properties of either to both.
get_filename_component(program "${PROGRAM}" NAME)
string(REGEX REPLACE "^nacre_|_tests?$" "" program "${program}")

set(text "")
function(add_entry name filter labels cost)
    string(REPLACE "|" ";" variables "${ENVIRONMENT}")
    set(name "${program}.${name}")
    string(APPEND text "add_test([==[${name}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${filter}]==])\n"
                       "set_tests_properties([==[${name}]==] PROPERTIES LABELS [==[${labels}]==] COST ${cost} "
                       "ENVIRONMENT [==[${variables}]==])\n")
    set(text "${text}" PARENT_SCOPE)
endfunction()

foreach(suite IN LISTS suites)
    set(label "${LABEL}")
    set(cost 1)  # ctest begins with what costs most, so that no core waits for the last one
    if(SWEEP AND suite MATCHES "^(${SWEEP})$")
        set(label sweep)
        set(cost 100)
    endif()
    if(SINGLE AND suite MATCHES "^(${SINGLE})$")
        foreach(test IN LISTS tests_${suite})
            add_entry("${test}" "${test}" "${label}" ${cost})
        endforeach()
    else()
        list(JOIN filter_${suite} ":" filter)
        add_entry("${suite}" "${filter}" "${label}" ${cost})
    endif()
endforeach()
file(WRITE "${OUTPUT}" "${text}")
