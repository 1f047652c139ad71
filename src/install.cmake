# What others build on: cmake --install build/release --component library --prefix WHERE, then find_package(flying) and
# flying::flying (docs/USING.md)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# One archive of everything from `math` to `json`
set(objects)
foreach(module math motion geometry mass collide broadphase response toi events rest world scene json)
    list(APPEND objects $<TARGET_OBJECTS:flying_${module}>)
endforeach()
add_library(flying_library STATIC ${objects})
set_target_properties(flying_library PROPERTIES OUTPUT_NAME flying EXPORT_NAME flying LINKER_LANGUAGE CXX)
# Vectors have the same layout and inline functions the same bits on both sides of the headers
target_compile_definitions(flying_library INTERFACE EIGEN_DONT_VECTORIZE EIGEN_MPL2_ONLY)
target_compile_options(flying_library INTERFACE -ffp-contract=off)
target_compile_features(flying_library INTERFACE cxx_std_20)
target_link_libraries(flying_library INTERFACE Eigen3::Eigen)
if(FLYING_SANITIZE)
    target_link_options(flying_library INTERFACE -fsanitize=address,undefined)
endif()
target_include_directories(flying_library INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/flying>)

install(TARGETS flying_library EXPORT flying_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(EXPORT flying_targets NAMESPACE flying:: FILE flyingTargets.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/flying COMPONENT library)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/flyingConfig.cmake @ONLY CONTENT [[
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4)
include(${CMAKE_CURRENT_LIST_DIR}/flyingTargets.cmake)
]])
write_basic_package_version_file(${PROJECT_BINARY_DIR}/flyingConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/flyingConfig.cmake ${PROJECT_BINARY_DIR}/flyingConfigVersion.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/flying COMPONENT library)

# Headers: those that a user includes, and what these include; the rest of the engine stays inside
install(CODE "set(FLYING_SRC \"${CMAKE_CURRENT_SOURCE_DIR}\")
    set(FLYING_INCLUDE \"${CMAKE_INSTALL_INCLUDEDIR}/flying\")" COMPONENT library)
install(SCRIPT ${CMAKE_CURRENT_SOURCE_DIR}/install_headers.cmake COMPONENT library)

install(TARGETS flying RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)

# The module of Python, by the preset `python`
option(FLYING_PYTHON "Build the module flying of Python (needs pybind11 and NumPy)" OFF)
if(FLYING_PYTHON)
    set(PYBIND11_FINDPYTHON ON)
    find_package(pybind11 2.10 REQUIRED)
    pybind11_add_module(flying_python MODULE NO_EXTRAS python/module.cpp python/scene_text.cpp)
    target_link_libraries(flying_python PRIVATE flying_json nlohmann_json::nlohmann_json)
    target_compile_definitions(flying_python PRIVATE FLYING_VERSION="${PROJECT_VERSION}")
    set_target_properties(flying_python PROPERTIES OUTPUT_NAME flying LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/python)
    install(TARGETS flying_python DESTINATION ${Python_SITEARCH} COMPONENT python)
endif()

# The literate tool, with all that a book of one's own needs: find_package(weave), docs/BOOKS.md
install(TARGETS weave RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT weave)
install(FILES ${PROJECT_SOURCE_DIR}/docs/chapter.cmake ${PROJECT_SOURCE_DIR}/docs/Doxyfile.in
    ${PROJECT_SOURCE_DIR}/docs/formulas.js ${PROJECT_SOURCE_DIR}/docs/pack_module.js
    ${PROJECT_SOURCE_DIR}/docs/print.js ${PROJECT_SOURCE_DIR}/docs/browser.js ${PROJECT_SOURCE_DIR}/docs/letters.py
    ${PROJECT_SOURCE_DIR}/docs/wrong.awk
    DESTINATION ${CMAKE_INSTALL_DATADIR}/weave COMPONENT weave)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/theme DESTINATION ${CMAKE_INSTALL_DATADIR}/weave COMPONENT weave)
install(FILES ${PROJECT_SOURCE_DIR}/tests/main.cpp DESTINATION ${CMAKE_INSTALL_DATADIR}/weave/tests COMPONENT weave)
install(FILES ${PROJECT_SOURCE_DIR}/tests/support/receipts.hpp ${PROJECT_SOURCE_DIR}/tests/support/receipts.cpp
        ${PROJECT_SOURCE_DIR}/tests/support/listener.hpp ${PROJECT_SOURCE_DIR}/tests/support/steps.cpp
    DESTINATION ${CMAKE_INSTALL_DATADIR}/weave/tests/support COMPONENT weave)
set(WEAVE_KIT_FOLDER ${CMAKE_INSTALL_DATADIR}/weave)
set(WEAVE_BIN_FOLDER ${CMAKE_INSTALL_BINDIR})
configure_package_config_file(${PROJECT_SOURCE_DIR}/docs/weaveConfig.cmake.in ${PROJECT_BINARY_DIR}/weaveConfig.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/weave PATH_VARS WEAVE_KIT_FOLDER WEAVE_BIN_FOLDER)
install(FILES ${PROJECT_BINARY_DIR}/weaveConfig.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/weave COMPONENT weave)
