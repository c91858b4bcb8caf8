# nacre_embed_text(target file symbol): the bytes of a file as `const std::string_view nacre::symbol`, read at build time.
#
# The library declares it: `namespace nacre { extern const std::string_view symbol; }`. Any bytes, any length (an array
# of char has no limit, where a string literal has), and a zero behind the last one. The file is a dependency.
#
# The second half of this file is the generator, run by the build as `cmake -P`: no tool but CMake is needed.
function(nacre_embed_text target file symbol)
    get_filename_component(input "${file}" ABSOLUTE)
    set(script "${CMAKE_CURRENT_FUNCTION_LIST_FILE}")
    set(output "${CMAKE_CURRENT_BINARY_DIR}/embedded/${symbol}.cpp")
    add_custom_command(
        OUTPUT "${output}"
        COMMAND "${CMAKE_COMMAND}" "-DINPUT=${input}" "-DOUTPUT=${output}" "-DSYMBOL=${symbol}" -P "${script}"
        DEPENDS "${input}" "${script}"
        COMMENT "Embedding ${symbol}"
        VERBATIM)
    target_sources(${target} PRIVATE "${output}")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE AND CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
    file(READ "${INPUT}" hex HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," characters "${hex}")
    # Eight characters of seven columns a line: compilers and people dislike one line of a megabyte.
    string(REGEX REPLACE "(.......)(.......)(.......)(.......)(.......)(.......)(.......)(.......)" "\\1\\2\\3\\4\\5\\6\\7\\8\n"
           characters "${characters}")
    get_filename_component(name "${INPUT}" NAME)
    file(WRITE "${OUTPUT}" "// Generated from ${name} by embed_text.cmake.
#include <string_view>

namespace nacre {
namespace {
constexpr char bytes[] = {
${characters}'\\0'};
}  // namespace
extern const std::string_view ${SYMBOL};
constinit const std::string_view ${SYMBOL}{bytes, sizeof bytes - 1};
}  // namespace nacre
")
endif()
