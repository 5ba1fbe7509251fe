// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/face_gauge.hpp"
#include "riprap/coupling/particle_walls/penalty_walls.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// Bodies with their boundary particles after a step: what the water pressed on, and how hard.
struct LoadedFaces {
    const geometry::ShapeSet& shapes;
    const body::BodySet& bodies;
    std::span<const std::uint8_t> is_dry;       ///< per body: not there for the water; empty = none
    const body::Motion& motion;                 ///< of all bodies, where the samples are
    SampleView samples;                         ///< the samples that the water may feel
    const fluid::BoundaryParticles& particles;  ///< ... as the water met them; may be more than the samples
    const fluid::Domain& domain;
    double spacing;                                           ///< dp [m]
    double reach;                                             ///< how deep the water looks into a solid [m]
    std::span<const std::vector<PenaltyWalls::Push>> pushes;  ///< of faces on particles, besides
};

/// Returns the reading of a transducer: the force of the water on the face about it over the area of the face there
/// [Pa],
///
///     p = -sum_s (f_s . n) w(x_s) / sum_s A_s w(x_s),     w(x) = B(a) B(b), in two dimensions B(a),
///
/// B(a) = 1/s int_(a-s/2)^(a+s/2) S da',
///
/// f_s the pressure force on boundary particle s behind the plane of the face, or the push of a particle on it, x_s its
/// foot on the plane, a and b distances from the gauge along the face, s the side of the square that the sensor takes
/// the mean over, S a cubic B-spline that is one spacing wide and ends at two (B is S without a side: sensor_weight and
/// spline_weight of the fluid's gauges) and A_s the area that a particle of the first layer stands for. So
/// the impulse of what hits is right however few particles it is, where an average over the particles near the gauge
/// takes one of them for a layer (docs/theory/coupling.md, 8).
///
/// A particle counts where its foot lies on the open face of its own body: that body just below, none just above.
/// Bodies that lie flush go on as one face. Boundary particles that are buried, where bodies overlap in a corner, have
/// no face of their own; they count for the place in front of the body that covers their foot. A gauge reads 0 where it
/// is dry or covered.
///
/// Within two spacings of a convex edge a gauge reads up to a third too little.
///
/// The reading is the force of the last step, not a mean since the last reading. Viscous forces and water in joints,
/// which no particle stands for, are not in it. Bodies thinner than `reach` feel the water of their other side too.
double read_face(const FaceGauge& gauge, const LoadedFaces& loaded);

/// Tells whether water can be at the gauge: nothing that is wet lies on it.
bool is_open(const FaceGauge& gauge, const LoadedFaces& loaded);

}  // namespace riprap::coupling
