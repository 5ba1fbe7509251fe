// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "riprap/body/body_set.hpp"
#include "riprap/coupling/sample_set.hpp"
#include "riprap/fluid/particle/domain.hpp"
#include "riprap/geometry/shape_set.hpp"

namespace riprap::coupling {

struct SampleSettings {
    double spacing{0};                          ///< dp of the fluid [m]
    double reach{0};                            ///< how deep the fluid looks into a solid: its support radius [m]
    fluid::Domain domain;                       ///< of the fluid
    std::int64_t limit{0};                      ///< most samples that may be made
    std::span<const std::uint8_t> is_dry;       ///< per body: feels no fluid and gets no samples; empty = none
    std::span<const std::uint8_t> is_slippery;  ///< per body: free slip; empty = none
};

/// The boundary particles of all wet bodies: layers under every face that meets water (face_layers.hpp), part by part,
/// in the frame of each body.
///
/// Parts of one body share faces; layers follow those too, and only points within `reach` of the surface that carries
/// a field are kept, so a re-entrant corner is as full as a plane wall. Bodies that never move, half-spaces among them,
/// are cut to the domain, grown by `reach` and the rest of a spacing where it is not periodic. Where two of these
/// overlap, as the walls of a tank do in its corners, a point stays with the body in which it lies deeper, or with the
/// first if equally deep. A half-space that moves keeps the samples of its start.
/// @throws CaseError  when about more than `limit` samples would be made
SampleSet sample_shapes(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
                        const SampleSettings& settings);

/// Whether a body never moves in a run.
bool is_still(const body::BodySet& bodies, BodyId body);

/// The depth of a point given in world axes below the surface of a body, the largest over its parts; negative outside,
/// then minus a lower bound of the distance [m].
double depth_in_body(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                     BodyId body, const Vec3& x);

}  // namespace riprap::coupling
