# A build with Emscripten sees only the headers of its own folder. What nacre uses of header-only libraries is the same
# for every machine, so it is taken from this one's: links to it lie in one folder, and nothing else of /usr/include does.
set(NACRE_HOST_INCLUDE "/usr/include" CACHE PATH "Where the header-only libraries of this machine are")

set(headers "${CMAKE_BINARY_DIR}/host_headers")
file(MAKE_DIRECTORY "${headers}")
foreach(path IN ITEMS glm hwy toml++ nlohmann eigen3/Eigen ceres Imath xxhash.h)
    if(NOT EXISTS "${NACRE_HOST_INCLUDE}/${path}")
        message(FATAL_ERROR "${NACRE_HOST_INCLUDE}/${path} is missing; set NACRE_HOST_INCLUDE")
    endif()
    get_filename_component(name "${path}" NAME)
    file(CREATE_LINK "${NACRE_HOST_INCLUDE}/${path}" "${headers}/${name}" SYMBOLIC)
endforeach()
foreach(library IN ITEMS glm::glm hwy::hwy tomlplusplus::tomlplusplus nlohmann_json::nlohmann_json Eigen3::Eigen
                         Imath::Imath)
    add_library(${library} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${library} SYSTEM INTERFACE "${headers}")
endforeach()
# Highway 1.0 has no vectors of doubles for WebAssembly: its portable ones, which the compiler makes SIMD of.
target_compile_definitions(hwy::hwy INTERFACE HWY_COMPILE_ONLY_EMU128)
# Else half.h wants a table that lies in Imath's library.
target_compile_definitions(Imath::Imath INTERFACE IMATH_HALF_NO_LOOKUP_TABLE)
set(NACRE_CERES_INCLUDE_DIR "${headers}")

# SIMD and exceptions of WebAssembly itself: browsers since 2022 have both.
add_compile_options(-msimd128 -fwasm-exceptions)
add_link_options(-fwasm-exceptions)
