# clang-tidy as .clang-tidy says over the sources of the libraries, each once: plugin/ is compiled
# for two precisions, but is the same code. The files of a folder are read as one, since most of the
# work is in Eigen's and Bullet's headers. Where two of them use one name for two things, which they
# may, that does not compile: the folder is then read file by file.
#   cmake -D ROOT=tree -D BUILD=folder -D RUN_CLANG_TIDY=program -D JOBS=n -P tidy.cmake
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
    set(entry_of_${name} ${i})
    cmake_path(GET name PARENT_PATH folder)
    list(APPEND files_of_${folder} ${name})
    list(APPEND folders ${folder})
  endif()
endforeach()
list(REMOVE_DUPLICATES folders)
if(NOT seen)
  message(FATAL_ERROR "no source of hydro/ or plugin/ is compiled in ${BUILD}")
endif()

# Appends to the list of commands `chosen` the one that reads all `files` as the one source `name`:
# that of the first of them, with the source in that file's place. GCC's precompiled headers say
# nothing to Clang.
function(read_as_one name files)
  list(GET files 0 first)
  string(JSON entry GET "${commands}" ${entry_of_${first}})
  set(text)
  foreach(file IN LISTS files)
    string(APPEND text "#include \"${ROOT}/${file}\"\n")
  endforeach()
  set(together ${BUILD}/tidy/${name}.cpp)
  file(WRITE ${together} "${text}")
  string(REPLACE "${ROOT}/${first}" "${together}" entry "${entry}")
  string(REGEX REPLACE "-Winvalid-pch|-include [^ ]*cmake_pch[^ ]*" "" entry "${entry}")
  string(JSON length LENGTH "${chosen}")
  string(JSON chosen SET "${chosen}" ${length} "${entry}")
  set(chosen "${chosen}" PARENT_SCOPE)
endfunction()

# Runs the commands `chosen`; sets `said` and `result`. Clang reads GCC's command lines. Its own
# warnings are off (-w): GCC's have been errors already.
function(run_tidy)
  file(WRITE ${BUILD}/tidy/compile_commands.json "${chosen}")
  execute_process(COMMAND ${RUN_CLANG_TIDY} -quiet -p ${BUILD}/tidy -j ${JOBS} -extra-arg=-w
                  OUTPUT_VARIABLE said ERROR_VARIABLE complained RESULT_VARIABLE result)
  string(ASCII 27 escape)
  string(REGEX REPLACE "${escape}\\[[0-9;]*m" "" said "${said}\n${complained}")  # colours
  set(said "${said}" PARENT_SCOPE)
  set(result ${result} PARENT_SCOPE)
endfunction()

# Found from the sources upwards, and the build may lie outside the tree.
configure_file(${ROOT}/.clang-tidy ${BUILD}/tidy/.clang-tidy COPYONLY)
set(chosen "[]")
foreach(folder IN LISTS folders)
  read_as_one(${folder} "${files_of_${folder}}")
endforeach()
run_tidy()

if(result AND NOT said MATCHES "error: [^\n]*\\[(bugprone|performance|readability)-")
  set(chosen "[]")
  foreach(folder IN LISTS folders)
    if(said MATCHES "${ROOT}/${folder}/[^/\n]*: error: ")
      message(STATUS "${folder} does not compile as one source: read file by file")
      foreach(file IN LISTS files_of_${folder})
        read_as_one(${file} ${file})
      endforeach()
    endif()
  endforeach()
  if(NOT chosen STREQUAL "[]")
    run_tidy()
  endif()
endif()
if(result)
  message(FATAL_ERROR "${said}")
endif()
list(LENGTH seen count)
message(STATUS "${count} files are clean")
