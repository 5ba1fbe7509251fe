// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/fluid/mps/mps_settings.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"

namespace riprap::fluid::mps {

/// Neighbours of particles within the support, row by row, in double: for systems of equations.
class Neighbours {
 public:
    /// Lists for each target the points within the support, ascending, and itself not.
    /// @param is_same  targets and points are the same particles
    void find(const MpsSettings& settings, std::span<const Vec3> targets, std::span<const Vec3> points, bool is_same);

    std::int64_t first(std::size_t i) const { return start_[i]; }
    std::int64_t end(std::size_t i) const { return start_[i + 1]; }
    std::size_t index(std::int64_t entry) const {
        return static_cast<std::size_t>(index_[static_cast<std::size_t>(entry)]);
    }
    /// W [-]
    double weight(std::int64_t entry) const { return weight_[static_cast<std::size_t>(entry)]; }
    std::size_t bytes() const { return bytes_of(start_, index_, weight_); }

 private:
    struct Found {
        std::int32_t index;
        double weight;
    };
    CellGrid grid_;
    std::vector<std::int64_t> start_{0};
    std::vector<std::int32_t> index_;
    std::vector<double> weight_;
    std::vector<std::vector<Found>> chunks_;
};

}  // namespace riprap::fluid::mps
