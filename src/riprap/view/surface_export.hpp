// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace riprap::view {

/// Frames and formats of surfaces for other programs.
struct SurfaceOptions {
    std::filesystem::path folder;  ///< of the run
    std::filesystem::path out;     ///< a folder; empty: surface in the folder of the run
    std::optional<int> frame;      ///< from 0; negative counts from the last, -1; none: all
    std::optional<double> time;    ///< the frame nearest to it [s]
    std::set<std::string> formats{"vtp", "ply", "glb"};
};

/// Writes the surface of the water and the blocks of a run: water_N.vtp with surface.pvd for ParaView, water_N.ply and
/// blocks_N.ply, and frame_N.glb (glTF 2.0, y up, one node for every block) for Blender and others. Half-spaces have no
/// size and are left out. @returns what was written, for the user @throws FileError
std::string export_surfaces(const SurfaceOptions& options);

}  // namespace riprap::view
