// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/default_scales.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"

namespace riprap::solid::affine {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Acceleration of a block and where it comes from.
struct Pull {
    double value{0};  ///< [m/s^2]
    const char* why{""};
};

double volume_of(const SolidScene& scene, std::size_t body) {
    double sum = 0;
    for (std::int32_t p = scene.bodies.part_begin[body]; p < scene.bodies.part_begin[body + 1]; ++p) {
        sum += scene.shapes.volume(scene.bodies.parts[at(p)].shape);
    }
    return sum;
}

/// Half of the edge of a cube, in the plane of a square, as large as the body; infinite for half-spaces [m].
double radius_of(const SolidScene& scene, std::size_t body) {
    const double volume = volume_of(scene, body);
    return 0.5 * (scene.bodies.is_planar ? std::sqrt(volume) : std::cbrt(volume));
}

/// Speed of the fastest corner at most: that of the centre and that of turning [m/s].
double speed_of(const SolidScene& scene, const body::BodyState& bodies, std::size_t body) {
    const Vec3 spin = body::angular_velocity(scene.bodies, bodies, BodyId{static_cast<std::int32_t>(body)});
    double turning = 0;
    if (norm(spin) > 0) {
        const Vec3 own = rotate_back(bodies.orientation[body], spin);
        for (std::int32_t p = scene.bodies.part_begin[body]; p < scene.bodies.part_begin[body + 1]; ++p) {
            const body::Part& part = scene.bodies.parts[at(p)];
            const geometry::ConvexView shape = scene.shapes.view(part.shape);
            for (int v = 0; v < shape.vertex_count; ++v) {
                const Vec3 corner = part.local.position + rotate(part.local.orientation, shape.vertex(v));
                turning = std::max(turning, norm(cross(own, corner)));
            }
        }
    }
    return norm(bodies.velocity[body]) + turning;
}

/// Sums the sizes of the loads and of the tension of bolts on each body [N].
std::vector<double> forces_on(const SolidScene& scene, const body::BodyState& bodies) {
    std::vector<double> sums(at(scene.bodies.size()), 0);
    for (const body::PointLoad& load : scene.point_loads) {
        double largest = load.table ? 0 : norm(load.force);
        for (const Vec3& force : load.table ? load.table->force : std::vector<Vec3>{}) {
            largest = std::max(largest, norm(force));
        }
        sums[at(load.body.value)] += largest;
    }
    const auto place = [&bodies](BodyId body, const Vec3& point) {
        return bodies.position[at(body.value)] + rotate(bodies.orientation[at(body.value)], point);
    };
    for (const body::Bolt& bolt : scene.bolts) {
        const double length = norm(place(bolt.second, bolt.second_point) - place(bolt.first, bolt.first_point));
        const double tension = bolt.stiffness * std::abs(length - bolt.rest_length);
        sums[at(bolt.first.value)] += tension;
        sums[at(bolt.second.value)] += tension;
    }
    return sums;
}

/// Tells what all blocks that may move weigh on the lowest of them.
struct Pile {
    double mass{0};    ///< [kg]
    double height{0};  ///< from the lowest centre to the highest, along gravity [m]

    /// Returns how many blocks of this mass and half edge one of them may carry, itself among them [-].
    double layers(double of_mass, double radius) const {
        return std::max(1.0, std::min(mass / of_mass, 1 + height / (2 * radius)));
    }
};

Pile pile_of(const SolidScene& scene, const body::BodyState& bodies) {
    const double gravity = norm(scene.gravity.value);
    const Vec3 up = gravity > 0 ? -1 / gravity * scene.gravity.value : Vec3{};
    Pile pile;
    double low = infinity, high = -infinity;
    for (std::size_t b = 0; b < at(scene.bodies.size()); ++b) {
        if (body::may_move(scene.bodies, b)) {
            pile.mass += scene.bodies.mass[b];
            low = std::min(low, dot(up, bodies.position[b]));
            high = std::max(high, dot(up, bodies.position[b]));
        }
    }
    pile.height = std::max(0.0, high - low);
    return pile;
}

/// Tells whether something moves bodies that default_scales() does not look at.
bool has_movers(const SolidScene& scene, bool has_water) {
    return has_water || std::ranges::any_of(scene.bodies.drive, [](body::Drive d) { return d == body::Drive::driven; });
}

}  // namespace

DefaultScales default_scales(const SolidScene& scene, const body::BodyState& bodies, bool has_water) {
    const std::vector<double> forces = forces_on(scene, bodies);
    const Pull gravity{norm(scene.gravity.value), "its weight"};
    const Pull least =
        gravity.value == 0 && has_movers(scene, has_water) ? Pull{standard_pull, "standard gravity"} : gravity;
    const Pile pile = pile_of(scene, bodies);
    DefaultScales found;
    const auto look = [&](std::size_t b, double radius, const Pull& pull) {
        const double mass = scene.bodies.mass[b], layers = pile.layers(mass, radius);
        const bool carries = gravity.value * layers > pull.value;
        const double load = mass * std::max(pull.value, gravity.value * layers);
        const std::string text =
            fmt::format("of '{}', R = {:.3g} m, a = {:.3g} m/s^2 by {}",
                        scene.bodies.name(BodyId{static_cast<std::int32_t>(b)}), radius, pull.value, pull.why);
        const double stiffness = springs_per_radius * load / radius;
        const double step = step_per_radian * std::sqrt(radius / (springs_per_radius * pull.value));
        if (stiffness > found.stiffness) {
            found.stiffness = stiffness;
            found.of_stiffness = fmt::format("{:g} m a/R {}", springs_per_radius, text);
            if (carries && layers > 1) {
                found.of_stiffness += fmt::format(", under the weight of {:.3g} such blocks", layers);
            }
        }
        const double modulus =
            std::min(modulus_of_rock, modulus_per_pressure * mass / volume_of(scene, b) * pull.value * radius);
        if (modulus > found.modulus) {
            found.modulus = modulus;
            found.of_modulus =
                modulus < modulus_of_rock ? fmt::format("{:g} rho a R {}", modulus_per_pressure, text) : "that of rock";
        }
        if (found.step == 0 || step < found.step) {
            found.step = step;
            found.of_step = fmt::format("{:g} sqrt(R/({:g} a)) {}", step_per_radian, springs_per_radius, text);
        }
    };
    const auto look_at_all = [&](const Pull& given) {
        for (std::size_t b = 0; b < at(scene.bodies.size()); ++b) {
            const double radius = radius_of(scene, b), mass = scene.bodies.mass[b];
            if (!body::may_move(scene.bodies, b) || !std::isfinite(radius) || !(radius > 0) || !(mass > 0)) {
                continue;
            }
            const double speed = speed_of(scene, bodies, b);
            const Pull pull =
                std::max({given, Pull{forces[b] / mass, "its loads"}, Pull{speed * speed / (4 * radius), "its speed"}},
                         [](const Pull& a, const Pull& other) { return a.value < other.value; });
            if (pull.value > 0) {
                look(b, radius, pull);
            }
        }
    };
    look_at_all(least);
    if (found.stiffness == 0) {
        look_at_all({standard_pull, "standard gravity"});
    }
    const std::string still = "no block moves";
    return found.stiffness > 0 ? found : DefaultScales{1e8, 1e-3, modulus_of_rock, still, still, still};
}

}  // namespace riprap::solid::affine
