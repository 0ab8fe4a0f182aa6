# clang-tidy as .clang-tidy says over the sources of the libraries, each once and together as they
# are compiled: plugin/ is compiled for two precisions, but is the same code.
#   cmake -D ROOT=tree -D BUILD=folder -D RUN_CLANG_TIDY=program -D JOBS=n -P tidy.cmake
cmake_minimum_required(VERSION 3.25)
file(READ ${BUILD}/compile_commands.json commands)
string(JSON last LENGTH "${commands}")
math(EXPR last "${last} - 1")
set(chosen "[]")
set(count 0)
foreach(i RANGE ${last})
  string(JSON entry GET "${commands}" ${i})
  string(JSON command GET "${entry}" command)
  if(command MATCHES " -o (hydro|plugin)/CMakeFiles/(hydro|files|bem|plugin)\\.dir/")
    string(JSON chosen SET "${chosen}" ${count} "${entry}")
    math(EXPR count "${count} + 1")
  endif()
endforeach()
if(count EQUAL 0)
  message(FATAL_ERROR "no source of hydro/ or plugin/ is compiled in ${BUILD}")
endif()

# .clang-tidy is found from the sources upwards, and the build may lie outside the tree.
configure_file(${ROOT}/.clang-tidy ${BUILD}/.clang-tidy COPYONLY)
file(WRITE ${BUILD}/tidy/compile_commands.json "${chosen}")
# Clang reads GCC's command lines. Its own warnings are off (-w): GCC's have been errors already.
execute_process(COMMAND ${RUN_CLANG_TIDY} -quiet -p ${BUILD}/tidy -j ${JOBS} -extra-arg=-w
                OUTPUT_VARIABLE said ERROR_VARIABLE complained RESULT_VARIABLE result)
string(ASCII 27 escape)
string(REGEX REPLACE "${escape}\\[[0-9;]*m" "" said "${said}\n${complained}")  # colours
if(result)
  message(FATAL_ERROR "${said}")
endif()
message(STATUS "${count} sources are clean")
