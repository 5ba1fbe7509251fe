// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/face_gauge.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/fluid/gauge/gauge.hpp"

namespace riprap::coupling {

/// All that the reading of a gauge depends on.
template <class Fluid>
struct GaugeQuery {
    const fluid::Gauge& gauge;
    const FaceGauge* face;  ///< of a gauge in a face, else nullptr
    const FluidScene& scene;
    const typename Fluid::Settings& settings;
    const fluid::ParticleState& particles;
    const typename Fluid::Fields& fields;
    const typename Fluid::Scratch* scratch;  ///< nullptr before the first step
    double time;                             ///< [s]
};

}  // namespace riprap::coupling
