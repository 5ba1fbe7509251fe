// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/point_in_body.hpp"

#include <fmt/format.h>

#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::scene {

bool is_in(const sim::Model& model, BodyId body, const Vec3& point, double tolerance) {
    const auto b = at(body.value);
    for (std::int32_t p = model.bodies.part_begin[b]; p < model.bodies.part_begin[b + 1]; ++p) {
        const body::Part& part = model.bodies.parts[at(p)];
        const geometry::ConvexView view = model.shapes.view(part.shape);
        const Vec3 x = rotate_back(part.local.orientation, point - part.local.position);
        const double size = std::isfinite(view.circumradius) ? view.circumradius : norm(x);
        if (contains(view, x, tolerance * size)) {
            return true;
        }
    }
    return false;
}

std::string holders_of(const CaseBuild& build, const Vec3& x) {
    std::string names;
    for (std::int32_t b = 0; b < build.model.bodies.size(); ++b) {
        if (is_in(build.model, BodyId{b}, build.point_of(BodyId{b}, x))) {
            names += fmt::format("{}'{}'", names.empty() ? "" : ", ", build.model.bodies.name(BodyId{b}));
        }
    }
    return names;
}

}  // namespace riprap::scene
