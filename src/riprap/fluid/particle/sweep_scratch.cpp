// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep_scratch.hpp"

namespace riprap::fluid {

SweepScratch::SweepScratch() : data_(std::make_unique<SweepScratchData>()) {}
SweepScratch::~SweepScratch() = default;
SweepScratch::SweepScratch(SweepScratch&&) noexcept = default;
SweepScratch& SweepScratch::operator=(SweepScratch&&) noexcept = default;

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
