// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/fluid_frame.hpp"

#include <array>

#include "riprap/fluid/sph/state_equation.hpp"

namespace riprap::io {

PolyData draw_fluid(const fluid::SphSettings& settings, const fluid::ParticleState& particles) {
    PolyData data;
    data.is_point_cloud = true;
    data.points = particles.position;
    data.add_field_array("spacing", std::array{settings.spacing});
    data.add_point_array("id", particles.id);
    std::vector<float> numbers(3 * particles.position.size());  // one buffer for all: there may be millions
    for (std::size_t i = 0; i < particles.velocity.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            numbers[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(particles.velocity[i][axis]);
        }
    }
    data.add_point_array("velocity", numbers, 3);
    numbers.resize(particles.position.size());
    const auto add = [&](const char* name, const auto& number_of) {
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            numbers[i] = static_cast<float>(number_of(i));
        }
        data.add_point_array(name, numbers);
    };
    add("speed", [&](std::size_t i) { return norm(particles.velocity[i]); });
    add("density", [&](std::size_t i) { return particles.density[i]; });
    add("pressure", [&](std::size_t i) { return pressure_of(settings, particles.density[i]); });
    return data;
}

}  // namespace riprap::io
