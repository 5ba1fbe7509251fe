// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// The reading of fluids with a model of turbulence, besides those of WaterReader.
namespace reading {
inline constexpr unsigned turbulence = 4096;
}  // namespace reading

/// What a WaterReader is too where its fluid offers reading::turbulence.
class TurbulenceReader {
 public:
    virtual ~TurbulenceReader() = default;
    /// Turbulent energy k of the water in a box, summed over its volume [m^5/s^2], in 2D [m^4/s^2]; 0 where the flow
    /// is laminar.
    virtual double turbulent_energy(const Vec3& low, const Vec3& high) const = 0;
};

}  // namespace riprap::fluid
