// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/remedy/tipping_bias.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "riprap/contact/elastic_foot.hpp"
#include "riprap/core/mat3.hpp"

namespace riprap::run {

namespace {

/// Bodies in scenes with more are looked at one by one, without what is stacked on them.
constexpr std::size_t most_stacked = 20000;

/// A free body on its lowest face.
struct Standing {
    BodyId body;
    Vec3 up;                              ///< into the body, normal to the foot [-]
    double level;                         ///< of the foot along `up` [m]
    double width, length;                 ///< of the foot: least extent, and extent across it [m]
    double stiffness;                     ///< k/r of the body [N/m^3]
    double low, high;                     ///< extent of the body along -gravity [m]
    double near_x, far_x, near_y, far_y;  ///< extents in the plane across gravity [m]
    double area{0};                       ///< of the foot [m^2]
    std::int64_t corners{0};              ///< of the foot
};

struct Extent {
    double low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    double size() const { return high - low; }
};

/// Unit vector normal to `up`, and normal to z in planar scenes.
Vec3 across(const Vec3& up, bool is_planar) {
    const Vec3 other = is_planar || std::abs(up.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    return normalized(cross(up, other));
}

/// Least width of the points of a foot and the extent across that direction, by directions 2 degrees apart.
void measure_foot(const std::vector<Vec3>& foot, bool is_planar, Standing& standing) {
    const Vec3 e1 = across(standing.up, is_planar), e2 = cross(standing.up, e1);
    standing.width = std::numeric_limits<double>::infinity();
    constexpr int directions = 90;
    for (int k = 0; k < (is_planar ? 1 : directions); ++k) {
        const double angle = M_PI * k / directions;
        const Vec3 along = std::cos(angle) * e1 + std::sin(angle) * e2, beside = cross(standing.up, along);
        Extent width, length;
        for (const Vec3& x : foot) {
            width.add(dot(x, along));
            length.add(dot(x, beside));
        }
        if (width.size() < standing.width) {
            standing.width = width.size();
            standing.length = is_planar ? 1 : length.size();
        }
    }
}

/// Returns the base that a part stands on; width 0 where it has no face within 60 degrees of the ground.
Standing stand(const sim::Model& model, const sim::State& state, const body::Part& part, const Vec3& down) {
    const auto b = static_cast<std::size_t>(part.body.value);
    const geometry::ConvexView shape = model.shapes.view(part.shape);
    const Quat turn = state.bodies.orientation[b] * part.local.orientation;
    const auto place = [&](const Vec3& x) {
        return state.bodies.position[b] + rotate(state.bodies.orientation[b], part.local.position) + rotate(turn, x);
    };
    Standing standing{part.body, {}, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    int lowest = -1;
    double alignment = 0.5;
    for (int f = 0; f < shape.face_count; ++f) {
        const double aligned = dot(rotate(turn, shape.normal(f)), down);
        if (shape.is_internal[f] == 0 && aligned > alignment) {
            alignment = aligned;
            lowest = f;
        }
    }
    if (lowest < 0) {
        return standing;
    }
    standing.up = -1.0 * rotate(turn, shape.normal(lowest));
    std::vector<Vec3> foot;
    for (int k = shape.face_start[lowest]; k < shape.face_start[lowest + 1]; ++k) {
        foot.push_back(place(shape.vertex(shape.face_vertex[k])));
    }
    measure_foot(foot, model.bodies.is_planar, standing);
    standing.corners = static_cast<std::int64_t>(foot.size());
    for (std::size_t k = 1; k + 1 < foot.size(); ++k) {
        standing.area += 0.5 * dot(standing.up, cross(foot[k + 1] - foot[0], foot[k] - foot[0]));
    }
    standing.level = dot(foot.front(), standing.up);
    standing.stiffness = model.materials[model.bodies.material[b]].normal_stiffness / shape.inscribed_radius;
    const Vec3 e1 = across(down, model.bodies.is_planar), e2 = cross(down, e1);
    Extent along, x, y;
    for (int v = 0; v < shape.vertex_count; ++v) {
        const Vec3 corner = place(shape.vertex(v));
        along.add(-dot(corner, down));
        x.add(dot(corner, e1));
        y.add(dot(corner, e2));
    }
    standing.low = along.low;
    standing.high = along.high;
    standing.near_x = x.low;
    standing.far_x = x.high;
    standing.near_y = y.low;
    standing.far_y = y.high;
    return standing;
}

/// `upper` rests on `lower`: its low end at the high end of the other, to a hundredth of their heights, over it in
/// plan.
bool rests_on(const Standing& upper, const Standing& lower) {
    const double slack = 0.01 * std::min(upper.high - upper.low, lower.high - lower.low);
    return std::abs(upper.low - lower.high) < slack && upper.near_x < lower.far_x && upper.far_x > lower.near_x &&
           upper.near_y < lower.far_y && upper.far_y > lower.near_y;
}

/// All that stands on the foot of one body, itself included.
struct Stack {
    std::int64_t above{0};
    double mass{0};
    Vec3 moment{};  ///< mass times place of its centre [kg m]
};

/// Stacks of bodies ordered by their low ends, from the highest down: what rests on a body is summed before it. A body
/// that rests on several counts for each of them.
std::vector<Stack> stacks_of(const sim::Model& model, const sim::State& state, const std::vector<Standing>& ordered) {
    std::vector<Stack> stacks(ordered.size());
    for (std::size_t k = ordered.size(); k-- > 0;) {
        const auto b = static_cast<std::size_t>(ordered[k].body.value);
        stacks[k].mass = model.bodies.mass[b];
        stacks[k].moment = model.bodies.mass[b] * state.bodies.position[b];
        if (ordered.size() > most_stacked) {
            continue;
        }
        const double height = ordered[k].high - ordered[k].low;
        const auto first = std::lower_bound(ordered.begin(), ordered.end(), ordered[k].high - 0.01 * height,
                                            [](const Standing& s, double low) { return s.low < low; });
        for (auto i = static_cast<std::size_t>(first - ordered.begin());
             i < ordered.size() && ordered[i].low < ordered[k].high + 0.01 * height; ++i) {
            if (i > k && rests_on(ordered[i], ordered[k])) {
                stacks[k].above += 1 + stacks[i].above;
                stacks[k].mass += stacks[i].mass;
                stacks[k].moment += stacks[i].moment;
            }
        }
    }
    return stacks;
}

/// Free bodies that stand, from the lowest up.
std::vector<Standing> standing_bodies(const sim::Model& model, const sim::State& state, const Vec3& down) {
    std::vector<Standing> ordered;
    for (const body::Part& part : model.bodies.parts) {
        const bool is_free = model.bodies.drive[static_cast<std::size_t>(part.body.value)] == body::Drive::free;
        if (!is_free || model.shapes.is_half_space(part.shape)) {
            continue;
        }
        const Standing standing = stand(model, state, part, down);
        // The lowest part of a body carries it.
        if (!ordered.empty() && ordered.back().body.value == part.body.value) {
            if (standing.width > 0 && standing.low < ordered.back().low) {
                ordered.back() = standing;
            }
        } else if (standing.width > 0) {
            ordered.push_back(standing);
        }
    }
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const Standing& a, const Standing& b) { return a.low < b.low; });
    return ordered;
}

/// Largest angle between the inward normal of a foot and upwards, over the run [rad].
double largest_lean(const sim::Model& model, const Vec3& up) {
    const body::Gravity& gravity = model.gravity;
    constexpr int looks = 256;  // at gravity that turns
    double least = 1;
    for (int k = 0; k <= (gravity.turns() ? looks : 0); ++k) {
        const double stop = std::min(model.time.end, gravity.stop);
        const double time = gravity.start + std::max(0.0, stop - gravity.start) * k / looks;
        const Vec3 now = gravity.turns() ? gravity.at(std::max(time, gravity.ramp)) : gravity.value;
        least = std::min(least, -dot(now, up) / norm(now));
    }
    return std::acos(std::clamp(least, -1.0, 1.0));
}

}  // namespace

std::vector<LoadedFoot> loaded_feet(const sim::Model& model, const sim::State& state) {
    const double gravity = norm(model.gravity.value);
    if (gravity == 0) {
        return {};
    }
    const std::vector<Standing> ordered = standing_bodies(model, state, (1 / gravity) * model.gravity.value);
    const std::vector<Stack> stacks = stacks_of(model, state, ordered);
    std::vector<LoadedFoot> feet;
    for (std::size_t k = 0; k < ordered.size(); ++k) {
        feet.push_back({ordered[k].body, stacks[k].above, gravity * stacks[k].mass, std::abs(ordered[k].area),
                        ordered[k].corners});
    }
    return feet;
}

std::optional<TippingBias> largest_tipping_bias(const sim::Model& model, const sim::State& state) {
    const double gravity = norm(model.gravity.value);
    if (gravity == 0) {
        return {};
    }
    const std::vector<Standing> ordered = standing_bodies(model, state, (1 / gravity) * model.gravity.value);
    const std::vector<Stack> stacks = stacks_of(model, state, ordered);
    std::optional<TippingBias> largest;
    for (std::size_t k = 0; k < ordered.size(); ++k) {
        const Standing& s = ordered[k];
        const Vec3 centre = (1 / stacks[k].mass) * stacks[k].moment;
        const contact::ElasticFoot foot{.width = s.width,
                                        .length = s.length,
                                        .centre_height = dot(centre, s.up) - s.level,
                                        .weight = stacks[k].mass * gravity,
                                        .stiffness = s.stiffness};
        if (!(foot.centre_height > 0)) {
            continue;
        }
        TippingBias found{
            s.body, stacks[k].above, std::atan(0.5 * foot.width / foot.centre_height), contact::tipping_slope(foot), 0,
            0};
        if (!largest || found.share() > largest->share()) {
            found.factor = std::pow(found.bias() / tolerated_tipping_bias, 3);
            found.lean = largest_lean(model, s.up);
            largest = found;
        }
    }
    return largest;
}

}  // namespace riprap::run
