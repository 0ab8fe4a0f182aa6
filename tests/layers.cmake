# The direction of the tree, checked: reads every #include of hydro/, plugin/, demos/ and tests/ and
# refuses what the two tables below do not allow. Own headers are included by their full path from
# the root, in quotes; everything else in angle brackets.
#   cmake [-D ROOT=tree] -P tests/layers.cmake
cmake_minimum_required(VERSION 3.25)
if(NOT DEFINED ROOT)
  cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH ROOT)
endif()

# 1. Own layers: what each may include besides itself. `hydro` stands for the headers beside the
# folders of hydro/ (Conventions.h, Errors.h), which everybody may include.
set(may_hydro)
set(may_hydro/geometry)
set(may_hydro/waves    hydro/geometry)
set(may_hydro/green)
set(may_hydro/database hydro/geometry hydro/waves)
set(may_hydro/bem      hydro/geometry hydro/waves hydro/green hydro/database)
set(may_hydro/memory   hydro/database)
set(may_hydro/forces   hydro/geometry hydro/waves hydro/database hydro/memory)
set(may_plugin         hydro/geometry hydro/waves hydro/database hydro/memory hydro/forces)
set(may_demos          ${may_plugin} hydro/green hydro/bem plugin)
set(may_tests          ${may_plugin} hydro/green hydro/bem)
# The tests that may see the plugin, and with it Bullet.
set(plugin_tests plugin verification consumer bench demos)

# 2. Libraries: a pattern of the header, and a pattern of the files that may include it. A header that
# no row names must be one of the C++ standard's, which have neither a folder nor an ending.
set(libraries
  "Eigen/.+"                            ".*"
  "unsupported/Eigen/.+"                ".*"
  "assimp/.+"                           "hydro/geometry/MeshIO[^/]*"
  "(hdf5|H5.+)\\.h"                     "(hydro|tests)/database/.+"
  "(lapacke|cblas)\\.h"             "(hydro/bem|tests/bench)/.+"
  "(bt[A-Z]|Bullet[A-Z]|LinearMath/).+" "(plugin|demos|tests/(plugin|verification|consumer|bench|demos))/.+"
  "(CLI/CLI\\.hpp|toml\\+\\+/toml\\.h)" "(demos|tests)/.+"
  "fmt/.+\\.h"                          "((hydro|plugin)/.+\\.cpp|(demos|tests)/.+)"
  "gtest/.+|gmock/.+"                   "tests/.+"
  "benchmark/benchmark\\.h"             "tests/bench/.+"
  "(unistd|fcntl|stdlib)\\.h|sys/.+\\.h" ".*"  # POSIX
  "[a-z_0-9]+"                          ".*")

# Sets `layer` to the row of table 1 that a file belongs to.
function(find_layer file layer)
  string(REGEX MATCH "^(hydro/[^/]+/|[^/]+/)" folder "${file}")
  string(REGEX REPLACE "/$" "" folder "${folder}")
  set(${layer} "${folder}" PARENT_SCOPE)
endfunction()

# Appends to `faults` what is wrong with including the own header `header` from `file`.
function(check_own file header)
  find_layer("${file}" from)
  find_layer("${header}" to)
  set(allowed ${may_${from}} ${from} hydro)
  string(REGEX MATCH "^tests/([^/]+)/" test_folder "${file}")
  if(test_folder AND CMAKE_MATCH_1 IN_LIST plugin_tests)
    list(APPEND allowed plugin demos)
  endif()
  if(NOT EXISTS "${ROOT}/${header}")
    set(fault "no such file (own headers are named by their full path from the root)")
  elseif(NOT to IN_LIST allowed)
    set(fault "${from} may not include ${to}")
  else()
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY faults "${file}: #include \"${header}\": ${fault}")
endfunction()

function(check_library file header)
  set(rows ${libraries})
  while(rows)
    list(POP_FRONT rows headers files)
    if("${header}" MATCHES "^(${headers})$")
      if(NOT "${file}" MATCHES "^(${files})$")
        set_property(GLOBAL APPEND PROPERTY faults
                     "${file}: #include <${header}>: only ${files} may include it")
      endif()
      return()
    endif()
  endwhile()
  set_property(GLOBAL APPEND PROPERTY faults
               "${file}: #include <${header}>: a library that tests/layers.cmake does not list")
endfunction()

set(files)
foreach(folder hydro plugin demos tests)
  file(GLOB_RECURSE found RELATIVE "${ROOT}" "${ROOT}/${folder}/*.h" "${ROOT}/${folder}/*.cpp")
  list(APPEND files ${found})
endforeach()
set(count 0)
foreach(file IN LISTS files)
  file(STRINGS "${ROOT}/${file}" lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    math(EXPR count "${count} + 1")
    if("${line}" MATCHES "include[ \t]*\"([^\"]+)\"")
      check_own("${file}" "${CMAKE_MATCH_1}")
    elseif("${line}" MATCHES "include[ \t]*<([^>]+)>")
      check_library("${file}" "${CMAKE_MATCH_1}")
    else()
      set_property(GLOBAL APPEND PROPERTY faults "${file}: cannot read: ${line}")
    endif()
  endforeach()
endforeach()

get_property(faults GLOBAL PROPERTY faults)
if(faults)
  list(JOIN faults "\n  " text)
  message(FATAL_ERROR "the layers of the tree are broken:\n  ${text}\n")
endif()
list(LENGTH files file_count)
message(STATUS "${count} includes of ${file_count} files keep to the layers")
