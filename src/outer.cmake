# Scenes as text: toml++ is header-only here (scene/toml_library.hpp)
find_path(FLYING_TOML toml++/toml.h REQUIRED)
flying_module(scene world)
flying_together(flying_scene)

# The engine for pages: a library for its tests, and a module of WebAssembly, beside it a program for Node
flying_module(live scene)
# Beside scenes it runs what the chapters lend to their pages
file(GLOB live_pieces CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/*/live.cpp)
target_sources(flying_live PRIVATE ${live_pieces})
if(FLYING_WASM)
    # A page's module is small rather than quick (the preset says so), but for where large heaps spend their time
    set_property(SOURCE rest/sweep_batches.cpp APPEND PROPERTY COMPILE_OPTIONS -Os)
    target_compile_options(flying_collide PRIVATE -Oz)
    add_executable(flying_wasm ${CMAKE_CURRENT_SOURCE_DIR}/live/exports.cpp)
    target_link_libraries(flying_wasm PRIVATE flying_live)
    set_target_properties(flying_wasm PROPERTIES OUTPUT_NAME flying SUFFIX .wasm
        RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
    # The stack first, so that one that is too deep traps instead of overwriting what lies below
    target_link_options(flying_wasm PRIVATE -mexec-model=reactor -Wl,--strip-all -Wl,--stack-first
        -Wl,-z,stack-size=1048576)
    # Nothing but the stack's very end lies in the first kilobyte, so that what is added to a pointer may be part of a load:
    # 3 % less to load for a page. A stack that is too deep traps as before. Loops and branches that are built anew from
    # a flat form take half a hundredth off again, and no time
    find_program(FLYING_WASM_OPT wasm-opt REQUIRED)
    add_custom_command(TARGET flying_wasm POST_BUILD VERBATIM
        COMMAND ${FLYING_WASM_OPT} --flatten --rereloop -Oz -Oz --converge --low-memory-unused
            $<TARGET_FILE:flying_wasm> -o $<TARGET_FILE:flying_wasm>)
    foreach(script docs/theme/engine.js tests/differential/bits/flying)
        get_filename_component(name ${script} NAME)
        configure_file(${PROJECT_SOURCE_DIR}/${script} ${PROJECT_BINARY_DIR}/bin/${name} COPYONLY)
    endforeach()
    return()
endif()

# Reports and runs to go on with, as text
find_package(nlohmann_json REQUIRED)
flying_module(json scene)
target_link_libraries(flying_json PRIVATE nlohmann_json::nlohmann_json)

# Cairo's pictures
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
flying_module(draw world)
target_link_libraries(flying_draw PUBLIC PkgConfig::CAIRO)
flying_together(flying_draw)

# Files that appear whole or not at all
flying_module(files math)

# A scene that is played with, without a display
find_package(fmt REQUIRED)
flying_module(play draw scene)
target_link_libraries(flying_play PUBLIC fmt::fmt)
flying_light(flying_play)
flying_together(flying_play)

# Its window, where gtkmm is there
if(FLYING_WINDOW)
    pkg_check_modules(GTKMM IMPORTED_TARGET gtkmm-4.0)
endif()
if(GTKMM_FOUND)
    flying_module(window play files)
    target_link_libraries(flying_window PRIVATE PkgConfig::GTKMM)
    # gtkmm's headers take longer to read than all of these files: read them once
    set_target_properties(flying_window PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    flying_light(flying_window)
endif()

# The program
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
file(GLOB app_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/app/*.cpp)
add_executable(flying ${app_sources})
target_link_libraries(flying PRIVATE flying_draw flying_json flying_files fmt::fmt CLI11::CLI11)
flying_together(flying)
target_compile_definitions(flying PRIVATE FLYING_VERSION="${PROJECT_VERSION}"
    FLYING_SCENES="${PROJECT_SOURCE_DIR}/chapters/scenes")
if(TARGET flying_window)
    target_link_libraries(flying PRIVATE flying_window)
    target_compile_definitions(flying PRIVATE FLYING_WINDOW)
endif()
set_target_properties(flying PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
# The literate tool: a library for its tests, and the program
file(GLOB weave_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/weave/*.cpp)
list(FILTER weave_sources EXCLUDE REGEX "/main\\.cpp$")
add_library(flying_weave STATIC ${weave_sources})
pkg_check_modules(MD4C REQUIRED IMPORTED_TARGET md4c-html)
target_link_libraries(flying_weave PUBLIC flying_flags fmt::fmt PRIVATE nlohmann_json::nlohmann_json PkgConfig::MD4C)
target_include_directories(flying_weave PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
# The engine isn't in it, and the book takes seconds
flying_light(flying_weave)
flying_together(flying_weave)
add_executable(weave weave/main.cpp)
target_link_libraries(weave PRIVATE flying_weave CLI11::CLI11)
flying_light(weave)

include(${CMAKE_CURRENT_SOURCE_DIR}/install.cmake)
