// SPDX-License-Identifier: Apache-2.0
// Densities in the wrong unit make a case that runs: blocks that weigh nothing are carried away by the first water.
#include <fmt/format.h>

#include <string_view>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/scene/warnings/density_warnings.hpp"

namespace riprap::scene {

namespace {

/// Foam starts at some 10 kg/m^3, liquids at 500; osmium has 22 600, mercury 13 600.
constexpr double lightest_solid = 5, lightest_liquid = 300, heaviest_solid = 23000, heaviest_liquid = 14000;

/// Returns the unit that a density outside of such limits may have been meant in.
std::string_view likely_unit(double density, double lightest) {
    return density < lightest ? "kg/m^3 are meant; others have their unit with them: \"2.4 t/m^3\""
                              : "kg/m^3 are meant, not the weight of a volume in N/m^3";
}

double volume_of(const CaseBuild& build, BodyId body) {
    const body::BodySet& bodies = build.model.bodies;
    double volume = 0;
    for (std::int32_t p = bodies.part_begin[at(body.value)]; p < bodies.part_begin[at(body.value) + 1]; ++p) {
        volume += build.model.shapes.volume(bodies.parts[at(p)].shape);
    }
    return volume;
}

void warn(CaseBuild& build, const SourcePlace& place, std::string message, std::string_view allowed) {
    build.warnings.push_back(to_string(Diagnostic{place, std::move(message), std::string(allowed)}));
}

}  // namespace

void warn_of_densities(CaseBuild& build) {
    const body::BodySet& bodies = build.model.bodies;
    std::int32_t told = -1;  // a name: copies are told of once
    for (std::int32_t i = 0; i < bodies.size(); ++i) {
        const double density =
            may_move(bodies, at(i)) ? bodies.mass[at(i)] / volume_of(build, BodyId{i}) : lightest_solid;
        if ((density < lightest_solid || density > heaviest_solid) && bodies.name_id[at(i)] != told) {
            told = bodies.name_id[at(i)];
            const std::string& name = bodies.names[at(told)];
            warn(build, build.names.at(name),
                 fmt::format("'{}' has a density of {:.4g} kg/m^3, as no solid has", name, density),
                 likely_unit(density, lightest_solid));
        }
    }
    if (build.model.particles() != nullptr) {
        const double density = build.model.particles()->settings().rest_density;
        if (density < lightest_liquid || density > heaviest_liquid) {
            warn(build, get(build.root, "fluid").place,
                 fmt::format("the water has a density of {:.4g} kg/m^3, as no liquid has", density),
                 likely_unit(density, lightest_liquid));
        }
    }
}

}  // namespace riprap::scene
