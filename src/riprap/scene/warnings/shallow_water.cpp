// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"
#include "riprap/scene/warnings/joined_regions.hpp"

namespace riprap::scene {

void warn_of_shallow_water(CaseBuild& build, const Value& regions, const coupling::ParticleFluid& fluid,
                           const coupling::Filling& filling) {
    const fluid::ParticleSettings& settings = fluid.settings();
    if (norm(fluid::without_periodic(build.model.gravity.at(0), settings.domain)) == 0) {
        return;  // no surface that the water lies flat below
    }
    const Vec3 up = build.up();
    std::vector<double> lowest(filling.regions.size(), std::numeric_limits<double>::infinity());
    std::vector<double> highest(filling.regions.size(), -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < filling.particles.position.size(); ++i) {
        const auto r = at(filling.region[i]);
        const double height = dot(up, filling.particles.position[i]);
        lowest[r] = std::min(lowest[r], height);
        highest[r] = std::max(highest[r], height);
    }
    const double least = settings.support_radius() + settings.spacing;
    std::vector<double> depths(lowest.size());
    for (std::size_t r = 0; r < lowest.size(); ++r) {
        depths[r] = filling.regions[r].count > 0 ? highest[r] - lowest[r] + settings.spacing : 0;
    }
    const std::vector<double> joined = joined_depths(filling, depths, settings.spacing);
    for (std::size_t r = 0; r < lowest.size() && r < regions.items.size(); ++r) {
        const double depth = depths[r];
        if (filling.regions[r].count > 0 && joined[r] < least - 1e-6 * settings.spacing) {
            build.warnings.push_back(to_string(Diagnostic{
                regions.items[r].place,
                fmt::format("the water is {:.3g} spacings deep: every particle lies in reach of both its surface and "
                            "its bed, and neither waves nor pressures in it are good",
                            depth / settings.spacing),
                fmt::format("fluid.spacing of {:.3g} m makes it ten spacings", 0.1 * depth)}));
        }
    }
}

}  // namespace riprap::scene
