# Installs Cutwater from its build folder into a fresh prefix, builds project/ against it, runs it.
#   cmake -D BUILD=folder -D WORK=scratch -D PROJECT=folder -D MESH=sphere -D COMPILER=c++
#         -P consume.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY COMMAND_ECHO STDOUT)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
foreach(internal green bem/matrices/InfluenceMatrices.h)
  if(EXISTS ${WORK}/prefix/include/cutwater/hydro/${internal})
    message(SEND_ERROR "hydro/${internal} is no public header, but it was installed")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S ${PROJECT} -B ${WORK}/build -G Ninja -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build)
# A game links neither Assimp nor LAPACK, by itself or through another library.
foreach(precision float float64)
  file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${WORK}/build/consumer_${precision}
       RESOLVED_DEPENDENCIES_VAR needed UNRESOLVED_DEPENDENCIES_VAR missing)
  if(NOT "${needed}" MATCHES "hdf5")
    message(SEND_ERROR "cannot see what consumer_${precision} is linked to: ${needed} ${missing}")
  endif()
  if("${needed};${missing}" MATCHES "[^;]*(assimp|lapack|blas|gomp)[^;]*")
    message(SEND_ERROR "consumer_${precision} is linked to ${CMAKE_MATCH_0}")
  endif()
endforeach()
# That file alone makes a ship.
run(${WORK}/build/consumer_solver ${MESH} ${WORK}/sphere.h5)
foreach(precision float float64)
  run(${WORK}/build/consumer_${precision} ${WORK}/sphere.h5)
endforeach()
