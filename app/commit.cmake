# Run by the build: writes OUTPUT, which names the commit of the tree SOURCE, if that has changed since. So nothing is
# compiled or linked anew but after a commit, or after the first change that follows one.
set(commit unknown)
find_package(Git QUIET)
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} describe --always --abbrev=12 --exclude * --dirty
    OUTPUT_VARIABLE said RESULT_VARIABLE result OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(result EQUAL 0 AND said MATCHES "^[0-9a-f]+(-dirty)?$")
    set(commit ${said})
  endif()
endif()
set(text "#pragma once\n#define THRONG_COMMIT \"${commit}\"\n")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT text STREQUAL old)
  file(WRITE ${OUTPUT} "${text}")
endif()
