// SPDX-License-Identifier: Apache-2.0
#pragma once

// Memory of a CUDA device, and copies between it and the host. Include it from .cu files only.

#include <cuda_runtime.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "riprap/core/device_error.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::parallel::cuda {

inline void check(cudaError_t code, const char* what) {
    if (code == cudaSuccess) {
        return;
    }
    const char* const advice =
        code == cudaErrorMemoryAllocation         ? ": a larger fluid.spacing, or fluid.runs_on = \"host\""
        : code == cudaErrorNoKernelImageForDevice ? ": a build with the device's CMAKE_CUDA_ARCHITECTURES"
                                                  : "";
    throw DeviceError(std::string("the device cannot ") + what + ": " + cudaGetErrorString(code) + advice);
}

/// Number of usable devices; 0 when there is no device or no driver for it.
inline int device_count() {
    int count = 0;
    return cudaGetDeviceCount(&count) == cudaSuccess ? count : 0;
}

/// Returns "NVIDIA H100, compute capability 9.0", of the device in use; why there is none where that is so.
inline std::string device_name() {
    int device = 0, count = 0;
    cudaDeviceProp properties{};
    cudaError_t code = cudaGetDeviceCount(&count);
    code = code == cudaSuccess ? cudaGetDevice(&device) : code;
    code = code == cudaSuccess ? cudaGetDeviceProperties(&properties, device) : code;
    if (code != cudaSuccess) {
        return std::string("none (") + cudaGetErrorString(code) + ")";
    }
    return std::string(properties.name) + ", compute capability " + std::to_string(properties.major) + "." +
           std::to_string(properties.minor);
}

/// Waits until the device has done all it was given, and reports what went wrong meanwhile.
inline void wait() { check(cudaDeviceSynchronize(), "wait for the device"); }

namespace detail {

/// Lets freed memory of the device stay with this program, so that buffers of a step cost no call of the driver.
inline void keep_freed_memory() {
    static const bool is_kept = [] {
        int device = 0;
        cudaMemPool_t pool{};
        auto all = ~std::uint64_t{0};
        check(cudaGetDevice(&device), "ask for the device");
        check(cudaDeviceGetDefaultMemPool(&pool, device), "ask for the device's memory");
        check(cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &all), "keep the device's memory");
        return true;
    }();
    static_cast<void>(is_kept);
}
inline void* allocate(std::size_t bytes) {
    keep_freed_memory();
    void* memory = nullptr;
    check(cudaMallocAsync(&memory, bytes, nullptr), "allocate device memory");
    return memory;
}
inline void release(void* memory) noexcept { cudaFreeAsync(memory, nullptr); }

/// Memory of the host that the device reads and writes by itself, in two halves: while one travels, the threads of the
/// host fill or empty the other. Four times as fast as the driver, which does the like with one thread.
class Stage {
 public:
    Stage() {
        for (Half& half : halves_) {
            check(cudaMallocHost(&half.memory, half_size), "allocate memory for copies");
            check(cudaEventCreateWithFlags(&half.arrived, cudaEventDisableTiming), "make an event");
        }
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    void upload(void* device, const void* host, std::size_t bytes) {
        const std::lock_guard lock(mutex_);
        for (std::size_t done = 0; done < bytes; done += half_size) {
            Half& half = next();
            const std::size_t part = std::min(half_size, bytes - done);
            check(cudaEventSynchronize(half.arrived), "wait for a copy");
            copy(half.memory, static_cast<const char*>(host) + done, part);
            send(static_cast<char*>(device) + done, half.memory, part, cudaMemcpyHostToDevice, half);
        }
    }
    void download(void* host, const void* device, std::size_t bytes) {
        const std::lock_guard lock(mutex_);
        Half* before = nullptr;
        std::size_t begin = 0, size = 0;
        for (std::size_t done = 0; done < bytes || before != nullptr; done += half_size) {
            Half* half = nullptr;
            const std::size_t part = done < bytes ? std::min(half_size, bytes - done) : 0;
            if (part > 0) {
                half = &next();
                check(cudaEventSynchronize(half->arrived), "wait for a copy");
                send(half->memory, static_cast<const char*>(device) + done, part, cudaMemcpyDeviceToHost, *half);
            }
            if (before != nullptr) {
                check(cudaEventSynchronize(before->arrived), "wait for a copy");
                copy(static_cast<char*>(host) + begin, before->memory, size);
            }
            before = half;
            begin = done;
            size = part;
        }
    }
    static Stage& of_process() {
        static Stage* const stage = new Stage;  // never freed: the driver may be gone when the program ends
        return *stage;
    }

 private:
    static constexpr std::size_t half_size = std::size_t{4} << 20;
    struct Half {
        void* memory{nullptr};
        cudaEvent_t arrived{};
    };
    Half& next() {
        turn_ = 1 - turn_;
        return halves_[turn_];
    }
    static void send(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind, Half& half) {
        check(cudaMemcpyAsync(to, from, bytes, kind, nullptr), "copy between host and device");
        check(cudaEventRecord(half.arrived, nullptr), "record a copy");
    }
    static void copy(void* to, const void* from, std::size_t bytes) {
        constexpr std::int64_t grain = 1 << 17;
        parallel::for_ranges(static_cast<std::int64_t>(bytes), grain, [=](std::int64_t begin, std::int64_t end) {
            std::memcpy(static_cast<char*>(to) + begin, static_cast<const char*>(from) + begin,
                        static_cast<std::size_t>(end - begin));
        });
    }
    std::mutex mutex_;  // two runs of one program share the halves
    Half halves_[2];
    int turn_{0};
};

}  // namespace detail

/// Owned array on the device. Entries are not initialised.
template <class T>
class DeviceArray {
    static_assert(std::is_trivially_copyable_v<T>);

 public:
    DeviceArray() = default;
    explicit DeviceArray(std::size_t size) : size_(size), capacity_(size) {
        if (size > 0) {
            data_ = static_cast<T*>(detail::allocate(size * sizeof(T)));
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
            detail::release(data_);
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
            *this = DeviceArray();  // free the old room before asking for more
            *this = DeviceArray(size);
        }
        size_ = size;
    }
    /// Copies host[0 .. size) to the device; the sizes must agree.
    void upload(std::span<const T> host) {
        if (host.size() != size_) {
            throw DeviceError("upload: " + std::to_string(host.size()) + " entries into an array of " +
                              std::to_string(size_));
        }
        detail::Stage::of_process().upload(data_, host.data(), host.size_bytes());
    }
    /// Copies them to host[0 .. size); the sizes must agree.
    void download(std::span<T> host) const {
        if (host.size() != size_) {
            throw DeviceError("download: " + std::to_string(size_) + " entries into room for " +
                              std::to_string(host.size()));
        }
        detail::Stage::of_process().download(host.data(), data_, host.size_bytes());
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
    T* data_{nullptr};
    std::size_t size_{0}, capacity_{0};
};

}  // namespace riprap::parallel::cuda
