# Headers that nearly every file reads, Eigen's above all, are read once for all of them: a file compiles in a second less.
# With g++ alone, which takes them as they are whatever else a target defines. What a file forgets to include, and what
# the warnings below would have found, the builds with clang and with sanitizers find, which go without.

function(flying_targets_of folder result)
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    foreach(below ${folders})
        flying_targets_of(${below} more)
        list(APPEND targets ${more})
    endforeach()
    set(${result} ${targets} PARENT_SCOPE)
endfunction()

# flying_precompile(name targets...): one set of headers for targets that share flying_flags
function(flying_precompile name)
    cmake_parse_arguments(arg "" "" "HEADERS;TARGETS" ${ARGN})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "// Holds the headers of all others\n")
    add_library(${name} STATIC ${PROJECT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE flying_flags)
    get_target_property(eigen_folder Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
    target_include_directories(${name} SYSTEM PRIVATE ${eigen_folder})
    target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
    foreach(target ${arg_TARGETS})
        target_precompile_headers(${target} REUSE_FROM ${name})
    endforeach()
endfunction()

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT FLYING_WASM AND NOT FLYING_SANITIZE)
    # g++ 12 forgets of precompiled headers that they are the system's, and warns of the standard library's own strings
    target_compile_options(flying_flags INTERFACE -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds
        -fpch-preprocess)
    flying_targets_of(${PROJECT_SOURCE_DIR} all)
    set(sources)
    set(tests)
    foreach(target ${all})
        get_target_property(type ${target} TYPE)
        if(NOT type MATCHES "^(STATIC_LIBRARY|EXECUTABLE)$")
            continue()
        endif()
        get_target_property(linked ${target} LINK_LIBRARIES)
        if("flying_test_main" IN_LIST linked)
            list(APPEND tests ${target})
        else()
            list(APPEND sources ${target})
        endif()
    endforeach()
    set(often <Eigen/Core> <algorithm> <array> <cmath> <cstdint> <cstdio> <functional> <limits> <map> <numbers>
        <optional> <span> <string> <string_view> <utility> <variant> <vector>)
    flying_precompile(flying_precompiled HEADERS ${often} TARGETS ${sources})
    if(tests)
        flying_precompile(flying_precompiled_tests HEADERS ${often} <doctest/doctest.h> TARGETS ${tests})
    endif()
endif()
