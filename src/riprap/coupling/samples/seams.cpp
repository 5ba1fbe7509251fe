// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/seams.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

constexpr double same_depth = 1e-6;  ///< of a spacing: depths closer than this are equal
constexpr double same_place = 1e-3;  ///< of a spacing: middles of cells closer than this are one
constexpr double flat = 0.1;         ///< sine squared of the angle of faces below which they make no corner
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Depth of a place in a body, negative outside, and the outward normal of the nearest face.
struct Depth {
    double value;
    Vec3 normal;  ///< in the axes that the place is given in
};

Depth find_depth(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                 BodyId body, const Vec3& x) {
    const Pose pose{state.position[at(body.value)], state.orientation[at(body.value)]};
    const Vec3 in_body = to_body(pose, x);
    Depth deepest{-infinity, {}};
    for (std::int32_t p = bodies.part_begin[at(body.value)]; p < bodies.part_begin[at(body.value) + 1]; ++p) {
        const body::Part& part = bodies.parts[at(p)];
        const geometry::ConvexView view = shapes.view(part.shape);
        const Vec3 local = to_body(part.local, in_body);
        Depth depth{infinity, {}};
        for (std::int32_t j = 0; j < view.face_count; ++j) {
            const double below = view.offset[j] - dot(view.normal(j), local);
            const bool is_end = bodies.is_planar && std::abs(view.normal_z[j]) > 0.5;
            if (!is_end && below < depth.value) {
                depth = {below, view.normal(j)};
            }
        }
        if (depth.value > deepest.value) {
            deepest = {depth.value, rotate(pose.orientation, rotate(part.local.orientation, depth.normal))};
        }
    }
    return deepest;
}

/// Depth in ground, sought up to `reach` from its surface: near by first, since a look costs as the square of its
/// reach.
Depth depth_in_ground(const body::Ground& ground, const Pose& pose, const Vec3& x, double reach) {
    const Vec3 in_body = to_body(pose, x);
    for (const double part : {0.125, 0.25, 0.5, 1.0}) {
        if (const auto near = ground.field.nearest(in_body, part * reach)) {
            return {-near->distance, rotate(pose.orientation, near->normal)};
        }
    }
    return {ground.field.is_inside(in_body) ? reach : -reach, {0, 0, 1}};
}

/// Where samples stand, body by body.
class SamplePlaces {
 public:
    SamplePlaces(const SampleSet& samples, const body::BodyState& state, double spacing)
        : bodies_(samples.body.begin(), samples.body.end()), near_(same_place * spacing) {
        places_.reserve(at(samples.size()));
        for (std::size_t i = 0; i < at(samples.size()); ++i) {
            const auto b = at(samples.body[i].value);
            places_.push_back(to_world({state.position[b], state.orientation[b]}, samples.anchor[i]));
        }
        if (!places_.empty()) {
            cells_.build(places_, fluid::Domain{}, spacing);
        }
    }
    const Vec3& place(std::int64_t sample) const { return places_[at(sample)]; }
    /// Tells whether a body has a sample at x.
    bool has_sample(BodyId body, const Vec3& x) const {
        return cells_.view().any_near(x, [&](std::int64_t k) {
            return bodies_[at(k)] == body && norm_squared(places_[at(k)] - x) <= near_ * near_;
        });
    }

 private:
    std::vector<BodyId> bodies_;
    std::vector<Vec3> places_;
    double near_;
    fluid::CellGrid cells_;
};

/// Decides what of a cell belongs to whom.
class Seams {
 public:
    Seams(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
          const SampleSettings& settings, std::span<const body::Ground> grounds, const SamplePlaces& samples)
        : shapes_(shapes),
          bodies_(bodies),
          state_(state),
          settings_(settings),
          grounds_(grounds),
          samples_(&samples),
          dimension_(bodies.is_planar ? 2 : 3) {
        for (std::int32_t b = 0; b < bodies.size(); ++b) {
            const bool is_dry = !settings.is_dry.empty() && settings.is_dry[at(b)] != 0;
            if (is_still(bodies, BodyId{b}) && !is_dry) {
                still_.push_back({BodyId{b}, radius_of(BodyId{b})});
            }
        }
    }

    /// The share of its volume that a sample of a still body keeps [-].
    double share(BodyId owner, const Vec3& x, const Vec3& normal) const {
        // Depths change by no more than the way, so their differences by no more than twice half a diagonal.
        const double reach = std::sqrt(static_cast<double>(dimension_)) * settings_.spacing;
        const double own = depth(owner, x).value;
        std::vector<Rival> rivals;
        Vec3 other_normal = normal;
        for (const Still& still : still_) {
            const Vec3& centre = state_.position[at(still.body.value)];
            if (still.body == owner || norm_squared(x - centre) > still.radius * still.radius) {
                continue;
            }
            const Depth other = depth(still.body, x);
            const double more = other.value - own;
            if (more > reach) {
                return 0;
            }
            if (more > -reach) {
                const bool is_tied = std::abs(more) <= tolerance() && samples_->has_sample(still.body, x);
                if (is_tied && still.body < owner) {
                    return 0;
                }
                other_normal = rivals.empty() ? other.normal : other_normal;
                rivals.push_back({still.body, is_tied});
            }
        }
        return rivals.empty() ? 1 : share_of_cell(owner, x, normal, other_normal, rivals);
    }

    /// Tells whether x lies in so many still bodies that none of its directions runs along the faces of all of them.
    bool is_in_vertex(BodyId owner, const Vec3& x, const Vec3& normal) const {
        std::vector<Vec3> across{normal};  // a base of the directions across their faces, orthonormal
        for (const Still& still : still_) {
            const Vec3& centre = state_.position[at(still.body.value)];
            if (still.body == owner || norm_squared(x - centre) > still.radius * still.radius) {
                continue;
            }
            const Depth other = depth(still.body, x);
            Vec3 rest = other.normal;
            for (const Vec3& known : across) {
                rest -= dot(other.normal, known) * known;
            }
            if (other.value > 0 && norm_squared(rest) > flat) {
                across.push_back(normalized(rest));
            }
        }
        return across.size() >= at(dimension_);
    }

 private:
    struct Still {
        BodyId body;
        double radius;
    };
    struct Rival {
        BodyId body;
        bool is_tied;  ///< as deep at the middle of the cell, with a cell of its own there, and leaves its part
    };

    double tolerance() const { return same_depth * settings_.spacing; }
    Depth depth(BodyId body, const Vec3& x) const {
        for (const body::Ground& ground : grounds_) {
            if (ground.body == body) {
                const Pose pose{state_.position[at(body.value)], state_.orientation[at(body.value)]};
                return depth_in_ground(ground, pose, x, 2 * (settings_.reach + settings_.spacing));
            }
        }
        return find_depth(shapes_, bodies_, state_, body, x);
    }
    double radius_of(BodyId body) const {
        double radius = 0;
        for (std::int32_t p = bodies_.part_begin[at(body.value)]; p < bodies_.part_begin[at(body.value) + 1]; ++p) {
            const body::Part& part = bodies_.parts[at(p)];
            radius = std::max(radius, norm(part.local.position) + shapes_.view(part.shape).circumradius);
        }
        return radius + settings_.spacing;
    }

    double share_of_cell(BodyId owner, const Vec3& x, const Vec3& normal, const Vec3& other_normal,
                         std::span<const Rival> rivals) const {
        const int n = dimension_ == 2 ? 8 : 6;  // points a side
        std::array<Vec3, 3> axis = axes_of(normal, other_normal);
        const auto offset = [n](int i) { return (i + 0.5) / n - 0.5; };
        double owned = 0, inside = 0;
        for (int k = 0; k < (dimension_ == 2 ? 1 : n); ++k) {
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    const Vec3 along = dimension_ == 2 ? Vec3{} : offset(k) * axis[2];
                    const Vec3 y = x + settings_.spacing * (offset(i) * axis[0] + offset(j) * axis[1] + along);
                    const double own = depth(owner, y).value;
                    inside += own > 0 ? 1 : 0;
                    owned += own > 0 ? part_of_point(own, y, rivals) : 0;
                }
            }
        }
        return inside > 0 ? owned / inside : 1;
    }

    /// Returns the share of the owner in a point of its cell: all where it is deepest, an even part where others are as
    /// deep.
    double part_of_point(double own, const Vec3& y, std::span<const Rival> rivals) const {
        double most_tied = own, most_other = -infinity;
        int equals = 0;
        for (const Rival& rival : rivals) {
            const double other = depth(rival.body, y).value;
            (rival.is_tied ? most_tied : most_other) = std::max(rival.is_tied ? most_tied : most_other, other);
        }
        for (const Rival& rival : rivals) {
            const bool is_equal = !rival.is_tied && std::abs(depth(rival.body, y).value - most_tied) <= tolerance();
            equals += is_equal ? 1 : 0;
        }
        return most_other > most_tied + tolerance() ? 0 : 1.0 / (1 + equals);
    }

    /// The normal, across the seam and along it.
    std::array<Vec3, 3> axes_of(const Vec3& normal, const Vec3& other) const {
        Vec3 along = dimension_ == 2 ? Vec3{0, 0, 1} : cross(normal, other);
        constexpr double parallel = 1e-6;  // sine of the angle
        if (norm(along) < parallel) {
            along = cross(normal, std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
        }
        along = normalized(along);
        return {normal, cross(along, normal), along};
    }

    const geometry::ShapeSet& shapes_;
    const body::BodySet& bodies_;
    const body::BodyState& state_;
    const SampleSettings& settings_;
    std::span<const body::Ground> grounds_;
    const SamplePlaces* samples_;
    int dimension_;
    std::vector<Still> still_;
};

}  // namespace

bool is_still(const body::BodySet& bodies, BodyId body) {
    return bodies.drive[at(body.value)] == body::Drive::fixed && bodies.release_time[at(body.value)] == infinity;
}

void share_seams(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                 const SampleSettings& settings, std::span<const body::Ground> grounds, SampleSet& samples) {
    const SamplePlaces places(samples, state, settings.spacing);
    const Seams seams(shapes, bodies, state, settings, grounds, places);
    std::vector<double> share(at(samples.size()), 1);
    std::vector<std::uint8_t> is_in_vertex(at(samples.size()), 0);
    parallel::for_each_uneven(samples.size(), 256, [&](std::int64_t i) {
        const BodyId owner = samples.body[at(i)];
        if (is_still(bodies, owner)) {
            const Pose pose{state.position[at(owner.value)], state.orientation[at(owner.value)]};
            const Vec3 normal = rotate(pose.orientation, samples.normal[at(i)]);
            share[at(i)] = seams.share(owner, places.place(i), normal);
            is_in_vertex[at(i)] = seams.is_in_vertex(owner, places.place(i), normal) ? 1 : 0;
        }
    });
    for (std::size_t i = 0; i < share.size(); ++i) {
        samples.volume.set(i, samples.volume[i] * share[i]);
        samples.is_in_vertex.set(i, is_in_vertex[i]);
    }
    samples.for_each_column([&share](auto& column) {
        std::remove_reference_t<decltype(column)> kept;
        for (std::size_t i = 0; i < share.size(); ++i) {
            if (share[i] > 0) {
                kept.push_back(column[i]);
            }
        }
        column = std::move(kept);
    });
}

}  // namespace riprap::coupling
