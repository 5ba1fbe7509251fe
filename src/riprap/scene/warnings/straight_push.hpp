// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "riprap/contact/placed_parts.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::scene {

/// Tells what a free body meets first on a straight way, and how its contacts take it up: by the distance potential,
/// with all that other bodies are where they are now.
///
/// From where it meets something the body is moved on, along d, its way where it comes head on, else against the push,
/// and E(s) is what its contacts store after a way s, the work against their force. They bring it to rest where
///
///     E(s) = m_e v^2/2 + m g_d s,    1/m_e = 1/m + (r x d) . J^-1 (r x d),
///
/// v the speed along d, g_d gravity along d, r from its centre of mass to where it is pushed. Contacts that a body has
/// at the start go with it and do not count. What is met, free or not, is taken to stay where it is.
struct StraightPush {
    BodyId body, other;
    double speed{0};   ///< at which they meet, along d [m/s]
    double motion{0};  ///< m_e v^2/2 [J]
    double weight{0};  ///< m g_d, of the weight and never below 0 [N]
    double thin{0};    ///< inscribed radius of the thinner of both [m]
    struct Sample {
        double way, stored;  ///< s [m], E [J]
    };
    std::vector<Sample> samples;    ///< ways that grow by a ratio; end where the contacts let the body go round
    bool goes_round{false};         ///< their push leans, or they lose it
    bool lies_on_something{false};  ///< at the start, so that it cannot go round but upwards

    /// To be taken up on a way [J].
    double brought(double way) const { return motion + weight * way; }
    /// Stored after a way, as a power of it between samples; the most of all after the last [J].
    double stored_after(double way) const;
    double last_way() const { return samples.back().way; }
    /// Where the contacts bring the body to rest [m]; nothing where they do not.
    std::optional<double> rest() const;
    /// Smallest factor on the stiffness with which they do.
    double needed_factor() const;
};

/// Does every contact of the case act by the distance potential, whose energy can be asked for along a way?
bool meets_by_potential(const sim::Model& model);

/// Follows a body along its velocity, or from rest along gravity, until the case ends.
/// @param way     unit vector
/// @param placed  parts where they are at the start
/// @returns nothing where it meets nothing, grazes it by less than a hundredth of an inscribed radius, or too much lies
///          about its way to look at
std::optional<StraightPush> straight_push(const sim::Model& model, const sim::State& state,
                                          const contact::PlacedParts& placed, BodyId body, const Vec3& way);

}  // namespace riprap::scene
