// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep_scratch.hpp"

#include "riprap/core/bytes.hpp"

namespace riprap::fluid {

SweepScratch::SweepScratch() : data_(std::make_unique<SweepScratchData>()) {}
SweepScratch::~SweepScratch() = default;
SweepScratch::SweepScratch(SweepScratch&&) noexcept = default;
SweepScratch& SweepScratch::operator=(SweepScratch&&) noexcept = default;

SweepScratch SweepScratch::sharing_buffers(SweepScratch& other) {
    SweepScratch scratch;
    scratch.data_->buffers = other.data_->buffers;
    scratch.data_->owns_buffers = false;
    return scratch;
}

std::size_t SweepScratch::bytes() const {
    const SweepBuffers& buffers = *data_->buffers;
    const std::size_t own =
        data_->owns_buffers ? bytes_of(buffers.fields, buffers.patch_sums) + buffers.records.bytes() : 0;
    return data_->list.bytes() + own;
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
