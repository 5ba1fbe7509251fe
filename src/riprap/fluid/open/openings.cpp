// SPDX-License-Identifier: Apache-2.0
// Where openings are, and how water comes in by them.
#include <cmath>
#include <numbers>

#include "riprap/fluid/open/layers.hpp"
#include "riprap/fluid/open/open_boundary.hpp"

namespace riprap::fluid {

namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

bool Opening::is_across(const Vec3& x, int dimension) const {
    for (int other = 0; other < dimension; ++other) {
        if (other != axis && !(x[other] >= low[other] && x[other] <= high[other])) {
            return false;
        }
    }
    return true;
}

const Opening* opening_with_layers_at(const OpenBoundaries& open, const ParticleSettings& settings, const Vec3& x) {
    const double reach = static_cast<double>(layer_count(settings)) * settings.spacing;
    const auto is_behind = [&](const Opening& opening, double side) {
        const double past = side * opening.past(x);
        return past > 0 && past <= reach && opening.is_across(x, settings.domain.dimension);
    };
    for (const Inflow& inflow : open.inflows) {
        if (is_behind(inflow.opening, -1)) {
            return &inflow.opening;
        }
    }
    for (const Outflow& outflow : open.outflows) {
        if (outflow.kind != OutflowKind::free && is_behind(outflow.opening, 1)) {
            return &outflow.opening;
        }
    }
    return nullptr;
}

double Inflow::speed_at(double time) const {
    return time < ramp ? 0.5 * speed * (1 - std::cos(std::numbers::pi * time / ramp)) : speed;
}

double Inflow::acceleration_at(double time) const {
    return time < ramp ? 0.5 * speed * std::numbers::pi / ramp * std::sin(std::numbers::pi * time / ramp) : 0;
}

double Inflow::distance_at(double time) const {
    return time < ramp ? 0.5 * speed * (time - ramp / std::numbers::pi * std::sin(std::numbers::pi * time / ramp))
                       : speed * (time - 0.5 * ramp);
}

std::vector<Vec3> rows_of(const Opening& opening, const ParticleSettings& settings, const Vec3& up, double level) {
    std::array<std::int64_t, 3> count{1, 1, 1};
    for (int axis = 0; axis < settings.domain.dimension; ++axis) {
        const double extent = opening.high[axis] - opening.low[axis];
        count[at(axis)] =
            axis == opening.axis ? 1 : static_cast<std::int64_t>(std::floor(extent / settings.spacing + 1e-6));
    }
    std::vector<Vec3> rows;
    for (std::int64_t c = 0; c < count[2]; ++c) {
        for (std::int64_t b = 0; b < count[1]; ++b) {
            for (std::int64_t a = 0; a < count[0]; ++a) {
                Vec3 x = opening.low;
                const std::array<std::int64_t, 3> place{a, b, c};
                for (int axis = 0; axis < settings.domain.dimension; ++axis) {
                    x[axis] +=
                        axis == opening.axis ? 0 : (static_cast<double>(place[at(axis)]) + 0.5) * settings.spacing;
                }
                if (dot(up, x) + (0.5 - 1e-6) * settings.spacing <= level) {
                    rows.push_back(x);
                }
            }
        }
    }
    return rows;
}

}  // namespace riprap::fluid
