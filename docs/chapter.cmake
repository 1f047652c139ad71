# What a chapter's CMakeLists.txt may call.
#
# flying_chapter(LINK targets... [PROGRAMS names...])
#     Builds and runs what the chapter's page shows, out of the files of its folder:
#     demo.cpp             its output is `::output demo`; so for every other name in PROGRAMS
#     figures.cpp          run with a folder as its argument, into which it writes NAME.svg and NAME.ndjson
#     exercises/eK/        with tests.cpp: stub.hpp must compile and fail, solution.hpp must pass, and each answer of wrong.txt, where
#                          there is one, must fail in the test that it names
#     the target chapter_NN, where flying_test made one before: it leaves the receipts
#     The results go to the folder `book` of the build; the target `book` depends on them.

set(FLYING_BOOK_FOLDER ${PROJECT_BINARY_DIR}/book)

# flying_page_program(target source): a program that a page quotes
function(flying_page_program target source)
    add_executable(${target} ${source})
    target_link_libraries(${target} PRIVATE flying_flags ${ARGN})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
    flying_light(${target})
endfunction()

# flying_answer(target folder answer targets...): the tests of an exercise with an answer to it. What the two do is counted, and
# tests/support/steps.cpp ends what comes to no end.
function(flying_answer target folder answer)
    add_executable(${target} ${folder}/tests.cpp ${answer})
    target_link_libraries(${target} PRIVATE flying_test_main flying_steps ${ARGN})
    target_include_directories(${target} PRIVATE ${folder} ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/chapters)
    flying_light(${target})
    # A loop that comes to no end is left in, whatever the language allows a compiler to assume
    target_compile_options(${target} PRIVATE -fsanitize-coverage=trace-pc -fno-finite-loops)
    target_compile_definitions(${target} PRIVATE FLYING_ANSWER="${answer}" FLYING_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()

function(flying_exercise number folder)
    get_filename_component(name ${folder} NAME)
    get_filename_component(chapter ${CMAKE_CURRENT_SOURCE_DIR} NAME)
    set(answers solution)
    if(FLYING_ONCE)
        list(APPEND answers stub)
    endif()
    set(mine ${PROJECT_SOURCE_DIR}/my/${chapter}/${name}.hpp)
    if(EXISTS ${mine})
        list(APPEND answers mine)
    endif()
    foreach(answer ${answers})
        set(target exercise_${number}_${name}_${answer})
        if(answer STREQUAL "mine")
            flying_answer(${target} ${folder} ${mine} ${ARGN})
            set_property(TARGET ${target} PROPERTY EXCLUDE_FROM_ALL ON)
        else()
            flying_answer(${target} ${folder} ${folder}/${answer}.hpp ${ARGN})
        endif()
    endforeach()
    set(title "exercise ${number} ${name}:")
    add_test(NAME "${title} the solution passes" COMMAND exercise_${number}_${name}_solution)
    set_tests_properties("${title} the solution passes" PROPERTIES TIMEOUT 60)
    add_test(NAME "${title} a hint is there" COMMAND ${CMAKE_COMMAND} -E md5sum ${folder}/hint.md)
    if(FLYING_ONCE)
        add_test(NAME "${title} the stub fails" COMMAND exercise_${number}_${name}_stub)
        set_tests_properties("${title} the stub fails" PROPERTIES WILL_FAIL TRUE TIMEOUT 60 LABELS once)
        flying_wrong_answers(${number} ${folder} ${ARGN})
    endif()
endfunction()

# What readers get wrong: the solution with a piece of it replaced, as docs/wrong.awk does, and the test that then speaks first
set(FLYING_WRONG_ANSWER ${CMAKE_CURRENT_LIST_DIR}/wrong.awk)
function(flying_wrong_answers number folder)
    set(list ${folder}/wrong.txt)
    if(NOT EXISTS ${list})
        return()
    endif()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
    get_filename_component(name ${folder} NAME)
    file(STRINGS ${list} titles REGEX "^# ")
    file(STRINGS ${list} speakers REGEX "^= ")
    foreach(title speaker IN ZIP_LISTS titles speakers)
        math(EXPR count "${count} + 1")
        set(target exercise_${number}_${name}_wrong_${count})
        set(answer ${CMAKE_CURRENT_BINARY_DIR}/${target}.hpp)
        add_custom_command(OUTPUT ${answer}
            COMMAND awk -v number=${count} -f ${FLYING_WRONG_ANSWER} ${list} ${folder}/solution.hpp > ${answer}
            DEPENDS ${FLYING_WRONG_ANSWER} ${list} ${folder}/solution.hpp VERBATIM)
        flying_answer(${target} ${folder} ${answer} ${ARGN})
        string(REGEX REPLACE "^[#=] " "" title "${title}")
        string(REGEX REPLACE "^[#=] " "" speaker "${speaker}")
        string(REGEX REPLACE "([][+.*()^$?|\\\\])" "\\\\\\1" speaker "${speaker}")
        set(test "exercise ${number} ${name}: not so: ${title}")
        add_test(NAME "${test}" COMMAND ${target} --no-colors=1 --abort-after=1)
        set_tests_properties("${test}" PROPERTIES PASS_REGULAR_EXPRESSION "TEST CASE: *${speaker}" TIMEOUT 60 LABELS once)
    endforeach()
endfunction()

function(flying_chapter)
    cmake_parse_arguments(arg "" "" "LINK;PROGRAMS" ${ARGN})
    get_filename_component(chapter ${CMAKE_CURRENT_SOURCE_DIR} NAME)
    string(SUBSTRING ${chapter} 0 2 number)
    set(matter "")

    # Run each program and keep what it prints
    foreach(program demo ${arg_PROGRAMS})
        if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${program}.cpp)
            continue()
        endif()
        set(target ${program}_${number})
        set(output ${FLYING_BOOK_FOLDER}/outputs/${chapter}/${program}.txt)
        flying_page_program(${target} ${program}.cpp ${arg_LINK})
        add_custom_command(OUTPUT ${output}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${FLYING_BOOK_FOLDER}/outputs/${chapter}
            COMMAND ${target} > ${output}.part
            COMMAND ${CMAKE_COMMAND} -E rename ${output}.part ${output}
            DEPENDS ${target} COMMENT "Running ${chapter}/${program}" VERBATIM)
        list(APPEND matter ${output})
        if(program STREQUAL demo)
            add_test(NAME "chapter ${number}: ${program} runs" COMMAND ${target})
        else()
            set_property(TARGET ${target} PROPERTY EXCLUDE_FROM_ALL ON) # the page runs it
        endif()
    endforeach()

    # Draw the figures
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/figures.cpp)
        set(drawn ${FLYING_BOOK_FOLDER}/figures/${chapter}.stamp)
        flying_page_program(figures_${number} figures.cpp ${arg_LINK})
        # The book alone needs them
        set_property(TARGET figures_${number} PROPERTY EXCLUDE_FROM_ALL ON)
        add_custom_command(OUTPUT ${drawn}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${FLYING_BOOK_FOLDER}/figures/${chapter}
            COMMAND figures_${number} ${FLYING_BOOK_FOLDER}/figures/${chapter}
            COMMAND ${CMAKE_COMMAND} -E touch ${drawn}
            DEPENDS figures_${number} COMMENT "Drawing ${chapter}" VERBATIM)
        list(APPEND matter ${drawn})
    endif()

    # Collect the receipts. A test that fails leaves none, and stops the book.
    set(receipts "")
    if(TARGET chapter_${number})
        set(receipts ${FLYING_BOOK_FOLDER}/receipts/chapter_${number}.json)
        target_include_directories(chapter_${number} PRIVATE ${PROJECT_SOURCE_DIR}/src)
        add_custom_command(OUTPUT ${receipts}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${FLYING_BOOK_FOLDER}/receipts
            COMMAND ${CMAKE_COMMAND} -E echo "{}" > ${receipts}.part
            COMMAND ${CMAKE_COMMAND} -E env FLYING_RECEIPTS=${receipts}.part $<TARGET_FILE:chapter_${number}> --minimal
            COMMAND ${CMAKE_COMMAND} -E rename ${receipts}.part ${receipts}
            DEPENDS chapter_${number} COMMENT "Collecting the receipts of ${chapter}" VERBATIM)
        list(APPEND matter ${receipts})
        add_custom_target(receipts_${number} DEPENDS ${receipts})
    endif()

    file(GLOB exercises CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/exercises/*/tests.cpp)
    foreach(tests ${exercises})
        get_filename_component(folder ${tests} DIRECTORY)
        flying_exercise(${number} ${folder} ${arg_LINK})

        # The page calls the solution one that passed in this build
        get_filename_component(name ${folder} NAME)
        set(passed ${FLYING_BOOK_FOLDER}/exercises/${chapter}/${name}.stamp)
        add_custom_command(OUTPUT ${passed}
            COMMAND exercise_${number}_${name}_solution --minimal
            COMMAND ${CMAKE_COMMAND} -E make_directory ${FLYING_BOOK_FOLDER}/exercises/${chapter}
            COMMAND ${CMAKE_COMMAND} -E touch ${passed}
            # After the receipts: a formula that broke is named as such before an exercise stumbles over it
            DEPENDS exercise_${number}_${name}_solution ${receipts} COMMENT "Trying the solution of ${chapter}/${name}" VERBATIM)
        list(APPEND matter ${passed})
    endforeach()

    add_custom_target(page_${number} DEPENDS ${matter})
    set_property(GLOBAL APPEND PROPERTY FLYING_BOOK_NEEDS page_${number})
endfunction()
