// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/scene/case/placed_part.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"

namespace riprap::scene {

namespace {

/// Tells whether some place of a side below the bed of its waves is in no solid. Looks at 16 places along each axis.
bool has_room_below(const CaseBuild& build, const fluid::Domain& domain, int side, int up, double bed) {
    constexpr int places = 16;
    const int axis = side / 2, beside = 3 - axis - up;
    Vec3 low = domain.low, high = domain.high;
    const double inside = 1e-3 * (high[axis] - low[axis]);
    const double end = side % 2 == 0 ? low[axis] + inside : high[axis] - inside;
    low[axis] = high[axis] = end;
    const PlacedSolids solids(build, build.is_dry, low, high);
    for (int i = 0; i < places * (domain.dimension == 3 ? places : 1); ++i) {
        Vec3 x{};
        x[axis] = end;
        x[up] = domain.low[up] + (i % places + 0.5) / places * (bed - domain.low[up]);
        if (domain.dimension == 3) {
            x[beside] = domain.low[beside] + (i / places + 0.5) / places * (domain.high[beside] - domain.low[beside]);
        }
        if (!solids.at(x, 0).is_valid()) {
            return true;
        }
    }
    return false;
}

}  // namespace

void warn_of_waves_over_depth(CaseBuild& build, const Value& waves, const coupling::FieldScene& scene) {
    int up = 0;
    for (int a = 1; a < 3; ++a) {
        up = std::abs(scene.up[a]) > std::abs(scene.up[up]) ? a : up;
    }
    if (scene.up[up] < 1 - 1e-9) {
        return;  // refused
    }
    double level = -1e300;
    for (const coupling::FillRegion& region : scene.regions) {
        level = std::max(level, std::min(region.level, top_of(region, scene.domain, scene.up)));
    }
    for (std::size_t i = 0; i < scene.waves.size(); ++i) {
        const coupling::WavesAtSide& wave = scene.waves[i];
        const double bed = level - wave.depth, below = bed - scene.domain.low[up];
        if (wave.side / 2 != up && below > 0.01 * wave.depth &&
            has_room_below(build, scene.domain, wave.side, up, bed)) {
            build.warnings.push_back(to_string(Diagnostic{
                waves.items[i].place,
                fmt::format("waves in {:.6g} m of water at the {} side of {}, where nothing solid fills the {:.4g} m "
                            "below: what comes in there moves as at the bed",
                            wave.depth, wave.side % 2 == 0 ? "low" : "high", "xyz"[wave.side / 2], below),
                fmt::format("a depth of {:.6g} m, or a bed", wave.depth + below)}));
        }
    }
}

}  // namespace riprap::scene
