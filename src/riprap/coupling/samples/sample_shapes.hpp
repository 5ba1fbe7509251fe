// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "riprap/body/body_set.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

struct SampleSettings {
    double spacing{0};                          ///< dp of the fluid [m]
    double reach{0};                            ///< how deep the fluid looks into a solid: its support radius [m]
    fluid::Domain domain;                       ///< of the fluid
    Vec3 lattice_corner{};                      ///< of a cell that water starts in: walls continue its lattice [m]
    std::int64_t limit{0};                      ///< most samples that may be made
    std::span<const std::uint8_t> is_dry;       ///< per body: feels no fluid and gets no samples; empty = none
    std::span<const std::uint8_t> is_slippery;  ///< per body: free slip; empty = none
};

/// The boundary particles of all wet bodies: layers under every face that meets water (face_layers.hpp), part by part,
/// in the frame of each body.
///
/// Parts of one body share faces; layers follow those too, and only points within `reach` of the surface that carries
/// a field are kept, so a re-entrant corner is as full as a plane wall. Bodies that never move, half-spaces among them,
/// are cut to the domain, grown by `reach`, a spacing and what is left to the next cell of the water's lattice where it
/// is not periodic: where walls stand on that lattice they continue it, whatever the domain. Where these overlap, as
/// walls do in the corner of a tank, volumes are shared out (seams.hpp). A half-space that moves keeps the samples of
/// its start.
/// @throws CaseError  when about more than `limit` samples would be made
SampleSet sample_shapes(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
                        const SampleSettings& settings);

/// Tells whether a body never moves in a run.
bool is_still(const body::BodySet& bodies, BodyId body);

}  // namespace riprap::coupling
