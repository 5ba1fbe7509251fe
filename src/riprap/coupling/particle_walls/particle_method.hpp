// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "riprap/core/account.hpp"
#include "riprap/coupling/fluid_method.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/coupling/fluid_traits.hpp"
#include "riprap/coupling/gauge_query.hpp"
#include "riprap/coupling/particle_walls/correct_bodies.hpp"
#include "riprap/coupling/particle_walls/face_reading.hpp"
#include "riprap/coupling/particle_walls/particle_scratch.hpp"

namespace riprap::coupling {

/// A fluid of particles between walls, bound to Model, State and Scratch for one step: FluidMethod.
class ParticleMethod final : public FluidMethod {
 public:
    using Settings = ParticleFluid;
    using Fields = NoFields;
    using Scratch = ParticleScratch;
    static std::span<const Account> accounts();
    static fluid::ShownFluid shown(const ShownQuery<Settings>& query);
    static fluid::ShownFluid shown_stirred(const ShownQuery<Settings>& query);
    static constexpr FluidTraits<Settings> traits{
        .offers = fluid::reading::of_particles,
        .makes_up = true,
        .starts_slowly = [](const Settings& water) { return fluid::starts_slowly(water.scheme); },
        .books_every_step = [](const Settings& water) { return fluid::books_every_step(water.scheme); },
        .spacing = [](const Settings& water) { return water.settings().spacing; },
        .grain = [](const Settings& water) { return water.settings().spacing; },
        .grain_mass = [](const Settings& water) { return water.settings().particle_mass; },
        .domain = [](const Settings& water) { return &water.settings().domain; },
        .courant = [](const Settings& water) { return water.settings().courant; },
        .bytes = [](const Settings& water) { return water.bytes(); },
        .accounts = &accounts,
        .shown = &shown,
        .shown_stirred = &shown_stirred};

    ParticleMethod(const FluidScene& scene, const Settings& water, const FluidState& state, Fields& fields,
                   Scratch& scratch);

    /// Fills inflows; on a fresh State.
    void start() override;
    /// Newton's step for bodies that accelerate by their loads, where the scheme has one (correct_bodies.hpp).
    bool correct(const body::BodySet& bodies, const body::BodyKinematics& kinematics,
                 std::span<const std::uint8_t> is_sought, std::span<const body::Acceleration> residual,
                 std::vector<body::Acceleration>& guess) override {
        return coupling::correct(*water_, bodies, kinematics, is_sought, residual, *scratch_, guess);
    }
    /// Has the scheme such a step? Then its water cannot give way, so that its loads follow the way of bodies within a
    /// step.
    bool corrects() const override {
        return scratch_->scheme->for_bodies() != nullptr && water_->wall == WallTreatment::boundary_particles;
    }
    /// Returns the longest step that sound, acceleration and viscosity allow.
    StepLimit limit() const override;
    /// Sorts the particles by place on steps given by the step number alone.
    void tidy(std::int64_t step) override;
    /// Sets how fast the corrections of absorbing paddles go over the span, and tells how that accelerates them.
    /// @param correction  per driven body, empty where none is corrected [m/s^2]
    void drive(const TimeSpan& span, std::vector<Vec3>& correction) override;
    /// Density, half a drift, and the forces within the fluid with bodies where they will be at mid-step. Bodies are
    /// not moved.
    Outcome begin(const TimeSpan& span, const body::Motion& now, const body::Motion& middle,
                  FluidStep& report) override;
    /// Finds the loads on bodies that move as `middle` says; its poses are those of begin.
    void load(const TimeSpan& span, const body::Motion& middle, FluidLoads& loads) override;
    /// Kicks the particles with the walls as they were last loaded.
    Outcome kick(const TimeSpan& span, FluidStep& report) override;
    /// The second half of the drift, and what passes inflows and outflows.
    Outcome end(const TimeSpan& span, FluidStep& report) override;

    /// Returns the share of each body's mass that its walls feed back to the loads: the bodies whose accelerations have
    /// to be iterated [-].
    std::span<const double> feedback() const override { return scratch_->bodies.kappa; }
    /// Reads a gauge; nothing before the first step for one on a face.
    static fluid::GaugeReading read(const GaugeQuery<ParticleMethod>& query);

 private:
    void hold_loads(const TimeSpan& span);
    Outcome outcome() const { return {found_.problem, 0, found_.remedy}; }

    const FluidScene* scene_;
    const ParticleFluid* water_;
    FluidState state_;
    ParticleScratch* scratch_;
    fluid::ParticleReport found_;  ///< by the scheme, over the span
};

}  // namespace riprap::coupling
