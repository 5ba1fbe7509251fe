// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// Seams between driven bodies and others that no force moves, as where a paddle or a gate slides through the floor:
/// solids that lie in each other stand for one. They change with every step, which those of seams.hpp do not.
///
/// **Volumes.** Every piece of solid belongs to the body in which it lies deepest. A sample keeps the share of its cell
/// in which its own body is deeper than any other; depths are taken as those of planes, so the share is that of a
/// square cut by a line.
///
/// **Velocities.** A body that slides along its face through another one vanishes there, and continuity takes that for
/// a wall that is drawn back or comes on, also where the water before it is at rest. In the solid that two bodies share
/// samples move with
///
///     v = v_1 + v_2 - u,     u . n_1 = v_1 . n_1,   u . n_2 = v_2 . n_2,
///
/// u the velocity of water in the corner, which each of the faces lets slide along it. Then both sums
/// sum V (u - v_w) . grad W, over either body and what they share, are those of whole plane walls that slide along
/// themselves: zero. Accelerations likewise, without the swing of turning normals.
///
/// **Loads.** Pressure acts along the normal of a face. What pairs pull along a face adds up to nothing over the face,
/// but in the solid that two bodies share a sample carries what presses on both. What it feels along its own face,
/// towards the face of the other body, is handed over to that one, so the sum over both is kept and a wall that slides
/// along itself does no work.
class MovingSeams {
 public:
    /// @param reach   how deep the water looks into a solid [m]
    /// @param is_dry  per body: not there for the water; empty = none
    MovingSeams(const geometry::ShapeSet& shapes, const body::BodySet& bodies, std::span<const std::uint8_t> is_dry,
                const body::Motion& motion, double spacing, double reach);

    /// Tells that no body is driven, or that no driven one meets water.
    bool empty() const { return held_.empty(); }
    /// Shares out volumes and motion of samples that have just been placed, and takes back what was shared before.
    void share(const SampleView& samples, fluid::BoundaryParticles& particles) const;
    /// Hands over what samples feel along their faces.
    void hand_over(const SampleView& samples, const fluid::BoundaryParticles& particles, body::Loads& loads) const;
    /// Returns by how much the power of the bodies that really take these loads is more than that of the forces on
    /// samples as they are told to move [W].
    double handed_power(const SampleView& samples, const fluid::BoundaryParticles& particles) const;

 private:
    struct PlacedShape {
        geometry::ConvexView view;
        Pose pose;
        BodyId body;
    };
    /// A body with the parts of others that it may meet.
    struct Side {
        BodyId body;
        std::vector<PlacedShape> others;
    };
    /// Names the body in which a sample lies deepest, and how.
    struct Meeting {
        BodyId body;
        double depth;  ///< of the sample in it, negative outside [m]
        Vec3 normal;   ///< of its face, outward
    };

    void add_pair(BodyId one, BodyId other);
    void add_parts(BodyId body, BodyId near, std::vector<PlacedShape>& parts) const;
    Side& side_of(BodyId body);
    std::optional<Meeting> meet(const Side& side, const Vec3& x) const;
    double depth_in(const PlacedShape& part, const Vec3& x, Vec3& normal) const;
    void take_back(const SampleView& samples, fluid::BoundaryParticles& particles) const;
    double share_of(double depth, const Vec3& normal, const Meeting& other) const;
    template <class Visit>
    void visit_handed(const SampleView& samples, const fluid::BoundaryParticles& particles, const Visit& visit) const;
    template <class Visit>
    void visit_meetings(const SampleView& samples, const fluid::BoundaryParticles& particles, const Visit& visit) const;

    const geometry::ShapeSet& shapes_;
    const body::BodySet& bodies_;
    const body::Motion& motion_;
    double spacing_, reach_;
    std::vector<BodyId> held_;  ///< wet bodies that no force moves; none where none is driven
    std::vector<Side> sides_;   ///< by body
};

}  // namespace riprap::coupling
