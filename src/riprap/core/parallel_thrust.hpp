// SPDX-License-Identifier: Apache-2.0
#pragma once

// Thrust back end of core/parallel: the functors of a device in memory of Thrust's own, by the device system that
// THRUST_DEVICE_SYSTEM names: its plain C++ or its OpenMP (a C++ compiler and Thrust's headers suffice). It keeps the
// sources for devices compiling and running where there is no CUDA; what it computes has the host's bits, as those of
// parallel_cuda.hpp have, whose names it shares.

#include <thrust/device_free.h>
#include <thrust/device_malloc.h>
#include <thrust/device_ptr.h>
#include <thrust/execution_policy.h>
#include <thrust/for_each.h>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/scan.h>
#include <thrust/sort.h>
#include <thrust/transform_reduce.h>
#include <thrust/version.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "riprap/core/blocks.hpp"
#include "riprap/core/device_error.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::parallel::thrust_system {

inline int device_count() { return 1; }
inline std::string device_name() {
    const char* const system = THRUST_DEVICE_SYSTEM == THRUST_DEVICE_SYSTEM_CPP   ? "C++"
                               : THRUST_DEVICE_SYSTEM == THRUST_DEVICE_SYSTEM_OMP ? "OpenMP"
                                                                                  : "another system";
    return "Thrust " + std::to_string(THRUST_MAJOR_VERSION) + "." + std::to_string(THRUST_MINOR_VERSION) + " with " +
           system + ", no GPU";
}
/// Loops of these systems have ended when they return.
inline void wait() {}

/// Owned array of Thrust's device. Entries are not initialised.
template <class T>
class DeviceArray {
    static_assert(std::is_trivially_copyable_v<T>);

 public:
    DeviceArray() = default;
    explicit DeviceArray(std::size_t size) : size_(size), capacity_(size) {
        if (size > 0) {
            data_ = thrust::raw_pointer_cast(thrust::device_malloc<T>(size));
        }
    }
    explicit DeviceArray(std::span<const T> host) : DeviceArray(host.size()) { upload(host); }
    DeviceArray(DeviceArray&& other) noexcept { swap(other); }
    DeviceArray& operator=(DeviceArray&& other) noexcept {
        swap(other);
        return *this;
    }
    ~DeviceArray() {
        if (data_ != nullptr) {
            thrust::device_free(thrust::device_pointer_cast(data_));
        }
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    std::size_t capacity() const { return capacity_; }
    T* data() { return data_; }
    const T* data() const { return data_; }

    /// Makes room for so many entries. What they hold is lost where the room has to grow.
    void resize(std::size_t size) {
        if (size > capacity_) {
            *this = DeviceArray();
            *this = DeviceArray(size);
        }
        size_ = size;
    }
    /// Copies host[0 .. size) to the device; the sizes must agree.
    void upload(std::span<const T> host) {
        agree(host.size());
        std::copy(host.begin(), host.end(), data_);
    }
    /// Copies them to host[0 .. size); the sizes must agree.
    void download(std::span<T> host) const {
        agree(host.size());
        std::copy(data_, data_ + size_, host.begin());
    }
    std::vector<T> download() const {
        std::vector<T> host(size_);
        download(host);
        return host;
    }
    void swap(DeviceArray& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

 private:
    void agree(std::size_t size) const {
        if (size != size_) {
            throw DeviceError("a copy of " + std::to_string(size) + " entries for an array of " +
                              std::to_string(size_));
        }
    }

    T* data_{nullptr};
    std::size_t size_{0}, capacity_{0};
};

/// f(i) for i in [0, n); f may write only what belongs to i.
template <class F>
void for_each(std::int64_t n, const F& f) {
    thrust::for_each_n(thrust::device, thrust::counting_iterator<std::int64_t>(0), std::max<std::int64_t>(0, n), f);
}

/// Same result as parallel::reduce with the same functors.
template <class T, class Map, class Fold>
T reduce(std::int64_t n, const T& identity, const Map& map, const Fold& fold) {
    const thrust::counting_iterator<std::int64_t> first(0);
    return thrust::transform_reduce(thrust::device, first, first + std::max<std::int64_t>(0, n), map, identity, fold);
}

namespace detail {

/// Adds up one block.
template <class T, class Map>
struct SumBlock {
    std::int64_t n, block;
    Map map;
    T* partial;

    RIPRAP_HD void operator()(std::int64_t k) const {
        const std::int64_t begin = k * block, end = begin + block < n ? begin + block : n;
        partial[k] = sum_in_chains<T>(begin, end, map);
    }
};

}  // namespace detail

/// Same bits as parallel::sum with the same functor.
template <class Map>
SumOf<Map> sum(std::int64_t n, const Map& map, std::int64_t block = reduce_block) {
    using T = SumOf<Map>;
    if (n <= 0) {
        return {};
    }
    const std::int64_t block_count = (n + block - 1) / block;
    DeviceArray<T> partial(static_cast<std::size_t>(block_count));
    for_each(block_count, detail::SumBlock<T, Map>{n, block, map, partial.data()});
    return total_of(partial.download());
}

/// out[i] = in[0] + ... + in[i-1]; returns the total. `out` may be `in`. T is an integer type.
template <class T>
T exclusive_scan(const DeviceArray<T>& in, DeviceArray<T>& out) {
    static_assert(std::is_integral_v<T>, "a sum of integers has one value in any order");
    if (in.empty()) {
        return T{};
    }
    const std::size_t last = in.size() - 1;
    const T last_entry = in.data()[last];
    thrust::exclusive_scan(thrust::device, in.data(), in.data() + in.size(), out.data());
    return out.data()[last] + last_entry;
}

/// Sorts 64-bit keys ascending and carries 32-bit values along; stable.
inline void sort_by_key(DeviceArray<std::uint64_t>& keys, DeviceArray<std::uint32_t>& values) {
    thrust::stable_sort_by_key(thrust::device, keys.data(), keys.data() + keys.size(), values.data());
}

/// Memory and loops of Thrust's device, with the members of parallel::Host.
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
        thrust_system::for_each(n, f);
    }
    template <class F>
    static void for_each_uneven(std::int64_t n, const F& f) {
        thrust_system::for_each(n, f);
    }
    template <class T, class Map, class Fold>
    static T reduce(std::int64_t n, const T& identity, const Map& map, const Fold& fold) {
        return thrust_system::reduce(n, identity, map, fold);
    }
    template <class Map>
    static SumOf<Map> sum(const Blocks& blocks, const Map& map) {
        RIPRAP_ASSERT(blocks.are_all(), "a device holds all blocks");
        return thrust_system::sum(blocks.size(), map);
    }
    static void sort_by_key(Array<std::uint64_t>& keys, Array<std::uint32_t>& values) {
        thrust_system::sort_by_key(keys, values);
    }
};

}  // namespace riprap::parallel::thrust_system
