// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "riprap/coupling/particle_walls/paddle_absorption.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/open/open_boundary.hpp"
#include "riprap/fluid/open/sponge.hpp"
#include "riprap/fluid/scheme_settings.hpp"

namespace riprap {
struct NoFields;  // core/fields.hpp
}

namespace riprap::coupling {

class ParticleMethod;

/// Treatment of walls.
enum class WallTreatment : std::uint8_t {
    boundary_particles,  ///< samples inside the kernel sums
    penalty,             ///< faces that push particles away
};

/// Settings of water made of particles, whatever scheme moves them.
struct ParticleFluid {
    using Method = ParticleMethod;
    using Fields = NoFields;
    using Choices = fluid::SchemeSettings;  ///< that `fluid.method` chooses from: see sim/settings.hpp
    Choices scheme;
    WallTreatment wall{WallTreatment::boundary_particles};
    SampleSet samples;                 ///< of all wet bodies; empty with penalty walls
    bool has_joint_pressure{true};     ///< water presses between faces too close for particles; boundary particles only
    std::vector<std::uint8_t> is_dry;  ///< per body
    std::vector<PaddleAbsorption> absorptions;
    std::vector<fluid::Sponge> sponges;
    fluid::OpenBoundaries open;
    std::string sound_speed_reason;  ///< where the sound speed comes from
    double depth{0};                 ///< of the water at the start [m]
    double filled_volume{0};         ///< [m^3]; in 2D [m^2]
    double region_volume{0};         ///< room that its regions have outside of solids [m^3]; in 2D [m^2]
    double reached_volume{0};        ///< part of region_volume that is wide enough for particles

    std::size_t bytes() const { return samples.bytes(); }
    const fluid::ParticleSettings& settings() const { return fluid::base_of(scheme); }
    fluid::ParticleSettings& settings() { return fluid::base_of(scheme); }
    /// Settings of SPH, where that is the scheme; for programs that set or read what is its alone.
    const fluid::SphSettings& sph() const { return std::get<fluid::SphSettings>(scheme); }
    fluid::SphSettings& sph() { return std::get<fluid::SphSettings>(scheme); }
};

}  // namespace riprap::coupling
