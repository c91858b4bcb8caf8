# What every target of this project is compiled with. Nothing here leaks to those who link the libraries.
function(nacre_target_options target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    # No fused multiply-adds behind our back. Highway asks for its own where the machine has them (colour/whole_cells.cpp).
    target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                                             -Wnon-virtual-dtor -Wold-style-cast)
    # GCC 12 sees overlaps in std::string's operator+ that are not there (GCC bug 105329).
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
        target_compile_options(${target} PRIVATE -Wno-restrict)
    endif()
    if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
        target_compile_options(${target} PRIVATE -Wreserved-identifier -Wzero-as-null-pointer-constant)
    endif()
    # Clang sees names of other files of a folder in a unity build; the linter compiles file by file and has no such.
    if(EMSCRIPTEN)
        target_compile_options(${target} PRIVATE -Wno-shadow)
    endif()
    if(NACRE_WARNINGS_AS_ERRORS)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
    if(NACRE_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=undefined
                                                 -fno-omit-frame-pointer)
        target_link_options(${target} PRIVATE -fsanitize=address,undefined)
    endif()
endfunction()

# With NACRE_UNITY_BUILD the files of a folder are compiled together, so that headers are read once per folder: that
# halves the time of a whole build, and makes one of a single file longer. Files of one folder therefore share their
# unnamed namespaces: give local names that differ. Left alone are files that a compiler reads several times (Highway's
# foreach_target.h), and those named behind the target.
function(nacre_unity_build target)
    if(NOT NACRE_UNITY_BUILD)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        if(IS_ABSOLUTE "${source}" OR source IN_LIST ARGN)
            continue()
        endif()
        file(STRINGS "${source}" several_times REGEX "foreach_target\\.h")
        if(NOT several_times)
            get_filename_component(folder "${source}" DIRECTORY)
            string(MAKE_C_IDENTIFIER "${target}_${folder}" group)
            set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
        endif()
    endforeach()
endfunction()
