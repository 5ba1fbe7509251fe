// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/default_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/sphere_dem/sample_bodies.hpp"

namespace riprap::solid::sphere_dem {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Twice the least inscribed radius of the parts of a body [m].
double size_of(const SolidScene& scene, std::int32_t body) {
    double least = infinity;
    for (std::int32_t p = scene.bodies.part_begin[at(body)]; p < scene.bodies.part_begin[at(body) + 1]; ++p) {
        least = std::min(least, scene.shapes.view(scene.bodies.parts[at(p)].shape).inscribed_radius);
    }
    return 2 * least;
}

double least_radius(const SphereSet& spheres, std::int32_t body) {
    double least = infinity;
    for (std::int32_t s = spheres.begin[at(body)]; s < spheres.begin[at(body) + 1]; ++s) {
        least = std::min(least, spheres.curvature[at(s)]);
    }
    return least;
}

/// Least portion of the samples of corners, by which their springs count; of a ball the whole [-].
double least_portion(const SphereSet& spheres, std::int32_t body) {
    double least = 1;
    for (std::int32_t s = spheres.begin[at(body)]; s < spheres.begin[at(body) + 1]; ++s) {
        least = spheres.is_sharp(s) ? std::min(least, spheres.portion[at(s)]) : least;
    }
    return least;
}

/// E* of two surfaces of one material over E [-].
double effective_share(const SphereDemSettings& settings) {
    return 0.5 / (1 - settings.poisson_ratio * settings.poisson_ratio);
}

}  // namespace

ContactDuty contact_duty(const SolidScene& scene, const SphereDemSettings& settings, const body::BodyState& state,
                         double speed) {
    const SphereSet spheres = sample_bodies(scene, settings);
    const double gravity = norm(scene.gravity.value);
    const Vec3 up = gravity > 0 ? -1 / gravity * scene.gravity.value : Vec3{};
    ContactDuty duty{.speed = speed, .size = infinity, .radius = infinity};
    double all = 0, heaviest = 0, low = infinity, high = -infinity;
    bool has_balls = false;
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        if (!may_move(scene.bodies, at(b)) || spheres.count_of(b) == 0) {
            continue;
        }
        const double mass = scene.bodies.mass[at(b)], size = size_of(scene, b), radius = least_radius(spheres, b);
        const double depth = impact_share * size, portion = least_portion(spheres, b);
        all += mass;
        heaviest = std::max(heaviest, mass);
        low = std::min(low, dot(up, state.position[at(b)]));
        high = std::max(high, dot(up, state.position[at(b)]));
        has_balls = has_balls || spheres.count_of(b) == 1;
        duty.size = std::min(duty.size, size);
        duty.radius = std::min(duty.radius, radius);
        duty.impact =
            std::max(duty.impact, mass * speed * speed / (portion * std::sqrt(radius) * std::pow(depth, 2.5)));
        duty.spring = std::max(duty.spring, mass * speed * speed / (portion * depth * depth));
    }
    if (all > 0) {
        const double of_edge = has_balls ? 1 : scene.bodies.is_planar ? 0.5 : 0.25 * duty.size / duty.radius;
        duty.load = gravity * std::min(all, heaviest * (1 + (high - low) / duty.size)) / of_edge;
    }
    return duty;
}

double static_overlap(const ContactDuty& duty, const SphereDemSettings& settings) {
    if (settings.laws.normal == contact::NormalLaw::linear) {
        return duty.load / spring_of(settings);
    }
    const double modulus = effective_share(settings) * modulus_of(settings);
    return std::pow(0.75 * duty.load / (modulus * std::sqrt(duty.radius)), 2.0 / 3);
}

SphereDemSettings completed(const SolidScene& scene, const SphereDemSettings& settings, const body::BodyState& state,
                            double speed) {
    SphereDemSettings all = settings;
    const bool is_hertz = settings.laws.normal == contact::NormalLaw::hertz;
    if ((is_hertz ? settings.youngs_modulus : settings.spring_stiffness) > 0) {
        return all;  // the other one is not read
    }
    const ContactDuty duty = contact_duty(scene, settings, state, speed);
    double modulus = least_modulus, stiffness = least_stiffness;
    if (duty.load > 0 || duty.impact > 0) {
        const double depth = static_share * duty.size;
        const double at_rest = 0.75 * duty.load / (std::sqrt(duty.radius) * std::pow(depth, 1.5));
        modulus = std::max(modulus, std::max(at_rest, 15.0 / 16 * duty.impact) / effective_share(settings));
        stiffness = std::max({stiffness, duty.load / depth, duty.spring});
    }
    all.youngs_modulus = settings.youngs_modulus > 0 ? settings.youngs_modulus : modulus;
    all.spring_stiffness = settings.spring_stiffness > 0 ? settings.spring_stiffness : stiffness;
    return all;
}

}  // namespace riprap::solid::sphere_dem
