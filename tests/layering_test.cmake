# cmake -DROOT=<repository> -P layering_test.cmake: fails, naming every culprit, when
#   - a file includes from a floor above its own, or from another room of its own floor (see `floors`),
#   - the core includes a third-party header other than GLM's and Highway's, or a standard one that reaches out of the
#     program (files, streams, threads, clocks, environment, global state),
#   - a library is used outside the folder that owns it,
#   - the root of the repository holds something that nobody expects there.
# layering_test_notices.cmake shows that it does.
cmake_minimum_required(VERSION 3.22)

set(root_entries
    .ci .clang-format .clang-tidy .git .github .gitignore CHANGELOG.md CMakeLists.txt CMakePresets.json LICENSE README.md
    build configs luts out run src tests)

# The rooms by floors, the lowest first. A file may include from its own room and from the floors below; rooms of one
# floor do not know each other. A room is a folder with all that lies in it: the longest that fits a path.
# nacre/export and nacre/conformance are planned and do not exist yet.
set(floors
    "nacre/base"
    "nacre/colour nacre/optics"
    "nacre/material"
    "nacre/shade"
    "nacre/pick nacre/lut"
    "nacre/accuracy nacre/scene nacre/export nacre/conformance"
    "nacre/swatch nacre/cost"
    "nacre/paper io"
    "pipeline"
    "cli web")

set(layers "")
set(below "")
foreach(floor IN LISTS floors)
    string(REPLACE " " ";" rooms "${floor}")
    foreach(room IN LISTS rooms)
        set(may_use_${room} ${below} ${room})
    endforeach()
    list(APPEND layers ${rooms})
    list(APPEND below ${rooms})
endforeach()

# The C and C++ headers that a pure, serial library has no business with. (<cstdlib> is getenv() and exit();
# std::abs is in <cmath> too.)
set(core_refuses
    cerrno chrono clocale condition_variable csetjmp csignal cstdio cstdlib ctime execution filesystem fstream future
    iostream latch barrier mutex semaphore shared_mutex stop_token syncstream thread)
# strtod() and snprintf(), for standard libraries whose <charconv> lacks doubles.
set(core_exceptions nacre/base/decimal.cpp)

# Third-party headers by the pattern of their names, and who may include them.
set(libraries
    "^glm/=nacre,io,pipeline,cli"
    "^hwy/=nacre"
    "^toml\\+\\+/=io"
    "^yaml-cpp/=io"
    "^OpenImageIO/=io"
    "^OpenColorIO/=io"
    "^Imath/=io,web"
    "^OpenEXR/=io"
    "^ceres/=io"
    "^Eigen/=io"
    "^xxhash\\.h=io"
    "^nlohmann/=pipeline,cli,web"
    "^CLI/=cli"
    "^tbb/=cli"
    "^oneapi/=cli")

set(generated_headers nacre_version.h)

# The folder among `layers` that the path lies in, or "".
function(layer_of path result)
    set(found "")
    foreach(layer IN LISTS layers)
        string(LENGTH "${found}" found_length)
        string(LENGTH "${layer}" length)
        string(FIND "${path}" "${layer}/" position)
        if(position EQUAL 0 AND length GREATER found_length)
            set(found "${layer}")
        endif()
    endforeach()
    set(${result} "${found}" PARENT_SCOPE)
endfunction()

set(complaints "")
set(files_read 0)
set(includes_read 0)
set(quoted "^[ \t]*#[ \t]*include[ \t]*\"([^\"]*)\"")
set(angled "^[ \t]*#[ \t]*include[ \t]*<([^>]*)>")

file(GLOB_RECURSE files RELATIVE "${ROOT}/src" "${ROOT}/src/*.h" "${ROOT}/src/*.cpp" "${ROOT}/src/*.in")
list(FILTER files EXCLUDE REGEX "^cmake/")
foreach(file IN LISTS files)
    math(EXPR files_read "${files_read} + 1")
    layer_of("${file}" layer)
    if(layer STREQUAL "")
        list(APPEND complaints "src/${file}: lies in none of the folders that the design knows")
        continue()
    endif()
    string(REGEX REPLACE "/.*" "" top "${layer}")

    file(STRINGS "${ROOT}/src/${file}" lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
        math(EXPR includes_read "${includes_read} + 1")
        if(line MATCHES "${quoted}")
            set(header "${CMAKE_MATCH_1}")
            layer_of("${header}" target)
            if(target STREQUAL "")
                if(NOT header IN_LIST generated_headers OR top STREQUAL "nacre")
                    list(APPEND complaints "src/${file}: \"${header}\" does not begin with nacre/, io/, pipeline/ or cli/")
                endif()
            elseif(NOT target IN_LIST may_use_${layer})
                list(APPEND complaints "src/${file}: ${layer} may not include from ${target}: \"${header}\"")
            endif()
        elseif(line MATCHES "${angled}")
            set(header "${CMAKE_MATCH_1}")
            set(owners "")
            foreach(library IN LISTS libraries)
                string(REGEX MATCH "^(.*)=(.*)$" row "${library}")
                set(pattern "${CMAKE_MATCH_1}")
                string(REPLACE "," ";" owners_here "${CMAKE_MATCH_2}")
                if(header MATCHES "${pattern}")
                    set(owners ${owners_here})
                endif()
            endforeach()
            if(owners)
                if(NOT top IN_LIST owners)
                    list(JOIN owners " or " owners)
                    list(APPEND complaints "src/${file}: <${header}> belongs in ${owners}, not in ${top}")
                endif()
            elseif(top STREQUAL "nacre")
                if(header IN_LIST core_refuses AND NOT file IN_LIST core_exceptions)
                    list(APPEND complaints "src/${file}: the core is pure and serial; it may not include <${header}>")
                elseif(NOT header MATCHES "^[a-z0-9_]+$")
                    list(APPEND complaints
                         "src/${file}: the core knows the standard library, GLM and Highway only, not <${header}>")
                endif()
            endif()
        elseif(top STREQUAL "nacre")  # a header named by a macro
            list(APPEND complaints "src/${file}: cannot tell what this includes: ${line}")
        endif()
    endforeach()
endforeach()
if(files_read LESS 1 OR includes_read LESS 1)
    list(APPEND complaints "${ROOT}/src: nothing to check")
endif()

# What git tracks, where there is git, so that a developer's own files are nobody's business.
set(git_status 1)
if(EXISTS "${ROOT}/.git")
    execute_process(COMMAND git -C "${ROOT}" ls-files --full-name -- . OUTPUT_VARIABLE entries ERROR_QUIET
                    RESULT_VARIABLE git_status)
    string(REGEX REPLACE "/[^\n]*" "" entries "${entries}")
    string(REPLACE "\n" ";" entries "${entries}")
endif()
if(NOT git_status EQUAL 0)
    file(GLOB entries RELATIVE "${ROOT}" "${ROOT}/*" "${ROOT}/.*")
endif()
list(REMOVE_DUPLICATES entries)
list(REMOVE_ITEM entries "" "." "..")
foreach(entry IN LISTS entries)
    if(NOT entry IN_LIST root_entries)
        list(APPEND complaints "${entry}: the root of the repository holds only what the design lists")
    endif()
endforeach()

if(complaints)
    list(JOIN complaints "\n" complaints)
    message(FATAL_ERROR "${complaints}")
endif()
message(STATUS "${files_read} files, ${includes_read} includes: all point down")
