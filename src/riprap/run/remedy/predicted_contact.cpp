// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/remedy/predicted_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/run/remedy/remedy_text.hpp"
#include "riprap/run/remedy/tipping_bias.hpp"
#include "riprap/scene/warnings/hard_impacts.hpp"
#include "riprap/scene/warnings/straight_push.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/settings.hpp"
#include "riprap/solid/sphere_dem/sample_bodies.hpp"

namespace riprap::run {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Share of the inscribed radius within which corners touch together, and bodies have not met yet [-].
constexpr double touching = 0.01;

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
    double force(double overlap) const { return linear > 0 ? linear * overlap : hertz * std::pow(overlap, 1.5); }
};

/// Contact of a body with what is below it or in its way.
struct Touch {
    BodyId body, other;
    Vec3 way;              ///< unit vector from the body to what it touches [-]
    double area;           ///< projected, or of the foot [m^2]
    std::int64_t corners;  ///< that touch together
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
    Springs(const sim::Model& model, const sim::State& state) : model_(model), state_(state) {
        if (const auto* spheres = std::get_if<solid::SphereDemSettings>(&model.solid); spheres != nullptr) {
            spheres_ = solid::sphere_dem::sample_bodies(sim::solid_scene(model), *spheres);
        }
    }

    Spring of(const Touch& touch) const {
        if (const auto* elasticity = sim::elasticity_of(model_.solid)) {
            // A corner of a prism in the plane stands for its edge, two corners in space.
            const double springs = static_cast<double>(touch.corners) * (sim::is_of_plane(model_) ? 0.5 : 1) *
                                   elasticity->contact_stiffness;
            return {elasticity->stiffness_per_area ? touch.area * *elasticity->stiffness_per_area : springs, 0, false};
        }
        if (const auto* spheres = std::get_if<solid::SphereDemSettings>(&model_.solid)) {
            return of_spheres(touch, *spheres);
        }
        return {spring_of_faces(model_, touch), 0, true};
    }

 private:
    Spring of_spheres(const Touch& touch, const solid::SphereDemSettings& settings) const {
        const auto count = spheres_.begin[at(touch.body.value) + 1] - spheres_.begin[at(touch.body.value)];
        if (count == 0) {
            return {spring_of_faces(model_, touch), 0, true};
        }
        const double many = portion_that_meets_first(touch);
        if (settings.laws.normal != contact::NormalLaw::hertz) {
            return {many * settings.spring_stiffness, 0, false};
        }
        const double modulus = 0.5 * settings.youngs_modulus / (1 - std::pow(settings.poisson_ratio, 2));
        const double radius = spheres_.curvature[at(spheres_.begin[at(touch.body.value)])];
        return {0, 4.0 / 3 * many * modulus * std::sqrt(radius), false};
    }

    /// Sum of the portions by which springs count, of the spheres of a body that a plane across the way touches first,
    /// within a tenth of their radius [-].
    double portion_that_meets_first(const Touch& touch) const {
        const Vec3 way = rotate(conjugate(state_.bodies.orientation[at(touch.body.value)]), touch.way);
        const auto begin = at(spheres_.begin[at(touch.body.value)]), end = at(spheres_.begin[at(touch.body.value) + 1]);
        double most = -infinity;
        for (std::size_t s = begin; s < end; ++s) {
            most = std::max(most, dot(way, spheres_.local[s]) + spheres_.radius[s]);
        }
        double sum = 0;
        for (std::size_t s = begin; s < end; ++s) {
            const bool is_first = dot(way, spheres_.local[s]) + spheres_.radius[s] > most - 0.1 * spheres_.radius[s];
            sum += is_first ? spheres_.portion[s] : 0;
        }
        return sum;
    }

    const sim::Model& model_;
    const sim::State& state_;
    solid::sphere_dem::SphereSet spheres_;
};

/// A first meeting of a free body.
struct Impact {
    Touch touch;
    double speed, mass, pull;
};

/// Area of a body as it is seen along a way, its farthest point that way from the centre of mass, and the corners that
/// are as far to a hundredth of the inscribed radius.
struct Outline {
    double area{0}, reach{0};  ///< [m^2], [m]
    std::int64_t corners{0};
};

Outline outline_of(const sim::Model& model, const sim::State& state, BodyId body, const Vec3& way) {
    Outline seen;
    std::vector<double> reaches;
    for (std::int32_t p = model.bodies.part_begin[at(body.value)]; p < model.bodies.part_begin[at(body.value) + 1];
         ++p) {
        const body::Part& own = model.bodies.parts[at(p)];
        const geometry::ConvexView shape = model.shapes.view(own.shape);
        const Quat turn = state.bodies.orientation[at(body.value)] * own.local.orientation;
        const Vec3 d = rotate(conjugate(turn), way);
        seen.area += shape.vertex_count > 0 ? 0.5 * dot(d, model.shapes.area_tensor(own.shape) * d) : 0;
        const Vec3 arm = rotate(state.bodies.orientation[at(body.value)], own.local.position);
        for (int v = 0; v < shape.vertex_count; ++v) {
            reaches.push_back(dot(way, arm) + dot(d, shape.vertex(v)));
            seen.reach = std::max(seen.reach, reaches.back());
        }
    }
    const double near = seen.reach - touching * radius_of(model, body);
    seen.corners = std::max<std::int64_t>(1, std::ranges::count_if(reaches, [near](double r) { return r >= near; }));
    return seen;
}

/// Area over which two bodies can touch along a way: that of the smaller, half-spaces aside [m^2].
double common_area(const sim::Model& model, const sim::State& state, const Outline& seen, BodyId other,
                   const Vec3& way) {
    const double behind = outline_of(model, state, other, way).area;
    return behind > 0 ? std::min(seen.area, behind) : seen.area;
}

std::optional<Impact> impact_along(const sim::Model& model, const sim::State& state, BodyId body, const Vec3& way) {
    const scene::Meeting met = scene::first_met(model, state, body, way);
    if (met.part < 0) {
        return std::nullopt;
    }
    const Outline seen = outline_of(model, state, body, way);
    const double along =
        std::max(0.0, dot(state.bodies.velocity[at(body.value)] - state.bodies.velocity[at(met.other.value)], way));
    const double room = met.distance - seen.reach;
    if (room < -touching * radius_of(model, body)) {
        return std::nullopt;  // they have met
    }
    const double pull = std::max(0.0, dot(model.gravity.at(0), way)), gap = std::max(0.0, room);
    const double speed = std::sqrt(along * along + 2 * pull * gap);
    const double after = pull > 0 ? (speed - along) / pull : gap / along;
    if (!(speed > 0) || !(after < model.time.end)) {
        return std::nullopt;
    }
    return Impact{{body, met.other, way, common_area(model, state, seen, met.other, way), seen.corners},
                  speed,
                  model.bodies.mass[at(body.value)],
                  pull};
}

/// Calls `visit` with each free body and each way that it may go at first, along its velocity and along gravity; with
/// none where water would carry bodies.
template <class Visit>
void for_each_way(const sim::Model& model, const sim::State& state, const Visit& visit) {
    if (model.has_fluid()) {
        return;
    }
    const auto looked_at = static_cast<std::int32_t>(
        std::min<double>(model.bodies.size(), most_pairs / std::max(1, model.bodies.part_count())));
    for (std::int32_t b = 0; b < looked_at; ++b) {
        if (!is_free(model.bodies, BodyId{b}, 0)) {
            continue;
        }
        for (const Vec3& way : {state.bodies.velocity[at(b)], model.gravity.at(0)}) {
            if (const double length = norm(way); length > 0) {
                visit(BodyId{b}, way / length);
            }
        }
    }
}

std::vector<Impact> first_impacts(const sim::Model& model, const sim::State& state) {
    std::vector<Impact> impacts;
    for_each_way(model, state, [&](BodyId body, const Vec3& way) {
        if (const auto impact = impact_along(model, state, body, way)) {
            impacts.push_back(*impact);
        }
    });
    return impacts;
}

/// The largest overlap of an impact by what its contacts store along the way (scene::StraightPush).
std::optional<PredictedOverlap> largest_push(const sim::Model& model, const sim::State& state, double wanted) {
    std::optional<PredictedOverlap> largest;
    contact::PlacedParts placed;
    place_parts(model.shapes, model.bodies, state.bodies, placed);
    for_each_way(model, state, [&](BodyId body, const Vec3& way) {
        const std::optional<scene::StraightPush> push = scene::straight_push(model, state, placed, body, way);
        if (!push || push->samples.empty() || (push->goes_round && !push->rest())) {
            return;
        }
        const double overlap = push->rest().value_or(push->last_way());
        if (!largest || overlap / push->thin > largest->share) {
            const double factor = push->brought(wanted * push->thin) / push->stored_after(wanted * push->thin);
            largest = PredictedOverlap{
                body,    push->other,          true,   push->speed,
                overlap, overlap / push->thin, factor, stiffness_text(model, body, push->other, true, factor)};
        }
    });
    return largest;
}

}  // namespace

double flat_contact_energy(const sim::Model& model, const sim::State& state, BodyId body, BodyId other, const Vec3& way,
                           double overlap) {
    const Vec3 direction = way / norm(way);
    const Outline seen = outline_of(model, state, body, direction);
    return Springs(model, state)
        .of({body, other, direction, common_area(model, state, seen, other, direction), seen.corners})
        .energy(overlap);
}

std::optional<PredictedOverlap> largest_overlap(const sim::Model& model, const sim::State& state, double wanted) {
    const Springs springs(model, state);
    std::optional<PredictedOverlap> largest;
    // `needed` is the factor on the stiffness with which the overlap is the wanted one.
    const auto offer = [&](const Touch& touch, const Spring& spring, double overlap, double speed, const auto& needed) {
        const double thin = std::min(radius_of(model, touch.body), radius_of(model, touch.other));
        const double share = overlap / thin;
        if (std::isfinite(share) && (!largest || share > largest->share)) {
            const double factor = needed(wanted * thin);
            largest = PredictedOverlap{
                touch.body, touch.other,
                speed > 0,  speed,
                overlap,    share,
                factor,     stiffness_text(model, touch.body, touch.other, spring.is_of_faces, factor)};
        }
    };
    const Vec3 gravity = model.gravity.at(0);
    const std::vector<LoadedFoot> feet = loaded_feet(model, state);
    const double pairs = static_cast<double>(feet.size()) * model.bodies.part_count();
    for (const LoadedFoot& foot : pairs < most_pairs ? feet : std::vector<LoadedFoot>{}) {
        const scene::Meeting met = scene::first_met(model, state, foot.body, gravity / norm(gravity));
        if (met.part >= 0) {
            const Touch touch{foot.body, met.other, gravity / norm(gravity), foot.area, foot.corners};
            const Spring spring = springs.of(touch);
            offer(touch, spring, spring.at_rest(foot.weight), 0,
                  [&](double overlap) { return foot.weight / spring.force(overlap); });
        }
    }
    if (scene::meets_by_potential(model)) {
        const std::optional<PredictedOverlap> push = largest_push(model, state, wanted);
        return !push || (largest && largest->share > push->share) ? largest : push;
    }
    for (const Impact& impact : first_impacts(model, state)) {
        const Spring spring = springs.of(impact.touch);
        offer(impact.touch, spring, spring.at_impact(impact.mass, impact.speed, impact.pull), impact.speed,
              [&](double overlap) {
                  return impact.mass * (0.5 * impact.speed * impact.speed + impact.pull * overlap) /
                         spring.energy(overlap);
              });
    }
    return largest;
}

std::optional<ImpactStep> shortest_impact(const sim::Model& model, const sim::State& state) {
    const double* const wanted = sim::step_of(model.solid);
    const double step = wanted == nullptr ? 0 : model.time.is_automatic() ? *wanted : model.time.time_step;
    std::optional<ImpactStep> least;
    if (step > 0) {
        const Springs springs(model, state);
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
