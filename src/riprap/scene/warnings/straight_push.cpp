// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/straight_push.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "riprap/body/locks.hpp"
#include "riprap/contact/distance_potential_physics.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/dem_settings.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::scene {

namespace {

using contact::Frame;
using geometry::ConvexView;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Depth of a contact over the inscribed radius of the thinner body below which they graze each other [-]: steps of a
/// floor so low are seams.
constexpr double grazing = 0.01;

/// Steps of the way over the inscribed radius of the thinner body [-].
constexpr double fine = 0.02;

/// Ways after which the energy is asked for: the shortest, over the inscribed radius of the thinner body, and how each
/// grows to the next [-].
constexpr double shortest = 1e-5, growth = 1.25;

/// Pairs of parts that are looked at for one body.
constexpr int most_looks = 20000;

/// Cosine between the way and the push, reversed, down to which contacts hold the body [-]: it is followed along its
/// way where it comes so, as what it slides on keeps it there, and as long as it does. A push that leans more lifts a
/// block over the step that it comes to. The energy is overrated by a fifth at most.
constexpr double head_on = 0.9;

/// Lowest corner of a shape along a direction [m].
double lowest(const ConvexView& shape, const Frame& frame, const Vec3& direction) {
    const Vec3 d = transpose_times(frame.axes, direction);
    double least = infinity;
    for (int v = 0; v < shape.vertex_count; ++v) {
        least = std::min(least, dot(d, shape.vertex(v)));
    }
    return least + dot(direction, frame.origin);
}

/// Way on which a shape surely comes to no point of another: until it has passed a face of the other that it is above,
/// or is passed by one of its own. @param direction of `moving`, unit
double way_to_faces(const ConvexView& faces, const Frame& frame, const ConvexView& corners, const Frame& other,
                    const Vec3& direction) {
    const double exact = 1e-9 * std::min(faces.inscribed_radius, corners.inscribed_radius);
    double way = 0;
    for (int j = 0; j < faces.face_count && corners.vertex_count > 0; ++j) {
        const Vec3 normal = frame.axes * faces.normal(j);
        const double gap = lowest(corners, other, normal) - dot(normal, frame.origin) - faces.offset[j];
        const double rate = -dot(normal, direction);
        if (gap >= -exact) {
            way = std::max(way, rate > 1e-9 ? std::max(gap, 0.0) / rate : infinity);
        }
    }
    return way;
}

/// A body on its way past the parts near it.
class Traveller {
 public:
    Traveller(const sim::Model& model, const contact::PlacedParts& placed, BodyId body, const Vec3& way, double length)
        : model_(model), placed_(placed), way_(way) {
        const std::vector<std::int32_t>& begin = model.bodies.part_begin;
        for (std::int32_t own = begin[at(body.value)]; own < begin[at(body.value) + 1]; ++own) {
            for (std::int32_t other = 0; other < model.bodies.part_count(); ++other) {
                if (model.bodies.parts[at(other)].body.value != body.value && is_near(own, other, length)) {
                    (can_meet({own, other}) ? pairs_ : beside_).push_back({own, other});
                }
            }
        }
    }

    struct Push {
        Vec3 force{}, moment{};  ///< on the body; about a point that goes with it [N], [N m]
    };

    /// Sum over all pairs, the body moved by `shift`; moments about `about`, which is moved too.
    Push push_at(const Vec3& shift, const Vec3& about) const {
        Push sum;
        contact::NormalContact found{};
        for (const contact::PartPair& pair : pairs_) {
            if (touch(pair, shift, found)) {
                sum.force += found.force;
                sum.moment += found.moment + cross(found.point - about - shift, found.force);
            }
        }
        return sum;
    }

    /// Pair that is first in each other by more than grazing; `met` is the way until it touches [m].
    std::optional<contact::PartPair> first(double length, double& met) const {
        int looks = 0;
        for (double s = 0; s < length && !pairs_.empty();) {
            double next = infinity;
            for (const contact::PartPair& pair : pairs_) {
                const double step = fine * thin_of(pair);
                double free = way_to_balls(pair, s);
                if (free < step) {
                    free = std::max(free, free_way(pair, s));
                }
                contact::NormalContact found{};
                if (free < step && touch(pair, s * way_, found) && found.depth > grazing * thin_of(pair)) {
                    met = touching(pair, s);
                    return pair;
                }
                next = std::min(next, std::max(free, step));
            }
            looks += static_cast<int>(pairs_.size());
            if (looks > most_looks) {
                return std::nullopt;
            }
            s += next;
        }
        return std::nullopt;
    }

    /// Does the body lie on another one, so that it touches it a share of a radius lower?
    bool lies(const Vec3& down, double share) const {
        contact::NormalContact found{};
        return norm(down) > 0 && std::ranges::any_of(beside_, [&](const contact::PartPair& pair) {
                   return touch(pair, share * thin_of(pair) / norm(down) * down, found);
               });
    }

    double thin_of(const contact::PartPair& pair) const {
        return std::min(view(pair.a).inscribed_radius, view(pair.b).inscribed_radius);
    }

 private:
    ConvexView view(std::int32_t part) const { return model_.shapes.view(model_.bodies.parts[at(part)].shape); }
    double stiffness(std::int32_t part) const {
        return model_.materials[model_.bodies.material[at(model_.bodies.parts[at(part)].body.value)]].normal_stiffness;
    }

    /// Does the ball about a part of the body come to that about the other?
    bool is_near(std::int32_t own, std::int32_t other, double length) const {
        const double reach = placed_.radii[at(own)] + placed_.radii[at(other)];
        if (!std::isfinite(reach)) {
            return true;
        }
        const Vec3 between = placed_.centers[at(other)] - placed_.centers[at(own)];
        const double along = std::clamp(dot(between, way_), 0.0, length);
        return norm(between - along * way_) <= reach;
    }

    /// Can they meet on the way? Not where they lie in each other already, or go along a face of one of them.
    bool can_meet(const contact::PartPair& pair) const {
        contact::NormalContact found{};
        return std::isfinite(free_way(pair, 0)) && !(touch(pair, {}, found) && found.depth > 1e-9 * thin_of(pair));
    }

    bool touch(const contact::PartPair& pair, const Vec3& shift, contact::NormalContact& found) const {
        const ConvexView a = view(pair.a), b = view(pair.b);
        Frame moved = placed_.frames[at(pair.a)];
        moved.origin += shift;
        contact::SeparatingCache cache;
        contact::DistancePotentialOptions options = std::get<solid::DemSettings>(model_.solid).contact;
        options.with_energy = false;  // dear of shapes with many faces, and given by the force along the way
        return contact::find_push({{a, moved}, stiffness(pair.a)}, {{b, placed_.frames[at(pair.b)]}, stiffness(pair.b)},
                                  options, cache, found);
    }

    /// Way from `s` on until the balls about both parts meet; infinite where they pass each other [m].
    double way_to_balls(const contact::PartPair& pair, double s) const {
        const double reach = placed_.radii[at(pair.a)] + placed_.radii[at(pair.b)];
        if (!std::isfinite(reach)) {
            return 0;
        }
        const Vec3 between = placed_.centers[at(pair.b)] - placed_.centers[at(pair.a)] - s * way_;
        const double along = dot(between, way_), beside = norm_squared(between) - along * along;
        if (norm_squared(between) <= reach * reach) {
            return 0;
        }
        return along > 0 && beside <= reach * reach ? along - std::sqrt(reach * reach - beside) : infinity;
    }

    double free_way(const contact::PartPair& pair, double s) const {
        const ConvexView a = view(pair.a), b = view(pair.b);
        Frame moved = placed_.frames[at(pair.a)];
        moved.origin += s * way_;
        const Frame& still = placed_.frames[at(pair.b)];
        return std::max(way_to_faces(b, still, a, moved, way_), way_to_faces(a, moved, b, still, -way_));
    }

    /// Way at which a pair that overlaps at `s` begins to [m].
    double touching(const contact::PartPair& pair, double s) const {
        contact::NormalContact found{};
        const double step = fine * thin_of(pair);
        double outside = s, inside = s;
        while (outside > 0 && touch(pair, outside * way_, found)) {
            inside = outside;
            outside = std::max(0.0, outside - step);
        }
        for (int i = 0; i < 20; ++i) {
            const double middle = 0.5 * (outside + inside);
            (touch(pair, middle * way_, found) ? inside : outside) = middle;
        }
        return inside;
    }

    const sim::Model& model_;
    const contact::PlacedParts& placed_;
    Vec3 way_;
    std::vector<contact::PartPair> pairs_;   ///< own part, other part: that may meet
    std::vector<contact::PartPair> beside_;  ///< that lie in each other, or go along a face
};

/// Work against a force that grows from f to g, as a power of the way from s to t; from nought as the way itself [J].
double work_between(double s, double f, double t, double g) {
    if (!(s > 0) || !(f > 0) || !(g > 0)) {
        return 0.5 * (f + g) * (t - s);
    }
    const double power = std::log(g / f) / std::log(t / s);
    return std::abs(power + 1) < 1e-6 ? f * s * std::log(t / s) : (g * t - f * s) / (power + 1);
}

/// Mass that answers to a push along a direction, by its moment about the centre of mass [kg].
double effective_mass(const sim::Model& model, const sim::State& state, BodyId body, const Traveller::Push& push) {
    const double mass = model.bodies.mass[at(body.value)];
    const Vec3 arm = push.moment / norm(push.force);
    const Sym3 inverse =
        body::inverse_inertia_of(model.bodies, at(body.value), state.bodies.orientation[at(body.value)]);
    return 1 / (1 / mass + dot(arm, inverse * arm));
}

}  // namespace

double StraightPush::stored_after(double way) const {
    const auto above = std::ranges::lower_bound(samples, way, {}, &Sample::way);
    if (above == samples.end()) {
        return std::ranges::max_element(samples, {}, &Sample::stored)->stored;
    }
    if (above == samples.begin()) {
        return above->stored * (way / above->way) * (way / above->way);  // as of any flat contact
    }
    const Sample& below = *std::prev(above);
    if (!(below.stored > 0) || !(above->stored > 0)) {
        return above->stored * (way - below.way) / (above->way - below.way);
    }
    return below.stored *
           std::pow(above->stored / below.stored, std::log(way / below.way) / std::log(above->way / below.way));
}

std::optional<double> StraightPush::rest() const {
    double low = 0;
    for (const Sample& sample : samples) {
        if (sample.stored < brought(sample.way)) {
            low = sample.way;
            continue;
        }
        double high = sample.way;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (stored_after(middle) < brought(middle) ? low : high) = middle;
        }
        return high;
    }
    return std::nullopt;
}

double StraightPush::needed_factor() const {
    double least = infinity;
    for (const Sample& sample : samples) {
        least = std::min(least, brought(sample.way) / sample.stored);
    }
    return least;
}

bool meets_by_potential(const sim::Model& model) {
    const auto* settings = std::get_if<solid::DemSettings>(&model.solid);
    return settings != nullptr && settings->pair_contact == solid::PairContact::distance_potential;
}

std::optional<StraightPush> straight_push(const sim::Model& model, const sim::State& state,
                                          const contact::PlacedParts& placed, BodyId body, const Vec3& way) {
    const double along = std::max(0.0, dot(state.bodies.velocity[at(body.value)], way));
    const double pull = std::max(0.0, dot(model.gravity.at(0), way)), end = model.time.end;
    const double length = along * end + 0.5 * pull * end * end;
    const Traveller traveller(model, placed, body, way, length);
    double met = 0;
    const auto pair = traveller.first(length, met);
    if (!pair || (along == 0 && met < 1e-6 * traveller.thin_of(*pair))) {
        return std::nullopt;  // or it lies there
    }
    StraightPush push;
    push.body = body;
    push.other = model.bodies.parts[at(pair->b)].body;
    push.thin = traveller.thin_of(*pair);
    push.lies_on_something = traveller.lies(model.gravity.at(0), fine);
    const Vec3 start = met * way, center = state.bodies.position[at(body.value)];
    const Traveller::Push at_first = traveller.push_at(start + fine * push.thin * way, center);
    if (!(norm(at_first.force) > 0)) {
        return std::nullopt;
    }
    const Vec3 against = -at_first.force / norm(at_first.force);
    const Vec3 in = dot(way, against) > head_on ? way : against;
    const double other_along = dot(state.bodies.velocity[at(push.other.value)], in);
    push.speed = std::sqrt(along * along + 2 * pull * met) * dot(way, in) - other_along;
    if (!(push.speed > 0)) {
        return std::nullopt;
    }
    push.motion = 0.5 * effective_mass(model, state, body, at_first) * push.speed * push.speed;
    push.weight = model.bodies.mass[at(body.value)] * std::max(0.0, dot(model.gravity.at(0), in));
    double before = 0, force_before = 0, stored = 0;
    for (double s = shortest * push.thin; s < growth * solid::most_overlap * push.thin; s *= growth) {
        const double way_in = std::min(s, solid::most_overlap * push.thin);
        const Traveller::Push now = traveller.push_at(start + way_in * in, center);
        const double force = -dot(now.force, in);
        const bool leans = norm(now.force) > 0 && !(force >= head_on * norm(now.force));
        if (leans || (s > fine * push.thin && !(force > 0))) {
            push.goes_round = true;
            break;
        }
        stored += work_between(before, force_before, way_in, force);
        push.samples.push_back({way_in, stored});
        before = way_in;
        force_before = force;
    }
    return push;
}

}  // namespace riprap::scene
