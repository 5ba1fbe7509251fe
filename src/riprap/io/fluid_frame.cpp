// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/fluid_frame.hpp"

#include <array>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/vtk_data.hpp"
#include "riprap/io/vtp.hpp"

namespace riprap::io {

void put_fluid(const TextSink& put, const fluid::ParticleSettings& settings, const fluid::ParticleState& particles,
               double time) {
    const std::size_t count = particles.position.size();
    std::vector<float> numbers;  // one buffer for all: there may be millions
    const auto put_scalar = [&](const char* name, const auto& number_of) {
        numbers.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            numbers[i] = static_cast<float>(number_of(i));
        }
        put_vtk_array(put, name, numbers);
    };
    const auto put_velocity = [&] {
        numbers.resize(3 * count);
        for (std::size_t i = 0; i < count; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                numbers[3 * i + at(axis)] = static_cast<float>(particles.velocity[i][axis]);
            }
        }
        put_vtk_array(put, "velocity", numbers, 3);
    };
    const auto put_arrays = [&] {
        put_vtk_array(put, "id", particles.id);
        put_velocity();
        put_scalar("speed", [&](std::size_t i) { return norm(particles.velocity[i]); });
        put_scalar("density", [&](std::size_t i) { return particles.density[i]; });
        put_scalar("pressure", [&](std::size_t i) { return pressure_of(settings, particles.density[i]); });
    };
    put_point_cloud(put, particles.position, vtk_field_array("spacing", std::array{settings.spacing}), time,
                    put_arrays);
}

void write_fluid(const std::filesystem::path& path, const fluid::ParticleSettings& settings,
                 const fluid::ParticleState& particles, double time) {
    AtomicFile file(path);
    put_fluid([&file](std::string_view piece) { file.write(piece); }, settings, particles, time);
    file.commit(Durability::later);
}

void write_field(const std::filesystem::path& path, const fluid::ShownWater& water, double time) {
    AtomicFile file(path);
    const TextSink put = [&file](std::string_view piece) { file.write(piece); };
    put_point_cloud(put, water.place, vtk_field_array("spacing", std::array{water.spacing}), time, [&] {
        std::vector<float> velocity, speed;
        for (const Vec3& u : water.velocity) {
            for (int axis = 0; axis < 3; ++axis) {
                velocity.push_back(static_cast<float>(u[axis]));
            }
            speed.push_back(static_cast<float>(norm(u)));
        }
        put_vtk_array(put, "id", water.id);
        put_vtk_array(put, "velocity", velocity, 3);
        put_vtk_array(put, "speed", speed);
        put_vtk_array(put, "pressure", water.pressure);
    });
    file.commit(Durability::later);
}

PolyData draw_surface(const fluid::ShownWater& water) {
    PolyData data;
    data.points = water.corner;
    for (std::size_t i = 0; i < water.corner.size(); ++i) {
        data.connectivity.push_back(static_cast<std::int32_t>(i));
    }
    data.offsets = water.polygon_end;
    return data;
}

}  // namespace riprap::io
