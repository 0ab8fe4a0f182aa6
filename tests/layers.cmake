# The direction of the tree, checked: reads every #include of hydro/, plugin/, demos/ and tests/ and
# refuses
#   - what the two tables below do not allow,
#   - a circle of files (X.h and X.cpp count as one), anywhere,
#   - a circle of folders,
#   - a folder `detail` looked into from outside the folder that it lies in (tests may).
# Own headers are included by their full path from the root, in quotes; everything else in angle
# brackets.
#   cmake [-D ROOT=tree] -P tests/layers.cmake
cmake_minimum_required(VERSION 3.25)
if(NOT DEFINED ROOT)
  cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH ROOT)
endif()

# 1. Own folders: what each may include besides itself, the headers beside the folders of hydro/
# (Conventions.h, Errors.h) and hydro/base. One that has no row of its own takes that of the folder
# it lies in.
set(geometry hydro/geometry hydro/geometry/panels)  # what layers above geometry may see of it
set(may_hydro "")
set(may_hydro/base "")
set(may_hydro/geometry "")
set(may_hydro/geometry/shapes    hydro/geometry)
set(may_hydro/geometry/guess     hydro/geometry)
set(may_hydro/geometry/repair    hydro/geometry)
set(may_hydro/geometry/panels    hydro/geometry)
set(may_hydro/geometry/wetted    hydro/geometry)
set(may_hydro/geometry/outer     hydro/geometry hydro/geometry/repair)
set(may_hydro/geometry/panelling hydro/geometry hydro/geometry/panels)
set(may_hydro/geometry/anyhull   hydro/geometry hydro/geometry/repair hydro/geometry/panelling
                                 hydro/geometry/outer)
set(may_hydro/waves "")
set(may_hydro/green "")
set(may_hydro/incident     ${geometry} hydro/waves)
# ship: also the levers of a hull at any heel, which its wetted triangles give.
set(may_hydro/ship         ${geometry} hydro/geometry/wetted)
set(may_hydro/database     ${geometry} hydro/ship)
set(may_hydro/excitation   ${geometry} hydro/waves hydro/incident hydro/ship hydro/database)
set(may_hydro/bem/settings ${geometry} hydro/ship hydro/database)
set(may_hydro/bem/linear "")
set(may_hydro/bem/matrices ${geometry} hydro/green hydro/bem/settings)
set(may_hydro/bem/solution ${geometry} hydro/waves hydro/incident hydro/bem/settings
                           hydro/bem/matrices hydro/bem/linear)
set(may_hydro/bem/drift     ${may_hydro/bem/solution} hydro/bem/solution hydro/ship hydro/database)
set(may_hydro/bem/reference ${may_hydro/bem/drift})
set(may_hydro/bem           ${may_hydro/bem/reference} hydro/green hydro/bem/drift
                            hydro/bem/reference)
set(may_hydro/memory   hydro/database)
set(may_hydro/finish   ${geometry} hydro/waves hydro/incident hydro/ship hydro/database
                       hydro/memory)
set(may_hydro/solve    ${geometry} hydro/ship hydro/database hydro/memory hydro/finish hydro/bem
                       hydro/bem/settings)
set(may_hydro/forces   ${geometry} hydro/geometry/wetted hydro/waves hydro/ship hydro/database
                       hydro/excitation hydro/memory)
set(may_hydro/forces/linear      ${may_hydro/forces} hydro/incident hydro/forces)
set(may_hydro/forces/nonlinear   ${may_hydro/forces} hydro/forces)
set(may_hydro/forces/drift       ${may_hydro/forces} hydro/forces)
set(may_hydro/forces/manoeuvring ${may_hydro/forces} hydro/forces)
set(may_hydro/forces/appendages  ${may_hydro/forces} hydro/forces)
set(may_hydro/response hydro/waves hydro/ship hydro/database hydro/excitation)
set(may_hydro/files    ${geometry} hydro/geometry/repair hydro/geometry/anyhull hydro/ship
                       hydro/database)
set(may_plugin         ${may_hydro/forces} hydro/forces hydro/forces/linear hydro/forces/nonlinear
                       hydro/forces/drift hydro/forces/manoeuvring hydro/forces/appendages
                       hydro/forces/floats)
set(may_demos "hydro/.+" plugin "demos/.+")  # patterns
set(may_tests "hydro/.+" "tests/.+")
# The tests that may see the plugin, and with it Bullet.
set(plugin_tests "tests/(plugin|verification|consumer|bench|demos)(/.+)?")
# Parts of the load: no file of these folders includes another of the same folder.
set(parts "hydro/forces/(linear|nonlinear|drift|manoeuvring|appendages)")

# 2. Libraries: a pattern of the header, and a pattern of the files that may include it. A header
# that no row names must be one of the C++ standard's, which have neither a folder nor an ending.
set(libraries
  "Eigen/.+"                            ".*"
  "unsupported/Eigen/.+"                ".*"
  "assimp/.+"                           "hydro/files/.+"
  "(hdf5|H5.+)\\.h"                     "(hydro|tests)/database/.+"
  "(lapacke|cblas)\\.h"                 "(hydro/bem/linear|tests/bench)/.+"
  "(bt[A-Z]|Bullet[A-Z]|LinearMath/).+"
                    "(plugin|demos|tests/(plugin|verification|consumer|bench|demos))/.+"
  "zlib\\.h"                             "demos/report_page/.+"
  "(CLI/CLI\\.hpp|toml\\+\\+/toml\\.h)" "(demos|tests)/.+"
  "fmt/.+\\.h"                          "((hydro|plugin)/.+\\.cpp|(demos|tests)/.+)"
  "gtest/.+|gmock/.+"                   "tests/.+"
  "benchmark/benchmark\\.h"             "tests/bench/.+"
  "(unistd|fcntl|stdlib)\\.h|sys/.+\\.h" ".*"  # POSIX
  "[a-z_0-9]+"                          ".*")

macro(fault text)
  set_property(GLOBAL APPEND PROPERTY faults "${text}")
endmacro()

# The folder of a file; `detail` counts as the folder that it lies in.
macro(find_folder file folder)
  string(REGEX REPLACE "(/detail)?/[^/]+$" "" ${folder} "${file}")
endmacro()

# Sets `allowed` to the patterns of the folders that `folder` may include.
function(find_allowed folder allowed)
  set(row "${folder}")
  while(NOT DEFINED may_${row} AND row MATCHES "/")
    cmake_path(GET row PARENT_PATH row)
  endwhile()
  set(patterns ${may_${row}} hydro hydro/base "${folder}")
  if("${folder}" MATCHES "^${plugin_tests}$")
    list(APPEND patterns plugin "demos/.+")
  endif()
  list(JOIN patterns "|" patterns)
  set(${allowed} "^(${patterns})$" PARENT_SCOPE)
endfunction()

# Checks that `file` in the folder `from` may include the own header `header`.
function(check_own file from header)
  set(line "${file}: #include \"${header}\"")
  if(NOT EXISTS "${ROOT}/${header}")
    fault("${line}: no such file (own headers are named by their full path from the root)")
    return()
  endif()
  find_folder("${header}" to)
  if(NOT DEFINED allowed_${from})
    find_allowed("${from}" pattern)
    set(allowed_${from} "${pattern}" CACHE INTERNAL "")
  endif()
  if(NOT to MATCHES "${allowed_${from}}")
    fault("${line}: ${from} may not include ${to}")
  endif()
  if(header MATCHES "/detail/[^/]+$" AND NOT "${from}/" MATCHES "^(${to}|tests)/")
    fault("${line}: only ${to} may look into its folder detail")
  endif()
  string(REGEX REPLACE "\\.[^.]+$" "" pair "${file}")
  string(REGEX REPLACE "\\.[^.]+$" "" other "${header}")
  if(from MATCHES "^${parts}$" AND from STREQUAL to AND NOT pair STREQUAL other)
    fault("${line}: parts of the load do not know each other")
  endif()
  if(NOT pair STREQUAL other)
    set_property(GLOBAL APPEND PROPERTY file_edges "${pair}" "${other}")
  endif()
  if(NOT from STREQUAL to)
    set_property(GLOBAL APPEND PROPERTY folder_edges "${from}" "${to}")
  endif()
endfunction()

function(check_library file header)
  set(rows ${libraries})
  while(rows)
    list(POP_FRONT rows headers files)
    if("${header}" MATCHES "^(${headers})$")
      if(NOT "${file}" MATCHES "^(${files})$")
        fault("${file}: #include <${header}>: only ${files} may include it")
      endif()
      return()
    endif()
  endwhile()
  fault("${file}: #include <${header}>: a library that tests/layers.cmake does not list")
endfunction()

# Refuses a circle in the graph whose edges are the pairs of the list `edges`: takes away whatever
# includes nothing that is left; what stays includes a circle, which is walked once.
function(check_circles edges what)
  set(nodes)
  while(edges)
    list(POP_FRONT edges from to)
    if(NOT DEFINED edge_${from}_${to})
      set(edge_${from}_${to} TRUE)
      list(APPEND needs_${from} "${to}")
      list(APPEND users_${to} "${from}")
      list(APPEND nodes "${from}" "${to}")
    endif()
  endwhile()
  list(REMOVE_DUPLICATES nodes)
  set(free)
  foreach(node IN LISTS nodes)
    list(LENGTH needs_${node} left_${node})
    if(left_${node} EQUAL 0)
      list(APPEND free "${node}")
    endif()
  endforeach()
  while(free)
    list(POP_FRONT free node)
    foreach(user IN LISTS users_${node})
      math(EXPR left_${user} "${left_${user}} - 1")
      if(left_${user} EQUAL 0)
        list(APPEND free "${user}")
      endif()
    endforeach()
  endwhile()
  foreach(node IN LISTS nodes)
    if(NOT left_${node} EQUAL 0)
      set(circle)
      while(NOT node IN_LIST circle)
        list(APPEND circle "${node}")
        foreach(needed IN LISTS needs_${node})
          if(NOT left_${needed} EQUAL 0)
            set(next "${needed}")
          endif()
        endforeach()
        set(node "${next}")
      endwhile()
      list(FIND circle "${node}" start)
      list(SUBLIST circle ${start} -1 circle)
      list(JOIN circle " -> " text)
      fault("a circle of ${what}: ${text} -> ${node}")
      return()
    endif()
  endforeach()
endfunction()

set(files)
foreach(folder hydro plugin demos tests)
  file(GLOB_RECURSE found RELATIVE "${ROOT}" "${ROOT}/${folder}/*.h" "${ROOT}/${folder}/*.cpp")
  list(APPEND files ${found})
endforeach()
set(count 0)
foreach(file IN LISTS files)
  find_folder("${file}" folder)
  file(STRINGS "${ROOT}/${file}" lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    math(EXPR count "${count} + 1")
    if("${line}" MATCHES "include[ \t]*\"([^\"]+)\"")
      check_own("${file}" "${folder}" "${CMAKE_MATCH_1}")
    elseif("${line}" MATCHES "include[ \t]*<([^>]+)>")
      check_library("${file}" "${CMAKE_MATCH_1}")
    else()
      fault("${file}: cannot read: ${line}")
    endif()
  endforeach()
endforeach()
get_property(file_edges GLOBAL PROPERTY file_edges)
check_circles("${file_edges}" "files")
get_property(folder_edges GLOBAL PROPERTY folder_edges)
check_circles("${folder_edges}" "folders")

get_property(faults GLOBAL PROPERTY faults)
if(faults)
  list(JOIN faults "\n  " text)
  message(FATAL_ERROR "the layers of the tree are broken:\n  ${text}\n")
endif()
list(LENGTH files file_count)
message(STATUS "${count} includes of ${file_count} files keep to the layers")
