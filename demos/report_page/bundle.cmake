# Bundles web/ into OUT, one HTML file, by npm's lock file; what npm fetches stays in WORK. Where
# that cannot be done, OUT holds the reason in one line, which `cutwater report` says; without STAMP
# the next build tries again.
#   cmake -D NPM=... -D NODE=... -D WEB=... -D WORK=... -D OUT=... -D STAMP=... -P bundle.cmake
function(cannot reason)
  string(REGEX REPLACE "[\r\n]+" " " reason "${reason}")
  file(WRITE ${WORK}/reason.txt "${reason}\n")
  file(COPY_FILE ${WORK}/reason.txt ${OUT} ONLY_IF_DIFFERENT)
  message("cutwater report: the page is not built: ${reason}")
endfunction()

file(REMOVE ${STAMP})
file(COPY ${WEB}/ DESTINATION ${WORK} PATTERN node_modules EXCLUDE)
file(SHA256 ${WEB}/package-lock.json lock)
set(installed ${WORK}/node_modules/.cutwater-${lock})
if(NOT EXISTS ${installed})
  execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
                  WORKING_DIRECTORY ${WORK} RESULT_VARIABLE failed
                  OUTPUT_QUIET ERROR_VARIABLE error)
  if(failed)
    string(REGEX MATCH "npm [eE][^\r\n]*" first "${error}")
    cannot("npm ci failed (it needs the network once): ${first}")
    return()
  endif()
  file(TOUCH ${installed})
endif()
execute_process(COMMAND ${NODE} build.mjs ${WORK}/page.html WORKING_DIRECTORY ${WORK}
                RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE error)
if(failed)
  message(FATAL_ERROR "node build.mjs failed:\n${error}")
endif()
file(COPY_FILE ${WORK}/page.html ${OUT} ONLY_IF_DIFFERENT)
file(TOUCH ${STAMP})
