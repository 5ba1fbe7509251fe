// SPDX-License-Identifier: Apache-2.0
#pragma once

// CUDA back end of core/parallel: the same loops over the same functors, on one device. Include it from .cu files only.
//
// A functor handed to these functions is a named type with RIPRAP_HD members, trivially copyable, holding plain
// pointers into DeviceArrays. Sums have the bits of the host's: each chain of a block is added up in index order by one
// thread, after all threads have evaluated the entries, and blocks are added up exactly by the host. Compile with
// -fmad=false, the device's counterpart of -ffp-contract=off.

#include <cuda_runtime.h>

#include <algorithm>
#include <cstdint>
#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <span>
#include <type_traits>

#include "riprap/core/blocks.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/parallel_cuda_memory.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::parallel::cuda {

namespace detail {

inline constexpr int threads_per_block = 128;

template <class F>
__global__ void for_each_kernel(std::int64_t n, F f) {
    const std::int64_t stride = static_cast<std::int64_t>(gridDim.x) * blockDim.x;
    for (std::int64_t i = static_cast<std::int64_t>(blockIdx.x) * blockDim.x + threadIdx.x; i < n; i += stride) {
        f(i);
    }
}

/// One block of threads per `block` entries: all threads evaluate a tile, thread 0 folds it in index order.
template <class T, class Map, class Fold>
__global__ void reduce_kernel(std::int64_t n, std::int64_t block, T identity, Map map, Fold fold, T* partial) {
    extern __shared__ __align__(16) unsigned char shared[];
    T* tile = reinterpret_cast<T*>(shared);
    const std::int64_t begin = static_cast<std::int64_t>(blockIdx.x) * block;
    const std::int64_t end = begin + block < n ? begin + block : n;
    T sum = identity;
    for (std::int64_t first = begin; first < end; first += blockDim.x) {
        const std::int64_t i = first + threadIdx.x;
        if (i < end) {
            tile[threadIdx.x] = map(i);
        }
        __syncthreads();
        if (threadIdx.x == 0) {
            const int count = static_cast<int>(end - first < blockDim.x ? end - first : blockDim.x);
            for (int k = 0; k < count; ++k) {
                sum = fold(sum, tile[k]);
            }
        }
        __syncthreads();
    }
    if (threadIdx.x == 0) {
        partial[blockIdx.x] = sum;
    }
}

/// Chains that a block of threads evaluates at a time: as many as fit in shared memory.
template <class T>
constexpr int chains_at_a_time() {
    constexpr auto chain_bytes = static_cast<int>(sum_chain * sizeof(T));
    static_assert(chain_bytes <= 48 * 1024, "one chain must fit in shared memory");
    constexpr int fitting = 48 * 1024 / chain_bytes;
    return fitting < 4 ? fitting : 4;
}

/// One block of threads per `block` entries: all threads evaluate some chains, one thread adds up each of them, and
/// thread 0 adds up the chains in index order, as sum_in_chains does.
template <class T, class Map>
__global__ void sum_kernel(std::int64_t n, std::int64_t block, Map map, T* partial) {
    extern __shared__ __align__(16) unsigned char shared[];
    T* tile = reinterpret_cast<T*>(shared);
    const std::int64_t begin = static_cast<std::int64_t>(blockIdx.x) * block;
    const std::int64_t end = begin + block < n ? begin + block : n;
    const JoinBy<AddRounded> by{};
    T total{};
    for (std::int64_t first = begin; first < end; first += blockDim.x) {
        const std::int64_t i = first + threadIdx.x;
        if (i < end) {
            tile[threadIdx.x] = map(i);
        }
        __syncthreads();
        const auto own = static_cast<std::int64_t>(threadIdx.x) * sum_chain;  // of this thread, where it has a chain
        if (own < blockDim.x && first + own < end) {
            T chain{};
            for (std::int64_t k = own; k < own + sum_chain && first + k < end; ++k) {
                by.add(chain, tile[k]);
            }
            tile[own] = chain;
        }
        __syncthreads();
        if (threadIdx.x == 0) {
            for (std::int64_t k = 0; k < blockDim.x && first + k < end; k += sum_chain) {
                by.add(total, tile[k]);
            }
        }
        __syncthreads();
    }
    if (threadIdx.x == 0) {
        partial[blockIdx.x] = total;
    }
}

/// Runs a CUB algorithm twice: once to learn its scratch size, once for real.
template <class Algorithm>
void run_with_scratch(const char* what, const Algorithm& algorithm) {
    std::size_t bytes = 0;
    check(algorithm(nullptr, bytes), what);
    DeviceArray<unsigned char> scratch(std::max<std::size_t>(bytes, 1));
    check(algorithm(scratch.data(), bytes), what);
}

}  // namespace detail

/// f(i) for i in [0, n); f may write only what belongs to i.
template <class F>
void for_each(std::int64_t n, const F& f) {
    if (n <= 0) {
        return;
    }
    const std::int64_t blocks = (n + detail::threads_per_block - 1) / detail::threads_per_block;
    const auto grid = static_cast<unsigned>(std::min<std::int64_t>(blocks, 1 << 20));
    detail::for_each_kernel<<<grid, detail::threads_per_block>>>(n, f);
    check(cudaGetLastError(), "start a loop on the device");
}

/// Same result as parallel::reduce with the same functors.
template <class T, class Map, class Fold>
T reduce(std::int64_t n, const T& identity, const Map& map, const Fold& fold, std::int64_t block = reduce_block) {
    static_assert(sizeof(T) * detail::threads_per_block <= 48 * 1024, "one tile must fit in shared memory");
    if (n <= 0) {
        return identity;
    }
    const std::int64_t block_count = (n + block - 1) / block;
    DeviceArray<T> partial(static_cast<std::size_t>(block_count));
    detail::reduce_kernel<<<static_cast<unsigned>(block_count), detail::threads_per_block,
                            sizeof(T) * detail::threads_per_block>>>(n, block, identity, map, fold, partial.data());
    check(cudaGetLastError(), "start a sum on the device");
    T total = identity;
    for (const T& p : partial.download()) {
        total = fold(total, p);
    }
    return total;
}

/// Same bits as parallel::sum with the same functor.
template <class Map>
SumOf<Map> sum(std::int64_t n, const Map& map, std::int64_t block = reduce_block) {
    using T = SumOf<Map>;
    if (n <= 0) {
        return {};
    }
    constexpr auto threads = static_cast<unsigned>(detail::chains_at_a_time<T>() * sum_chain);
    const std::int64_t block_count = (n + block - 1) / block;
    DeviceArray<T> partial(static_cast<std::size_t>(block_count));
    detail::sum_kernel<<<static_cast<unsigned>(block_count), threads, sizeof(T) * threads>>>(n, block, map,
                                                                                             partial.data());
    check(cudaGetLastError(), "start a sum on the device");
    return total_of(partial.download());
}

/// out[i] = in[0] + ... + in[i-1]; returns the total. `out` may be `in`. T is an integer type.
template <class T>
T exclusive_scan(const DeviceArray<T>& in, DeviceArray<T>& out) {
    static_assert(std::is_integral_v<T>, "a sum of integers has one value in any order");
    const auto n = static_cast<std::int64_t>(in.size());
    if (n == 0) {
        return T{};
    }
    T last{};
    T last_sum{};
    check(cudaMemcpy(&last, in.data() + n - 1, sizeof(T), cudaMemcpyDeviceToHost), "copy from the device");
    detail::run_with_scratch("scan on the device", [&](void* scratch, std::size_t& bytes) {
        return cub::DeviceScan::ExclusiveSum(scratch, bytes, in.data(), out.data(), n);
    });
    check(cudaMemcpy(&last_sum, out.data() + n - 1, sizeof(T), cudaMemcpyDeviceToHost), "copy from the device");
    return last_sum + last;
}

/// Sorts 64-bit keys ascending and carries 32-bit values along; stable.
inline void sort_by_key(DeviceArray<std::uint64_t>& keys, DeviceArray<std::uint32_t>& values) {
    DeviceArray<std::uint64_t> sorted_keys(keys.size());
    DeviceArray<std::uint32_t> sorted_values(values.size());
    const auto n = static_cast<std::int64_t>(keys.size());
    if (n == 0) {
        return;
    }
    detail::run_with_scratch("sort on the device", [&](void* scratch, std::size_t& bytes) {
        return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys.data(), sorted_keys.data(), values.data(),
                                               sorted_values.data(), n);
    });
    keys.swap(sorted_keys);
    values.swap(sorted_values);
}

/// Memory and loops of the device in use, with the members of parallel::Host.
struct Device {
    template <class T>
    using Array = DeviceArray<T>;

    template <class T>
    static void upload(std::span<const T> host, Array<T>& there) {
        there.resize(host.size());
        there.upload(host);
    }
    template <class T>
    static void download(const Array<T>& there, std::span<T> host) {
        there.download(host);
    }
    template <class F>
    static void for_each(std::int64_t n, const F& f) {
        cuda::for_each(n, f);
    }
    template <class F>
    static void for_each_uneven(std::int64_t n, const F& f) {
        cuda::for_each(n, f);
    }
    template <class T, class Map, class Fold>
    static T reduce(std::int64_t n, const T& identity, const Map& map, const Fold& fold) {
        return cuda::reduce(n, identity, map, fold);
    }
    template <class Map>
    static SumOf<Map> sum(const Blocks& blocks, const Map& map) {
        RIPRAP_ASSERT(blocks.are_all(), "a device holds all blocks");
        return cuda::sum(blocks.size(), map);
    }
    static void sort_by_key(Array<std::uint64_t>& keys, Array<std::uint32_t>& values) {
        cuda::sort_by_key(keys, values);
    }
};

}  // namespace riprap::parallel::cuda
