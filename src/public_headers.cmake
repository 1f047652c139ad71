# The library's face: what a program that builds on it includes
set(FLYING_PUBLIC_HEADERS world/world.hpp scene/read.hpp scene/write.hpp scene/generate.hpp scene/generate_words.hpp scene/fault.hpp
    json/report_json.hpp json/saved_run.hpp)

# flying_public_headers(src result): these and all that they include, by their paths from src
function(flying_public_headers src result)
    set(waiting ${FLYING_PUBLIC_HEADERS})
    set(found)
    while(waiting)
        list(POP_FRONT waiting header)
        if(header IN_LIST found)
            continue()
        endif()
        list(APPEND found ${header})
        file(STRINGS ${src}/${header} lines REGEX "^#include \"")
        foreach(line ${lines})
            string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" included "${line}")
            list(APPEND waiting ${included})
        endforeach()
    endwhile()
    list(SORT found)
    set(${result} ${found} PARENT_SCOPE)
endfunction()
