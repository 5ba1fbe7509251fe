// SPDX-License-Identifier: Apache-2.0
#pragma once

// CUDA back end of core/parallel: the same loops over the same functors, on one device. Include it from .cu files only.
//
// A functor handed to these functions is a named type with RIPRAP_HD members, trivially copyable, holding plain
// pointers into DeviceArrays. Sums have the bits of the host's: every block of entries (`reduce_block` unless told) is
// folded in index order by one thread, after all threads have evaluated the entries. Compile with -fmad=false, the
// device's counterpart of -ffp-contract=off.

#include <cuda_runtime.h>

#include <algorithm>
#include <cstdint>
#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "riprap/core/field.hpp"
#include "riprap/core/range.hpp"

namespace riprap::parallel::cuda {

/// The CUDA runtime refused something; the message says what was asked and the runtime's reason.
class DeviceError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline void check(cudaError_t code, const char* what) {
    if (code != cudaSuccess) {
        throw DeviceError(std::string(what) + ": " + cudaGetErrorString(code));
    }
}

/// Number of usable devices; 0 when there is no device or no driver for it.
inline int device_count() {
    int count = 0;
    return cudaGetDeviceCount(&count) == cudaSuccess ? count : 0;
}

/// "NVIDIA H100, compute capability 9.0", of the device in use.
inline std::string device_name() {
    int device = 0;
    cudaDeviceProp properties{};
    check(cudaGetDevice(&device), "ask for the device");
    check(cudaGetDeviceProperties(&properties, device), "ask for the device's properties");
    return std::string(properties.name) + ", compute capability " + std::to_string(properties.major) + "." +
           std::to_string(properties.minor);
}

/// Waits until the device has done all it was given, and reports what went wrong meanwhile.
inline void wait() { check(cudaDeviceSynchronize(), "wait for the device"); }

/// Owned array on the device. Entries are not initialised.
template <class T>
class DeviceArray {
    static_assert(std::is_trivially_copyable_v<T>);

 public:
    DeviceArray() = default;
    explicit DeviceArray(std::size_t size) : size_(size) {
        if (size > 0) {
            check(cudaMalloc(reinterpret_cast<void**>(&data_), size * sizeof(T)), "allocate device memory");
        }
    }
    explicit DeviceArray(std::span<const T> host) : DeviceArray(host.size()) { upload(host); }
    DeviceArray(DeviceArray&& other) noexcept { swap(other); }
    DeviceArray& operator=(DeviceArray&& other) noexcept {
        swap(other);
        return *this;
    }
    ~DeviceArray() { cudaFree(data_); }

    std::size_t size() const { return size_; }
    T* data() { return data_; }
    const T* data() const { return data_; }

    /// Copies host[0 .. size) to the device; the sizes must agree.
    void upload(std::span<const T> host) {
        if (host.size() != size_) {
            throw DeviceError("upload: " + std::to_string(host.size()) + " entries into an array of " +
                              std::to_string(size_));
        }
        check(cudaMemcpy(data_, host.data(), size_ * sizeof(T), cudaMemcpyHostToDevice), "copy to the device");
    }
    std::vector<T> download() const {
        std::vector<T> host(size_);
        check(cudaMemcpy(host.data(), data_, size_ * sizeof(T), cudaMemcpyDeviceToHost), "copy from the device");
        return host;
    }
    void swap(DeviceArray& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
    }

 private:
    T* data_{nullptr};
    std::size_t size_{0};
};

/// Memory of the device in use, for Field.
class Memory final : public DeviceMemory {
 public:
    void* allocate(std::size_t bytes) override {
        void* memory = nullptr;
        check(cudaMalloc(&memory, bytes), "allocate device memory");
        return memory;
    }
    void release(void* memory) noexcept override { cudaFree(memory); }
    void upload(void* device, const void* host, std::size_t bytes) override {
        check(cudaMemcpy(device, host, bytes, cudaMemcpyHostToDevice), "copy to the device");
    }
    void download(void* host, const void* device, std::size_t bytes) override {
        check(cudaMemcpy(host, device, bytes, cudaMemcpyDeviceToHost), "copy from the device");
    }
};

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

/// A functor whose entries begin elsewhere than at zero.
template <class F>
struct Shifted {
    F f;
    std::int64_t begin;
    RIPRAP_HD void operator()(std::int64_t i) const { f(begin + i); }
};

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

/// f(i) for every i of a range, on the host or on the device: the same functor, bound to spans of Fields there.
template <class F>
void for_each(Residence where, const Range& owned, const F& f) {
    if (where == Residence::host) {
        parallel::for_each(owned, f);
        return;
    }
    for_each(owned.size(), detail::Shifted<F>{f, owned.begin});
}

/// Same bits as parallel::reduce with the same functors.
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
    detail::run_with_scratch("sort on the device", [&](void* scratch, std::size_t& bytes) {
        return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys.data(), sorted_keys.data(), values.data(),
                                               sorted_values.data(), n);
    });
    keys.swap(sorted_keys);
    values.swap(sorted_values);
}

}  // namespace riprap::parallel::cuda
