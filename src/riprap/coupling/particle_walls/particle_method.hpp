// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "riprap/core/account.hpp"
#include "riprap/coupling/fluid_report.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/coupling/gauge_query.hpp"
#include "riprap/coupling/particle_walls/correct_bodies.hpp"
#include "riprap/coupling/particle_walls/face_reading.hpp"
#include "riprap/coupling/particle_walls/particle_scratch.hpp"

namespace riprap::coupling {

/// A fluid of particles between walls, bound to Model, State and Scratch for one step: FluidMethod.
class ParticleMethod {
 public:
    using Settings = ParticleFluid;
    using Fields = NoFields;
    using Scratch = ParticleScratch;
    static constexpr bool is_there = true;
    static constexpr bool leads = true;  ///< its step is that of the run
    static std::span<const Account> accounts();
    /// See sim/method_traits.hpp: a scheme says so by a member of its settings.
    static bool books_every_step(const Settings& water) {
        return std::visit([]<class Scheme>(const Scheme& /*scheme*/) { return books_all<Scheme>; }, water.scheme);
    }
    static double grain(const Settings& water) { return water.settings().spacing; }

    ParticleMethod(const FluidScene& scene, const Settings& water, const FluidState& state, Fields& fields,
                   Scratch& scratch);

    /// Fills inflows; on a fresh State.
    void start();
    /// Newton's step for bodies that accelerate by their loads, where the scheme has one (correct_bodies.hpp).
    bool correct(const body::BodySet& bodies, const body::BodyKinematics& kinematics,
                 std::span<const std::uint8_t> is_sought, std::span<const body::Acceleration> residual,
                 std::vector<body::Acceleration>& guess) const {
        return coupling::correct(*water_, bodies, kinematics, is_sought, residual, *scratch_, guess);
    }
    /// Has the scheme such a step? Then its water cannot give way, so that its loads follow the way of bodies within a
    /// step.
    bool corrects() const {
        return scratch_->scheme->for_bodies() != nullptr && water_->wall == WallTreatment::boundary_particles;
    }
    /// Returns the longest step that sound, acceleration and viscosity allow.
    StepLimit limit() const;
    /// Sorts the particles by place on steps given by the step number alone.
    void tidy(std::int64_t step);
    /// Sets how fast the corrections of absorbing paddles go over the span, and tells how that accelerates them.
    /// @param correction  per driven body, empty where none is corrected [m/s^2]
    void drive(const TimeSpan& span, std::vector<Vec3>& correction);
    /// Density, half a drift, and the forces within the fluid with bodies where they will be at mid-step. Bodies are
    /// not moved.
    Outcome begin(const TimeSpan& span, const body::Motion& now, const body::Motion& middle, FluidStep& report);
    /// Finds the loads on bodies that move as `middle` says; its poses are those of begin.
    void load(const TimeSpan& span, const body::Motion& middle, FluidLoads& loads);
    /// Kicks the particles with the walls as they were last loaded.
    Outcome kick(const TimeSpan& span, FluidStep& report);
    /// The second half of the drift, and what passes inflows and outflows.
    Outcome end(const TimeSpan& span, FluidStep& report);

    /// Returns the share of each body's mass that its walls feed back to the loads: the bodies whose accelerations have
    /// to be iterated [-].
    std::span<const double> feedback() const { return scratch_->bodies.kappa; }
    static constexpr unsigned offers = fluid::reading::of_particles;
    /// Reads a gauge; nothing before the first step for one on a face.
    static fluid::GaugeReading read(const GaugeQuery<ParticleMethod>& query);

 private:
    template <class Scheme>
    static constexpr bool books_all = requires {
        requires Scheme::books_every_step;
    };
    void hold_loads(const TimeSpan& span);

    const FluidScene* scene_;
    const ParticleFluid* water_;
    FluidState state_;
    ParticleScratch* scratch_;
};

}  // namespace riprap::coupling
