// SPDX-License-Identifier: Apache-2.0
#pragma once

// The words in which methods say what their balance of energy is made of.

#include <cstdint>
#include <string_view>

namespace riprap {

/// Side of an account in the balance of energy of a method. The balance
///     sum(stored) + sum(lost) + sum(given) - sum(gained)
/// keeps the value that it has at the first kick.
enum class Balance : std::uint8_t {
    stored,  ///< energy held at the kick
    lost,    ///< taken out by friction, damping, fracture or the numerics since time 0
    given,   ///< work done since time 0 on what does not belong to the method
    gained,  ///< work done since time 0 by what does not belong to the method
    aside,   ///< told beside the balance: no energy
};

/// When the amount of a step is known: a balance holds at the kick, in the middle of the step.
enum class Booking : std::uint8_t {
    at_kick,      ///< the amount is the value at the kick
    since_kick,   ///< the amount was gathered since the last kick and counts whole
    across_kick,  ///< the amount is a rate at the kick times the step: half of it counts before the kick, half after it
};

/// One account of a method: "fluid.viscous" is the account "viscous" of the fluid. In planar scenes its amounts are per
/// metre of width.
struct Account {
    std::string_view name;
    Balance entry;
    Booking booking;
    std::string_view help;       ///< follows the name in the manual: "by friction at contacts"
    bool is_artificial{false};   ///< no physics, but the price of the numerics
    std::string_view unit{"J"};  ///< of those aside another one
};

/// The first account of particles that totals of checkpoints before it lack, and all after it.
inline constexpr std::string_view first_young_account = "tearing";

}  // namespace riprap
