// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "riprap/core/error.hpp"

namespace riprap {

/// Memory in which loops run.
enum class Residence : std::uint8_t { host, device };

/// Memory of a device. A back end implements it (core/parallel_cuda.hpp); the host alone has none.
class DeviceMemory {
 public:
    virtual ~DeviceMemory() = default;
    virtual void* allocate(std::size_t bytes) = 0;
    virtual void release(void* memory) noexcept = 0;
    virtual void upload(void* device, const void* host, std::size_t bytes) = 0;
    virtual void download(void* host, const void* device, std::size_t bytes) = 0;
};

/// One number, vector or tensor per entity, on the host, on a device, or on both. It knows where its newest values are
/// and copies them only when they are asked for elsewhere, so that a step whose loops all run on a device moves
/// nothing. Loops are named functors that hold the spans.
template <class T>
class Field {
    static_assert(std::is_trivially_copyable_v<T>, "a device gets the bytes");

 public:
    Field() = default;
    /// @param device  memory of the device that loops may run on; nullptr: the host alone
    explicit Field(std::vector<T> values, DeviceMemory* device = nullptr) : host_(std::move(values)), memory_(device) {}
    explicit Field(std::size_t size, DeviceMemory* device = nullptr) : Field(std::vector<T>(size), device) {}
    Field(Field&& other) noexcept { swap(other); }
    Field& operator=(Field&& other) noexcept {
        swap(other);
        return *this;
    }
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;
    ~Field() {
        if (device_ != nullptr) {
            memory_->release(device_);
        }
    }

    std::size_t size() const { return host_.size(); }
    /// Tells whether the newest values are there.
    bool is_in(Residence where) const { return where == Residence::host ? is_on_host_ : is_on_device_; }

    /// Returns the values for loops that read them there.
    std::span<const T> read(Residence where) {
        bring(where);
        return entries(where);
    }
    /// Returns the values for loops that change some of them there.
    std::span<T> change(Residence where) {
        bring(where);
        leave_only(where);
        return entries(where);
    }
    /// Returns room for loops that write every entry there; the old values are lost.
    std::span<T> overwrite(Residence where) {
        make_room(where);
        leave_only(where);
        return entries(where);
    }
    void swap(Field& other) noexcept {
        std::swap(host_, other.host_);
        std::swap(memory_, other.memory_);
        std::swap(device_, other.device_);
        std::swap(is_on_host_, other.is_on_host_);
        std::swap(is_on_device_, other.is_on_device_);
    }

 private:
    std::size_t bytes() const { return host_.size() * sizeof(T); }
    std::span<T> entries(Residence where) {
        return {where == Residence::host ? host_.data() : static_cast<T*>(device_), host_.size()};
    }
    void make_room(Residence where) {
        if (where == Residence::device && device_ == nullptr && !host_.empty()) {
            RIPRAP_ASSERT(memory_ != nullptr, "a field of the host alone was asked for on a device");
            device_ = memory_->allocate(bytes());
        }
    }
    void bring(Residence where) {
        make_room(where);
        if (is_in(where) || host_.empty()) {
            return;
        }
        if (where == Residence::device) {
            memory_->upload(device_, host_.data(), bytes());
            is_on_device_ = true;
        } else {
            memory_->download(host_.data(), device_, bytes());
            is_on_host_ = true;
        }
    }
    void leave_only(Residence where) {
        is_on_host_ = where == Residence::host;
        is_on_device_ = where == Residence::device;
    }

    std::vector<T> host_;
    DeviceMemory* memory_{nullptr};
    void* device_{nullptr};
    bool is_on_host_{true}, is_on_device_{false};
};

}  // namespace riprap
