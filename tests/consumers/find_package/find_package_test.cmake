# cmake -DNACRE_BINARY_DIR=... -DSCRATCH=... -DGENERATOR=... -DCXX=... -DBUILD_TYPE=... -DLINK_FLAGS=... [-DWITH_PROGRAM=ON] -P this
#
# Installs nacre into a new folder, moves it (an installation must not depend on where it was made), and builds and runs
# the project beside this file against it.
cmake_minimum_required(VERSION 3.22)

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
run("${CMAKE_COMMAND}" --install "${NACRE_BINARY_DIR}" --prefix "${SCRATCH}/made")
file(RENAME "${SCRATCH}/made" "${SCRATCH}/moved")

run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${SCRATCH}/build" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_EXE_LINKER_FLAGS=${LINK_FLAGS}"
    "-DCMAKE_PREFIX_PATH=${SCRATCH}/moved")
run("${CMAKE_COMMAND}" --build "${SCRATCH}/build")
run("${SCRATCH}/build/nacre_consumer")

# nacre came from the new folder, and nothing in it names the place where it was built.
file(STRINGS "${SCRATCH}/build/CMakeCache.txt" found REGEX "^nacre_DIR:PATH=${SCRATCH}/moved/")
file(GLOB_RECURSE package "${SCRATCH}/moved/*.cmake")
foreach(file IN LISTS package)
    file(READ "${file}" text)
    string(FIND "${text}" "${NACRE_BINARY_DIR}" position)
    if(NOT position EQUAL -1)
        message(FATAL_ERROR "${file} names the build folder")
    endif()
endforeach()
if(NOT found OR NOT package)
    message(FATAL_ERROR "the project was not built against what was installed")
endif()

if(WITH_PROGRAM)
    run("${SCRATCH}/moved/bin/nacre" --version)
endif()
file(REMOVE_RECURSE "${SCRATCH}")
