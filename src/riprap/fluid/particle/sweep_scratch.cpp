// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep_scratch.hpp"

#include "riprap/core/bytes.hpp"

namespace riprap::fluid {

SweepScratch::SweepScratch() : data_(std::make_unique<SweepScratchData>()) {}
SweepScratch::~SweepScratch() = default;
SweepScratch::SweepScratch(SweepScratch&&) noexcept = default;
SweepScratch& SweepScratch::operator=(SweepScratch&&) noexcept = default;

std::size_t SweepScratch::bytes() const {
    return data_->list.bytes() + bytes_of(data_->fields, data_->patch_sums) + data_->records.bytes();
}

std::size_t BufferPool::bytes() const {
    const std::lock_guard lock(mutex_);
    std::size_t bytes = bytes_of(free_);
    for (const std::unique_ptr<Buffer>& buffer : free_) {
        bytes += bytes_of(*buffer);
    }
    return bytes;
}

std::unique_ptr<BufferPool::Buffer> BufferPool::take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
        return std::make_unique<Buffer>();
    }
    std::unique_ptr<Buffer> buffer = std::move(free_.back());
    free_.pop_back();
    return buffer;
}

void BufferPool::give(std::unique_ptr<Buffer> buffer) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(buffer));
}

}  // namespace riprap::fluid
