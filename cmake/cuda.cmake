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

# The same rounding on both sides: no contraction of a*b+c, neither by g++ nor by nvcc.
# CMake 3.25 does not know the C++20 flag of nvcc 13, so the standard is written out.
set(RIPRAP_CUDA_OPTIONS -std=c++20 -fmad=false --expt-relaxed-constexpr -Werror=all-warnings
  -Xcompiler=-ffp-contract=off,-Wall,-Wextra)
