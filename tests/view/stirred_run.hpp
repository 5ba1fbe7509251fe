// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <vector>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/vtp.hpp"
#include "view/stirred_water.hpp"

namespace riprap::view {

/// Writes a run folder with the water of StirredWater, per_side^3 particles of it, and nothing else.
inline void write_stirred_run(const std::filesystem::path& folder, int per_side, int frame_count) {
    io::make_folder(folder / "frames");
    StirredWater water(per_side);
    std::vector<io::PvdFrame> list;
    constexpr double interval = 0.01;  // [s]
    for (int f = 0; f < frame_count; ++f) {
        water.advance(interval);
        const WaterFrame frame = water.shuffled();
        io::PolyData data;
        data.is_point_cloud = true;
        data.points = frame.position;
        data.add_field_array("spacing", std::array{StirredWater::spacing});
        data.add_point_array("id", frame.id);
        data.add_point_array("speed", frame.speed);
        data.add_point_array("pressure", frame.pressure);
        list.push_back({f * interval, fmt::format("frames/water_{:06}.vtp", f)});
        io::write_vtp(folder / list.back().file, data, list.back().time);
    }
    io::write_pvd(folder / "out.pvd", list);
    io::write_file(folder / "run.json", "{}\n");
    io::write_file(folder / "resolved.toml", "title = \"Stirred water\"\ngravity = [0.0, 0.0, -9.81]\n");
}

}  // namespace riprap::view
