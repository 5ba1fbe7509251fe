// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/fluid_frame.hpp"

#include <array>
#include <vector>

#include "riprap/fluid/sph/state_equation.hpp"
#include "riprap/io/atomic_file.hpp"

namespace riprap::io {

void put_fluid(const TextSink& put, const fluid::SphSettings& settings, const fluid::ParticleState& particles,
               double time) {
    PointCloudText text(put, particles.position, vtk_field_array("spacing", std::array{settings.spacing}), time);
    text.add_array("id", particles.id);
    std::vector<float> numbers(3 * particles.position.size());  // one buffer for all: there may be millions
    for (std::size_t i = 0; i < particles.velocity.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            numbers[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(particles.velocity[i][axis]);
        }
    }
    text.add_array("velocity", numbers, 3);
    numbers.resize(particles.position.size());
    const auto add = [&](const char* name, const auto& number_of) {
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            numbers[i] = static_cast<float>(number_of(i));
        }
        text.add_array(name, numbers);
    };
    add("speed", [&](std::size_t i) { return norm(particles.velocity[i]); });
    add("density", [&](std::size_t i) { return particles.density[i]; });
    add("pressure", [&](std::size_t i) { return pressure_of(settings, particles.density[i]); });
    text.finish();
}

void write_fluid(const std::filesystem::path& path, const fluid::SphSettings& settings,
                 const fluid::ParticleState& particles, double time) {
    AtomicFile file(path);
    put_fluid([&file](std::string_view piece) { file.write(piece); }, settings, particles, time);
    file.commit(Durability::later);
}

}  // namespace riprap::io
