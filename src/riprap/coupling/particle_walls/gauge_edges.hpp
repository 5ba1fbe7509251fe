// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/particle_walls/face_reading.hpp"
#include "riprap/coupling/particle_walls/side_forces.hpp"

namespace riprap::coupling {

/// Reads a face as read_face does, with what the water before it does alone: water behind a body thinner than the
/// support has no part in it (SideForces).
double read_face(const FaceGauge& gauge, const LoadedFaces& loaded, const WaterAtFace& water);

/// Spacings from an edge that stands out into the water within which a gauge reads too little [-].
inline constexpr double near_edge = 2;

/// Tells whether a gauge, or the rim of its square, is nearer than that to an edge of its face.
bool is_near_edge(const FaceGauge& gauge, const LoadedFaces& loaded);

}  // namespace riprap::coupling
