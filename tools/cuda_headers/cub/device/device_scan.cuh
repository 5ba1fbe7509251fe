// SPDX-License-Identifier: Apache-2.0
// See cuda_runtime.h beside the folder of this one.
#pragma once

#include <cuda_runtime.h>

namespace cub {
struct DeviceScan {
    template <class In, class Out, class Count>
    static cudaError_t ExclusiveSum(void* scratch, std::size_t& bytes, In in, Out out, Count count);
};
}  // namespace cub
