// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/quantity_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "riprap/core/parallel.hpp"

namespace riprap::sim {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

std::size_t index(BodyId body) { return static_cast<std::size_t>(body.value); }
Vec3 scalar(double value) { return {value, 0, 0}; }

Vec3 position(const Moment& m, BodyId b) { return m.state.bodies.position[index(b)]; }
Vec3 displacement(const Moment& m, BodyId b) { return position(m, b) - m.initial.bodies.position[index(b)]; }
Vec3 distance(const Moment& m, BodyId b) { return scalar(norm(displacement(m, b))); }
/// Distance from the upright axis of the scene, z or in a plane y.
Vec3 axis_distance(const Moment& m, BodyId b) {
    const Vec3 x = position(m, b);
    return scalar(m.model.bodies.is_planar ? std::abs(x.x) : std::hypot(x.x, x.y));
}
Vec3 velocity(const Moment& m, BodyId b) { return m.state.bodies.velocity[index(b)]; }
Vec3 speed(const Moment& m, BodyId b) { return scalar(norm(velocity(m, b))); }
Vec3 spin(const Moment& m, BodyId b) { return body::angular_velocity(m.model.bodies, m.state.bodies, b); }

/// Offset of a point of a body from its centre of mass, R U X.
Vec3 offset_of(const body::BodyState& bodies, BodyId b, const Vec3& point) {
    const std::size_t i = index(b);
    return rotate(bodies.orientation[i], bodies.deforms() ? bodies.stretch[i] * point : point);
}
Vec3 position_of(const body::BodyState& bodies, BodyId b, const Vec3& point) {
    return bodies.position[index(b)] + offset_of(bodies, b, point);
}
Vec3 position_of_point(const Moment& m, BodyId b, const Vec3& point) { return position_of(m.state.bodies, b, point); }
Vec3 displacement_of_point(const Moment& m, BodyId b, const Vec3& point) {
    return position_of(m.state.bodies, b, point) - position_of(m.initial.bodies, b, point);
}
Vec3 distance_of_point(const Moment& m, BodyId b, const Vec3& point) {
    return scalar(norm(displacement_of_point(m, b, point)));
}
Vec3 velocity_of_point(const Moment& m, BodyId b, const Vec3& point) {
    const body::BodyState& bodies = m.state.bodies;
    const Vec3 r = offset_of(bodies, b, point);
    const Vec3 stretching = bodies.deforms() ? bodies.stretch_rate[index(b)] * r : Vec3{};
    return velocity(m, b) + cross(spin(m, b), r) + stretching;
}
Vec3 speed_of_point(const Moment& m, BodyId b, const Vec3& point) {
    return scalar(norm(velocity_of_point(m, b, point)));
}
Vec3 rotation_vector(const Moment& m, BodyId b) {
    return to_rotation_vector(m.state.bodies.orientation[index(b)] * conjugate(m.initial.bodies.orientation[index(b)]));
}
Vec3 rotation(const Moment& m, BodyId b) { return scalar(norm(rotation_vector(m, b))); }
Vec3 kinetic_energy_of_body(const Moment& m, BodyId b) {
    const double mass = m.model.bodies.mass[index(b)];
    return scalar(0.5 * mass * norm_squared(velocity(m, b)) +
                  0.5 * dot(m.state.bodies.angular_momentum[index(b)], spin(m, b)));
}
Vec3 of_last_step(const std::vector<Vec3>& values, BodyId b) {
    return index(b) < values.size() ? values[index(b)] : Vec3{missing, missing, missing};
}
Vec3 contact_force(const Moment& m, BodyId b) {
    return m.scratch == nullptr ? Vec3{missing, missing, missing} : of_last_step(m.scratch->contact_force(), b);
}
Vec3 contact_torque(const Moment& m, BodyId b) {
    return m.scratch == nullptr ? Vec3{missing, missing, missing} : of_last_step(m.scratch->contact_torque(), b);
}
Vec3 contact_force_size(const Moment& m, BodyId b) { return scalar(norm(contact_force(m, b))); }

/// Mass of so many particles of water as these counts add up to.
Vec3 mass_of(const Moment& m, const std::vector<std::int64_t>& counts) {
    const double particles = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
    return scalar(m.model.particles() != nullptr ? m.model.particles()->settings().particle_mass * particles : missing);
}
Vec3 water_mass_in(const Moment& m) { return mass_of(m, m.state.open.entered); }
Vec3 water_mass_out(const Moment& m) { return mass_of(m, m.state.open.left); }

template <auto member>
Vec3 reported(const Moment& m) {
    return m.report == nullptr ? scalar(missing) : scalar(static_cast<double>(m.report->*member));
}
template <double Ledger::*member>
Vec3 booked(const Moment& m) {
    return m.report == nullptr ? scalar(missing) : scalar(m.report->ledger.*member);
}
/// A figure that only a complete ledger has.
template <double Ledger::*member>
Vec3 measured(const Moment& m) {
    return m.report == nullptr || !m.report->ledger.has_energy ? scalar(missing) : scalar(m.report->ledger.*member);
}
template <Vec3 Ledger::*member>
Vec3 booked_vector(const Moment& m) {
    return m.report == nullptr ? Vec3{missing, missing, missing} : m.report->ledger.*member;
}
Vec3 time_now(const Moment& m) { return scalar(m.state.time); }
Vec3 step_now(const Moment& m) { return scalar(static_cast<double>(m.state.step)); }
Vec3 tilt(const Moment& m) {
    const Vec3& before = m.model.gravity.value;
    const Vec3 now = m.model.gravity.at(m.state.time);
    return scalar(std::atan2(norm(cross(before, now)), dot(before, now)));
}
Vec3 max_displacement(const Moment& m) {
    const auto moved = [&m](std::int64_t i) {
        const BodyId id{static_cast<std::int32_t>(i)};
        return is_free(m.model.bodies, id, m.state.time) ? distance(m, id).x : 0.0;
    };
    return scalar(
        parallel::reduce(m.model.bodies.size(), 0.0, moved, [](double a, double b) { return std::max(a, b); }));
}

/// A load of the water on one body; NaN where there is none yet.
template <std::vector<Vec3> body::Loads::*member, bool has_pressure, bool has_viscous>
Vec3 fluid_load(const Moment& m, BodyId id) {
    constexpr Vec3 unknown{missing, missing, missing};
    if (m.scratch == nullptr || m.scratch->fluid_loads().pressure.empty()) {
        return unknown;
    }
    const coupling::FluidLoads& loads = m.scratch->fluid_loads();
    Vec3 load{};
    if constexpr (has_pressure) {
        load += (loads.pressure.*member)[index(id)];
    }
    if constexpr (has_viscous) {
        load += (loads.viscous.*member)[index(id)];
    }
    return load;
}
constexpr auto force = &body::Loads::force, torque = &body::Loads::torque;

template <double FluidLedger::*member>
Vec3 of_fluid(const Moment& m) {
    return m.report == nullptr ? scalar(missing) : scalar(m.report->ledger.fluid.*member);
}
template <Vec3 FluidLedger::*member>
Vec3 vector_of_fluid(const Moment& m) {
    return m.report == nullptr ? Vec3{missing, missing, missing} : m.report->ledger.fluid.*member;
}
Vec3 artificial_share(const Moment& m) {
    if (m.report == nullptr || !m.report->ledger.has_energy) {
        return scalar(missing);
    }
    const Ledger& ledger = m.report->ledger;
    return scalar(ledger.turnover > 0 ? ledger.fluid.artificial / ledger.turnover : 0);
}

// Kept as two lists by owner, in the order in which the manual prints them.
const std::array body_table{
    Quantity{{"position", "m", 3, true, "centre of mass"}, position, nullptr, position_of_point},
    Quantity{{"displacement", "m", 3, true, "of the centre of mass since time 0"},
             displacement,
             nullptr,
             displacement_of_point},
    Quantity{{"distance", "m", 1, true, "length of the displacement"}, distance, nullptr, distance_of_point},
    Quantity{{"axis_distance", "m", 1, true, "of the centre of mass from the axis x = y = 0, in a plane x = 0"},
             axis_distance,
             nullptr},
    Quantity{{"velocity", "m/s", 3, true, "of the centre of mass"}, velocity, nullptr, velocity_of_point},
    Quantity{{"speed", "m/s", 1, true, "length of the velocity"}, speed, nullptr, speed_of_point},
    Quantity{{"angular_velocity", "rad/s", 3, true, "in world axes"}, spin, nullptr},
    Quantity{{"rotation", "rad", 1, true, "angle turned since time 0, 0 to pi"}, rotation, nullptr},
    Quantity{{"rotation_vector", "rad", 3, true, "axis times angle turned since time 0"}, rotation_vector, nullptr},
    Quantity{{"kinetic_energy", "J", 1, true, "of translation and rotation"}, kinetic_energy_of_body, nullptr},
    Quantity{{"contact_force", "N", 3, true,
              "sum of the contact forces of the last step, those of fixed points and bolts with them"},
             contact_force,
             nullptr},
    Quantity{{"contact_force_size", "N", 1, true, "length of contact_force"}, contact_force_size, nullptr},
    Quantity{{"contact_torque", "N m", 3, true, "of the contacts about the centre of mass"}, contact_torque, nullptr},
    Quantity{{"fluid_force", "N", 3, true, "of water, in the last step; in a planar scene per metre of width"},
             fluid_load<force, true, true>,
             nullptr},
    Quantity{
        {"fluid_pressure_force", "N", 3, true, "the part of it by pressure"}, fluid_load<force, true, false>, nullptr},
    Quantity{{"fluid_viscous_force", "N", 3, true, "the part of it by viscosity: 0 but on bodies with slip = false"},
             fluid_load<force, false, true>,
             nullptr},
    Quantity{
        {"fluid_torque", "N m", 3, true, "of water about the centre of mass"}, fluid_load<torque, true, true>, nullptr},
};

const std::array scene_table{
    Quantity{{"time", "s", 1, false, "simulated time"}, nullptr, time_now},
    Quantity{{"step", "-", 1, false, "steps done"}, nullptr, step_now},
    Quantity{{"max_speed", "m/s", 1, false, "of the fastest body"}, nullptr, reported<&StepReport::max_speed>},
    Quantity{{"max_displacement", "m", 1, false, "of the free body that moved farthest since time 0"},
             nullptr,
             max_displacement},
    Quantity{{"tilt", "rad", 1, false, "angle that gravity has turned"}, nullptr, tilt},
    Quantity{{"max_overlap", "m", 1, false, "of the deepest contact"}, nullptr, reported<&StepReport::max_depth>},
    Quantity{{"max_potential", "-", 1, false, "of the deepest contact over the inscribed radius"},
             nullptr,
             reported<&StepReport::max_potential>},
    Quantity{
        {"contact_count", "-", 1, false, "pairs of bodies that touch"}, nullptr, reported<&StepReport::contact_count>},
    Quantity{{"energy_residual", "J", 1, false, "what the energy ledger does not close by"},
             nullptr,
             measured<&Ledger::residual>},
    Quantity{{"energy_turnover", "J", 1, false, "what the residual is judged against"},
             nullptr,
             measured<&Ledger::turnover>},
    Quantity{{"artificial_share", "-", 1, false,
              "of the artificial accounts of the fluid (diffusion, shifting, ...) in energy_turnover"},
             nullptr,
             artificial_share},
    Quantity{{"momentum", "kg m/s", 3, false, "of free bodies"}, nullptr, booked_vector<&Ledger::momentum>},
    Quantity{{"impulse", "N s", 3, false, "of gravity, supports and damping since time 0"},
             nullptr,
             booked_vector<&Ledger::impulse>},
    Quantity{{"angular_momentum", "kg m^2/s", 3, false, "of free bodies about the origin"},
             nullptr,
             booked_vector<&Ledger::angular_momentum>},
    Quantity{{"angular_impulse", "N m s", 3, false, "about the origin since time 0"},
             nullptr,
             booked_vector<&Ledger::angular_impulse>},
    Quantity{{"momentum_residual", "kg m/s", 3, false, "what the momentum ledger does not close by"},
             nullptr,
             booked_vector<&Ledger::momentum_residual>},
    Quantity{{"angular_momentum_residual", "kg m^2/s", 3, false, "likewise, about the origin"},
             nullptr,
             booked_vector<&Ledger::angular_momentum_residual>},
    Quantity{{"mass", "kg", 1, false, "of free bodies"}, nullptr, booked<&Ledger::mass>},
    Quantity{{"water_mass_in", "kg", 1, false, "of water that came in since time 0"}, nullptr, water_mass_in},
    Quantity{{"water_mass_out", "kg", 1, false, "of water that left since time 0"}, nullptr, water_mass_out},
    Quantity{{"coupling_gap", "J", 1, false, "what bodies got beyond what water says it gave, since time 0"},
             nullptr,
             of_fluid<&FluidLedger::coupling_gap>},
    Quantity{{"water_energy_residual", "J", 1, false, "what the water's energy does not close by"},
             nullptr,
             of_fluid<&FluidLedger::residual>},
    Quantity{{"water_momentum", "kg m/s", 3, false, "of water"}, nullptr, vector_of_fluid<&FluidLedger::momentum>},
    Quantity{{"water_momentum_residual", "kg m/s", 3, false, "what the water's momentum does not close by"},
             nullptr,
             vector_of_fluid<&FluidLedger::momentum_residual>},
    Quantity{{"water_mass", "kg", 1, false, "of water"}, nullptr, of_fluid<&FluidLedger::mass>},
    Quantity{{"max_water_speed", "m/s", 1, false, "of the fastest particle"},
             nullptr,
             reported<&StepReport::max_fluid_speed>},
    Quantity{{"water_passes", "-", 1, false, "force passes of the step, more than one where light bodies need it"},
             nullptr,
             reported<&StepReport::fluid_passes>},
    Quantity{{"water_residual", "-", 1, false,
              "of the accelerations of light bodies after the last pass; above 0.01 the passes ran out"},
             nullptr,
             reported<&StepReport::fluid_residual>},
    Quantity{{"solver_iterations", "-", 1, false, "of the water's pressure equation in the step, all passes"},
             nullptr,
             reported<&StepReport::solver_iterations>},
    Quantity{{"solver_residual", "-", 1, false, "of the water's pressure equation over its right-hand side"},
             nullptr,
             reported<&StepReport::solver_residual>},
    Quantity{{"solid_substeps", "-", 1, false, "steps of the bodies within the step"},
             nullptr,
             reported<&StepReport::substeps>},
};

}  // namespace

std::span<const Quantity> body_quantities() { return body_table; }
std::span<const Quantity> scene_quantities() { return scene_table; }

}  // namespace riprap::sim
