// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/gauge/gauge.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/fluid/gauge/interpolate.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {

namespace {

constexpr std::array<GaugeInfo, 8> infos{{{GaugeKind::pressure, "pressure", "Pa", 1},
                                          {GaugeKind::velocity, "velocity", "m/s", 3},
                                          {GaugeKind::level, "level", "m", 1},
                                          {GaugeKind::surface, "surface", "m", 1},
                                          {GaugeKind::run_up, "run_up", "m", 1},
                                          {GaugeKind::flow, "flow", "m^3/s", 1},
                                          {GaugeKind::volume, "volume", "m^3", 1},
                                          {GaugeKind::wall_pressure, "wall_pressure", "Pa", 1}}};

/// A line is looked at in steps of this share of the spacing.
constexpr double line_step = 0.25;

/// A unit vector normal to `up` and, in two dimensions, in the plane.
Vec3 across(const Vec3& up, int dimension) {
    if (dimension == 2) {
        return {up.y, -up.x, 0};
    }
    const Vec3 least = std::abs(up.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    return normalized(least - dot(least, up) * up);
}

double level(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state) {
    const bool is_planar = settings.domain.dimension == 2;
    const Vec3 first = across(gauge.up, settings.domain.dimension);
    const Vec3 second = cross(gauge.up, first);
    const auto weight_at = [&](const Vec3& d) {
        double weight = dot(d, gauge.up) < 0 ? 0.0 : spline_weight(dot(d, first), settings.spacing);
        if (weight > 0 && !is_planar) {
            weight *= spline_weight(dot(d, second), settings.spacing);
        }
        return weight;
    };
    const double rest_volume = settings.particle_mass / settings.rest_density;
    const PeriodicImages images(settings.domain);
    double sum = 0;
    for (std::size_t j = 0; j < state.position.size(); ++j) {
        const Vec3 d = images.nearest(state.position[j], gauge.point) - gauge.point;
        double weight = 0;
        for (const Vec3& shift : images.shifts()) {
            weight += weight_at(d + shift);
        }
        sum += weight > 0 ? rest_volume * weight : 0.0;
    }
    return sum;
}

/// Water fraction at equal steps along a line from its start to its end.
std::vector<double> fractions_along(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state) {
    const double length = norm(gauge.end - gauge.point);
    const auto steps = static_cast<std::int64_t>(std::ceil(length / (line_step * settings.spacing)));
    const Vec3 way = gauge.end - gauge.point;
    const std::vector<std::size_t> near = particles_near_line(gauge.point, gauge.end, settings, state);
    std::vector<double> fraction;
    for (std::int64_t i = 0; i <= steps; ++i) {
        const Vec3 x = gauge.point + static_cast<double>(i) / static_cast<double>(steps) * way;
        fraction.push_back(water_fraction(x, settings, state, near));
    }
    return fraction;
}

double crossing(const std::vector<double>& fraction, std::size_t i, double length) {
    const double share = (fraction[i] - 0.5) / (fraction[i] - fraction[i + 1]);
    return length * (static_cast<double>(i) + share) / static_cast<double>(fraction.size() - 1);
}

double surface(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state) {
    const std::vector<double> fraction = fractions_along(gauge, settings, state);
    const double length = norm(gauge.end - gauge.point);
    if (fraction.back() >= 0.5) {
        return length;
    }
    for (std::size_t i = fraction.size() - 1; i-- > 0;) {
        if (fraction[i] >= 0.5) {
            return crossing(fraction, i, length);
        }
    }
    return 0;
}

double run_up(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state) {
    const std::vector<double> fraction = fractions_along(gauge, settings, state);
    const double length = norm(gauge.end - gauge.point);
    for (std::size_t i = 0; i + 1 < fraction.size(); ++i) {
        if (fraction[i] < 0.5) {
            return 0;
        }
        if (fraction[i + 1] < 0.5) {
            return crossing(fraction, i, length);
        }
    }
    return length;
}

bool is_between(const Vec3& x, const Vec3& low, const Vec3& high, int skipped_axis, int dimension) {
    for (int axis = 0; axis < dimension; ++axis) {
        if (axis != skipped_axis && (x[axis] < low[axis] || x[axis] >= high[axis])) {
            return false;
        }
    }
    return true;
}

/// The axis along which a rectangle has no extent: that of its normal.
int normal_axis(const Gauge& gauge) {
    const Vec3 extent = gauge.end - gauge.point;
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
        axis = std::abs(extent[i]) < std::abs(extent[axis]) ? i : axis;
    }
    return axis;
}

double flow(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state) {
    const int axis = settings.domain.dimension == 2
                         ? (std::abs(gauge.end.x - gauge.point.x) < std::abs(gauge.end.y - gauge.point.y) ? 0 : 1)
                         : normal_axis(gauge);
    const double rest_volume = settings.particle_mass / settings.rest_density;
    const PeriodicImages images(settings.domain);
    double sum = 0;
    for (std::size_t j = 0; j < state.position.size(); ++j) {
        double weight = 0;
        for (const Vec3& shift : images.shifts()) {
            const Vec3 x = state.position[j] + shift;
            if (is_between(x, gauge.point, gauge.end, axis, settings.domain.dimension)) {
                weight = std::max(weight, spline_weight(x[axis] - gauge.point[axis], settings.spacing));
            }
        }
        sum += weight > 0 ? rest_volume * weight * state.velocity[j][axis] : 0.0;
    }
    return sum;
}

double volume(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state) {
    const double rest_volume = settings.particle_mass / settings.rest_density;
    const PeriodicImages images(settings.domain);
    double sum = 0;
    for (std::size_t j = 0; j < state.position.size(); ++j) {
        const auto is_in = [&](const Vec3& shift) {
            return is_between(state.position[j] + shift, gauge.point, gauge.end, -1, settings.domain.dimension);
        };
        if (std::any_of(images.shifts().begin(), images.shifts().end(), is_in)) {
            sum += rest_volume;
        }
    }
    return sum;
}

}  // namespace

std::span<const GaugeInfo> gauge_kinds() { return infos; }

const GaugeInfo& info_of(GaugeKind kind) { return infos[static_cast<std::size_t>(kind)]; }

const GaugeInfo* find_gauge_kind(std::string_view name) {
    for (const GaugeInfo& info : infos) {
        if (info.name == name) {
            return &info;
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

std::array<double, 3> read_gauge(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state) {
    switch (gauge.kind) {
        case GaugeKind::pressure:
            return {interpolate(gauge.point, settings, state,
                                [&](std::size_t j) { return pressure_of(settings, state.density[j]); }),
                    0, 0};
        case GaugeKind::velocity: {
            std::array<double, 3> v{};
            for (int axis = 0; axis < settings.domain.dimension; ++axis) {
                v[static_cast<std::size_t>(axis)] =
                    interpolate(gauge.point, settings, state, [&](std::size_t j) { return state.velocity[j][axis]; });
            }
            return v;
        }
        case GaugeKind::level:
            return {level(gauge, settings, state), 0, 0};
        case GaugeKind::surface:
            return {surface(gauge, settings, state), 0, 0};
        case GaugeKind::run_up:
            return {run_up(gauge, settings, state), 0, 0};
        case GaugeKind::flow:
            return {flow(gauge, settings, state), 0, 0};
        case GaugeKind::volume:
            return {volume(gauge, settings, state), 0, 0};
        case GaugeKind::wall_pressure:
            break;  // the forces on a face are not here
    }
    throw InternalError("a gauge that the water alone cannot read");
}

}  // namespace riprap::fluid
