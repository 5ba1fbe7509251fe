# SPDX-License-Identifier: Apache-2.0
# Writes HEADER with the commit of the tree at SOURCE, "+" behind it where files differ from it, "" where there is no
# repository. An unchanged header is left alone.
find_package(Git QUIET)
set(commit "")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} rev-parse --short=12 HEAD
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE code)
  if(code EQUAL 0)
    execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} status --porcelain --untracked-files=no
                    OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT changes STREQUAL "")
      string(APPEND commit "+")
    endif()
  else()
    set(commit "")
  endif()
endif()
set(text "#define RIPRAP_COMMIT \"${commit}\"\n")
set(known "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} known)
endif()
if(NOT known STREQUAL text)
  file(WRITE ${HEADER} "${text}")
endif()
