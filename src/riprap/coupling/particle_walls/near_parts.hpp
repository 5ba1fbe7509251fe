// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"
#include "riprap/geometry/polyhedra/convex_view.hpp"

namespace riprap::coupling {

/// A convex part of a body, where it is.
struct PlacedPart {
    geometry::ConvexView shape;
    Pose pose;
    std::int32_t body;
    double reach;  ///< no particle farther from its centre is looked at; negative: none at all [m]
};

/// Which parts may be near which particles. Particles are taken in blocks that follow each other in the State, so that
/// sorted ones lie in small boxes; parts go down a tree of such boxes. The cost grows with the particles and with the
/// parts, not with their product: a part far from all water is dismissed by one box. Which parts are named besides
/// those that are near changes no bit of what is found with them.
class NearParts {
 public:
    static constexpr std::int64_t block_size = 64;  ///< particles

    /// @param within  distance from a face from which on nothing is asked for [m]
    void find(std::span<const PlacedPart> parts, std::span<const Vec3> particles, const fluid::Domain& domain,
              double within);

    /// Parts that may come within the distance of a particle of the block, ascending.
    std::span<const std::int32_t> of_block(std::int64_t block) const {
        const auto b = static_cast<std::size_t>(block);
        return {parts_.data() + begin_[b], static_cast<std::size_t>(begin_[b + 1] - begin_[b])};
    }
    std::size_t bytes() const { return bytes_of(levels_, hits_, begin_, parts_); }

 private:
    static constexpr std::int64_t branches = 8;
    struct Bounds {
        Vec3 low, high;
    };

    void build_tree(std::span<const Vec3> particles);
    bool may_touch(const PlacedPart& part, const Bounds& box, bool is_block) const;
    bool is_beyond_a_face(const PlacedPart& part, const Vec3& centre, const Vec3& half) const;
    void visit(const PlacedPart& part, std::size_t level, std::int64_t entry, std::vector<std::int32_t>& hits) const;

    Vec3 period_{};  ///< 0 along axes that do not repeat [m]
    double within_{0};
    std::vector<std::vector<Bounds>> levels_;      ///< from the blocks up to one box
    std::vector<std::vector<std::int32_t>> hits_;  ///< blocks of each part
    std::vector<std::int64_t> begin_;              ///< of each block in parts_, one more at the end
    std::vector<std::int32_t> parts_;
};

}  // namespace riprap::coupling
