# SPDX-License-Identifier: Apache-2.0
# The CUDA compiler, for the project and for the self-test, which is a project of its own.

# nvcc is often installed without being on PATH.
if(NOT CMAKE_CUDA_COMPILER)
  find_program(CMAKE_CUDA_COMPILER nvcc PATHS /usr/local/cuda/bin REQUIRED)
endif()
if(NOT CMAKE_CUDA_ARCHITECTURES)
  set(CMAKE_CUDA_ARCHITECTURES 80)  # and its PTX, which newer devices compile when they load it
endif()
enable_language(CUDA)
# CMake 3.25 does not know the C++20 flag of nvcc 13.
foreach(kind STANDARD EXTENSION)
  if(NOT CMAKE_CUDA20_${kind}_COMPILE_OPTION)
    set(CMAKE_CUDA20_${kind}_COMPILE_OPTION -std=c++20)
  endif()
endforeach()
set(CMAKE_CUDA_STANDARD 20)

# The same rounding on both sides: no contraction of a*b+c, neither by g++ nor by nvcc.
set(RIPRAP_CUDA_OPTIONS -fmad=false --expt-relaxed-constexpr -Werror=all-warnings
  -Xcompiler=-ffp-contract=off,-Wall,-Wextra)
