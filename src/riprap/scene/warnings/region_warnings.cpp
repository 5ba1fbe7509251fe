// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/coupling/hydrostatic/joint_cover.hpp"
#include "riprap/scene/case/placed_part.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"

namespace riprap::scene {

namespace {

/// The box of a body where it is at the start.
struct Box {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};

Box box_of(const CaseBuild& build, std::size_t b) {
    Box box;
    for (std::int32_t p = build.model.bodies.part_begin[b]; p < build.model.bodies.part_begin[b + 1]; ++p) {
        const PlacedPart part = placed(build, build.model.bodies.parts[at(p)]);
        for (std::int32_t v = 0; v < part.shape.vertex_count; ++v) {
            const Vec3 x = part.pose.position + rotate(part.pose.orientation, part.shape.vertex(v));
            box.low = min(box.low, x);
            box.high = max(box.high, x);
        }
    }
    return box;
}

}  // namespace

void warn_of_regions_at_faces(CaseBuild& build, const Value& regions, const coupling::HydrostaticSettings& settings) {
    const double slack = coupling::lies_on_share * settings.spacing;
    for (std::size_t r = 0; r < settings.basins.size() && r < regions.items.size(); ++r) {
        const coupling::HydrostaticSettings::Basin& basin = settings.basins[r];
        for (std::size_t b = 0; b < build.model.bodies.mass.size(); ++b) {
            if (!body::may_move(build.model.bodies, b) || !(build.model.bodies.mass[b] > 0)) {
                continue;
            }
            const Box box = box_of(build, b);
            for (int a = 0; a < (settings.is_planar ? 2 : 3); ++a) {
                const bool ends_here =
                    std::abs(basin.high[a] - box.low[a]) <= slack || std::abs(basin.low[a] - box.high[a]) <= slack;
                if (std::abs(settings.up[a]) < 0.5 && ends_here) {
                    build.warnings.push_back(to_string(Diagnostic{
                        regions.items[r].place,
                        fmt::format("the region ends at a face of '{}': once that has moved away by {:.3g} m, water "
                                    "presses on it no more",
                                    build.model.bodies.name(BodyId{static_cast<std::int32_t>(b)}), slack),
                        "a region that reaches as far as the water would follow"}));
                    return;  // one line for all
                }
            }
        }
    }
}

}  // namespace riprap::scene
