// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "riprap/scene/read_case.hpp"

namespace riprap::run {

/// One number of a case that is not known exactly: a row of [[spread]].
struct Spread {
    std::string key;               ///< path of the number, as for --set
    double low{0}, high{0};        ///< of the uniform distribution, SI
    bool is_normal{false};         ///< of mean and deviation instead
    double mean{0}, deviation{0};  ///< SI
};

/// Rows of [[spread]] of a case; none where it has none.
std::vector<Spread> spreads_of(const scene::LoadedCase& loaded);

/// "body.gate.position.0 from 0.2 to 0.3", "material.ice.friction_coefficient 0.4 with a deviation of 0.05"
std::string text_of(const Spread& spread);

/// Value of one number in one member: a function of the seed of the case, the member and the key alone, so that more
/// members or further numbers leave the others as they were.
double draw(const Spread& spread, std::uint64_t seed, std::int64_t member);

}  // namespace riprap::run
