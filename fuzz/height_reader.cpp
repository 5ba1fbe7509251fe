// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "refusal.hpp"
#include "riprap/geometry/ground/height_grid.hpp"

// Reads bytes as heights, in both forms, and makes triangles of small grids. A grid has as many heights as it says, and
// every point of a triangle is finite.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace riprap;
    constexpr std::int64_t small = 10'000;
    const auto look = [](const geometry::HeightGrid& grid) {
        if (grid.columns < 2 || grid.rows < 2 || !(grid.dx > 0) || !(grid.dy > 0) ||
            static_cast<std::int64_t>(grid.z.size()) != grid.columns * grid.rows) {
            std::abort();
        }
        if (grid.columns * grid.rows > small) {
            return;
        }
        for (const Vec3& x : geometry::mesh_of(geometry::cut_grid(grid, {}, 0), {}).points) {
            if (!is_finite(x)) {
                std::abort();
            }
        }
    };
    read_or_refuse(data, size, [&](std::string_view text) { look(geometry::read_xyz(text, "fuzz", 0.5)); });
    read_or_refuse(data, size, [&](std::string_view text) { look(geometry::read_esri_ascii(text, "fuzz", 0.5)); });
    return 0;
}
