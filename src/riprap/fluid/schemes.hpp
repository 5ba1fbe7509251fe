// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <variant>

#include "riprap/fluid/mps/mps_step.hpp"
#include "riprap/fluid/scheme_settings.hpp"
#include "riprap/fluid/sph/sph_step.hpp"
#include "riprap/fluid/wcmps/wcmps_step.hpp"

namespace riprap::fluid {

/// Makes the scheme of the settings at hand, which have to outlive it.
inline std::unique_ptr<ParticleScheme> make_scheme(const SchemeSettings& settings) {
    return std::visit([](const auto& own) { return make_scheme(own); }, settings);
}

}  // namespace riprap::fluid
