// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/body/ground.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// The solids of a scene as filling sees them: all parts of all bodies, with their images across periodic sides, and
/// the surfaces of ground. Small parts are in cells, so that what a question costs does not grow with the blocks far
/// away.
class FillSolids {
 public:
    /// @param farthest  no distance is asked for beyond it [m]
    FillSolids(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
               const fluid::Domain& domain, double farthest);
    bool contain(const Vec3& x) const;
    /// True inside of a solid, and outside where a surface is less than `distance` away [m].
    bool are_near(const Vec3& x, double distance) const;
    /// The same, of solids thinner than `thickness` alone: whose largest ball has that diameter [m].
    bool thin_are_near(const Vec3& x, double distance, double thickness) const;
    /// The place next to x that is `distance` away from the solid which x lies deepest in or nearest to; x itself where
    /// none is so near [m].
    Vec3 push_out(const Vec3& x, double distance) const;
    /// Tells whether the straight way from a to b, both outside of solids, leads through one, however thin.
    bool lie_between(const Vec3& a, const Vec3& b) const;

 private:
    struct Placed {
        geometry::ConvexView shape;
        Pose pose;
    };
    void add_images(const fluid::Domain& domain);
    void sort_into_cells();
    static bool is_near(const Placed& part, const Vec3& x, double distance);
    static bool is_cut(const Placed& part, const Vec3& a, const Vec3& b);
    template <class Is>
    bool is_any(const Vec3& x, const Is& is) const;

    double farthest_;
    std::vector<Placed> parts_;  ///< the small ones first
    std::size_t small_{0};       ///< number of them
    fluid::CellGrid cells_;      ///< of centres of the small ones
    std::vector<body::Ground> grounds_;
    std::vector<Pose> poses_;  ///< of the grounds
};

}  // namespace riprap::coupling
