// SPDX-License-Identifier: Apache-2.0
// See cuda_runtime.h beside the folder of this one.
#pragma once

#include <cuda_runtime.h>

namespace cub {
struct DeviceRadixSort {
    template <class Key, class Value, class Count>
    static cudaError_t SortPairs(void* scratch, std::size_t& bytes, const Key* keys, Key* sorted_keys, const Value* values,
                                 Value* sorted_values, Count count);
};
}  // namespace cub
