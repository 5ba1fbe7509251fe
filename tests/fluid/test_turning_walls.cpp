// SPDX-License-Identifier: Apache-2.0
// A disc that spins in the flow that it makes of still water, u = omega R^2/r: water sticks to its face, not to the
// boundary particles below it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

#include "fluid/dam.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double spacing = 0.01, viscosity = 1e-3, omega = 2;  // [m], [m^2/s], [rad/s]

/// Calls put(place, radius, volume) for rings of particles a spacing apart about the origin.
template <class Put>
void for_ring(double radius, const Put& put) {
    const auto count = std::lround(2 * std::numbers::pi * radius / spacing);
    for (long k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
        put(radius * Vec3{std::cos(angle), std::sin(angle), 0},
            2 * std::numbers::pi * radius * spacing / static_cast<double>(count));
    }
}

Vec3 swing(double rate, const Vec3& x) { return {-rate * x.y, rate * x.x, 0}; }

template <class Settings>
void choose_viscosity(Settings& settings) {
    if constexpr (std::is_base_of_v<SphSettings, Settings>) {
        settings.viscosity.template choose<LaminarSps>();
        settings.viscosity.template get<LaminarSps>().kinematic_viscosity = viscosity;
        settings.viscosity.template get<LaminarSps>().smagorinsky = 0;
    } else {
        settings.kinematic_viscosity = viscosity;
    }
}

struct Spun {
    double torque{0};  ///< of viscosity on the disc, over that of the flow at hand
    double miss{0};    ///< of heat and work of viscosity from what the water loses, over the work
};

/// @param has_feet  boundary particles know their feet on the face
template <class Settings>
Spun spin(double radius, bool has_feet) {
    Settings settings;
    choose_viscosity(settings);
    ParticleSettings& base = settings;
    base.spacing = spacing;
    base.sound_speed = 10;
    base.particle_mass = base.rest_density * spacing * spacing;
    base.domain = {{-10, -10, 0}, {10, 10, 0}, {}, 2};
    ParticleState state;
    for (int ring = 0; ring < 10; ++ring) {
        const double r = radius + (ring + 0.5) * spacing;
        for_ring(r, [&](const Vec3& x, double) {
            state.add(x, swing(omega * radius * radius / (r * r), x), base.rest_density,
                      static_cast<std::int32_t>(state.size()));
        });
    }
    BoundaryParticles walls;
    std::vector<Vec3> feet;
    for (int ring = 0; ring < 4; ++ring) {
        for_ring(radius - (ring + 0.5) * spacing, [&](const Vec3& x, double volume) {
            walls.position.push_back(x);
            walls.velocity.push_back(swing(omega, x));
            walls.acceleration.push_back({});
            walls.volume.push_back(volume);
            walls.is_slippery.push_back(0);
            feet.push_back(has_feet ? radius / norm(x) * x : x);
        });
    }
    for (const Vec3& foot : feet) {
        walls.foot_velocity.push_back(swing(omega, foot));
    }
    const auto scheme = make_scheme(settings);
    FluidReport report;
    const TimeSpan span{0, 1e-9};
    scheme->update_density(state, walls, {}, 1e-9, report);
    scheme->begin_forces(state, walls, span, {}, report);
    scheme->load_walls(state, walls, {});
    const std::vector<Vec3> before = state.velocity;
    scheme->kick(state, walls, {}, span, {}, report);
    Spun spun;
    double work = 0;
    for (std::size_t w = 0; w < feet.size(); ++w) {
        spun.torque += cross(feet[w], walls.viscous_force[w]).z;
        work += dot(walls.pressure_force[w], walls.velocity[w]) + dot(walls.viscous_force[w], swing(omega, feet[w]));
    }
    // The torque of mu (du/dr - u/r) is twice that of mu du/dr, the part that pairs of particles alone have.
    const double parts = std::is_base_of_v<SphSettings, Settings> ? 2 : 1;
    spun.torque /= -parts * 2 * std::numbers::pi * radius * radius * base.rest_density * viscosity * omega;
    spun.miss = std::abs(report.work_on_solids - span.dt * work) / (span.dt * std::abs(work));
    return spun;
}

template <class Settings>
class TurningWallsOf : public ::testing::Test {};
using AllSettings = ::testing::Types<SphSettings, SphOnDevice, WcmpsSettings, MpsSettings>;
TYPED_TEST_SUITE(TurningWallsOf, AllSettings);

TYPED_TEST(TurningWallsOf, a_disc_feels_the_shear_of_the_water_that_sticks_to_its_face) {
    for (const double spacings : {10.0, 40.0}) {
        const Spun at_feet = spin<TypeParam>(spacings * spacing, true);
        const Spun at_samples = spin<TypeParam>(spacings * spacing, false);
        // What misses is of the layer of walls, two and a half spacings thick, and of rings of particles.
        EXPECT_NEAR(at_feet.torque, 1, spacings < 20 ? 0.055 : 0.03) << spacings;
        EXPECT_LT(at_samples.torque, 0.5) << spacings;  // no closer at 40 spacings
        EXPECT_LT(at_feet.miss, 1e-9) << spacings;
    }
}

}  // namespace
}  // namespace riprap::fluid::testing
