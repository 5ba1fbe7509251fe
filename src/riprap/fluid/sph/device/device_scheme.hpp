// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "riprap/fluid/particle/cell_sweep.hpp"
#include "riprap/fluid/sph/delta_sph.hpp"
#include "riprap/fluid/sph/device/device_columns.hpp"
#include "riprap/fluid/sph/device/device_sph.hpp"

namespace riprap::fluid {

/// The numbers of a step in memory of `Where`, and the cells that its sums go by.
template <class Memory>
struct DeviceSphData : SphNumbers<Memory> {
    CellLists<Memory> lists;
    std::size_t bytes() const { return SphNumbers<Memory>::bytes() + lists.bytes(); }
};

template <class Where, PairPhysics Pair>
void add_pair_sums(const SphSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, CellPairs<Where>& pairs) {
    cell_sweep(pair, {settings.support_radius(), settings.domain}, targets, candidates, sums, pairs);
}
template <class Where, MutualPhysics Pair>
void add_pair_sums_within(const SphSettings& settings, const Pair& pair,
                          const SweepSide<Pair::target_fields>& particles,
                          const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums,
                          CellPairs<Where>& pairs) {
    add_pair_sums(settings, pair, particles, particles, sums, pairs);
}

/// Describes the water about a wall particle under this gravity, as WaterAtWalls has it.
struct DescribeWall {
    PressureAtWall at_wall;
    NumbersView<3> slope;
    Vec3 gravity;
    double* weight_there;
    double* pressure_there;
    Vec3* slope_there;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto w = static_cast<std::size_t>(entry);
        weight_there[w] = at_wall.weight[w];
        slope_there[w] = slope.vector(w);
        pressure_there[w] = at_wall(w, gravity);
    }
};

/// delta_sph whose loops run over copies in memory of `Where`. The State stays with the host, which may change all of
/// it before update_density, places of particles and all of walls before begin_forces, and how walls move before each
/// load_walls: that is what these verbs take. Each gives back what it changed.
template <class Where>
class DeviceSph final : public ParticleScheme {
 public:
    explicit DeviceSph(const SphSettings& settings) : settings_(&settings) {}

    FluidTimeStep limit(const ParticleState& state) const override { return choose_fluid_time_step(*settings_, state); }

    void update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                        FluidReport& report) override {
        water_.take(state);
        walls_.take(walls);
        place(state, walls);
        delta_sph::update_density(*settings_, water_.columns(), walls_.columns(), in_plane(gravity, settings_->domain),
                                  dt, data_, report);
        water_.give_density(state);
    }

    void begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span,
                      const Vec3& /*gravity*/, FluidReport& report) override {
        find_lost_particle(*settings_, state, span.time, report);
        if (report.problem.empty()) {
            water_.take_places(state);
            walls_.take_for_forces(walls);
            place(state, walls);
            delta_sph::begin_forces(*settings_, water_.columns(), walls_.columns(), data_);
        }
    }

    void describe_walls(const Vec3& gravity, WaterAtWalls& water) const override {
        const auto count = data_.at_walls.weight.size();
        typename Where::template Array<double> weight(count), pressure(count);
        typename Where::template Array<Vec3> slope(count);
        Where::for_each(static_cast<std::int64_t>(count),
                        DescribeWall{pressure_at_wall(data_.at_walls), data_.at_walls.slope.columns(), gravity,
                                     weight.data(), pressure.data(), slope.data()});
        water.weight.resize(count);
        water.pressure.resize(count);
        water.slope.resize(count);
        Where::template download<double>(weight, water.weight);
        Where::template download<double>(pressure, water.pressure);
        Where::template download<Vec3>(slope, water.slope);
    }

    void load_walls(const ParticleState& /*state*/, BoundaryParticles& walls, const Vec3& gravity) override {
        walls_.take_motion(walls);
        delta_sph::load_walls(*settings_, water_.columns(), walls_.columns(), in_plane(gravity, settings_->domain),
                              data_);
        walls_.give_loads(walls);
    }

    void kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
              const SparseVectors& extra_force, FluidReport& report) override {
        const Vec3 pull = in_plane(gravity, settings_->domain);
        delta_sph::finish_forces(*settings_, water_.columns(), walls_.columns(), pull, span.dt, data_, report);
        kick_particles(*settings_, water_.columns(), pull, span.dt, data_,
                       extra_.take(extra_force, state.position.size()), report);
        water_.give_motion(state);
        book_compression(*settings_, state, report);
        state.max_acceleration = report.max_acceleration;
        book_walls(walls, span.dt, report);
        find_wild_particle(*settings_, state, span.time, report);
    }

    std::size_t bytes() const override { return water_.bytes() + walls_.bytes() + extra_.bytes() + data_.bytes(); }

 private:
    void place(const ParticleState& state, const BoundaryParticles& walls) {
        data_.lists.place({settings_->support_radius(), settings_->domain}, box_of(state.position),
                          water_.columns().positions(), box_of(walls.position), walls_.columns().positions());
    }

    const SphSettings* settings_;
    WaterThere<Where> water_;
    WallsThere<Where> walls_;
    SparseThere<Where> extra_;
    DeviceSphData<Where> data_;
};

}  // namespace riprap::fluid
