// SPDX-License-Identifier: Apache-2.0
#pragma once

// ParaView output: one VTP file (polygons or points) per frame, and a PVD file that lists the frames with their times.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/vec3.hpp"
#include "riprap/io/vtk_data.hpp"

namespace riprap::io {

/// A VTP file under construction: points, then cells over them, then arrays on the cells or points.
struct PolyData {
    std::vector<Vec3> points;                ///< [m]
    std::vector<std::int32_t> connectivity;  ///< points of every polygon, one after another
    std::vector<std::int32_t> offsets;       ///< where each polygon ends in `connectivity`
    bool is_point_cloud{false};              ///< every point is a vertex cell of its own; no polygons

    void add_cell_array(std::string_view name, std::span<const float> values, int components = 1);
    void add_cell_array(std::string_view name, std::span<const std::int32_t> values);
    void add_point_array(std::string_view name, std::span<const float> values, int components = 1);
    void add_point_array(std::string_view name, std::span<const std::int32_t> values);
    /// Values of the frame as a whole, of any number: one tuple per body, for example.
    void add_field_array(std::string_view name, std::span<const double> values, int components = 1);

    std::string cell_arrays, point_arrays, field_arrays;  ///< DataArray elements, encoded
};

/// Puts the text of a cloud of points, each a vertex cell of its own: of millions of particles no copy is needed but of
/// the array at hand. @param field_arrays  of vtk_field_array  @param put_arrays  calls put_vtk_array for each array on
/// the points
void put_point_cloud(const TextSink& put, std::span<const Vec3> points, std::string_view field_arrays, double time,
                     const std::function<void()>& put_arrays);

/// The text of one frame. `time` is stored as TimeValue [s].
std::string encode_vtp(const PolyData& data, double time);

/// Writes one frame, whole or not at all; on the disk at the next flush_file_system. @throws FileError
void write_vtp(const std::filesystem::path& path, const PolyData& data, double time);

/// One entry of a PVD file.
struct PvdFrame {
    double time{0};    ///< [s]
    std::string file;  ///< relative to the PVD file
    int part{0};       ///< frames of one time with different parts are shown together
};

/// Replaces the PVD file in the same way: a viewer that reads while the run writes sees whole frames only.
void write_pvd(const std::filesystem::path& path, std::span<const PvdFrame> frames);

}  // namespace riprap::io
