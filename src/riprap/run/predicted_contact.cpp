// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/predicted_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/run/remedy_text.hpp"
#include "riprap/run/tipping_bias.hpp"
#include "riprap/scene/warnings/hard_impacts.hpp"
#include "riprap/sim/methods.hpp"
#include "riprap/solid/sphere_dem/sample_bodies.hpp"

namespace riprap::run {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Bodies times parts that are looked at for first meetings.
constexpr double most_pairs = 2e7;

/// Spring of a flat contact: F = K d, or C d^(3/2) of spheres by Hertz' law.
struct Spring {
    double linear{0};  ///< K [N/m]
    double hertz{0};   ///< C [N/m^1.5]
    bool is_of_faces{true};

    double at_rest(double load) const { return linear > 0 ? load / linear : std::pow(load / hertz, 2.0 / 3); }
    /// Overlap at which m v^2/2 + m g d is stored [m].
    double at_impact(double mass, double speed, double pull) const {
        const double load = mass * pull, motion = mass * speed * speed;
        if (linear > 0) {
            return (load + std::sqrt(load * load + linear * motion)) / linear;
        }
        double d = std::pow(1.25 * motion / hertz, 0.4);  // 2/5 C d^(5/2) = m v^2/2 + m g d
        for (int i = 0; i < 20; ++i) {
            d = std::pow(2.5 * (0.5 * motion + load * d) / hertz, 0.4);
        }
        return d;
    }
    double energy(double overlap) const {
        return linear > 0 ? 0.5 * linear * overlap * overlap : 0.4 * hertz * std::pow(overlap, 2.5);
    }
    /// Factor on the stiffness with which an overlap becomes another.
    double factor(double overlap, double wanted, bool is_impact) const {
        const double power = linear > 0 ? (is_impact ? 2 : 1) : (is_impact ? 2.5 : 1.5);
        return std::pow(overlap / wanted, power);
    }
};

/// Contact of a body with what is below it or in its way.
struct Touch {
    BodyId body, other;
    double area;           ///< projected, or of the foot [m^2]
    std::int64_t corners;  ///< of the face that touches
};

double radius_of(const sim::Model& model, BodyId body) {
    double least = infinity;
    for (std::int32_t p = model.bodies.part_begin[at(body.value)]; p < model.bodies.part_begin[at(body.value) + 1];
         ++p) {
        least = std::min(least, model.shapes.view(model.bodies.parts[at(p)].shape).inscribed_radius);
    }
    return least;
}

double spring_of_faces(const sim::Model& model, const Touch& touch) {
    const auto one = [&](BodyId body) {
        return model.materials[model.bodies.material[at(body.value)]].normal_stiffness / radius_of(model, body);
    };
    return touch.area * (one(touch.body) + one(touch.other));
}

/// Springs of the contacts of a case.
class Springs {
 public:
    explicit Springs(const sim::Model& model) : model_(model) {
        if (const auto* spheres = std::get_if<solid::SphereDemSettings>(&model.solid); spheres != nullptr) {
            spheres_ = solid::sphere_dem::sample_bodies(sim::solid_scene(model), *spheres);
        }
    }

    Spring of(const Touch& touch) const {
        return std::visit(
            [&](const auto& settings) -> Spring {
                if constexpr (requires { settings.elasticity.stiffness_per_area; }) {
                    // A corner of a prism in the plane stands for its edge, two corners in space.
                    constexpr bool is_of_plane = requires { settings.plane; };
                    const double springs = static_cast<double>(touch.corners) * (is_of_plane ? 0.5 : 1) *
                                           settings.elasticity.contact_stiffness;
                    return {settings.elasticity.stiffness_per_area
                                ? touch.area * *settings.elasticity.stiffness_per_area
                                : springs,
                            0, false};
                } else if constexpr (requires { settings.spring_stiffness; }) {
                    return of_spheres(touch, settings);
                } else {
                    return {spring_of_faces(model_, touch), 0, true};
                }
            },
            model_.solid);
    }

 private:
    template <class Settings>
    Spring of_spheres(const Touch& touch, const Settings& settings) const {
        const auto count = spheres_.begin[at(touch.body.value) + 1] - spheres_.begin[at(touch.body.value)];
        if (count == 0) {
            return {spring_of_faces(model_, touch), 0, true};
        }
        const double many = std::max(1, spheres_.flat_count[at(touch.body.value)]);
        if (settings.laws.normal != contact::NormalLaw::hertz) {
            return {many * settings.spring_stiffness, 0, false};
        }
        const double modulus = 0.5 * settings.youngs_modulus / (1 - std::pow(settings.poisson_ratio, 2));
        const double radius = spheres_.radius[at(spheres_.begin[at(touch.body.value)])];
        return {0, 4.0 / 3 * many * modulus * std::sqrt(radius), false};
    }

    const sim::Model& model_;
    solid::sphere_dem::SphereSet spheres_;
};

/// A first meeting of a free body.
struct Impact {
    Touch touch;
    double speed, mass, pull;
};

/// Corners of the face of a body that lies most squarely across a direction.
std::int64_t corners_towards(const sim::Model& model, const sim::State& state, BodyId body, const Vec3& direction) {
    double best = -1;
    std::int64_t corners = 1;
    for (std::int32_t p = model.bodies.part_begin[at(body.value)]; p < model.bodies.part_begin[at(body.value) + 1];
         ++p) {
        const body::Part& part = model.bodies.parts[at(p)];
        const geometry::ConvexView shape = model.shapes.view(part.shape);
        const Vec3 d = rotate(conjugate(state.bodies.orientation[at(body.value)] * part.local.orientation), direction);
        for (int f = 0; f < shape.face_count; ++f) {
            if (dot(shape.normal(f), d) > best) {
                best = dot(shape.normal(f), d);
                corners = shape.face_start[f + 1] - shape.face_start[f];
            }
        }
    }
    return corners;
}

/// Area of a body as it is seen along a way, and its farthest point that way from the centre of mass.
struct Outline {
    double area{0}, reach{0};  ///< [m^2], [m]
};

Outline outline_of(const sim::Model& model, const sim::State& state, BodyId body, const Vec3& way) {
    Outline seen;
    for (std::int32_t p = model.bodies.part_begin[at(body.value)]; p < model.bodies.part_begin[at(body.value) + 1];
         ++p) {
        const body::Part& own = model.bodies.parts[at(p)];
        const geometry::ConvexView shape = model.shapes.view(own.shape);
        const Quat turn = state.bodies.orientation[at(body.value)] * own.local.orientation;
        const Vec3 d = rotate(conjugate(turn), way);
        seen.area += shape.vertex_count > 0 ? 0.5 * dot(d, model.shapes.area_tensor(own.shape) * d) : 0;
        const Vec3 arm = rotate(state.bodies.orientation[at(body.value)], own.local.position);
        for (int v = 0; v < shape.vertex_count; ++v) {
            seen.reach = std::max(seen.reach, dot(way, arm) + dot(d, shape.vertex(v)));
        }
    }
    return seen;
}

std::optional<Impact> impact_along(const sim::Model& model, const sim::State& state, BodyId body, const Vec3& way) {
    const scene::Meeting met = scene::first_met(model, state, body, way);
    if (met.part < 0) {
        return std::nullopt;
    }
    const Outline seen = outline_of(model, state, body, way);
    const double along =
        std::max(0.0, dot(state.bodies.velocity[at(body.value)] - state.bodies.velocity[at(met.other.value)], way));
    const double pull = std::max(0.0, dot(model.gravity.at(0), way)), gap = std::max(0.0, met.distance - seen.reach);
    const double speed = std::sqrt(along * along + 2 * pull * gap);
    const double after = pull > 0 ? (speed - along) / pull : gap / along;
    if (!(speed > 0) || !(after < model.time.end)) {
        return std::nullopt;
    }
    return Impact{{body, met.other, seen.area, corners_towards(model, state, body, way)},
                  speed,
                  model.bodies.mass[at(body.value)],
                  pull};
}

std::vector<Impact> first_impacts(const sim::Model& model, const sim::State& state) {
    std::vector<Impact> impacts;
    if (model.has_fluid()) {
        return impacts;
    }
    const auto looked_at = static_cast<std::int32_t>(
        std::min<double>(model.bodies.size(), most_pairs / std::max(1, model.bodies.part_count())));
    for (std::int32_t b = 0; b < looked_at; ++b) {
        if (!is_free(model.bodies, BodyId{b}, 0)) {
            continue;
        }
        for (const Vec3& way : {state.bodies.velocity[at(b)], model.gravity.at(0)}) {
            if (const double length = norm(way); length > 0) {
                if (const auto impact = impact_along(model, state, BodyId{b}, way / length)) {
                    impacts.push_back(*impact);
                }
            }
        }
    }
    return impacts;
}

}  // namespace

double flat_contact_energy(const sim::Model& model, const sim::State& state, BodyId body, BodyId other, const Vec3& way,
                           double overlap) {
    const Vec3 direction = way / norm(way);
    const Outline seen = outline_of(model, state, body, direction);
    return Springs(model).of({body, other, seen.area, corners_towards(model, state, body, direction)}).energy(overlap);
}

std::optional<PredictedOverlap> largest_overlap(const sim::Model& model, const sim::State& state) {
    const Springs springs(model);
    std::optional<PredictedOverlap> largest;
    const auto offer = [&](const Touch& touch, const Spring& spring, double overlap, double speed) {
        const double thin = std::min(radius_of(model, touch.body), radius_of(model, touch.other));
        const double share = overlap / thin;
        if (std::isfinite(share) && (!largest || share > largest->share)) {
            const double factor = spring.factor(overlap, large_overlap * thin, speed > 0);
            largest = PredictedOverlap{touch.body,
                                       touch.other,
                                       speed > 0,
                                       speed,
                                       overlap,
                                       share,
                                       stiffness_text(model, touch.body, touch.other, spring.is_of_faces, factor)};
        }
    };
    const Vec3 gravity = model.gravity.at(0);
    const std::vector<LoadedFoot> feet = loaded_feet(model, state);
    const double pairs = static_cast<double>(feet.size()) * model.bodies.part_count();
    for (const LoadedFoot& foot : pairs < most_pairs ? feet : std::vector<LoadedFoot>{}) {
        const scene::Meeting met = scene::first_met(model, state, foot.body, gravity / norm(gravity));
        if (met.part >= 0) {
            const Touch touch{foot.body, met.other, foot.area, foot.corners};
            const Spring spring = springs.of(touch);
            offer(touch, spring, spring.at_rest(foot.weight), 0);
        }
    }
    for (const Impact& impact : first_impacts(model, state)) {
        const Spring spring = springs.of(impact.touch);
        offer(impact.touch, spring, spring.at_impact(impact.mass, impact.speed, impact.pull), impact.speed);
    }
    return largest;
}

std::optional<ImpactStep> shortest_impact(const sim::Model& model, const sim::State& state) {
    const double step = std::visit(
        [&](const auto& settings) {
            if constexpr (requires { settings.step; }) {
                return model.time.is_automatic() ? settings.step : model.time.time_step;
            }
            return 0.0;
        },
        model.solid);
    std::optional<ImpactStep> least;
    if (step > 0) {
        const Springs springs(model);
        for (const Impact& impact : first_impacts(model, state)) {
            const double omega = std::sqrt(springs.of(impact.touch).linear / impact.mass);
            const double back = std::exp(-M_PI * omega * step / 4);
            if (!least || back < least->back) {
                least = ImpactStep{impact.touch.body, impact.touch.other, impact.speed, back,
                                   -4 * std::log(well_resolved) / (M_PI * omega)};
            }
        }
    }
    return least;
}

}  // namespace riprap::run
