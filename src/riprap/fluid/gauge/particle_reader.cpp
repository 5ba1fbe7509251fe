// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/gauge/particle_reader.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/selection.hpp"
#include "riprap/fluid/gauge/box_shares.hpp"
#include "riprap/fluid/gauge/interpolate.hpp"
#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"

namespace riprap::fluid {

namespace {

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

/// Water fraction at equal steps along a line from its start to its end, looked up one by one: a line may be far longer
/// than the water is wide.
class FractionsAlong {
 public:
    FractionsAlong(const Vec3& start, const Vec3& end, const ParticleSettings& settings, const ParticleState& state)
        : start_(start),
          way_(end - start),
          settings_(settings),
          state_(state),
          near_(particles_near_line(start, end, settings, state)),
          steps_(std::max<std::int64_t>(
              1, static_cast<std::int64_t>(std::ceil(norm(way_) / (line_step * settings.spacing))))) {
        find_range();
    }
    std::int64_t steps() const { return steps_; }
    /// Beyond these the line is dry.
    std::int64_t first() const { return first_; }
    std::int64_t last() const { return last_; }
    double operator()(std::int64_t i) const {
        const Vec3 x = start_ + static_cast<double>(i) / static_cast<double>(steps_) * way_;
        return water_fraction(x, settings_, state_, near_);
    }
    /// Where the fraction is a half between the samples i and i + 1 with these fractions [m].
    double crossing(std::int64_t i, double here, double there) const {
        const double share = (here - 0.5) / (here - there);
        return norm(way_) * (static_cast<double>(i) + share) / static_cast<double>(steps_);
    }

 private:
    /// Cuts the line at a reach from the box around all particles, along axes without a period.
    void find_range() {
        const Box box = box_of(state_.position);
        const Domain& domain = settings_.domain;
        double low = 0, high = near_.empty() ? -1 : 1;  // as shares of the line
        for (int axis = 0; axis < domain.dimension && !near_.empty(); ++axis) {
            if (way_[axis] == 0 || domain.is_periodic[static_cast<std::size_t>(axis)]) {
                continue;
            }
            const double reach = settings_.support_radius();
            const double a = (box.low[axis] - reach - start_[axis]) / way_[axis];
            const double b = (box.high[axis] + reach - start_[axis]) / way_[axis];
            low = std::max(low, std::min(a, b));
            high = std::min(high, std::max(a, b));
        }
        const auto steps = static_cast<double>(steps_);
        first_ = low <= high ? static_cast<std::int64_t>(std::floor(low * steps)) : 0;
        last_ = low <= high ? static_cast<std::int64_t>(std::ceil(high * steps)) : -1;
    }

    Vec3 start_, way_;
    const ParticleSettings& settings_;
    const ParticleState& state_;
    std::vector<std::size_t> near_;
    std::int64_t steps_, first_{0}, last_{-1};
};

/// Samples of a line that are looked at, at most: one along a period repeats itself long before.
constexpr std::int64_t most_samples = 1'000'000;

bool is_between(const Vec3& x, const Vec3& low, const Vec3& high, int skipped_axis, int dimension) {
    for (int axis = 0; axis < dimension; ++axis) {
        if (axis != skipped_axis && (x[axis] < low[axis] || x[axis] >= high[axis])) {
            return false;
        }
    }
    return true;
}

/// The axis along which a rectangle has no extent: that of its normal.
int normal_axis(const Vec3& extent) {
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
        axis = std::abs(extent[i]) < std::abs(extent[axis]) ? i : axis;
    }
    return axis;
}

}  // namespace

double ParticleReader::pressure(const Vec3& x) const {
    return interpolate(x, settings_, state_, [&](std::size_t j) { return pressure_of(settings_, state_.density[j]); });
}

Vec3 ParticleReader::velocity(const Vec3& x) const {
    Vec3 v{};
    for (int axis = 0; axis < settings_.domain.dimension; ++axis) {
        v[axis] = interpolate(x, settings_, state_, [&](std::size_t j) { return state_.velocity[j][axis]; });
    }
    return v;
}

double ParticleReader::level(const Vec3& x, const Vec3& up) const {
    const bool is_planar = settings_.domain.dimension == 2;
    const Vec3 first = across(up, settings_.domain.dimension);
    const Vec3 second = cross(up, first);
    const auto weight_at = [&](const Vec3& d) {
        double weight = dot(d, up) < 0 ? 0.0 : spline_weight(dot(d, first), settings_.spacing);
        if (weight > 0 && !is_planar) {
            weight *= spline_weight(dot(d, second), settings_.spacing);
        }
        return weight;
    };
    const double rest_volume = settings_.particle_mass / settings_.rest_density;
    const PeriodicImages images(settings_.domain);
    const auto weight_of = [&](std::size_t j) {
        const Vec3 d = images.nearest(state_.position[j], x) - x;
        double weight = 0;
        for (const Vec3& shift : images.shifts()) {
            weight += weight_at(d + shift);
        }
        return weight;
    };
    double sum = 0;
    for (const std::size_t j : parallel::select(state_.size(), [&](std::size_t j) { return weight_of(j) > 0; })) {
        sum += rest_volume * weight_of(j);
    }
    return sum;
}

double ParticleReader::surface(const Vec3& start, const Vec3& end) const {
    const FractionsAlong fraction(start, end, settings_, state_);
    double beyond = fraction.last() >= 0 ? fraction(fraction.last()) : 0;
    if (fraction.last() == fraction.steps() && beyond >= 0.5) {
        return norm(end - start);
    }
    const std::int64_t lowest = std::max(fraction.first(), fraction.last() - most_samples);
    for (std::int64_t i = fraction.last() - 1; i >= lowest; --i) {
        const double here = fraction(i);
        if (here >= 0.5) {
            return fraction.crossing(i, here, beyond);
        }
        beyond = here;
    }
    return 0;
}

double ParticleReader::run_up(const Vec3& start, const Vec3& end) const {
    const FractionsAlong fraction(start, end, settings_, state_);
    double here = fraction.first() == 0 && fraction.last() >= 0 ? fraction(0) : 0;
    if (here < 0.5) {
        return 0;
    }
    for (std::int64_t i = 0; i < std::min(fraction.last(), most_samples); ++i) {
        const double there = fraction(i + 1);
        if (there < 0.5) {
            return fraction.crossing(i, here, there);
        }
        here = there;
    }
    return norm(end - start);
}

double ParticleReader::flow(const Vec3& low, const Vec3& high) const {
    const int axis = settings_.domain.dimension == 2 ? (std::abs(high.x - low.x) < std::abs(high.y - low.y) ? 0 : 1)
                                                     : normal_axis(high - low);
    const double rest_volume = settings_.particle_mass / settings_.rest_density;
    const PeriodicImages images(settings_.domain);
    const auto weight_of = [&](std::size_t j) {
        double weight = 0;
        for (const Vec3& shift : images.shifts()) {
            const Vec3 x = state_.position[j] + shift;
            if (is_between(x, low, high, axis, settings_.domain.dimension)) {
                weight = std::max(weight, spline_weight(x[axis] - low[axis], settings_.spacing));
            }
        }
        return weight;
    };
    double sum = 0;
    for (const std::size_t j : parallel::select(state_.size(), [&](std::size_t j) { return weight_of(j) > 0; })) {
        sum += rest_volume * weight_of(j) * state_.velocity[j][axis];
    }
    return sum;
}

double ParticleReader::volume(const Vec3& low, const Vec3& high) const {
    BoxShares shares(low, high, settings_.spacing, settings_.domain.dimension);
    const PeriodicImages images(settings_.domain);
    const auto is_near = [&](std::size_t j) {
        return std::any_of(images.shifts().begin(), images.shifts().end(),
                           [&](const Vec3& shift) { return shares.is_near(state_.position[j] + shift); });
    };
    const std::vector<std::size_t> near = parallel::select(state_.size(), is_near);
    for (const std::size_t j : near) {
        for (const Vec3& shift : images.shifts()) {
            if (const Vec3 x = state_.position[j] + shift; shares.is_near(x)) {
                shares.note(x);
            }
        }
    }
    double sum = 0;
    for (const std::size_t j : near) {
        double share = 0;
        for (const Vec3& shift : images.shifts()) {
            share += shares.share(state_.position[j] + shift);
        }
        sum += std::min(1.0, share);  // a box longer than a period holds it once
    }
    return settings_.particle_mass / settings_.rest_density * sum;
}

std::vector<std::size_t> ParticleReader::inside(const Vec3& low, const Vec3& high) const {
    return parallel::select(state_.size(), [&](std::size_t j) { return is_inside(j, low, high); });
}

bool ParticleReader::is_inside(std::size_t particle, const Vec3& low, const Vec3& high) const {
    const PeriodicImages images(settings_.domain);
    return std::any_of(images.shifts().begin(), images.shifts().end(), [&](const Vec3& shift) {
        return is_between(state_.position[particle] + shift, low, high, -1, settings_.domain.dimension);
    });
}

Vec3 ParticleReader::mean_of(const std::vector<Vec3>& field, const Vec3& low, const Vec3& high) const {
    Vec3 sum{};
    double count = 0;
    for (const std::size_t j : inside(low, high)) {
        sum += field[j];
        count += 1;
    }
    return count > 0 ? sum / count : sum;
}

Vec3 ParticleReader::centre(const Vec3& low, const Vec3& high) const { return mean_of(state_.position, low, high); }

Vec3 ParticleReader::mean_velocity(const Vec3& low, const Vec3& high) const {
    return mean_of(state_.velocity, low, high);
}

GaugeReading read_gauge(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state) {
    return gauge.kind->read(gauge, ParticleReader(settings, state));
}

}  // namespace riprap::fluid
