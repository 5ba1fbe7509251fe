# SPDX-License-Identifier: Apache-2.0
# Flags shared by every target, and the two functions that declare libraries and tests.
find_package(Threads REQUIRED)
# Found here once: imported targets are visible below the folder that found them, and static libraries hand theirs on.
find_package(fmt REQUIRED)
find_package(ZLIB REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)

add_library(riprap_flags INTERFACE)
target_include_directories(riprap_flags INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(riprap_flags INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-march=${RIPRAP_MARCH} -ffp-contract=off -fno-math-errno -fno-trapping-math
    -Wall -Wextra -Wconversion -Wshadow -Wno-psabi>)
target_compile_definitions(riprap_flags INTERFACE RIPRAP_MARCH="${RIPRAP_MARCH}")
if(RIPRAP_WERROR)
  target_compile_options(riprap_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(RIPRAP_ASSERTIONS)
  target_compile_definitions(riprap_flags INTERFACE RIPRAP_ASSERTIONS)
endif()
if(RIPRAP_SANITIZE)
  # undefined behaviour ends a program as well: what is only printed fails no test
  target_compile_options(riprap_flags INTERFACE -fsanitize=${RIPRAP_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  target_link_options(riprap_flags INTERFACE -fsanitize=${RIPRAP_SANITIZE})
endif()
target_link_libraries(riprap_flags INTERFACE Threads::Threads)

# For files that hold the inner loops over pairs of particles and nothing else. Products may be fused with sums, which
# is a third of the arithmetic: their bits depend on the compiler, never on threads or lists of neighbours. With the 32
# registers of AVX-512, GCC must be told to mix the instructions of two independent evaluations, as each is a chain that
# the processor waits for; with 16 registers, what is mixed is spilled to memory and a fifth slower.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_FLAGS "-march=${RIPRAP_MARCH}")
string(MAKE_C_IDENTIFIER "RIPRAP_AVX512_WITH_${RIPRAP_MARCH}" has_avx512)  # the answer is kept per -march
check_cxx_source_compiles("#ifndef __AVX512F__\n#error\n#endif\nint main() {}" ${has_avx512})
unset(CMAKE_REQUIRED_FLAGS)
set(RIPRAP_KERNEL_OPTIONS -ffp-contract=fast)
if(${has_avx512})
  list(APPEND RIPRAP_KERNEL_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-fschedule-insns>)
endif()

include(cmake/precompiled.cmake)

# riprap_library(NAME DEPENDS other... ): one library per folder, alias riprap::NAME, sources are the .cpp beside it.
# Arrows between folders are the DEPENDS lists; a wrong one is a link error.
function(riprap_library name)
  cmake_parse_arguments(arg "" "" "DEPENDS;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(TRANSFORM arg_DEPENDS PREPEND "riprap::")
  if(sources)
    add_library(riprap_${name} STATIC ${sources})
    target_link_libraries(riprap_${name} PUBLIC riprap_flags ${arg_DEPENDS} PRIVATE ${arg_PRIVATE})
    # The program and the Python module are linked from the same objects: that is why they give the same bits. With
    # hidden names the code is that of a program, calls and inlining included.
    set_target_properties(riprap_${name} PROPERTIES
      POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    riprap_precompile(riprap_${name} library ${arg_PRIVATE})
  else()
    add_library(riprap_${name} INTERFACE)
    target_link_libraries(riprap_${name} INTERFACE riprap_flags ${arg_DEPENDS})
  endif()
  add_library(riprap::${name} ALIAS riprap_${name})
endfunction()

# riprap_test(NAME LINK other... ): one test program per folder of tests/, sources are the test_*.cpp beside it.
function(riprap_test name)
  cmake_parse_arguments(arg "" "" "LINK;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/test_*.cpp)
  if(NOT sources)
    return()
  endif()
  list(TRANSFORM arg_LINK PREPEND "riprap::")
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE riprap_flags ${arg_LINK} ${arg_PRIVATE} GTest::gmock_main)
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(test_${name} PRIVATE RIPRAP_SOURCE_DIR=".")
  target_compile_options(test_${name} PRIVATE $<$<CONFIG:Release>:-O1>)  # tests are compiled once and run once
  riprap_precompile(test_${name} test ${arg_PRIVATE})
  gtest_discover_tests(test_${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} PROPERTIES DISCOVERY_TIMEOUT 60)
endfunction()
