# Bundles web/ into OUT, one HTML file; what npm fetches by the lock file stays in WORK. Where that
# cannot be done, OUT holds the reason in one line, which `cutwater report` says; without STAMP the
# next build tries again.
#   cmake -D NPM=... -D NODE=... -D WEB=... -D WORK=... -D OUT=... -D STAMP=... -P bundle.cmake
file(REMOVE ${STAMP})
file(MAKE_DIRECTORY ${WORK})
file(SHA256 ${WEB}/package-lock.json lock)
set(installed ${WORK}/node_modules/.cutwater-${lock})
if(NOT EXISTS ${installed})
  file(COPY ${WEB}/package.json ${WEB}/package-lock.json DESTINATION ${WORK})
  execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
                  WORKING_DIRECTORY ${WORK} RESULT_VARIABLE failed
                  OUTPUT_QUIET ERROR_VARIABLE error)
  if(NOT failed EQUAL 0)
    string(REGEX MATCH "npm [eE][^\r\n]*" first "${error}")
    set(reason "npm ci failed when it was built, which needs the network once: ${first}")
    file(WRITE ${WORK}/reason.txt "${reason}\n")
    file(COPY_FILE ${WORK}/reason.txt ${OUT} ONLY_IF_DIFFERENT)
    message("cutwater report is built without its page: ${reason}")
    return()
  endif()
  file(TOUCH ${installed})
endif()
execute_process(COMMAND ${NODE} ${WEB}/build.mjs ${WORK}/page.html ${WORK}/node_modules
                RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE error)
if(NOT failed EQUAL 0)
  message(FATAL_ERROR "node build.mjs failed:\n${error}")
endif()
file(COPY_FILE ${WORK}/page.html ${OUT} ONLY_IF_DIFFERENT)
file(TOUCH ${STAMP})
