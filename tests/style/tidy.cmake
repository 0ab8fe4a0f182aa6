# clang-tidy as .clang-tidy says over the sources of the libraries, each once: plugin/ is compiled for
# two precisions, but is the same code.
#   cmake -D ROOT=tree -D BUILD=folder -D RUN_CLANG_TIDY=program -D COMPILER=c++ -D JOBS=n -P tidy.cmake
cmake_minimum_required(VERSION 3.25)
file(READ ${BUILD}/compile_commands.json commands)
set(chosen "[]")
set(seen)
string(JSON last LENGTH "${commands}")
math(EXPR last "${last} - 1")
foreach(i RANGE ${last})
  string(JSON entry GET "${commands}" ${i})
  string(JSON file GET "${entry}" file)
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${ROOT} OUTPUT_VARIABLE name)
  if(name MATCHES "^(hydro|plugin)/" AND NOT name IN_LIST seen)
    list(LENGTH seen count)
    list(APPEND seen ${name})
    string(JSON chosen SET "${chosen}" ${count} "${entry}")
  endif()
endforeach()
file(WRITE ${BUILD}/tidy/compile_commands.json "${chosen}")

# Clang reads GCC's command lines. Its own warnings are off (-w): GCC's have been errors already.
# Headers that only GCC brings (omp.h) are found behind Clang's.
execute_process(COMMAND ${COMPILER} -print-file-name=include
                OUTPUT_VARIABLE headers OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${RUN_CLANG_TIDY} -quiet -p ${BUILD}/tidy -j ${JOBS}
                        -extra-arg=-w -extra-arg=-idirafter${headers}
                OUTPUT_VARIABLE said ERROR_VARIABLE complained RESULT_VARIABLE result)
if(result)
  message(FATAL_ERROR "${said}\n${complained}")
endif()
list(LENGTH seen count)
message(STATUS "${count} files are clean")
