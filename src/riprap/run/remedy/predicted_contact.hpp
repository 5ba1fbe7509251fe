// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::run {

/// Overlap over the inscribed radius of the thinner body above which `check` warns [-]: a body that sinks in so far
/// stands lower, and comes to others earlier, than it was drawn.
inline constexpr double large_overlap = 0.1;

/// Overlap that the stiffness of a case allows, by the springs of a flat contact: at rest W/K, in an impact
///
///     d = (m g + sqrt((m g)^2 + K m v^2))/K,
///
/// K = A (k_a/r_a + k_b/r_b) where bodies meet by faces, n k or A k with n springs k of corners or of the area A, and
/// Hertz' law of n spheres where they meet by spheres. Impacts by the distance potential: by what the contacts store on
/// the way (scene::StraightPush).
struct PredictedOverlap {
    BodyId body, other;     ///< it comes to, or stands on
    bool is_impact{false};  ///< else it stands there
    double speed{0};        ///< of the impact [m/s]
    double overlap{0};      ///< [m]
    double share{0};        ///< of the inscribed radius of the thinner of the two [-]
    double factor{1};       ///< on the stiffness with which the share is the wanted one [-]
    std::string stiffness;  ///< "key = value" of that stiffness
};

/// Returns the overlap that is the largest share. Impacts are those of first meetings (scene::first_met), before the
/// end and without water, which would carry bodies; a foot carries all that is stacked on it.
/// @param wanted  share for which it names the stiffness
std::optional<PredictedOverlap> largest_overlap(const sim::Model& model, const sim::State& state,
                                                double wanted = large_overlap);

/// Returns what a flat contact of two bodies stores at an overlap, by the same springs [J].
/// @param way  from the one to the other, of any length
double flat_contact_energy(const sim::Model& model, const sim::State& state, BodyId body, BodyId other, const Vec3& way,
                           double overlap);

/// Loss of an impact by the step of an implicit method. A step h of a scheme whose forces are those of its end damps
/// the spring of a contact, omega = sqrt(K/m), by the ratio omega h/4 of the critical one [Shi1988]: of the speed
///
///     exp(-pi omega h/4)
///
/// comes back.
struct ImpactStep {
    BodyId body, other;
    double speed{0};  ///< [m/s]
    double back{0};   ///< share of the speed that comes back [-]
    double step{0};   ///< with which `well_resolved` of it does [s]
};

inline constexpr double well_resolved = 0.98;

/// Returns the impact of which least comes back; nothing for methods without a step of their own.
std::optional<ImpactStep> shortest_impact(const sim::Model& model, const sim::State& state);

}  // namespace riprap::run
