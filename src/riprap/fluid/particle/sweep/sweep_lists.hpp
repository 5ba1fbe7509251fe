// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "riprap/core/blocks.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::fluid {

class PlacedParticles;

/// Lists of neighbours and buffers of the sums over them, between fluid and walls: a cache, kept from step to step.
/// Where each set of particles is, and boxes around them, are there once.
class SweepLists {
 public:
    SweepLists();
    ~SweepLists();
    SweepLists(SweepLists&&) noexcept;
    SweepLists& operator=(SweepLists&&) noexcept;

    /// Tells the sweeps that follow where the particles are: to be called after every move of either set.
    /// @param blocks  those of the fluid
    void place(const SweepReach& reach, const parallel::Blocks& blocks, std::span<const Vec3> fluid,
               std::span<const Vec3> walls);
    std::size_t bytes() const;

 private:
    std::shared_ptr<PlacedParticles> fluid_, walls_;

 public:
    SweepScratch fluid_fluid, fluid_walls, walls_fluid, walls_walls;
};

}  // namespace riprap::fluid
