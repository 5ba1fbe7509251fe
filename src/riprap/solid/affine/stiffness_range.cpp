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
    if (elasticity.contact_stiffness >= least) {
        return {};
    }
    return {{{},
             fmt::format("contact_stiffness is {:.3g} N/m: on one corner '{}' sinks in by more than its radius",
                         elasticity.contact_stiffness, scene.bodies.name(of)),
             fmt::format("at least {:.3g} N/m, its weight over its radius, and a thousand times that for overlaps of a "
                         "per mille",
                         least)}};
}

std::vector<SceneProblem> stiffness_problems(const SolidScene& scene, const Elasticity& elasticity) {
    double smallest = 0;
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        const body::Part& part = scene.bodies.parts[at(scene.bodies.part_begin[at(b)])];
        if (body::may_move(scene.bodies, at(b)) && !scene.shapes.is_half_space(part.shape)) {
            const double radius = scene.shapes.view(part.shape).circumradius;
            smallest = smallest > 0 ? std::min(smallest, radius) : radius;
        }
    }
    const double limit = 1e6 * elasticity.youngs_modulus * smallest;
    if (smallest == 0 || elasticity.contact_stiffness <= limit) {
        return softness_problems(scene, elasticity);
    }
    return {{{},
             fmt::format("contact_stiffness is {:.3g} N/m", elasticity.contact_stiffness),
             fmt::format("at most {:.3g} N/m: 1e6 E r, r the radius of the smallest block", limit)}};
}

}  // namespace riprap::solid::affine
