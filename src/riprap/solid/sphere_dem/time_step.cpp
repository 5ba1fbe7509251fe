// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/body/may_move.hpp"
#include "riprap/contact/law/hertz.hpp"
#include "riprap/contact/law/linear_spring.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Stiffest pair that a material takes part in.
contact::ContactPair stiffest_pair(const SphereModel& model, MaterialId material) {
    contact::ContactPair stiffest;
    for (std::int32_t other = 0; other < model.table.size(); ++other) {
        const contact::ContactPair& pair = model.table.pair(material, MaterialId{other});
        stiffest.modulus = std::max(stiffest.modulus, pair.modulus);
        stiffest.normal_stiffness = std::max(stiffest.normal_stiffness, pair.normal_stiffness);
    }
    return stiffest;
}

double smallest_radius(const SphereSet& spheres, std::size_t body) {
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t s = spheres.begin[body]; s < spheres.begin[body + 1]; ++s) {
        least = std::min(least, spheres.curvature[at(s)]);
    }
    return least;
}

/// Mass of the lightest body that moves and whose surface the samples of another one meet; infinity without such [kg].
double lightest_sampled(const SphereModel& model) {
    double least = std::numeric_limits<double>::infinity();
    std::int32_t count = 0;
    for (std::int32_t b = 0; b < model.bodies.size(); ++b) {
        const bool may_meet = may_move(model.bodies, at(b)) && model.spheres.count_of(b) > 0;
        count += may_meet ? 1 : 0;
        least = may_meet && model.spheres.is_sampled[at(b)] != 0 ? std::min(least, model.bodies.mass[at(b)]) : least;
    }
    return count > 1 ? least : std::numeric_limits<double>::infinity();
}

/// Least effective mass that a sphere may meet at the surface of a body that moves and is no sphere, 1/m_e = 1/m +
/// R^2/I, R the farthest point from the centre of mass and I the least principal moment, and of one that is sampled,
/// m_e = m as for its spheres; infinity without such [kg].
double lightest_face(const SphereModel& model) {
    const body::BodySet& bodies = model.bodies;
    double least = lightest_sampled(model);
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        if (!may_move(bodies, at(b)) || model.spheres.count_of(b) > 0) {
            continue;
        }
        const double reach = reach_of(bodies, model.shapes, b);
        const Vec3& moments = bodies.principal_moments[at(b)];
        const double moment = bodies.is_planar ? moments.z : std::min({moments.x, moments.y, moments.z});
        least = std::min(least, 1 / (1 / bodies.mass[at(b)] + reach * reach / moment));
    }
    return least;
}

/// Impact of a body's smallest sphere that the step has to resolve.
struct Impact {
    double modulus, stiffness;         ///< E* [Pa] and k [N/m] of the stiffest pair of materials
    double radius, mass, beside_face;  ///< R, m and effective mass against a body that is no sphere [m, kg]
    double speed;                      ///< v [m/s]
    double flat;                       ///< springs side by side [-]
    bool operator==(const Impact&) const = default;
};

double duration_of(const Impact& impact, contact::NormalLaw law) {
    const double light = std::min(0.5 * impact.mass, impact.beside_face);
    const bool is_linear = law == contact::NormalLaw::linear;
    const double alone =
        is_linear
            ? contact::linear_contact_time(impact.stiffness, light, 0)
            : std::min(
                  contact::hertz_contact_time(impact.modulus, 0.5 * impact.radius, 0.5 * impact.mass, impact.speed),
                  contact::hertz_contact_time(impact.modulus, impact.radius, impact.beside_face, impact.speed));
    // N springs side by side: an impact lasts N^(-2/5) as long by Hertz, N^(-1/2) on linear springs.
    return alone * std::pow(impact.flat, is_linear ? -0.5 : -0.4);
}

/// Grows with duration_of and takes no power: its square (linear) or its 5/2 th power (Hertz) but for a constant.
double order_of(const Impact& impact, contact::NormalLaw law) {
    if (law == contact::NormalLaw::linear) {
        return std::min(0.5 * impact.mass, impact.beside_face) / (impact.stiffness * impact.flat);
    }
    const double lightness =
        std::min(0.5 * impact.mass / std::sqrt(0.5 * impact.radius), impact.beside_face / std::sqrt(impact.radius));
    return lightness / (impact.modulus * std::sqrt(impact.speed) * impact.flat);
}

/// A body by what is least of it; of equal bodies the first.
struct Least {
    double value;
    std::int32_t body;
};

Least lesser(const Least& a, const Least& b) { return b.value < a.value ? b : a; }

}  // namespace

double fastest_point(const SphereModel& model, const body::BodyState& state) {
    const auto speed_of = [&](std::int64_t i) {
        const BodyId body{static_cast<std::int32_t>(i)};
        const double speed = norm(state.velocity[at(i)]);
        const bool is_ball =
            model.spheres.count_of(body.value) == 1 && model.spheres.local[at(model.spheres.begin[at(i)])] == Vec3{};
        if (is_ball || state.angular_momentum[at(i)] == Vec3{}) {
            return speed;
        }
        const double reach = reach_of(model.bodies, model.shapes, body.value);
        return speed + norm(angular_velocity(model.bodies, state, body)) * reach;
    };
    return parallel::reduce(state.size(), 0.0, speed_of, [](double a, double b) { return std::max(a, b); });
}

SphereStep step_limit(const SphereModel& model, const body::BodyState& state, double gravity) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const contact::NormalLaw law = model.settings.normal;
    const double fast = 2 * fastest_point(model, state), face = lightest_face(model);
    const bool adds_up =
        model.settings.sharing == contact::Sharing::dashpots || model.settings.sharing == contact::Sharing::sum;
    std::vector<contact::ContactPair> pairs;
    for (std::int32_t m = 0; m < model.table.size(); ++m) {
        pairs.push_back(stiffest_pair(model, MaterialId{m}));
    }
    const auto is_in = [&](std::int64_t b) {
        return may_move(model.bodies, at(b)) && model.spheres.count_of(static_cast<std::int32_t>(b)) > 0;
    };
    const auto impact_of = [&](std::int64_t b) {
        const double radius = smallest_radius(model.spheres, at(b)), mass = model.bodies.mass[at(b)];
        const contact::ContactPair& pair = pairs[at(model.bodies.material[at(b)].value)];
        return Impact{.modulus = pair.modulus,
                      .stiffness = pair.normal_stiffness,
                      .radius = radius,
                      .mass = mass,
                      .beside_face = mass / (1 + mass / face),
                      .speed = std::max({fast, std::sqrt(4 * gravity * radius), 1e-6}),
                      .flat = adds_up ? static_cast<double>(model.spheres.flat_count[at(b)]) : 1.0};
    };
    const auto least_of = [&](const auto& value_of) {
        const auto one = [&](std::int64_t b) {
            return is_in(b) ? Least{value_of(impact_of(b)), static_cast<std::int32_t>(b)} : Least{never, 0};
        };
        return parallel::reduce(model.bodies.size(), Least{never, 0}, one, lesser);
    };
    const Least nearly = least_of([&](const Impact& impact) { return order_of(impact, law); });
    if (!std::isfinite(nearly.value)) {
        return {never, {}, "no sphere can touch another"};
    }
    // Powers are for those that round-off could put first, and only once for all that are alike.
    const Impact shortest = impact_of(nearly.body);
    const double duration = duration_of(shortest, law), hardly_longer = nearly.value * (1 + 1e-9);
    const Least exactly = least_of([&](const Impact& impact) {
        return impact == shortest ? duration : order_of(impact, law) > hardly_longer ? never : duration_of(impact, law);
    });
    const BodyId body{exactly.body};
    return {exactly.value / model.settings.steps_per_contact, body,
            "duration of an impact of " + model.bodies.name(body)};
}

}  // namespace riprap::solid::sphere_dem
