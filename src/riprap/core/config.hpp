// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Marks a function that is compiled for the host and, in CUDA builds, for the device.
#if defined(__CUDACC__)
#define RIPRAP_HD __host__ __device__
#else
#define RIPRAP_HD
#endif
