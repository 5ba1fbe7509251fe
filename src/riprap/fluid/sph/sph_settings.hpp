// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/sph/viscosities.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
}

namespace riprap::fluid {

class ParticleScheme;  // particle/particle_scheme.hpp

enum class SphScheme : std::uint8_t { delta_sph, muller };

/// Which loops make the sums over neighbours: those of a processor, or one thread per particle as on a device. Part of
/// a result, as they add in another order.
enum class RunsOn : std::uint8_t { host, device };

/// Settings of SPH: Model. One set of defaults serves every case.
struct SphSettings : ParticleSettings {
    static constexpr std::string_view method_name = "sph";
    static MethodKeys<SphSettings> keys();

    SphScheme scheme{SphScheme::delta_sph};
    RunsOn runs_on{RunsOn::host};
    Viscosities viscosity;
    double density_diffusion{0.1};   ///< delta [-]
    double acoustic_damping{1};      ///< a of the bulk viscosity that damps sound [-]; 0 = off
    double shifting{10};             ///< A of the particle shifting [-]; 0 = off
    bool gradient_correction{true};  ///< density follows the divergence inside the water
    std::int64_t sound_steps{1};     ///< most of them on one geometry (docs/theory/sph.md, 12)

    static void complete(SphSettings& settings) {
        if (settings.scheme == SphScheme::muller) {
            settings.state_equation = StateEquation::linear_without_tension;  // its own
        }
    }
    /// Inflows, outflows and joints need layers that take part in the sums of a scheme with a rate of density.
    static bool has_rate(const SphSettings& settings) { return settings.scheme == SphScheme::delta_sph; }
    static constexpr SchemeTraits<SphSettings> traits{
        .books_every_step = true, .complete = &complete, .takes_openings = &has_rate, .takes_joints = &has_rate};
    /// Müller's scheme has no loops for a device, nor have sums in double.
    bool is_on_device() const { return runs_on == RunsOn::device && scheme == SphScheme::delta_sph && !is_plain; }
};

/// Makes the scheme of these settings.
std::unique_ptr<ParticleScheme> make_scheme(const SphSettings& settings);

}  // namespace riprap::fluid
