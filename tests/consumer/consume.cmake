# Installs Cutwater from its build folder into a fresh prefix, builds project/ against it, runs it.
#   cmake -D BUILD=folder -D WORK=scratch -D PROJECT=folder -D MESH=sphere -D COMPILER=c++
#         -D FIRST_SHIP=program -P consume.cmake
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
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/command --component command)
if(EXISTS ${WORK}/command/include OR NOT EXISTS ${WORK}/command/bin/cutwater)
  message(SEND_ERROR "the component command is the command alone")
endif()
foreach(file boat.h5 boat.glb ship.toml)
  if(NOT EXISTS ${WORK}/command/share/cutwater/boat/${file})
    message(SEND_ERROR "the command comes without the boat's ${file}")
  endif()
endforeach()
# The command works where it is installed, in both precisions, and the man page names what it does.
foreach(program cutwater cutwater-float32)
  run(${WORK}/prefix/bin/${program} --version)
endforeach()
execute_process(COMMAND ${WORK}/prefix/bin/cutwater --help OUTPUT_VARIABLE help
                COMMAND_ERROR_IS_FATAL ANY)
file(READ ${WORK}/prefix/share/man/man1/cutwater.1 page)
string(REGEX MATCHALL "\n  [a-z]+  " commands "${help}")
list(LENGTH commands count)
if(count LESS 10)
  message(SEND_ERROR "cannot see the commands of --help: ${help}")
endif()
foreach(command IN LISTS commands)
  string(STRIP "${command}" command)
  if(NOT page MATCHES "\n[.]BI ${command} ")
    message(SEND_ERROR "the man page does not name the command ${command}")
  endif()
endforeach()
# The package for Debian holds command, man page, the boat, libraries and headers.
find_program(DPKG_DEB dpkg-deb)
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
if(DPKG_DEB AND DPKG_SHLIBDEPS)
  run(${CMAKE_CPACK_COMMAND} -G DEB --config ${BUILD}/CPackConfig.cmake -B ${WORK}/package)
  file(GLOB package ${WORK}/package/cutwater_*.deb)
  execute_process(COMMAND ${DPKG_DEB} --contents ${package} OUTPUT_VARIABLE contents
                  COMMAND_ERROR_IS_FATAL ANY)
  foreach(file bin/cutwater bin/cutwater-float32 share/man/man1/cutwater.1
               share/doc/cutwater/copyright share/cutwater/boat/boat.h5
               share/cutwater/boat/boat.glb share/cutwater/boat/ship.toml
               include/cutwater/plugin/Seaway.h
               include/cutwater/hydro/solve/Solve.h libcutwater_hydro.a libcutwater_plugin.a
               libcutwater_plugin_float64.a libcutwater_bem.a libcutwater_files.a
               cutwater/cutwater-config.cmake)
    if(NOT contents MATCHES "[.]/usr/[^\n]*${file}\n")
      message(SEND_ERROR "the package lacks ${file}: ${contents}")
    endif()
  endforeach()
  execute_process(COMMAND ${DPKG_DEB} --field ${package} Depends OUTPUT_VARIABLE needs
                  COMMAND_ERROR_IS_FATAL ANY)
  if(NOT needs MATCHES "libhdf5.*" OR NOT needs MATCHES "libc6")
    message(SEND_ERROR "the package does not say what its command needs: ${needs}")
  endif()
endif()
run(${CMAKE_COMMAND} -S ${PROJECT} -B ${WORK}/build -G Ninja -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release
    -D FIRST_SHIP=${FIRST_SHIP})
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
# The README's program sails the boat that is installed, where the package's own variable says.
file(READ ${WORK}/build/data_dir.txt data_dir)
run(${CMAKE_COMMAND} -E chdir ${data_dir}/boat ${WORK}/build/consumer_first)
