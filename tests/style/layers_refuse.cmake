# layers.cmake must refuse what it is there to refuse: plants a few includes at a time in a small
# tree, wrong ones and right ones of each kind.
#   cmake -D WORK=scratch folder -P tests/style/layers_refuse.cmake
cmake_minimum_required(VERSION 3.25)
set(layers ${CMAKE_CURRENT_LIST_DIR}/../layers.cmake)

# Writes includes into a fresh tree, FILE HEADER pairs, and sets `refused`.
function(try refused)
  file(REMOVE_RECURSE ${WORK})
  foreach(there hydro/Errors.h hydro/base/Simd.h hydro/geometry/SurfaceMesh.h
                hydro/geometry/detail/Inner.h hydro/geometry/panels/PanelMesh.h
                hydro/geometry/panelling/Panelling.h hydro/geometry/repair/MeshRepair.h
                hydro/waves/Wave.h hydro/green/WaveTerm.h hydro/incident/PanelWave.h
                hydro/bem/BuildCoefficients.h hydro/bem/linear/Factorization.h
                hydro/bem/matrices/NearWave.h hydro/database/Coefficients.h
                hydro/excitation/WaveExcitation.h hydro/memory/Convolution.h
                hydro/finish/Finish.h hydro/forces/ForceGenerator.h hydro/forces/linear/Radiation.h
                hydro/files/MeshIO.h hydro/response/Response.h plugin/Ship.h
                demos/cutwater/input/Toml.h tests/support/Hulls.h)
    file(WRITE ${WORK}/${there} "#pragma once\n")
  endforeach()
  set(rest ${ARGN})
  while(rest)
    list(POP_FRONT rest file header)
    file(APPEND ${WORK}/${file} "#include ${header}\n")
  endwhile()
  execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${WORK} -P ${layers}
                  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE text)
  set(${refused} ${result} PARENT_SCOPE)
  set(said "${text}" PARENT_SCOPE)
endfunction()

# expect_refused(WHY file header [file header...]): refused, with words that match WHY.
function(expect_refused why)
  try(refused ${ARGN})
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  if(NOT refused)
    message(SEND_ERROR "layers.cmake allowed ${ARGN}")
  elseif(NOT said MATCHES "${why}")
    message(SEND_ERROR "layers.cmake refused ${ARGN} for another reason than \"${why}\": ${said}")
  endif()
endfunction()

function(expect_allowed)
  try(refused ${ARGN})
  if(refused)
    message(SEND_ERROR "layers.cmake refused ${ARGN}: ${said}")
  endif()
endfunction()

# Folders.
set(may_not "may not include")
expect_refused(${may_not} hydro/geometry/A.cpp "\"hydro/waves/Wave.h\"")
expect_refused(${may_not} hydro/geometry/A.cpp "\"hydro/geometry/panels/PanelMesh.h\"")
expect_refused(${may_not} hydro/geometry/shapes/A.cpp "\"hydro/geometry/panels/PanelMesh.h\"")
expect_refused(${may_not} hydro/geometry/repair/A.cpp "\"hydro/geometry/panelling/Panelling.h\"")
expect_refused(${may_not} hydro/geometry/panelling/A.cpp "\"hydro/geometry/repair/MeshRepair.h\"")
expect_refused(${may_not} hydro/base/A.cpp     "\"hydro/geometry/SurfaceMesh.h\"")
expect_refused(${may_not} hydro/waves/A.cpp    "\"hydro/geometry/SurfaceMesh.h\"")
expect_refused(${may_not} hydro/green/A.cpp    "\"hydro/waves/Wave.h\"")
expect_refused(${may_not} hydro/database/A.cpp "\"hydro/bem/BuildCoefficients.h\"")
expect_refused(${may_not} hydro/database/A.cpp "\"hydro/incident/PanelWave.h\"")
expect_refused(${may_not} hydro/bem/matrices/A.cpp "\"hydro/bem/BuildCoefficients.h\"")
expect_refused(${may_not} hydro/bem/linear/A.cpp   "\"hydro/bem/matrices/NearWave.h\"")
expect_refused(${may_not} hydro/memory/A.cpp   "\"hydro/forces/linear/Radiation.h\"")
expect_refused(${may_not} hydro/memory/A.cpp   "\"hydro/finish/Finish.h\"")
expect_refused(${may_not} hydro/forces/A.cpp   "\"hydro/bem/BuildCoefficients.h\"")
expect_refused(${may_not} hydro/forces/A.cpp   "\"hydro/forces/linear/Radiation.h\"")
expect_refused(${may_not} hydro/forces/A.cpp   "\"hydro/files/MeshIO.h\"")
expect_refused(${may_not} hydro/forces/A.cpp   "\"plugin/Ship.h\"")
expect_refused(${may_not} hydro/response/A.cpp "\"hydro/forces/linear/Radiation.h\"")
expect_refused(${may_not} hydro/Errors.h       "\"hydro/geometry/SurfaceMesh.h\"")
expect_refused(${may_not} plugin/A.cpp         "\"hydro/bem/BuildCoefficients.h\"")
expect_refused(${may_not} plugin/A.cpp         "\"hydro/green/WaveTerm.h\"")
expect_refused(${may_not} plugin/A.cpp         "\"hydro/files/MeshIO.h\"")
expect_refused(${may_not} demos/A.cpp          "\"tests/support/Hulls.h\"")
expect_refused(${may_not} tests/waves/A.cpp    "\"plugin/Ship.h\"")
expect_refused("no such file" hydro/waves/A.cpp "\"Wave.h\"")
expect_refused("folder detail" hydro/incident/A.cpp "\"hydro/geometry/detail/Inner.h\"")
expect_refused("do not know each other"
               hydro/forces/linear/A.cpp "\"hydro/forces/linear/Radiation.h\"")

# Libraries.
set(only "may include it")
expect_refused(${only} hydro/waves/A.cpp    "<btBulletDynamicsCommon.h>")
expect_refused(${only} hydro/forces/A.cpp   "<BulletDynamics/Dynamics/btRigidBody.h>")
expect_refused(${only} tests/forces/A.cpp   "<btBulletDynamicsCommon.h>")
expect_refused(${only} hydro/geometry/A.cpp "<assimp/scene.h>")
expect_refused(${only} tests/files/A.cpp    "<assimp/scene.h>")
expect_refused(${only} hydro/memory/A.cpp   "<hdf5.h>")
expect_refused(${only} hydro/bem/A.cpp      "<lapacke.h>")
expect_refused(${only} hydro/geometry/A.h   "<fmt/core.h>")
expect_refused(${only} plugin/A.cpp         "<toml++/toml.h>")
expect_refused(${only} hydro/base/A.cpp     "<gtest/gtest.h>")
expect_refused("does not list" plugin/A.cpp      "<omp.h>")
expect_refused("does not list" hydro/waves/A.cpp "<boost/math/tools/roots.hpp>")
expect_refused("cannot read" hydro/waves/A.cpp "WAVE_HEADER")

# Circles. A source counts as its header.
expect_refused("a circle of files: hydro/waves/A -> hydro/waves/B -> hydro/waves/A"
               hydro/waves/A.h "\"hydro/waves/B.h\"" hydro/waves/B.h "\"hydro/waves/A.h\"")
expect_refused("a circle of files" hydro/waves/A.h "\"hydro/Errors.h\""
               hydro/waves/A.cpp "\"hydro/waves/B.h\""
               hydro/waves/B.h "\"hydro/Errors.h\"" hydro/waves/B.cpp "\"hydro/waves/C.h\""
               hydro/waves/C.h "\"hydro/waves/A.h\"")
expect_refused("a circle of files" plugin/A.h "\"plugin/B.h\"" plugin/B.h "\"plugin/A.h\"")
expect_refused("a circle of files"
               tests/waves/A.h "\"tests/waves/B.h\"" tests/waves/B.h "\"tests/waves/A.h\"")
set(demo demos/cutwater)
expect_refused("a circle of folders: ${demo}/input -> ${demo}/output -> ${demo}/input"
               demos/cutwater/input/A.cpp "\"demos/cutwater/output/B.h\""
               demos/cutwater/output/B.h "\"hydro/Errors.h\""
               demos/cutwater/output/C.cpp "\"demos/cutwater/input/Toml.h\"")
expect_refused("a circle of folders" tests/waves/A.cpp "\"tests/support/Hulls.h\""
               tests/waves/B.h "\"hydro/Errors.h\"" tests/support/B.cpp "\"tests/waves/B.h\"")

expect_allowed(hydro/incident/A.cpp           "\"hydro/geometry/panels/PanelMesh.h\""
               hydro/bem/A.cpp                "\"hydro/green/WaveTerm.h\""
               hydro/bem/linear/A.cpp         "<lapacke.h>"
               hydro/files/A.cpp              "<assimp/scene.h>"
               hydro/files/A.cpp              "\"hydro/geometry/repair/MeshRepair.h\""
               hydro/geometry/A.cpp           "\"hydro/geometry/detail/Inner.h\""
               hydro/geometry/detail/Inner.cpp "\"hydro/geometry/detail/Inner.h\""
               hydro/geometry/detail/Inner.cpp "\"hydro/geometry/SurfaceMesh.h\""
               hydro/geometry/panelling/A.cpp "\"hydro/geometry/panels/PanelMesh.h\""
               hydro/database/A.cpp           "<hdf5.h>"
               hydro/forces/linear/A.cpp      "\"hydro/forces/ForceGenerator.h\""
               hydro/forces/linear/Radiation.cpp "\"hydro/forces/linear/Radiation.h\""
               plugin/A.cpp                   "\"hydro/forces/linear/Radiation.h\""
               plugin/A.cpp                   "<btBulletDynamicsCommon.h>"
               tests/plugin/A.cpp             "\"plugin/Ship.h\""
               tests/geometry/A.cpp           "\"hydro/geometry/detail/Inner.h\""
               tests/geometry/A.cpp           "\"tests/support/Hulls.h\""
               demos/A.cpp                    "\"hydro/bem/BuildCoefficients.h\""
               hydro/green/A.cpp              "<cmath>"
               hydro/green/A.cpp              "\"hydro/Errors.h\""
               hydro/green/A.cpp              "\"hydro/base/Simd.h\"")
file(REMOVE_RECURSE ${WORK})
