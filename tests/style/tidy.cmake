# clang-tidy as .clang-tidy says over the sources of the libraries, each once: plugin/ is compiled for
# two precisions, but is the same code. The files of a folder are read as one, since most of the work
# is in Eigen's and Bullet's headers.
#   cmake -D ROOT=tree -D BUILD=folder -D RUN_CLANG_TIDY=program -D COMPILER=c++ -D JOBS=n -P tidy.cmake
cmake_minimum_required(VERSION 3.25)
file(READ ${BUILD}/compile_commands.json commands)
set(seen)
set(folders)
string(JSON last LENGTH "${commands}")
math(EXPR last "${last} - 1")
foreach(i RANGE ${last})
  string(JSON file GET "${commands}" ${i} file)
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${ROOT} OUTPUT_VARIABLE name)
  if(name MATCHES "^(hydro|plugin)/" AND NOT name IN_LIST seen)
    list(APPEND seen ${name})
    cmake_path(GET name PARENT_PATH folder)
    if(NOT folder IN_LIST folders)
      list(APPEND folders ${folder})
      set(first_of_${folder} ${i})
    endif()
    string(APPEND text_of_${folder} "#include \"${file}\"\n")
  endif()
endforeach()
if(NOT seen)
  message(FATAL_ERROR "no source of hydro/ or plugin/ is compiled by itself in ${BUILD}")
endif()

# One entry a folder: the command of its first file with all of them in that file's place.
set(chosen "[]")
set(count 0)
foreach(folder IN LISTS folders)
  set(together ${BUILD}/tidy/${folder}.cpp)
  file(WRITE ${together} "${text_of_${folder}}")
  string(JSON entry GET "${commands}" ${first_of_${folder}})
  string(JSON file GET "${entry}" file)
  string(REPLACE "${file}" "${together}" entry "${entry}")
  string(JSON chosen SET "${chosen}" ${count} "${entry}")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE ${BUILD}/tidy/compile_commands.json "${chosen}")
# Found from the sources upwards, and the build may lie outside the tree.
configure_file(${ROOT}/.clang-tidy ${BUILD}/tidy/.clang-tidy COPYONLY)

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
