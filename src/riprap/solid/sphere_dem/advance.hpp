// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/explicit_dem.hpp"
#include "riprap/solid/faces_on_faces.hpp"
#include "riprap/solid/sphere_dem/dashpot_loss.hpp"
#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// Time of a step.
struct StepTimes {
    double begin;     ///< [s]
    double dt;        ///< [s]
    double previous;  ///< length of the step before; dt for the first [s]
};

/// Books of one step.
struct SphereReport {
    KickReport kick;                ///< motion and outside loads, at the kick
    ContactSums contacts;           ///< energies at the mid-step poses
    DashpotLoss dashpots;           ///< in this step
    std::int64_t contact_count{0};  ///< of spheres, several a pair of bodies
    bool has_searched{false};       ///< candidate pairs were searched afresh
    std::string problem;            ///< empty = the step stands
};

/// One step: drift half, contacts at the mid-step poses, kick, drift half (docs/theory/motion.md). `external` holds
/// over the step.
SphereReport advance(const SphereModel& model, const Vec3& gravity, const body::LoadView& external,
                     const StepTimes& times, body::BodyState& bodies, SphereState& state, SphereScratch& scratch);

/// Contact loads at the poses of `bodies` into `scratch.loads`; springs advance by the time since the last evaluation.
/// @param faces  meets bodies without spheres with each other; nullptr where none of them can move
ContactSums evaluate_contacts(const SphereModel& model, double time, double sliding_time, const body::BodyState& bodies,
                              SphereState& state, SphereScratch& scratch, FacesOnFaces* faces = nullptr,
                              bool with_energy = false);

/// Counts the pairs of bodies of which one has spheres and that touch.
std::int64_t count_touching(const SphereModel& model, const SphereState& state);

}  // namespace riprap::solid::sphere_dem
