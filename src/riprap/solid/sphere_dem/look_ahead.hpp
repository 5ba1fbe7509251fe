// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/body_set.hpp"
#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"

namespace riprap::solid::sphere_dem {

/// Buffers of a look ahead: Scratch. Apart from those of the step, which output reads after it.
struct LookAhead {
    SphereScratch buffers;
    body::BodyState bodies;  ///< where they will be
};

/// Can the step follow the contacts? Where all bodies that move are sampled and meet surfaces by Hertz.
bool follows_contacts(const SphereModel& model);

/// A step to lengthen.
struct KnownStep {
    double longest;  ///< that is safe for whatever comes, T/7.5 of the shortest impact T [s]
    double gravity;  ///< its size [m/s^2]
};

/// Longest step by the contacts that there will be at its end [s]. With velocities as they are, bodies are moved over
/// the step that will be taken, 0.15 of it; each contact that is found there allows
///
///     min(2/omega, T/7.5),   omega^2 = sum_A k l + sum_B k l,   k = 2 E* sqrt(R d),   l = 1/m + r^2/I,
///     T = 2.87 (sqrt(v_n) (sum_A h l + sum_B h l))^(-2/5),      h = E* sqrt(R),
///
/// where sums go over all contacts of both bodies A and B, d is the overlap, r the arm of the contact, and v_n the
/// speed at which the contact closes or opens, so that an impact is as exact on its way out: omega bounds the
/// frequencies of the contacts, T is the duration of an impact on all of them. Springs count by the portions of their
/// samples. Steps are no longer than 16 times the known one nor than twice the one before, and move no point by more
/// than R/100; they are no shorter than the known one.
double longest_ahead(const SphereModel& model, const body::BodyState& state, const KnownStep& known, LookAhead& ahead);

}  // namespace riprap::solid::sphere_dem
