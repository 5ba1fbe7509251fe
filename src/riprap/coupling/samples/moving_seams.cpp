// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/moving_seams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double same_depth = 1e-6;  ///< of a spacing: depths closer than this are equal
constexpr double flat = 0.1;         ///< sine squared of the angle of two faces below which they make no corner

/// The part of a unit square about the origin below the line a x + b y = s (a, b >= 0, not both 0).
double share_below(double a, double b, double s) {
    const double width = a + b, more = std::max(a, b) / width, less = std::min(a, b) / width;
    const double t = std::clamp(0.5 + s / width, 0.0, 1.0), rest = 1 - t;
    if (t < less) {
        return t * t / (2 * more * less);
    }
    return rest < less ? 1 - rest * rest / (2 * more * less) : (t - 0.5 * less) / more;
}

/// The part of a cell of one spacing that lies below a face, its middle at this depth. By its middle alone, a row that
/// lies at another height than half a spacing would count for one body or the other as a whole, and the sums over both
/// sides of the seam no longer balance: a wall at rest with its rows half a spacing higher bears 1.5 % of what presses
/// on it along its face.
double share_within(double depth, double spacing) { return std::clamp(0.5 + depth / spacing, 0.0, 1.0); }

struct Box {
    Vec3 low, high;
};

/// The box of a body, grown by a margin; without end for half-spaces.
Box box_of(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const Pose& pose, BodyId body,
           double margin) {
    const Vec3 all{infinity, infinity, infinity}, grown = margin * Vec3{1, 1, 1};
    Box box{all, -all};
    for (std::int32_t p = bodies.part_begin[at(body.value)]; p < bodies.part_begin[at(body.value) + 1]; ++p) {
        const body::Part& part = bodies.parts[at(p)];
        const geometry::ConvexView view = shapes.view(part.shape);
        if (view.vertex_count == 0) {
            return {-all, all};
        }
        for (int v = 0; v < view.vertex_count; ++v) {
            const Vec3 x = to_world(pose, to_world(part.local, view.vertex(v)));
            box = {min(box.low, x), max(box.high, x)};
        }
    }
    return {box.low - grown, box.high + grown};
}

bool meets_ball(const Box& box, const Vec3& centre, double radius) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(centre[axis] + radius >= box.low[axis] && centre[axis] - radius <= box.high[axis])) {
            return false;
        }
    }
    return true;
}

}  // namespace

MovingSeams::MovingSeams(const geometry::ShapeSet& shapes, const body::BodySet& bodies,
                         std::span<const std::uint8_t> is_dry, const body::Motion& motion, double spacing, double reach)
    : shapes_(shapes), bodies_(bodies), motion_(motion), spacing_(spacing), reach_(reach) {
    const auto is_driven = [&](BodyId b) { return bodies.drive[at(b.value)] == body::Drive::driven; };
    for (std::int32_t b = 0; b < bodies.size() && !bodies.driven_bodies.empty(); ++b) {
        if (!body::may_move(bodies, at(b)) && (is_dry.empty() || is_dry[at(b)] == 0)) {
            held_.push_back(BodyId{b});
        }
    }
    if (std::ranges::none_of(held_, is_driven)) {
        held_.clear();
    }
    for (const BodyId one : held_) {
        if (!is_driven(one)) {
            continue;
        }
        for (const BodyId other : held_) {
            const bool is_met_already = is_driven(other) && !(one < other);
            if (other != one && !is_met_already) {
                add_pair(one, other);
            }
        }
    }
    std::ranges::sort(sides_, {}, &Side::body);
}

MovingSeams::Side& MovingSeams::side_of(BodyId body) {
    const auto found = std::ranges::find(sides_, body, &Side::body);
    if (found != sides_.end()) {
        return *found;
    }
    Side& side = sides_.emplace_back();
    side.body = body;
    return side;
}

void MovingSeams::add_pair(BodyId one, BodyId other) {
    std::vector<PlacedShape> of_one, of_other;
    add_parts(other, one, of_other);
    if (of_other.empty()) {
        return;
    }
    add_parts(one, other, of_one);
    std::vector<PlacedShape>& beside_one = side_of(one).others;
    beside_one.insert(beside_one.end(), of_other.begin(), of_other.end());
    std::vector<PlacedShape>& beside_other = side_of(other).others;
    beside_other.insert(beside_other.end(), of_one.begin(), of_one.end());
}

/// Adds the parts of a body that come near another one.
void MovingSeams::add_parts(BodyId body, BodyId near, std::vector<PlacedShape>& parts) const {
    const Box box = box_of(shapes_, bodies_, motion_.pose[at(near.value)], near, reach_ + spacing_);
    const Pose& pose = motion_.pose[at(body.value)];
    for (std::int32_t p = bodies_.part_begin[at(body.value)]; p < bodies_.part_begin[at(body.value) + 1]; ++p) {
        const body::Part& part = bodies_.parts[at(p)];
        const geometry::ConvexView view = shapes_.view(part.shape);
        const Pose placed{to_world(pose, part.local.position), pose.orientation * part.local.orientation};
        if (meets_ball(box, placed.position, view.circumradius)) {
            parts.push_back({view, placed, body});
        }
    }
}

/// Depth below the faces of a part that carry a field; -infinity behind one that does not.
double MovingSeams::depth_in(const PlacedShape& part, const Vec3& x, Vec3& normal) const {
    const Vec3 local = to_body(part.pose, x);
    double depth = infinity;
    for (std::int32_t j = 0; j < part.view.face_count; ++j) {
        const Vec3 n = part.view.normal(j);
        const double below = part.view.offset[j] - dot(n, local);
        if (bodies_.is_planar && std::abs(n.z) > 0.5) {
            continue;
        }
        if (part.view.is_internal[j] != 0) {
            if (below < 0) {
                return -infinity;
            }
        } else if (below < depth) {
            depth = below;
            normal = n;
        }
    }
    normal = rotate(part.pose.orientation, normal);
    return depth;
}

std::optional<MovingSeams::Meeting> MovingSeams::meet(const Side& side, const Vec3& x) const {
    std::optional<Meeting> deepest;
    for (const PlacedShape& part : side.others) {
        const double radius = part.view.circumradius + reach_;
        if (norm_squared(x - part.pose.position) > radius * radius) {
            continue;
        }
        Vec3 normal{};
        const double depth = depth_in(part, x, normal);
        if (depth > -reach_ && (!deepest || depth > deepest->depth)) {
            deepest = Meeting{part.body, depth, normal};
        }
    }
    return deepest;
}

double MovingSeams::share_of(double depth, const Vec3& normal, const Meeting& other) const {
    const double more = depth - other.depth, cosine = dot(normal, other.normal);
    const double across = norm(other.normal - cosine * normal), along = std::abs(1 - cosine);
    if (across + along < same_depth) {
        return more > same_depth * spacing_ ? 1 : more < -same_depth * spacing_ ? 0 : 0.5;
    }
    return share_below(along, across, more / spacing_);
}

/// Calls visit(i, side, other) for the samples that another body is near.
template <class Visit>
void MovingSeams::visit_meetings(const SampleView& samples, const fluid::BoundaryParticles& particles,
                                 const Visit& visit) const {
    for (const Side& side : sides_) {
        const std::size_t end = samples.begin_of(BodyId{side.body.value + 1});
        for (std::size_t i = samples.begin_of(side.body); i < end; ++i) {
            if (const std::optional<Meeting> other = meet(side, particles.position[i])) {
                visit(i, side, *other);
            }
        }
    }
}

namespace {

/// v - k (n - c n'), so that the velocity of water in the corner slides along both faces: see MovingSeams.
Vec3 in_shared_solid(const Vec3& own, const Vec3& other, const Vec3& normal, const Vec3& other_normal) {
    const double cosine = dot(normal, other_normal), sine_squared = 1 - cosine * cosine;
    if (sine_squared < flat) {
        return own;
    }
    return own - dot(normal, own - other) / sine_squared * (normal - cosine * other_normal);
}

struct PointMotion {
    Vec3 velocity, acceleration;
};
PointMotion motion_at(const body::Motion& motion, BodyId body, const Vec3& x) {
    const std::size_t b = at(body.value);
    const Vec3 arm = x - motion.pose[b].position, swing = cross(motion.angular_velocity[b], arm);
    return {motion.velocity[b] + swing, motion.acceleration[b] + cross(motion.angular_acceleration[b], arm) +
                                            cross(motion.angular_velocity[b], swing)};
}

}  // namespace

void MovingSeams::take_back(const SampleView& samples, fluid::BoundaryParticles& particles) const {
    for (const BodyId body : held_) {
        const bool is_still = bodies_.drive[at(body.value)] == body::Drive::fixed;  // never placed again
        const std::size_t end = samples.begin_of(BodyId{body.value + 1});
        for (std::size_t i = samples.begin_of(body); i < end; ++i) {
            particles.volume[i] = samples.volume(i);
            if (is_still) {
                particles.velocity[i] = particles.acceleration[i] = {};
            }
        }
    }
}

void MovingSeams::share(const SampleView& samples, fluid::BoundaryParticles& particles) const {
    take_back(samples, particles);
    visit_meetings(samples, particles, [&](std::size_t i, const Side& side, const Meeting& other) {
        const Vec3 normal = rotate(motion_.pose[at(side.body.value)].orientation, samples.normal(i));
        particles.volume[i] *= share_of(samples.depth(i), normal, other);
        const double within = share_within(other.depth, spacing_);
        if (within == 0) {
            return;
        }
        const PointMotion of_other = motion_at(motion_, other.body, particles.position[i]);
        const auto lead = [&](Vec3& own, const Vec3& of_it) {
            own += within * (in_shared_solid(own, of_it, normal, other.normal) - own);
        };
        lead(particles.velocity[i], of_other.velocity);
        lead(particles.acceleration[i], of_other.acceleration);
        if (i < particles.normal.size()) {
            particles.normal[i] = std::sqrt(1 - within) * normal;  // in a vertex too
        }
    });
}

/// Calls visit(i, from, to, force) for the forces that samples in shared solid hand over.
template <class Visit>
void MovingSeams::visit_handed(const SampleView& samples, const fluid::BoundaryParticles& particles,
                               const Visit& visit) const {
    visit_meetings(samples, particles, [&](std::size_t i, const Side& side, const Meeting& other) {
        const Vec3 normal = rotate(motion_.pose[at(side.body.value)].orientation, samples.normal(i));
        const Vec3 along = other.normal - dot(normal, other.normal) * normal;
        const double within = share_within(other.depth, spacing_);
        if (within > 0) {
            const bool is_corner = norm_squared(along) >= flat;
            const double share = is_corner ? dot(particles.pressure_force[i], along) / norm_squared(along) : 0;
            visit(i, side.body, other.body, within * share * along);
        }
    });
}

void MovingSeams::hand_over(const SampleView& samples, const fluid::BoundaryParticles& particles,
                            body::Loads& loads) const {
    visit_handed(samples, particles, [&](std::size_t i, BodyId from, BodyId to, const Vec3& force) {
        const auto add = [&](BodyId body, const Vec3& part) {
            const std::size_t b = at(body.value);
            loads.force[b] += part;
            loads.torque[b] += cross(particles.position[i] - motion_.pose[b].position, part);
        };
        add(from, -force);
        add(to, force);
    });
}

double MovingSeams::handed_power(const SampleView& samples, const fluid::BoundaryParticles& particles) const {
    double power = 0;
    visit_handed(samples, particles, [&](std::size_t i, BodyId from, BodyId to, const Vec3& force) {
        const Vec3& x = particles.position[i];
        const Vec3 kept = particles.pressure_force[i] - force;
        power += dot(kept, motion_at(motion_, from, x).velocity) + dot(force, motion_at(motion_, to, x).velocity) -
                 dot(particles.pressure_force[i], particles.velocity[i]);
    });
    return power;
}

}  // namespace riprap::coupling
