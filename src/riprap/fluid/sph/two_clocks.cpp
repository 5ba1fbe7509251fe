// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/two_clocks.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/bytes.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::fluid {

namespace {

/// Way that water may go in a flow step, over h [Zhang2020].
constexpr double way_in_flow_step = 0.25;
/// A flow step ends early where it has gone this much further than foreseen [-].
constexpr double way_forgiven = 1.2;

double fastest_of(const ParticleState& state) {
    return std::sqrt(parallel::reduce(
        state.blocks(), 0.0, [&](std::int64_t i) { return norm_squared(state.velocity[static_cast<std::size_t>(i)]); },
        [](double a, double b) { return std::max(a, b); }));
}

/// Adds what an update of density changed.
void book(const DensityUpdate& update, ParticleReport& report) {
    const parallel::JoinBy<parallel::AddRounded> by{};
    by.add(report.by_density, update.losses);
    by.add(report.shifted, update.shifting);
    by.add(report.volume, update.volume);
}

/// The volumes of walls times what they press with, for sums.
FieldView push_of(const WallColumns& walls) {
    FieldView push = field(walls.volumes());
    push.factor = walls.pressure;
    return push;
}

}  // namespace

std::int64_t TwoClocks::sound_steps(const ParticleState& state, double dt) const {
    const double h = settings_.smoothing_length(), way = fastest_of(state) * dt;
    const double viscous = limit(state).viscous;
    double most = static_cast<double>(settings_.sound_steps);
    if (way > 0) {
        most = std::min(most, way_in_flow_step * h / way);
    }
    most = std::min(most, viscous / dt);
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(most));
}

double TwoClocks::renew(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                        bool are_walls_still, double& since, ParticleReport& report) {
    FlowClock& flow = state.flow;
    if (flow.is_under_way() && are_walls_still) {
        return 0;
    }
    if (flow.has_geometry()) {
        // Half of the change of density between two kicks belongs to the geometry of either.
        const double half = since - 0.5 * span.dt;
        advance(state, walls, in_plane(gravity, settings_.domain), half, true, report);
        report.earlier_heat += half * damping_;
        since = 0.5 * span.dt;
    }
    const std::int64_t steps = are_walls_still ? sound_steps(state, span.dt) : 1;
    if (steps == 1) {
        flow.clear();
        return span.dt;
    }
    begin_flow_step(state, steps, span.dt);
    return flow.span;
}

void TwoClocks::begin_flow_step(ParticleState& state, std::int64_t steps, double dt) {
    FlowClock& flow = state.flow;
    flow.done = 0;
    flow.steps = steps;
    flow.span = static_cast<double>(steps) * dt;
    flow.travel = 0;
    flow.velocity = state.velocity;
    flow.density = state.density;
    flow.place.resize(state.position.size());
    parallel::for_each(state.blocks(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        flow.place[i] = state.position[i] + 0.5 * flow.span * state.velocity[i];
    });
    flow.stamp = stamp_of(flow);
}

std::uint64_t TwoClocks::stamp_of(const FlowClock& flow) {
    const auto one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        Hasher hasher;
        hasher.add(&entry, sizeof entry);
        hasher.add(&flow.place[i], sizeof(Vec3));
        hasher.add(&flow.velocity[i], sizeof(Vec3));
        hasher.add(&flow.density[i], sizeof(double));
        return hasher.value();
    };
    const std::uint64_t sum = parallel::reduce(static_cast<std::int64_t>(flow.place.size()), std::uint64_t{0}, one,
                                               [](std::uint64_t a, std::uint64_t b) { return a + b; });
    return std::max<std::uint64_t>(sum, 1);
}

Surroundings TwoClocks::around() const {
    return {water_.bareness.columns(), leaves_wall_.columns(), caught_.columns(), water_.volume.columns(),
            wall_slope_.columns(),     slow_force_.columns(),  rate_.columns()};
}

ParticleColumns TwoClocks::in_geometry(const ParticleState& state) const {
    ParticleColumns columns = columns_of(state);
    columns.position = const_cast<Vec3*>(state.flow.place.data());
    return columns;
}

void TwoClocks::place(const ParticleState& state, const BoundaryParticles& walls) {
    site_.lists().place(reach_of(settings_), state.blocks(), state.flow.place, walls.position);
}

void TwoClocks::find_geometry(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                              ParticleReport& report) {
    place(state, walls);
    ParticleColumns start = in_geometry(state);
    start.velocity = const_cast<Vec3*>(state.flow.velocity.data());
    start.density = const_cast<double*>(state.flow.density.data());
    const auto count = static_cast<std::size_t>(start.count);
    this->find_pressure(start);
    make_room(count, water_.bareness, leaves_wall_, caught_, rate_, wall_slope_, slow_force_);
    stage_.resize(count, settings_.is_plain, SphPlaces::count + (has_stress() ? tensor_numbers : 0));
    corrections_ = lend_corrections(stage_);
    const WallColumns solid = columns_of(walls);
    const DensitySums sums = sum_continuity(start, solid, gravity);
    Where::for_each(start.count, CorrectGeometry{settings_.domain.dimension, settings_.gradient_correction, sums,
                                                 corrections_, around()});
    add_pair_sums(settings_, WallSlope{kernel_}, side(start.positions()), side(walls.position, walls.volume),
                  fresh(sinks(wall_slope_)), site_.lists().fluid_walls);
    if (dt > 0) {
        carry_density(state, sums.diffusion, dt, Update::first, report);
    }
    find_slow_forces(start, walls, gravity);
    known_ = state.flow.stamp;
}

/// Sums the forces of DeltaSph without any pressure.
void TwoClocks::find_slow_forces(const ParticleColumns& start, const BoundaryParticles& walls, const Vec3& gravity) {
    const auto of_walls = static_cast<std::size_t>(walls.size());
    no_pressure_.assign(of_walls, 0);
    no_force_.resize(of_walls);
    viscous_on_walls_.resize(of_walls);
    WallColumns solid = columns_of(walls);
    solid.pressure = no_pressure_.data();
    solid.pressure_force = no_force_.data();
    solid.viscous_force = viscous_on_walls_.data();
    prepare_forces(start);
    water_.pressure.fill(static_cast<std::size_t>(start.count), settings_.is_plain, {0});
    this->sum_at_walls(start, solid);
    this->sum_fluid_forces(start);
    if (has_stress()) {
        sum_velocity_gradient(start, solid);
        add_stress_of_fluid(start);
    }
    this->load(start, solid, gravity);
    if (has_stress()) {
        add_stress_on_walls(start, solid);
    }
    std::fill(no_pressure_.begin(), no_pressure_.end(), 0);  // load has written to it
    this->add_forces_from_walls(start, solid);
    if (has_stress()) {
        add_stress_from_walls(start, solid);
    }
    Where::for_each(start.count, KeepSlowForce{water_.volume.columns(), forces_.force, slow_force_.columns()});
}

void TwoClocks::update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                               ParticleReport& report) {
    if (!state.flow.is_under_way()) {
        known_ = 0;
        const DensityUpdate closing{report.by_density, report.shifted, report.volume, {}, 0};
        Base::update_density(state, walls, gravity, dt, report);
        book(closing, report);
        return;
    }
    const Vec3 pull = in_plane(gravity, settings_.domain);
    if (state.flow.done == 0) {
        find_geometry(state, walls, pull, dt, report);
    } else {
        advance(state, walls, pull, dt, false, report);
    }
    density_time_ = dt;
}

void TwoClocks::advance(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                        bool is_closing, ParticleReport& report) {
    if (known_ != state.flow.stamp) {
        find_geometry(state, walls, gravity, 0, report);
    }
    place(state, walls);
    const ParticleColumns fluid = in_geometry(state);
    Where::for_each(fluid.count, PressureOfDensity{PressureLaw(settings_), fluid.density, water_.pressure.columns()});
    const NumbersView<1> diffusion = stage_.lend<1>(SphPlaces::diffusion);
    const Vec3 weight = settings_.rest_density * gravity;
    add_pair_sums_within(
        settings_, SoundContinuity{kernel_, {weight.x, weight.y, weight.z}},
        side(fluid.positions(), fluid.velocities(), water_.pressure, water_.volume, corrections_.tensor),
        fresh(sinks(diffusion, rate_)), site_.lists().fluid_fluid);
    carry_density(state, diffusion, dt, is_closing ? Update::closing : Update::within, report);
}

void TwoClocks::carry_density(ParticleState& state, NumbersView<1> diffusion, double dt, Update update,
                              ParticleReport& report) {
    const bool is_first = update == Update::first;
    const double resistance = resistance_of_damping(settings_);
    state.damping.resize(resistance > 0 ? state.position.size() : 0);
    const ParticleColumns fluid = in_geometry(state);
    const double diffusivity = 2 * settings_.density_diffusion * settings_.smoothing_length() /
                               (settings_.sound_speed * settings_.rest_density);
    const AdvanceOnGeometry advance_one{dt,
                                        diffusivity,
                                        escape_in_step(settings_.sound_speed * dt / settings_.spacing),
                                        settings_.rest_density,
                                        settings_.particle_mass,
                                        PressureLaw(settings_),
                                        fluid.density,
                                        is_first ? fluid.dilution : nullptr,
                                        fluid.damping,
                                        update == Update::closing ? 0 : resistance,
                                        fluid.velocity,
                                        diffusion,
                                        corrections_.damped,
                                        is_first,
                                        corrections_.tensor,
                                        around()};
    const DensityUpdate sums = Where::sum(state.blocks(), advance_one);
    damping_ = sums.damping;
    book(sums, report);
}

void TwoClocks::begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span,
                             const Vec3& gravity, ParticleReport& report) {
    if (!state.flow.is_under_way()) {
        Base::begin_forces(state, walls, span, gravity, report);
        return;
    }
    find_lost_particle(settings_, state, span.time, report);
    if (!report.problem.empty()) {
        return;
    }
    const ParticleColumns fluid = in_geometry(state);
    forces_ = lend_force_sums(stage_);
    Where::for_each(fluid.count,
                    DampSound{PressureLaw(settings_), resistance_of_damping(settings_), fluid.density, rate_.columns(),
                              corrections_.damped, water_.pressure.columns(), forces_.wall_heat});
    const auto stress = products(fields(corrections_.tensor), water_.pressure);
    add_pair_sums(settings_, SoundOnWalls{kernel_}, side(std::span<const Vec3>(walls.position)),
                  side(fluid.positions(), water_.pressure, water_.volume, stress),
                  fresh(sinks(at_walls_.pressure, at_walls_.push)), site_.lists().walls_fluid);
    add_pair_sums_within(settings_, SoundForce{kernel_}, side(fluid.positions(), water_.volume, stress),
                         fresh(sinks(forces_.force)), site_.lists().fluid_fluid);
}

void TwoClocks::load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) {
    if (!state.flow.is_under_way()) {
        Base::load_walls(state, walls, gravity);
        return;
    }
    const WallColumns solid = columns_of(walls);
    Where::for_each(solid.count,
                    ExtrapolateToWall{solid, this->pressure_at_wall(), in_plane(gravity, settings_.domain)});
    std::fill(walls.viscous_force.begin(), walls.viscous_force.end(), Vec3{});
    Where::for_each(solid.count, ForceOnWall{solid, at_walls_.slope.columns(), at_walls_.push.columns()});
    walls.viscous_force = viscous_on_walls_;
}

void TwoClocks::kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                     const SparseVectors& extra_force, ParticleReport& report) {
    if (!state.flow.is_under_way()) {
        Base::kick(state, walls, gravity, span, extra_force, report);
        return;
    }
    const Vec3 pull = in_plane(gravity, settings_.domain);
    const ParticleColumns fluid = in_geometry(state);
    add_pair_sums(settings_, WallSlope{kernel_}, side(fluid.positions()),
                  side(std::span<const Vec3>(walls.position), std::array{push_of(columns_of(walls))}),
                  fresh(sinks(forces_.wall_hold)), site_.lists().fluid_walls);
    report.earlier_heat += (density_time_ - 0.5 * span.dt) * damping_;
    finish_kick_in_flow(state, walls, pull, span, extra_force, report);
    FlowClock& flow = state.flow;
    if (flow.done == 0) {
        shift_flow(state, walls, pull, span.dt, report);
    }
    flow.done += 1;
    flow.travel += span.dt * report.max_speed;
    if (flow.travel + span.dt * report.max_speed > way_forgiven * way_in_flow_step * settings_.smoothing_length()) {
        flow.end();
    }
}

void TwoClocks::finish_kick_in_flow(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                                    const TimeSpan& span, const SparseVectors& extra_force, ParticleReport& report) {
    const ParticleColumns fluid = columns_of(state);
    const KickOnGeometry kick_one{settings_.particle_mass,
                                  span.dt,
                                  gravity,
                                  gravity - without_periodic(gravity, settings_.domain),
                                  fluid,
                                  corrections_.tensor,
                                  around(),
                                  water_.pressure.columns(),
                                  forces_.wall_heat,
                                  forces_.force,
                                  forces_.wall_hold,
                                  site_.extra(extra_force, state.position.size())};
    book_kick(fluid.count, gravity, span.dt, Where::sum(state.blocks(), kick_one), report);
    book_compression(state, report);
    state.max_acceleration = report.max_acceleration;
    book_walls(walls, span.dt, report);
    find_wild_particle(settings_, state, span.time, report);
}

void TwoClocks::find_concentration(const parallel::Blocks& blocks, const BoundaryParticles& walls,
                                   const std::vector<Vec3>& places) {
    const std::span<const Vec3> at(places);
    site_.lists().place(reach_of(settings_), blocks, places, walls.position);
    add_pair_sums_within(settings_, Concentration{kernel_}, side(at, water_.volume),
                         fresh(sinks(water_.concentration_gradient)), site_.lists().fluid_fluid);
    add_pair_sums(settings_, WallSlope{kernel_}, side(at), side(std::span<const Vec3>(walls.position), walls.volume),
                  sinks(water_.concentration_gradient), site_.lists().fluid_walls);
}

void TwoClocks::shift_flow(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                           ParticleReport& report) {
    if (settings_.shifting == 0) {
        return;
    }
    const ParticleColumns fluid = columns_of(state);
    const UrgeToShift urge{settings_.domain.dimension, water_.strain.columns(), water_.bareness.columns()};
    const double most = settings_.shifting * state.flow.span * Where::reduce(fluid.count, 0.0, urge, Largest{});
    constexpr double share_of_part = 0.35;
    constexpr int most_parts = 4;
    const int parts = static_cast<int>(std::clamp(std::ceil(most / share_of_part), 1.0, double(most_parts)));
    const double time = state.flow.span / parts;
    shifted_ = state.flow.place;
    for (int part = 0; part < parts; ++part) {
        if (part > 0) {
            find_concentration(state.blocks(), walls, shifted_);
        }
        const ShiftPart shift_one{{settings_.domain.dimension, settings_.shifting, settings_.smoothing_length(), time,
                                   settings_.particle_mass, without_periodic(gravity, settings_.domain), fluid.position,
                                   fluid.dilution, water_.concentration_gradient.columns(), water_.strain.columns(),
                                   water_.bareness.columns(), corrections_.share, forces_.to_surface},
                                  time / dt,
                                  part == 0,
                                  shifted_.data()};
        const Shifted shifted = Where::sum(state.blocks(), shift_one);
        report.shifted += shifted.potential;
        report.max_shift += std::sqrt(shifted.longest_squared);
    }
}

std::size_t TwoClocks::bytes() const {
    return Base::bytes() + leaves_wall_.bytes() + caught_.bytes() + rate_.bytes() + wall_slope_.bytes() +
           slow_force_.bytes() + bytes_of(viscous_on_walls_, no_pressure_, no_force_, shifted_);
}

}  // namespace riprap::fluid
