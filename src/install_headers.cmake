# Copies the public headers and those that they include. FLYING_SRC is where from, FLYING_INCLUDE where to under the prefix.
cmake_policy(VERSION 3.25)
include(${FLYING_SRC}/public_headers.cmake)
flying_public_headers(${FLYING_SRC} headers)
foreach(header ${headers})
    get_filename_component(folder ${header} DIRECTORY)
    file(INSTALL ${FLYING_SRC}/${header} DESTINATION ${CMAKE_INSTALL_PREFIX}/${FLYING_INCLUDE}/${folder})
endforeach()
