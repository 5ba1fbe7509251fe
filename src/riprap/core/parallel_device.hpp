// SPDX-License-Identifier: Apache-2.0
#pragma once

// The device that a .cu file is compiled for, under one name: `parallel::device` has memory, loops, sums, scan and sort
// of CUDA (parallel_cuda.hpp) or, where RIPRAP_WITH_THRUST is set and no CUDA is needed, of Thrust on one of its
// systems (parallel_thrust.hpp).

#ifdef RIPRAP_WITH_THRUST
#include "riprap/core/parallel_thrust.hpp"
namespace riprap::parallel {
namespace device = thrust_system;
}
#else
#include "riprap/core/parallel_cuda.hpp"
namespace riprap::parallel {
namespace device = cuda;
}
#endif
