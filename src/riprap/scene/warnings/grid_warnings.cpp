// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/grid_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"
#include "riprap/scene/warnings/joined_regions.hpp"
#include "riprap/scene/warnings/paddle_warnings.hpp"

namespace riprap::scene {

namespace {

/// Cells between bed and surface of which the middle ones have neither in the cells next to them.
constexpr double least_cells = 4;

/// Places of water on a lattice of the cells' width; nothing where there are too many, or where these do not fit.
std::optional<coupling::Filling> places_of_water(const CaseBuild& build, const coupling::FieldScene& scene,
                                                 double width) {
    constexpr std::int64_t most = 1'000'000;
    fluid::SphSettings lattice;
    lattice.spacing = width;
    lattice.domain = scene.domain;
    try {
        return coupling::fill(build.model.shapes, build.model.bodies, build.state.bodies, lattice, scene.up,
                              scene.regions, {most, most});
    } catch (const CaseError&) {
        return std::nullopt;  // these places are for warnings alone
    }
}

void warn_of_shallow_regions(CaseBuild& build, const Value& regions, const coupling::Filling& filling, double width) {
    std::vector<double> lowest(filling.regions.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < filling.particles.position.size(); ++i) {
        double& least = lowest[at(filling.region[i])];
        least = std::min(least, dot(build.up(), filling.particles.position[i]));
    }
    std::vector<double> depths(lowest.size());
    for (std::size_t r = 0; r < lowest.size(); ++r) {
        depths[r] = filling.regions[r].count > 0 ? filling.regions[r].surface - (lowest[r] - 0.5 * width) : 0;
    }
    const std::vector<double> joined = joined_depths(filling, depths, width);
    for (std::size_t r = 0; r < lowest.size() && r < regions.items.size(); ++r) {
        const double depth = depths[r];
        if (filling.regions[r].count > 0 && joined[r] < (least_cells - 1e-6) * width) {
            build.warnings.push_back(to_string(Diagnostic{
                regions.items[r].place,
                fmt::format("the water is {:.3g} cells deep: every cell of it lies beside its surface or its "
                            "bed, and neither waves nor pressures in it are good",
                            depth / width),
                fmt::format("fluid.spacing of {:.3g} m makes it ten cells", 0.1 * depth)}));
        }
    }
}

}  // namespace

void warn_of_water_in_cells(CaseBuild& build, const Value& regions, const coupling::FieldScene& scene, double width) {
    const bool has_surface = norm(fluid::without_periodic(build.model.gravity.at(0), scene.domain)) > 0;
    if (!(width > 0) || scene.regions.empty() || !has_surface || !build.has_all_bodies) {
        return;
    }
    const std::optional<coupling::Filling> filling = places_of_water(build, scene, width);
    if (!filling || filling->particles.size() == 0) {
        return;
    }
    warn_of_shallow_regions(build, regions, *filling, width);
    warn_of_water_at_paddles(build, width, *filling);
}

}  // namespace riprap::scene
