// SPDX-License-Identifier: Apache-2.0
// delta_sph by the loops of a device, run on the host: the same physics in another order of sums.
#include <gmock/gmock.h>

#include <array>
#include <functional>
#include <utility>

#include "fluid/sph/water.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/key.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/kernel.hpp"

namespace riprap::fluid::testing {
namespace {

/// A heap of water that falls apart in a corner of sticky and slippery walls, of which one moves.
Water heap(int dimension, bool is_turbulent, int layers = 8) {
    Water water;
    const double dp = 0.05;
    SphSettings& settings = water.settings;
    settings = settings_2d(dp, 30);
    settings.particle_mass = settings.rest_density * std::pow(dp, dimension);
    settings.domain.dimension = dimension;
    settings.domain.low.z = -100;
    settings.domain.high.z = 100;
    if (dimension == 3) {
        settings.domain.low.z = 0;
        settings.domain.high.z = layers * dp;
        settings.domain.is_periodic[2] = true;
    }
    if (is_turbulent) {
        settings.viscosity.choose<LaminarSps>();
    }
    water.gravity = {0.5, -9.81, 0};
    layers = dimension == 3 ? layers : 1;
    for (int layer = 0; layer < layers; ++layer) {
        const double z = dimension == 3 ? (layer + 0.5) * dp : 0;
        for_lattice(dp, 10 * dp, 12 * dp, [&](double x, double y) {
            water.add_particle({x + 0.2 * dp * std::sin(40 * y + z), y, z}, {0.3 * y, 0.2 * std::sin(9 * x), 0}, 100);
        });
        for (int k = -4; k < 24; ++k) {
            for (int row = 1; row <= 3; ++row) {
                water.add_wall_particle({(k + 0.5) * dp, (0.5 - row) * dp, z}, k < 8);
                if (k >= 0 && k < 12) {
                    water.add_wall_particle({(0.5 - row) * dp, (k + 0.5) * dp, z}, false, {0.2, 0, 0});
                }
            }
        }
    }
    for (std::size_t w = 0; w < water.walls.position.size(); ++w) {
        water.walls.acceleration[w] = water.walls.velocity[w].x > 0 ? Vec3{3, 0, 0} : Vec3{};
        water.walls.given_pressure.push_back(w % 7 == 0 ? 200 : -1);
    }
    return water;
}

struct Outcome {
    SphSettings settings;
    ParticleState state;
    ParticleReport report;
    Vec3 force{};
};

Outcome run(Water water, RunsOn where, int steps = 20) {
    water.settings.runs_on = where;
    const std::unique_ptr<ParticleScheme> scheme = make_scheme(water.settings);
    Outcome outcome;
    SparseVectors extra(water.state.position.size());
    extra.add(3, {5, 1, 0});
    double last_dt = 0;
    for (int k = 0; k < steps; ++k) {
        const TimeSpan span{water.time, 5e-4};
        outcome.report = {};
        scheme->update_density(water.state, water.walls, water.gravity, 0.5 * (last_dt + span.dt), outcome.report);
        drift(water.settings, water.state, 0.5 * span.dt);
        scheme->begin_forces(water.state, water.walls, span, water.gravity, outcome.report);
        scheme->load_walls(water.state, water.walls, water.gravity);
        scheme->kick(water.state, water.walls, water.gravity, span, extra, outcome.report);
        drift(water.settings, water.state, 0.5 * span.dt);
        last_dt = span.dt;
        water.time += span.dt;
    }
    for (std::size_t w = 0; w < water.walls.position.size(); ++w) {
        outcome.force += water.walls.pressure_force[w] + water.walls.viscous_force[w];
    }
    outcome.state = water.state;
    outcome.settings = water.settings;
    return outcome;
}

/// Largest differences of places [m], velocities [m/s] and densities [kg/m^3].
std::array<double, 3> apart(const Outcome& a, const Outcome& b) {
    std::array<double, 3> most{};
    for (std::size_t i = 0; i < a.state.position.size(); ++i) {
        most[0] = std::max(most[0], norm(a.state.position[i] - b.state.position[i]));
        most[1] = std::max(most[1], norm(a.state.velocity[i] - b.state.velocity[i]));
        most[2] = std::max(most[2], std::abs(a.state.density[i] - b.state.density[i]));
    }
    return most;
}

/// The sums in double tell what floats lose: the device must not lose more than the lanes of the host, but for chance.
void expect_as_good_as_the_host(const std::function<Water()>& water) {
    const auto result = [&](RunsOn where, bool is_plain) {
        Water start = water();
        start.settings.is_plain = is_plain;
        return run(std::move(start), where);
    };
    const Outcome device = result(RunsOn::device, false), host = result(RunsOn::host, false),
                  plain = result(RunsOn::host, true);
    ASSERT_EQ(device.report.problem, "");
    const auto by_device = apart(device, plain), by_host = apart(host, plain);
    for (std::size_t k = 0; k < by_host.size(); ++k) {
        EXPECT_LT(by_device[k], 3 * by_host[k]) << k;
    }
    EXPECT_LT(by_host[0], 1e-4 * device.settings.spacing);
    const auto near = [](double one, double other) { EXPECT_NEAR(one, other, 1e-3 * std::abs(other) + 1e-9); };
    near(device.report.kinetic, plain.report.kinetic);
    near(device.report.potential, plain.report.potential);
    near(device.report.internal, plain.report.internal);
    near(device.report.dissipated_viscous, plain.report.dissipated_viscous);
    near(device.report.by_density.sum(), plain.report.by_density.sum());
    near(device.report.shifted, plain.report.shifted);
    near(device.report.wall_exchange, plain.report.wall_exchange);
    near(device.report.work_on_solids, plain.report.work_on_solids);
    near(device.report.work_external, plain.report.work_external);
    near(device.force.x, plain.force.x);
    near(device.force.y, plain.force.y);
}

TEST(DeviceScheme, moves_water_as_the_host_does) {
    for (const int dimension : {2, 3}) {
        expect_as_good_as_the_host([&] { return heap(dimension, false); });
    }
}

TEST(DeviceScheme, spares_smooth_flow_too) {
    expect_as_good_as_the_host([] {
        Water water = heap(3, false);
        water.settings.viscosity.get<ArtificialViscosity>().spares_smooth = true;
        return water;
    });
}

TEST(DeviceScheme, has_the_whole_viscous_stress_too) {
    expect_as_good_as_the_host([] { return heap(3, true); });
}

TEST(DeviceScheme, has_the_same_bits_at_any_number_of_threads) {
    const auto hash = [](int threads) {
        parallel::set_thread_count(threads);
        const Outcome outcome = run(heap(3, true, 40), RunsOn::device, 2);
        parallel::set_thread_count(1);
        EXPECT_GT(outcome.state.size(), parallel::reduce_block);  // else there is one block only
        return std::pair(hash_fields(outcome.state), outcome.report.kinetic);
    };
    const auto alone = hash(1);
    EXPECT_EQ(hash(3), alone);
}

TEST(DeviceScheme, leaves_schemes_that_have_none_to_the_host) {
    for (const bool is_plain : {false, true}) {
        const auto hash = [&](RunsOn where) {
            Water water = heap(2, false);
            water.settings.scheme = is_plain ? SphScheme::delta_sph : SphScheme::muller;
            water.settings.is_plain = is_plain;
            return hash_fields(run(std::move(water), where, 3).state);
        };
        EXPECT_EQ(hash(RunsOn::device), hash(RunsOn::host)) << is_plain;
    }
}

TEST(DeviceScheme, needs_no_walls) {
    const auto drop = [](RunsOn where) {
        Water water = heap(2, false);
        water.walls = {};
        return run(std::move(water), where, 3);
    };
    const Outcome device = drop(RunsOn::device);
    ASSERT_EQ(device.report.problem, "");
    EXPECT_LT(apart(device, drop(RunsOn::host))[0], 1e-9);
}

WaterAtWalls description(Water water, RunsOn where) {
    water.settings.runs_on = where;
    const std::unique_ptr<ParticleScheme> scheme = make_scheme(water.settings);
    ParticleReport report;
    WaterAtWalls found;
    scheme->update_density(water.state, water.walls, water.gravity, 1e-4, report);
    scheme->begin_forces(water.state, water.walls, {0, 1e-4}, water.gravity, report);
    scheme->describe_walls(water.gravity, found);
    return found;
}

TEST(DeviceScheme, describes_the_water_at_walls_as_the_host_does) {
    for (const int dimension : {2, 3}) {
        const WaterAtWalls host = description(heap(dimension, false), RunsOn::host);
        const WaterAtWalls device = description(heap(dimension, false), RunsOn::device);
        const SphSettings settings = heap(dimension, false).settings;
        const double peak = WendlandC2(settings.smoothing_length(), dimension).value(0.0);
        ASSERT_EQ(host.weight.size(), device.weight.size());
        double most = 0;
        for (std::size_t w = 0; w < host.weight.size(); ++w) {
            most = std::max(most, host.pressure[w]);
            ASSERT_NEAR(device.weight[w], host.weight[w], 1e-5 * host.weight[w] + 1e-6 * peak);
            ASSERT_NEAR(device.pressure[w], host.pressure[w], 1e-3 * host.pressure[w] + 0.1);
            ASSERT_LT(norm(device.slope[w] - host.slope[w]), 1e-4 / settings.spacing);
        }
        EXPECT_GT(most, 100);
    }
}

TEST(DeviceScheme, refuses_powers_that_hosts_and_devices_round_in_two_ways) {
    SphSettings settings;
    settings.runs_on = RunsOn::device;
    const auto check = SphSettings::keys().check;
    EXPECT_TRUE(check(settings).empty());
    settings.tait_exponent = 6.5;
    ASSERT_EQ(check(settings).size(), 1u);
    EXPECT_EQ(check(settings)[0].key, "tait_exponent");
    settings.runs_on = RunsOn::host;
    EXPECT_TRUE(check(settings).empty());
}

}  // namespace
}  // namespace riprap::fluid::testing
