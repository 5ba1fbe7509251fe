// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dda/failure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "riprap/core/index.hpp"

namespace riprap::solid::explicit_dda {

Failure find_failure(const affine::BlockSystem& system, const Settings& settings, const affine::BlockState& state) {
    for (std::int32_t b = 0; b < system.size(); ++b) {
        const double volume = determinant(affine::rows_at(state.deformation, at(b)));
        if (!is_finite(state.position[at(b)]) || !std::isfinite(volume)) {
            return {b, "has no finite place any more"};
        }
        if (volume >= settings.max_stretch || volume <= 1 / settings.max_stretch) {
            return {b, fmt::format("is strained to {:.3g} times its volume; allowed: 1/{:g} to {:g}", volume,
                                   settings.max_stretch, settings.max_stretch)};
        }
    }
    return {};
}

}  // namespace riprap::solid::explicit_dda
