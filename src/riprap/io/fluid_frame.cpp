// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/fluid_frame.hpp"

#include <array>

#include "riprap/fluid/sph/state_equation.hpp"

namespace riprap::io {

PolyData draw_fluid(const fluid::SphSettings& settings, const fluid::ParticleState& particles) {
    PolyData data;
    data.is_point_cloud = true;
    data.points = particles.position;
    std::vector<float> velocity, speed, density, pressure;
    velocity.reserve(3 * particles.position.size());
    for (std::size_t i = 0; i < particles.position.size(); ++i) {
        const Vec3& v = particles.velocity[i];
        velocity.insert(velocity.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
        speed.push_back(static_cast<float>(norm(v)));
        density.push_back(static_cast<float>(particles.density[i]));
        pressure.push_back(static_cast<float>(pressure_of(settings, particles.density[i])));
    }
    data.add_field_array("spacing", std::array{settings.spacing});
    data.add_point_array("id", particles.id);
    data.add_point_array("velocity", velocity, 3);
    data.add_point_array("speed", speed);
    data.add_point_array("density", density);
    data.add_point_array("pressure", pressure);
    return data;
}

}  // namespace riprap::io
