// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <variant>

#include "riprap/fluid/particle/particle_scheme.hpp"
#include "riprap/fluid/scheme_settings.hpp"

namespace riprap::fluid {

/// Makes the scheme of the settings at hand.
inline std::unique_ptr<ParticleScheme> make_scheme(const SchemeSettings& settings) {
    return std::visit([](const auto& own) { return make_scheme(own); }, settings);
}

}  // namespace riprap::fluid
