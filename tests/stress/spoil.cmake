# cmake -DFROM=file -DTO=file -DWAS=text -DIS=text -P spoil.cmake: a copy in which one text is another. The text must stand
# in the file exactly once.
file(READ ${FROM} text)
string(REPLACE "${WAS}" "" without "${text}")
string(LENGTH "${text}" before)
string(LENGTH "${without}" after)
string(LENGTH "${WAS}" length)
math(EXPR gone "${before} - ${after}")
if(NOT gone EQUAL length)
    message(FATAL_ERROR "${FROM} holds '${WAS}' ${gone} / ${length} times, expected once: see tests/stress/CMakeLists.txt")
endif()
string(REPLACE "${WAS}" "${IS}" text "${text}")
file(WRITE ${TO} "${text}")
