// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"

namespace riprap::coupling {

/// Loads in corners of bodies that never move, as where the walls of a tank meet each other and its floor.
///
/// Pressure acts along the normal of a face. Over a plane wall that goes on behind its corner, what pairs pull along it
/// adds up to nothing, and what they press is the force on it. But the solid behind a corner belongs to one of the two
/// bodies alone, or to the floor that the other stands on: the sum over its samples lacks what they bear for both
/// faces. So what a sample feels along its own face is handed over to the body that stands out of that face near it,
///
///     f = c n + sum c_k n_k,     body k takes c_k n_k,
///
/// n the normal of the sample's face and n_k those of the faces that rise from it. A body counts where it stands out of
/// the face within the reach of the water, whether it goes on below it, ends on it or is thinner than that reach: over
/// the face outside of it, and over what it covers, pulls along add up to its share. The sum over all bodies is kept.
class CornerLoads {
 public:
    CornerLoads() = default;
    /// @param samples  of all bodies; where those of bodies that never move stay
    CornerLoads(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
                const SampleSettings& settings, const SampleSet& samples);

    bool empty() const { return shares_.empty(); }
    /// Hands over what the samples of a view feel along their faces.
    void hand_over(const SampleView& samples, const body::Motion& motion, const fluid::BoundaryParticles& particles,
                   body::Loads& loads) const;
    std::size_t bytes() const { return shares_.capacity() * sizeof(Share); }

 private:
    /// Gives (f . dual) normal of a force on a sample to another body.
    struct Share {
        std::int32_t sample;  ///< its number among all
        BodyId to;
        bool is_beyond;  ///< it: only what presses on its face is for it
        Vec3 dual, normal;
    };
    std::vector<Share> shares_;  ///< by sample
};

}  // namespace riprap::coupling
