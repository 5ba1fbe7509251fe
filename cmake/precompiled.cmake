# SPDX-License-Identifier: Apache-2.0
# Headers of the standard library (and of fmt and GoogleTest) take a third of the time to compile; they are precompiled
# once per kind of target. Sources include what they use all the same: under `scripts/test --full` clang reads each without.
# With ccache they do not pay: it reads the 90 MB of them for every file. Choose one: -DRIPRAP_PCH=OFF goes with a launcher.
option(RIPRAP_PCH "Precompile headers of the standard library, fmt and GoogleTest" ON)

# precompile(TARGET KIND LIBRARY...): reuses the headers of KIND, which follow from the libraries that TARGET links.
function(riprap_precompile target kind)
  if(NOT RIPRAP_PCH)
    return()
  endif()
  set(headers <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory> <numeric>
      <optional> <ranges> <span> <sstream> <string> <string_view> <tuple> <unordered_map> <utility> <variant> <vector>)
  set(libraries riprap_flags)
  set(name riprap_headers_${kind})
  if(kind STREQUAL "test")
    list(APPEND headers <gmock/gmock.h> <gtest/gtest.h>)
    list(APPEND libraries GTest::gmock_main)
  endif()
  if("fmt::fmt" IN_LIST ARGN)
    list(APPEND headers <fmt/format.h>)
    list(APPEND libraries fmt::fmt)
    string(APPEND name "_fmt")
  endif()
  if(NOT TARGET ${name})
    file(WRITE ${PROJECT_BINARY_DIR}/${name}.cpp "")
    add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE ${libraries})
    target_precompile_headers(${name} PRIVATE ${headers})
    if(kind STREQUAL "test")
      target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    else()
      set_target_properties(${name} PROPERTIES
        POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${name})
endfunction()

# riprap_compile_with(OPTIONS SOURCE...): flags of single sources, which headers compiled without them do not fit.
function(riprap_compile_with options)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${options}" SKIP_PRECOMPILE_HEADERS ON)
endfunction()
