// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/corner_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "riprap/body/ground.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double flat = 0.1;  ///< sine squared of the angle of two faces below which they make no corner
constexpr int most = 2;       ///< bodies that one sample hands over to
constexpr double skin = 0.1;  ///< of a spacing: below a face its body is there

/// A part of a body that never moves, where it stands.
struct StillPart {
    geometry::ConvexView view;
    Pose pose;
    BodyId body;
    const body::Ground* ground;  ///< that it is; null = convex
    double radius;
};

/// A face that rises from that of a sample.
struct Rise {
    BodyId body;
    double depth;  ///< of the place before the sample's face behind this one [m]
    Vec3 normal;
    bool is_beyond;  ///< the place is beyond the body, where there may be water too
};

/// Finds the faces of bodies that never move.
class StillFaces {
 public:
    StillFaces(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
               const SampleSettings& settings, const std::vector<body::Ground>& grounds)
        : spacing_(settings.spacing), reach_(settings.reach), is_planar_(bodies.is_planar) {
        for (std::int32_t b = 0; b < bodies.size(); ++b) {
            const bool is_dry = !settings.is_dry.empty() && settings.is_dry[at(b)] != 0;
            if (is_dry || !is_still(bodies, BodyId{b})) {
                continue;
            }
            const Pose pose{state.position[at(b)], state.orientation[at(b)]};
            const auto ground = std::ranges::find(grounds, BodyId{b}, &body::Ground::body);
            if (ground != grounds.end()) {
                parts_.push_back({{}, pose, BodyId{b}, &*ground, infinity});
                continue;
            }
            for (std::int32_t p = bodies.part_begin[at(b)]; p < bodies.part_begin[at(b) + 1]; ++p) {
                const body::Part& part = bodies.parts[at(p)];
                const geometry::ConvexView view = shapes.view(part.shape);
                const Pose placed{to_world(pose, part.local.position), pose.orientation * part.local.orientation};
                parts_.push_back({view, placed, BodyId{b}, nullptr, view.circumradius});
            }
        }
    }

    /// The faces that rise near a place just before the face of a body, one a body, the nearest first.
    std::vector<Rise> rising(BodyId owner, const Vec3& place, const Vec3& normal) const {
        std::vector<Rise> found;
        for (const StillPart& part : parts_) {
            const double radius = part.radius + reach_;
            if (part.body == owner || norm_squared(place - part.pose.position) > radius * radius) {
                continue;
            }
            const std::optional<Rise> rise =
                part.ground != nullptr ? rise_of_ground(part, place, normal) : rise_of(part, place, normal);
            if (!rise) {
                continue;
            }
            const auto known = std::ranges::find(found, rise->body, &Rise::body);
            if (known == found.end()) {
                found.push_back(*rise);
            } else if (rise->depth < known->depth) {
                *known = *rise;
            }
        }
        std::ranges::stable_sort(found, [](const Rise& a, const Rise& b) { return a.depth < b.depth; });
        return found;
    }

    /// Tells whether any of the face of a body about a place is free of other bodies that never move.
    bool meets_water(BodyId body, const Vec3& foot, const Vec3& n) const {
        constexpr int steps = 2;
        const Vec3 first = is_planar_ ? cross(n, Vec3{0, 0, 1})
                                      : normalized(cross(n, std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
        const Vec3 second = is_planar_ ? Vec3{} : cross(n, first);
        const int across = is_planar_ ? 0 : steps;
        const auto is_own = [body](const StillPart& part) { return part.body == body; };
        const auto is_any = [](const StillPart&) { return true; };
        for (int i = -steps; i <= steps; ++i) {
            for (int j = -across; j <= across; ++j) {
                const Vec3 way = static_cast<double>(i) * first + static_cast<double>(j) * second;
                const Vec3 x = foot + (reach_ / steps) * way;
                if (is_in(x - skin * spacing_ * n, is_own) && !is_in(x + 0.5 * spacing_ * n, is_any)) {
                    return true;
                }
            }
        }
        return false;
    }

 private:
    static bool is_along(const Vec3& one, const Vec3& other) {
        const double cosine = dot(one, other);
        return 1 - cosine * cosine < flat;
    }
    bool is_end(const geometry::ConvexView& view, int face) const {
        return is_planar_ && std::abs(view.normal_z[face]) > 0.5;
    }

    std::optional<Rise> rise_of_ground(const StillPart& part, const Vec3& place, const Vec3& normal) const {
        const auto near = part.ground->field.nearest(to_body(part.pose, place), reach_);
        if (!near || near->distance >= 0) {
            return std::nullopt;
        }
        const Vec3 n = rotate(part.pose.orientation, near->normal);
        return is_along(n, normal) ? std::nullopt : std::optional(Rise{part.body, -near->distance, n, false});
    }

    /// Finds the nearest face of a part with water before it and the place behind it, in the part or beyond.
    std::optional<Rise> rise_of(const StillPart& part, const Vec3& place, const Vec3& normal) const {
        const Vec3 local = to_body(part.pose, place);
        const auto below = [&](int j) { return part.view.offset[j] - dot(part.view.normal(j), local); };
        std::optional<Rise> nearest;
        for (int j = 0; j < part.view.face_count; ++j) {
            const Vec3 n = rotate(part.pose.orientation, part.view.normal(j));
            const double depth = below(j);
            if (is_end(part.view, j) || part.view.is_internal[j] != 0 || is_along(n, normal) || depth <= 0 ||
                depth > reach_ || (nearest && depth >= nearest->depth)) {
                continue;
            }
            bool is_beside = false, is_beyond = false;
            for (int m = 0; m < part.view.face_count && !is_beside; ++m) {
                if (m == j || is_end(part.view, m) || below(m) >= 0) {
                    continue;
                }
                const Vec3 other = rotate(part.pose.orientation, part.view.normal(m));
                const bool is_behind = is_along(other, n) && dot(other, n) < 0;
                is_beyond = is_beyond || is_behind;
                is_beside =
                    !is_behind && (is_along(other, normal) || meets_water(part.body, place + below(m) * other, other));
            }
            if (!is_beside && meets_water(part.body, place + depth * n, n)) {
                nearest = Rise{part.body, depth, n, is_beyond};
            }
        }
        return nearest;
    }

    template <class Wanted>
    bool is_in(const Vec3& x, const Wanted& wanted) const {
        return std::ranges::any_of(parts_, [&](const StillPart& part) {
            if (!wanted(part) || norm_squared(x - part.pose.position) > part.radius * part.radius) {
                return false;
            }
            const Vec3 local = to_body(part.pose, x);
            if (part.ground != nullptr) {
                return part.ground->field.is_inside(local);
            }
            for (int j = 0; j < part.view.face_count; ++j) {
                if (!is_end(part.view, j) && part.view.offset[j] < dot(part.view.normal(j), local)) {
                    return false;
                }
            }
            return true;
        });
    }

    double spacing_, reach_;
    bool is_planar_;
    std::vector<StillPart> parts_;
};

/// Keeps of the faces those that make corners with that of the sample and with each other.
void keep_corners(const Vec3& normal, std::vector<Rise>& rises) {
    std::vector<Rise> kept;
    for (const Rise& rise : rises) {
        Vec3 own = rise.normal - dot(rise.normal, normal) * normal;
        if (!kept.empty()) {
            const Vec3 along = normalized(kept[0].normal - dot(kept[0].normal, normal) * normal);
            own -= dot(own, along) * along;
        }
        if (norm_squared(own) >= flat && kept.size() < most) {
            kept.push_back(rise);
        }
    }
    rises = std::move(kept);
}

/// The vector whose product with c n + c_1 n_1 (+ c_2 n_2) is c_1.
Vec3 dual_of(const Vec3& normal, const std::vector<Rise>& rises, std::size_t which) {
    if (rises.size() == 1) {
        const Vec3 along = rises[0].normal - dot(rises[0].normal, normal) * normal;
        return (1 / norm_squared(along)) * along;
    }
    const Vec3 across = cross(normal, rises[1 - which].normal);
    return (1 / dot(across, rises[which].normal)) * across;
}

}  // namespace

CornerLoads::CornerLoads(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
                         const SampleSettings& settings, const SampleSet& samples) {
    const std::vector<body::Ground> grounds = body::find_grounds(bodies, shapes);
    const StillFaces faces(shapes, bodies, initial, settings, grounds);
    std::vector<std::vector<Share>> of_sample(at(samples.size()));
    parallel::for_each_uneven(samples.size(), 256, [&](std::int64_t i) {
        const BodyId owner = samples.body[at(i)];
        if (!is_still(bodies, owner)) {
            return;
        }
        const Pose pose{initial.position[at(owner.value)], initial.orientation[at(owner.value)]};
        const Vec3 normal = rotate(pose.orientation, Vec3(samples.normal[at(i)]));
        const double above = samples.depth[at(i)] + 0.5 * settings.spacing;
        const Vec3 place = to_world(pose, samples.anchor[at(i)]) + above * normal;
        std::vector<Rise> rises = faces.rising(owner, place, normal);
        if (rises.empty() || !faces.meets_water(owner, place - 0.5 * settings.spacing * normal, normal)) {
            return;
        }
        keep_corners(normal, rises);
        for (std::size_t k = 0; k < rises.size(); ++k) {
            of_sample[at(i)].push_back({static_cast<std::int32_t>(i), rises[k].body, rises[k].is_beyond,
                                        dual_of(normal, rises, k), rises[k].normal});
        }
    });
    for (const std::vector<Share>& some : of_sample) {
        shares_.insert(shares_.end(), some.begin(), some.end());
    }
}

void CornerLoads::hand_over(const SampleView& samples, const body::Motion& motion,
                            const fluid::BoundaryParticles& particles, body::Loads& loads) const {
    std::size_t i = 0;
    const auto count = at(samples.size());
    for (const Share& share : shares_) {
        while (i < count && samples.number(i) < at(share.sample)) {
            ++i;
        }
        if (i == count) {
            break;
        }
        if (samples.number(i) != at(share.sample)) {
            continue;
        }
        const double pull = dot(particles.pressure_force[i], share.dual);
        const Vec3 force = (share.is_beyond ? std::min(0.0, pull) : pull) * share.normal;
        const auto add = [&](BodyId body, const Vec3& part) {
            const std::size_t b = at(body.value);
            loads.force[b] += part;
            loads.torque[b] += cross(particles.position[i] - motion.pose[b].position, part);
        };
        add(samples.body(i), -force);
        add(share.to, force);
    }
}

}  // namespace riprap::coupling
