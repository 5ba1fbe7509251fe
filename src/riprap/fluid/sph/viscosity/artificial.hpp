// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <type_traits>

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"

namespace riprap {
template <class S>
class KeyList;  // core/key.hpp
}

namespace riprap::fluid {

/// Artificial viscosity [Monaghan1992], with the rest density and sound speed of [Antuono2010]: particles that approach
/// repel,
///
///     force = b V alpha h c_0 rho_0 min(0, v.d)/(r^2 + 0.01 h^2) F d,   b = 1,
///
/// or b = (R_i + R_j)/2 where smooth flow is spared, R the share of roughness.hpp [-], which differs from the sources.
struct ArtificialViscosity {
    static constexpr std::string_view word = "artificial";
    static constexpr std::string_view help = "particles that approach repel";
    static KeyList<ArtificialViscosity> keys();

    static constexpr bool follows_strain = false, has_transposed_stress = false;
    double alpha{0.02};         ///< [-]
    bool spares_smooth{false};  ///< acts on motion that is not linear in space alone

    /// Tells whether a particle has R for its viscosity.
    bool follows_roughness() const { return spares_smooth; }
    /// Equivalent kinematic viscosity at most: alpha c_0 h/(2 (dimension + 2)) [Monaghan2005].
    RIPRAP_HD double kinematic(const ParticleSettings& s, double /*strain_rate*/) const {
        return alpha * s.sound_speed * s.smoothing_length() / (2 * (s.domain.dimension + 2));
    }

    struct Pair {
        double strength;              ///< alpha h c_0 rho_0 [Pa s]
        double soft;                  ///< 0.01 h^2 [m^2]
        double least, per_roughness;  ///< b = least + per_roughness (R_i + R_j) [-]

        template <int Dim, class Real>
        RIPRAP_HD void add(const Real* v, const Real* d, Real r2, Real, Real slope, Real volume, Real rough_pair,
                           Real* force) const {
            Real closing(0);
            for (int axis = 0; axis < Dim; ++axis) {
                closing = closing + v[axis] * d[axis];
            }
            const Real share = Real(least) + Real(per_roughness) * rough_pair;
            const Real size =
                share * Real(strength) * min(closing, Real(0)) * reciprocal(r2 + Real(soft)) * slope * volume;
            for (int axis = 0; axis < Dim; ++axis) {
                force[axis] = size * d[axis];
            }
        }
    };
    template <class Kernel>
    Pair pair(const ParticleSettings& s, const Kernel& /*kernel*/) const {
        const double h = s.smoothing_length();
        const bool spares = spares_smooth && std::is_same_v<Kernel, WendlandC2>;  // R is that of delta_sph
        return {alpha * h * s.sound_speed * s.rest_density, 0.01 * h * h, spares ? 0.0 : 1.0, spares ? 0.5 : 0.0};
    }
};

}  // namespace riprap::fluid
