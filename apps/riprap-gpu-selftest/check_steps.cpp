// SPDX-License-Identifier: Apache-2.0
// Whole steps of water between walls: the same scheme on the device and on the host.
#include "checks.hpp"
#include "riprap/fluid/sph/device/device_sph.hpp"
#include "some_tank.hpp"

namespace selftest {

namespace {

using riprap::fluid::LaminarSps;

Tank after_steps(Tank tank, std::unique_ptr<riprap::fluid::ParticleScheme> (*make)(const riprap::fluid::SphSettings&)) {
    const auto scheme = make(tank.settings);
    for (int k = 0; k < 10; ++k) {
        tank.step(*scheme);
    }
    return tank;
}

bool check_steps_of(const char* what, const Tank& start) {
    const Tank host = after_steps(start, riprap::fluid::make_device_scheme_on_host);
    const Tank device = after_steps(start, riprap::fluid::make_device_scheme);
    std::printf("ten steps of %zu particles in %d dimensions, %zu of walls, %s\n", start.water.position.size(),
                start.settings.domain.dimension, start.walls.position.size(), what);
    const auto books = [](const Tank& tank) {
        const riprap::fluid::FluidReport& r = tank.report;
        return std::vector<double>{r.kinetic,          r.potential, r.internal,       r.dissipated_viscous,
                                   r.by_density.sum(), r.shifted,   r.work_on_solids, r.wall_exchange,
                                   r.work_external,    r.max_speed};
    };
    bool ok = host.report.problem.empty() && device.report.problem.empty();
    ok &= same_bits("  places", host.water.position, device.water.position);
    ok &= same_bits("  velocities", host.water.velocity, device.water.velocity);
    ok &= same_bits("  densities", host.water.density, device.water.density);
    ok &= same_bits("  dilutions", host.water.dilution, device.water.dilution);
    ok &= same_bits("  forces on walls", host.walls.pressure_force, device.walls.pressure_force);
    ok &= same_bits("  viscous forces on walls", host.walls.viscous_force, device.walls.viscous_force);
    ok &= same_bits("  pressures about walls", host.about_walls.pressure, device.about_walls.pressure);
    ok &= same_bits("  slopes at walls", host.about_walls.slope, device.about_walls.slope);
    ok &= same_bits("  weights at walls", host.about_walls.weight, device.about_walls.weight);
    ok &= same_bits("  energies", books(host), books(device));
    return ok;
}

}  // namespace

bool check_steps() {
    bool ok = true;
    for (const bool is_turbulent : {false, true}) {
        const char* const law = is_turbulent ? "laminar_sps" : "artificial viscosity";
        for (Tank tank : {some_tank(24), some_channel(60), some_drop(60)}) {
            if (is_turbulent) {
                tank.settings.viscosity.choose<LaminarSps>();
            }
            ok &= check_steps_of(law, tank);
        }
    }
    return ok;
}

}  // namespace selftest
