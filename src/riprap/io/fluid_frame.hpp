// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "riprap/fluid/shown_fluid.hpp"
#include "riprap/io/base64.hpp"
#include "riprap/io/vtp.hpp"

namespace riprap::io {

/// The text of a frame, piece by piece: water as points. Point arrays: id, velocity [m/s], speed [m/s], density
/// [kg/m^3] where the water has one (half a step behind the places), pressure [Pa]. Field array: spacing [m] of the
/// points.
void put_fluid(const TextSink& put, const fluid::ShownFluid& water, double time);

/// Writes that frame, whole or not at all; on the disk at the next flush_file_system. @throws FileError
void write_fluid(const std::filesystem::path& path, const fluid::ShownFluid& water, double time);

/// Polygons of its surface.
PolyData draw_surface(const fluid::ShownFluid& water);

}  // namespace riprap::io
