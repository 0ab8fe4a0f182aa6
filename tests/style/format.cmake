# Every source is formatted as .clang-format says.
#   cmake -D ROOT=tree -D CLANG_FORMAT=program -P tests/style/format.cmake
cmake_minimum_required(VERSION 3.25)
set(sources)
foreach(folder hydro plugin demos tests)
  file(GLOB_RECURSE found "${ROOT}/${folder}/*.h" "${ROOT}/${folder}/*.cpp")
  list(APPEND sources ${found})
endforeach()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${sources} RESULT_VARIABLE result)
if(result)
  message(FATAL_ERROR "run clang-format -i on the files above")
endif()
list(LENGTH sources count)
message(STATUS "${count} files are formatted")
