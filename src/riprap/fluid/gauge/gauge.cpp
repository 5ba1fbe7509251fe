// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/gauge/gauge.hpp"

#include <cmath>

#include "riprap/fluid/gauge/gauge_kinds.hpp"

namespace riprap::fluid {

double lagged(double shown, double now, double dt, double response) {
    return shown - std::expm1(-dt / response) * (now - shown);
}

std::span<const GaugeKind* const> gauge_kinds() { return all_gauges; }

const GaugeKind* find_gauge_kind(std::string_view word) {
    for (const GaugeKind* kind : all_gauges) {
        if (kind->word == word) {
            return kind;
        }
    }
    return nullptr;
}

Gauge carried(const Gauge& gauge, std::span<const Vec3> position, std::span<const Quat> orientation) {
    Gauge out = gauge;
    if (gauge.carrier >= 0) {
        const auto body = static_cast<std::size_t>(gauge.carrier);
        const Pose pose{position[body], orientation[body]};
        out.point = to_world(pose, gauge.point);
        out.end = to_world(pose, gauge.end);
        out.carrier = -1;
    }
    return out;
}

}  // namespace riprap::fluid
