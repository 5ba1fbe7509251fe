// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/shown_water.hpp"
#include "riprap/io/base64.hpp"
#include "riprap/io/vtp.hpp"

namespace riprap::io {

/// The text of a frame, piece by piece: particles of a fluid as points. Point arrays: id, velocity [m/s], speed [m/s],
/// density [kg/m^3] (half a step behind the places), pressure [Pa] at that density. Field array: spacing [m] of the
/// particles at the start.
void put_fluid(const TextSink& put, const fluid::ParticleSettings& settings, const fluid::ParticleState& particles,
               double time);

/// Writes that frame, whole or not at all; on the disk at the next flush_file_system. @throws FileError
void write_fluid(const std::filesystem::path& path, const fluid::ParticleSettings& settings,
                 const fluid::ParticleState& particles, double time);

/// Writes the water of a field as such a frame: a point for every wet cell. @throws FileError
void write_field(const std::filesystem::path& path, const fluid::ShownWater& water, double time);

/// Polygons of its surface.
PolyData draw_surface(const fluid::ShownWater& water);

}  // namespace riprap::io
