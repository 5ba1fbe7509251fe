// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"
#include "riprap/fluid/sph/muller_kernels.hpp"

namespace riprap {
template <class S>
class KeyList;  // core/key.hpp
}

namespace riprap::fluid {

/// Laminar viscosity [Morris1997], molecular plus that of the eddies which the spacing does not resolve, nu_t =
/// (C_s dp)^2 |S| [Smagorinsky1963], [Gotoh2001]:
///
///     force = V (mu_i + mu_j) F v,
///
/// and with it the transposed part of the viscous stress (transposed_stress.hpp).
struct LaminarSps {
    static constexpr std::string_view word = "laminar_sps";
    static constexpr std::string_view help =
        "that of water, with a model of what turbulence the particles do not "
        "resolve";
    static KeyList<LaminarSps> keys();

    static constexpr bool follows_strain = true, has_transposed_stress = true;
    static bool follows_roughness() { return false; }
    double kinematic_viscosity{1e-6};  ///< nu [m^2/s]
    double smagorinsky{0.12};          ///< C_s [-]

    RIPRAP_HD double kinematic(const ParticleSettings& s, double strain_rate) const {
        const double mixing = smagorinsky * s.spacing;
        return kinematic_viscosity + mixing * mixing * strain_rate;
    }

    struct Pair {
        template <int Dim, class Real>
        RIPRAP_HD void add(const Real* v, const Real*, Real, Real, Real slope, Real volume, Real mu_pair,
                           Real* force) const {
            for (int axis = 0; axis < Dim; ++axis) {
                force[axis] = mu_pair * slope * volume * v[axis];
            }
        }
    };
    Pair pair(const ParticleSettings& /*s*/, const WendlandC2& /*kernel*/) const { return {}; }

    /// Viscosity of [Muller2003], its sign corrected: force = -V (mu_i + mu_j)/2 L v.
    struct MullerPair {
        LaplacianKernel kernel;

        template <int Dim, class Real>
        RIPRAP_HD void add(const Real* v, const Real*, Real, Real r, Real, Real volume, Real mu_pair,
                           Real* force) const {
            const Real size = Real(-0.5) * mu_pair * kernel.laplacian(r) * volume;
            for (int axis = 0; axis < Dim; ++axis) {
                force[axis] = size * v[axis];
            }
        }
    };
    MullerPair pair(const ParticleSettings& s, const SpikyKernel& /*kernel*/) const {
        return {LaplacianKernel(s.support_radius(), s.domain.dimension)};
    }
};

}  // namespace riprap::fluid
