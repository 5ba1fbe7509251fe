// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/stiffness_range.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"

namespace riprap::solid::affine {

std::vector<SceneProblem> softness_problems(const SolidScene& scene, const Elasticity& elasticity) {
    const double gravity = norm(scene.gravity.value);
    double least = 0;
    BodyId of{};
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        const body::Part& part = scene.bodies.parts[at(scene.bodies.part_begin[at(b)])];
        if (body::may_move(scene.bodies, at(b)) && !scene.shapes.is_half_space(part.shape)) {
            const double needed = scene.bodies.mass[at(b)] * gravity / scene.shapes.view(part.shape).circumradius;
            of = needed > least ? BodyId{b} : of;
            least = std::max(least, needed);
        }
    }
    if (corner_stiffness(scene, elasticity) >= least) {
        return {};
    }
    if (elasticity.stiffness_per_area) {
        return {{{},
                 fmt::format("contact_stiffness_per_area is {:.3g} Pa/m: on one corner '{}' sinks in by more than its "
                             "radius",
                             *elasticity.stiffness_per_area, scene.bodies.name(of)),
                 fmt::format("at least {:.3g} Pa/m, and a thousand times that for overlaps of a per mille",
                             least / least_contact_area(scene))}};
    }
    return {{{},
             fmt::format("contact_stiffness is {:.3g} N/m: on one corner '{}' sinks in by more than its radius",
                         elasticity.contact_stiffness, scene.bodies.name(of)),
             fmt::format("at least {:.3g} N/m, its weight over its radius, and a thousand times that for overlaps of a "
                         "per mille",
                         least)}};
}

namespace {

/// Tells of shear stiffnesses of points beside normal ones per area.
void add_point_shear(const SolidScene& scene, std::vector<SceneProblem>& problems) {
    for (int a = 0; a < scene.materials.size(); ++a) {
        for (int b = a; b < scene.materials.size(); ++b) {
            if (const double shear = scene.materials.pair(MaterialId{a}, MaterialId{b}).shear_stiffness; shear > 0) {
                problems.push_back({{},
                                    fmt::format("contact_stiffness_per_area stands beside a shear stiffness of {:.3g} "
                                                "N/m of a point",
                                                shear),
                                    "shear_ratio of the material"});
                return;
            }
        }
    }
}

}  // namespace

std::vector<SceneProblem> stiffness_problems(const SolidScene& scene, const Elasticity& elasticity) {
    const double radius = smallest_radius(scene);
    if (radius == 0) {
        return softness_problems(scene, elasticity);
    }
    if (elasticity.stiffness_per_area) {
        const double limit = 1e6 * elasticity.youngs_modulus / radius;  // of a face as wide as the radius
        if (*elasticity.stiffness_per_area > limit) {
            return {{{},
                     fmt::format("contact_stiffness_per_area is {:.3g} Pa/m", *elasticity.stiffness_per_area),
                     fmt::format("at most {:.3g} Pa/m: 1e6 E/r, r the radius of the smallest block", limit)}};
        }
        std::vector<SceneProblem> problems = softness_problems(scene, elasticity);
        add_point_shear(scene, problems);
        return problems;
    }
    const double limit = 1e6 * elasticity.youngs_modulus * radius;
    if (elasticity.contact_stiffness <= limit) {
        return softness_problems(scene, elasticity);
    }
    return {{{},
             fmt::format("contact_stiffness is {:.3g} N/m", elasticity.contact_stiffness),
             fmt::format("at most {:.3g} N/m: 1e6 E r, r the radius of the smallest block", limit)}};
}

}  // namespace riprap::solid::affine
