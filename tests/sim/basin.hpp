// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/coupling/fill.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"
#include "sim/small_scene.hpp"

namespace riprap::sim {

/// Spacing of the water in these tests [m].
inline constexpr double dp = 0.05;

/// Water about blocks in two dimensions.
struct Basin : SmallScene {
    double sound_speed = 30;  ///< [m/s]; before water is filled in

    Basin() { model.bodies.is_planar = true; }

    BodyId add_square(double edge, double density, const Vec3& place, const Vec3& velocity = {}, double spin = 0) {
        rock().density = density;
        const std::vector<geometry::Point2> corners{
            {-0.5 * edge, -0.5 * edge}, {0.5 * edge, -0.5 * edge}, {0.5 * edge, 0.5 * edge}, {-0.5 * edge, 0.5 * edge}};
        return add("block" + std::to_string(model.bodies.size()), add_shape(geometry::planar_prism(corners).value()),
                   {place, {}}, body::Drive::free, velocity, {0, 0, spin});
    }
    void add_wall(const Vec3& normal, double offset) {
        add("wall" + std::to_string(model.bodies.size()), model.shapes.add_half_space(normal, offset), {},
            body::Drive::fixed);
    }
    void fill(const Vec3& low, const Vec3& high, const Vec3& margin, double level, const Vec3& gravity) {
        model.gravity.value = gravity;
        coupling::ParticleFluid& water = model.fluid.emplace<coupling::ParticleFluid>();
        water.settings().spacing = dp;
        water.settings().particle_mass = 1000 * dp * dp;
        water.settings().sound_speed = sound_speed;
        water.settings().domain = {low - margin, high + margin, {}, 2};
        water.is_dry.assign(static_cast<std::size_t>(model.bodies.size()), 0);
        const coupling::FillRegion region{
            {geometry::moved(geometry::box({high.x - low.x, high.y - low.y, 1}), {0.5 * (low + high), {}})}, level};
        coupling::Filling filling =
            coupling::fill(model.shapes, model.bodies, state.bodies, water.settings(), {0, 1, 0},
                           std::vector<coupling::FillRegion>{region}, {1'000'000, 1'000'000});
        set_hydrostatic_density(filling, water.settings(), gravity);
        state.fluid = std::move(filling.particles);
        coupling::SampleSettings settings;
        settings.spacing = dp;
        settings.reach = water.settings().support_radius();
        settings.domain = water.settings().domain;
        settings.limit = 1'000'000;
        water.samples = sample_shapes(model.shapes, model.bodies, state.bodies, settings);
    }
    /// A pool with walls on three sides.
    void fill_pool(double width, double level) {
        add_walls(width);
        fill({0, 0, 0}, {width, 2 * level, 0}, {dp, dp, 0}, level, {0, -9.81, 0});
    }
    void add_walls(double width) {
        add_wall({0, 1, 0}, 0);
        add_wall({1, 0, 0}, 0);
        add_wall({-1, 0, 0}, -width);
    }
    Vec3 total_momentum() const {
        Vec3 sum{};
        for (const Vec3& v : state.fluid.velocity) {
            sum += model.particles()->settings().particle_mass * v;
        }
        for (std::size_t b = 0; b < model.bodies.mass.size(); ++b) {
            if (model.bodies.drive[b] == body::Drive::free) {
                sum += model.bodies.mass[b] * state.bodies.velocity[b];
            }
        }
        return sum;
    }
    /// Momentum that could have been exchanged: the scale of its round-off.
    double momentum_scale() const {
        double sum = 0;
        for (const Vec3& v : state.fluid.velocity) {
            sum += model.particles()->settings().particle_mass * norm(v);
        }
        return sum;
    }
    StepReport steps(std::int64_t count, Scratch& scratch) {
        if (state.step == 0) {
            initialise(model, state);
        }
        StepReport report;
        for (std::int64_t i = 0; i < count && (i == 0 || report.status.ok()); ++i) {
            const double dt = choose_time_step(model, state, scratch).dt;
            report = advance(model, state, scratch, dt, Measure::energy);
        }
        return report;
    }
};

}  // namespace riprap::sim
