// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/hard_impacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/scene/warnings/straight_push.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/quantity.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::scene {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_pairs = 2e7;

/// Distance along a line at which it enters a convex part from outside; infinite where it does not [m].
double distance_to(const geometry::ConvexView& shape, const Pose& pose, const Vec3& from, const Vec3& direction) {
    const Vec3 x = to_body(pose, from), d = to_body(pose, from + direction) - x;
    double enter = -infinity, leave = infinity;
    for (int j = 0; j < shape.face_count; ++j) {
        const double height = dot(shape.normal(j), x) - shape.offset[j], rate = dot(shape.normal(j), d);
        if (rate == 0) {
            enter = height > 0 ? infinity : enter;
        } else {
            (rate < 0 ? enter : leave) = rate < 0 ? std::max(enter, -height / rate) : std::min(leave, -height / rate);
        }
    }
    return enter <= leave && enter > 0 ? enter : infinity;
}

/// Tells that a line passes the sphere about all vertices of a part at a distance, so that its many faces need not be
/// looked at. @param center  of the shape [m], @param direction  unit vector
bool passes_by(const geometry::ConvexView& shape, const Vec3& center, const Vec3& from, const Vec3& direction) {
    constexpr double round_off = 1 + 1e-9;
    const Vec3 way = center - from;
    const double along = dot(way, direction), radius = round_off * shape.circumradius;
    return shape.vertex_count > 0 && (along < -radius || norm_squared(way) - along * along > radius * radius);
}

}  // namespace

Meeting first_met(const sim::Model& model, const sim::State& state, BodyId body, const Vec3& direction) {
    Meeting first;
    for (std::int32_t p = 0; p < model.bodies.part_count(); ++p) {
        const body::Part& part = model.bodies.parts[at(p)];
        const auto b = at(part.body.value);
        if (part.body.value == body.value) {
            continue;
        }
        const geometry::ConvexView shape = model.shapes.view(part.shape);
        const Vec3& from = state.bodies.position[at(body.value)];
        const Vec3 center = to_world({state.bodies.position[b], state.bodies.orientation[b]}, part.local.position);
        if (passes_by(shape, center, from, direction)) {
            continue;
        }
        const double distance =
            distance_to(shape, {center, state.bodies.orientation[b] * part.local.orientation}, from, direction);
        if (distance < first.distance) {
            first = {part.body, p, distance};
        }
    }
    return first;
}

namespace {

double stiffness_of(const sim::Model& model, BodyId body) {
    return model.materials[model.bodies.material[at(body.value)]].normal_stiffness;
}

/// Impact of a body on the first obstacle in a direction, where it is more than the contact holds.
std::optional<HardImpact> impact_along(const sim::Model& model, const sim::State& state, std::int32_t body,
                                       const Vec3& direction) {
    const Meeting met = first_met(model, state, BodyId{body}, direction);
    const body::BodySet& bodies = model.bodies;
    if (met.part < 0) {
        return std::nullopt;
    }
    const body::Part& other = bodies.parts[at(met.part)];
    double area = 0, r = infinity;
    for (std::int32_t p = bodies.part_begin[at(body)]; p < bodies.part_begin[at(body) + 1]; ++p) {
        const body::Part& own = bodies.parts[at(p)];
        const Vec3 d = rotate(conjugate(state.bodies.orientation[at(body)] * own.local.orientation), direction);
        area += 0.5 * dot(d, model.shapes.area_tensor(own.shape) * d);
        r = std::min(r, model.shapes.view(own.shape).inscribed_radius);
    }
    const double r_other = model.shapes.view(other.shape).inscribed_radius;
    const double k = stiffness_of(model, BodyId{body}), k_other = stiffness_of(model, other.body);
    const double depth = solid::most_overlap * std::min(r, r_other);
    const double capacity = 0.5 * area * (k / r + k_other / r_other) * depth * depth;

    const double along =
        std::max(0.0, dot(state.bodies.velocity[at(body)] - state.bodies.velocity[at(other.body.value)], direction));
    const double pull = std::max(0.0, dot(model.gravity.at(0), direction)), way = std::max(0.0, met.distance - r);
    const double square = along * along + 2 * pull * way, mass = bodies.mass[at(body)];
    if (!(square > 0 || pull > 0)) {
        return std::nullopt;
    }
    const double energy = mass * (0.5 * square + pull * depth);
    const double falls_for = pull > 0 ? (std::sqrt(square) - along) / pull : way / along;
    if (falls_for > model.time.end) {
        return std::nullopt;
    }
    if (!(energy > capacity) || capacity <= 0) {
        return std::nullopt;
    }
    return HardImpact{BodyId{body}, other.body, std::sqrt(square), energy, capacity, k * energy / capacity};
}

/// The same by what the contacts store along the way.
std::optional<HardImpact> impact_by_energy(const sim::Model& model, const sim::State& state,
                                           const contact::PlacedParts& placed, std::int32_t body,
                                           const Vec3& direction) {
    const auto push = straight_push(model, state, placed, BodyId{body}, direction);
    if (!push || push->samples.empty() || push->rest() || (push->goes_round && !push->lies_on_something)) {
        return std::nullopt;  // what goes round an edge in the open may well do so
    }
    const double factor = push->needed_factor();
    const double energy = push->brought(push->last_way());
    return HardImpact{push->body,      push->other,     push->speed,
                      energy,          energy / factor, factor * stiffness_of(model, push->body),
                      push->goes_round};
}

}  // namespace

std::vector<HardImpact> find_hard_impacts(const sim::Model& model, const sim::State& state) {
    if (!sim::tells_depth(model)) {
        return {};
    }
    const body::BodySet& bodies = model.bodies;
    std::vector<std::optional<HardImpact>> found(at(bodies.size()));
    const auto looked_at =
        static_cast<std::int64_t>(std::min<double>(bodies.size(), most_pairs / std::max(1, bodies.part_count())));
    const Vec3 gravity = model.gravity.at(0);
    const bool knows_energy = meets_by_potential(model);
    contact::PlacedParts placed;
    if (knows_energy) {
        place_parts(model.shapes, bodies, state.bodies, placed);
    }
    parallel::for_each_uneven(looked_at, 16, [&](std::int64_t i) {
        const auto body = static_cast<std::int32_t>(i);
        if (!is_free(bodies, BodyId{body}, 0)) {
            return;
        }
        for (const Vec3& way : {state.bodies.velocity[at(body)], gravity}) {
            if (const double length = norm(way); length > 0) {
                const auto impact = knows_energy ? impact_by_energy(model, state, placed, body, way / length)
                                                 : impact_along(model, state, body, way / length);
                const bool is_worse = impact && (!found[at(i)] || impact->energy * found[at(i)]->capacity >
                                                                      found[at(i)]->energy * impact->capacity);
                found[at(i)] = is_worse ? impact : found[at(i)];
            }
        }
    });
    std::vector<HardImpact> impacts;
    for (const std::optional<HardImpact>& one : found) {
        if (one) {
            impacts.push_back(*one);
        }
    }
    return impacts;
}

std::string text_of(const HardImpact& impact, const sim::Model& model) {
    const std::string unit = sim::unit_in("J", model.bodies.is_planar);
    return fmt::format(
        "'{}' comes to '{}' with {:.3g} m/s and {:.3g} {}, and their contact holds about {:.3g} {} before {}; a "
        "normal_stiffness of about {:.2g} Pa would carry it",
        model.bodies.name(impact.body), model.bodies.name(impact.other), impact.speed, impact.energy, unit,
        impact.capacity, unit,
        impact.goes_round ? "its push leans and lets the one go round the other"
                          : "the centre of one lies in the other",
        impact.needed_stiffness);
}

}  // namespace riprap::scene
