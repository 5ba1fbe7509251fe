// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/fluid_frame.hpp"

#include <array>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/vtk_data.hpp"
#include "riprap/io/vtp.hpp"

namespace riprap::io {

void put_fluid(const TextSink& put, const fluid::ShownFluid& water, double time) {
    put_point_cloud(put, water.place, vtk_field_array("spacing", std::array{water.spacing}), time, [&] {
        std::vector<float> numbers;  // one buffer for both: there may be millions
        numbers.reserve(3 * water.velocity.size());
        for (const Vec3& u : water.velocity) {
            for (int axis = 0; axis < 3; ++axis) {
                numbers.push_back(static_cast<float>(u[axis]));
            }
        }
        put_vtk_array(put, "id", water.id);
        put_vtk_array(put, "velocity", numbers, 3);
        numbers.clear();
        for (const Vec3& u : water.velocity) {
            numbers.push_back(static_cast<float>(norm(u)));
        }
        put_vtk_array(put, "speed", numbers);
        if (water.has_density) {
            put_vtk_array(put, "density", water.density);
        }
        put_vtk_array(put, "pressure", water.pressure);
    });
}

void write_fluid(const std::filesystem::path& path, const fluid::ShownFluid& water, double time) {
    AtomicFile file(path);
    put_fluid([&file](std::string_view piece) { file.write(piece); }, water, time);
    file.commit(Durability::later);
}

PolyData draw_surface(const fluid::ShownFluid& water) {
    PolyData data;
    data.points = water.corner;
    for (std::size_t i = 0; i < water.corner.size(); ++i) {
        data.connectivity.push_back(static_cast<std::int32_t>(i));
    }
    data.offsets = water.polygon_end;
    return data;
}

}  // namespace riprap::io
