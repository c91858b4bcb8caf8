# cmake -DSCRATCH=<folder> -P layering_test_notices.cmake: layering_test.cmake passes a small tree that is right, and
# fails each time one thing in it is wrong.
cmake_minimum_required(VERSION 3.22)

# check(<regex of the complaint, or "passes"> [file content]...): the right tree, with these files on top.
function(check expected)
    file(REMOVE_RECURSE "${SCRATCH}")
    set(files
        src/nacre/base/error.h "#include <string>"
        src/nacre/optics/lobe.cpp "#include \"nacre/optics/lobe.h\"\n#include <glm/glm.hpp>\n#include <hwy/highway.h>"
        src/nacre/colour/observer.h "#include \"nacre/base/error.h\""
        src/nacre/lut/bake.h "#include \"nacre/optics/lobe.h\"\n#include \"nacre/colour/observer.h\""
        src/io/image/lut_file.cpp "#include \"nacre/lut/bake.h\"\n#include <fstream>\n#include <OpenImageIO/imageio.h>"
        src/cli/main.cpp "#include \"io/image/lut_file.h\"\n#include <CLI/CLI.hpp>\n#include <thread>"
        README.md "" tests/x "" build/x "" .clang-format ""
        ${ARGN})
    while(files)
        list(POP_FRONT files name content)
        file(WRITE "${SCRATCH}/${name}" "${content}\n")
    endwhile()
    execute_process(COMMAND "${CMAKE_COMMAND}" "-DROOT=${SCRATCH}" -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/layering_test.cmake"
                    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    string(REGEX REPLACE "[ \n]+" " " output "${output}")
    if(expected STREQUAL "passes")
        if(NOT status EQUAL 0)
            message(SEND_ERROR "a right tree is refused: ${output}")
        endif()
    elseif(status EQUAL 0 OR NOT output MATCHES "${expected}")
        message(SEND_ERROR "expected the complaint \"${expected}\", got: ${output}")
    endif()
endfunction()

check(passes)
check("nacre/optics may not include from nacre/colour" src/nacre/optics/film.h "#include \"nacre/colour/observer.h\"")
check("nacre/colour may not include from nacre/optics" src/nacre/colour/a.h "  #  include \"nacre/optics/lobe.h\"")
check("nacre/colour may not include from nacre/lut" src/nacre/colour/a.cpp "#include \"nacre/lut/bake.h\"")
check("nacre/base may not include from nacre/optics" src/nacre/base/error.h "#include \"nacre/optics/lobe.h\"")
check("nacre/lut may not include from io" src/nacre/lut/a.cpp "#include \"io/image/lut_file.h\"")
check("nacre/pick may not include from nacre/lut" src/nacre/pick/a.cpp "#include \"nacre/lut/job.h\"")
check("nacre/scene may not include from nacre/accuracy" src/nacre/scene/readers/a.cpp "#include \"nacre/accuracy/scan.h\"")
check("nacre/accuracy may not include from nacre/scene" src/nacre/accuracy/a.h "#include \"nacre/scene/readers/a.h\"")
check("nacre/scene may not include from nacre/swatch" src/nacre/scene/a.h "#include \"nacre/swatch/swatch.h\"")
check("io may not include from pipeline" src/io/ocio/a.cpp "#include \"pipeline/loaded_scene.h\"")
check("pipeline may not include from cli" src/pipeline/a.cpp "#include \"cli/console.h\"")
check("<CLI/CLI.hpp> belongs in cli, not in pipeline" src/pipeline/a.cpp "#include <CLI/CLI.hpp>")
check("io may not include from cli" src/io/a.cpp "#include \"cli/console.h\"")
check("\"lobe.h\" does not begin with" src/nacre/optics/lobe.cpp "#include \"lobe.h\"")
check("may not include <fstream>" src/nacre/lut/a.cpp "#include <fstream>")
check("may not include <cstdlib>" src/nacre/optics/a.cpp "#include <cstdlib>")
check("may not include <thread>" src/nacre/lut/a.h "#include <vector>\n#include <thread>")
check("standard library, GLM and Highway only, not <unistd.h>" src/nacre/lut/a.cpp "#include <unistd.h>")
check("standard library, GLM and Highway only, not <boost/math/x.hpp>" src/nacre/base/a.h "#include <boost/math/x.hpp>")
check("<OpenImageIO/imageio.h> belongs in io, not in nacre" src/nacre/lut/a.cpp "#include <OpenImageIO/imageio.h>")
check("<OpenColorIO/OpenColorIO.h> belongs in io, not in cli" src/cli/a.cpp "#include <OpenColorIO/OpenColorIO.h>")
check("<nlohmann/json.hpp> belongs in pipeline or cli or web, not in nacre" src/nacre/lut/a.h "#include <nlohmann/json.hpp>")
check("cannot tell what this includes" src/nacre/base/a.h "#include HEADER")
check("lies in none of the folders" src/util/misc.h "")
check("notes.txt: the root of the repository" notes.txt "")
check(".vscode: the root of the repository" .vscode/x "")
file(REMOVE_RECURSE "${SCRATCH}")
