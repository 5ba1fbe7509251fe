// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep/sweep_scratch.hpp"

#include "riprap/core/bytes.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"
#include "riprap/fluid/particle/sweep/sweep_lists.hpp"

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

SweepScratch::SweepScratch(const std::shared_ptr<PlacedParticles>& targets,
                           const std::shared_ptr<PlacedParticles>& candidates, SweepScratch* buffers)
    : data_(std::make_unique<SweepScratchData>(ClusterList(targets, candidates))) {
    if (buffers != nullptr) {
        data_->buffers = buffers->data_->buffers;
        data_->owns_buffers = false;
    }
}

SweepLists::SweepLists()
    : fluid_(std::make_shared<PlacedParticles>()),
      walls_(std::make_shared<PlacedParticles>()),
      fluid_fluid(fluid_, fluid_, nullptr),
      fluid_walls(fluid_, walls_, &fluid_fluid),
      walls_fluid(walls_, fluid_, &fluid_fluid),
      walls_walls(walls_, walls_, &fluid_fluid) {}
SweepLists::~SweepLists() = default;
SweepLists::SweepLists(SweepLists&&) noexcept = default;
SweepLists& SweepLists::operator=(SweepLists&&) noexcept = default;

void SweepLists::place(const SweepReach& reach, const parallel::Blocks& blocks, std::span<const Vec3> fluid,
                       std::span<const Vec3> walls) {
    fluid_->order().take(blocks);
    const Box box = box_of(fluid, walls);
    const FixedPoint fixed(reach, max(box.high - box.low, Vec3{}));
    fluid_->place(fluid, fixed, reach.domain.dimension);
    walls_->place(walls, fixed, reach.domain.dimension);
}

std::size_t SweepLists::bytes() const {
    return fluid_->bytes() + walls_->bytes() + fluid_fluid.bytes() + fluid_walls.bytes() + walls_fluid.bytes() +
           walls_walls.bytes();
}

std::size_t SweepScratch::bytes() const {
    const SweepBuffers& buffers = *data_->buffers;
    const std::size_t own = data_->owns_buffers
                                ? bytes_of(buffers.packed.fields, buffers.packed.blocks, buffers.packed.place,
                                           buffers.patch_sums, buffers.patch_begin) +
                                      buffers.records.bytes()
                                : 0;
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
