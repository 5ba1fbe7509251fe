// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/solid_around.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/core/index.hpp"

namespace riprap::coupling {

namespace {

constexpr double parallel = 1e-9;  ///< sine squared or volume of unit vectors that give no point to meet in [-]

}  // namespace

void SolidAround::add(const geometry::ConvexView& shape, const Pose& pose, const Vec3& x, const Vec3& way) {
    const Vec3 local = to_body(pose, x);
    const auto part = static_cast<std::int32_t>(begin_.size()) - 1;
    for (std::int32_t j = 0; j < shape.face_count; ++j) {
        const Vec3 n = rotate(pose.orientation, shape.normal(j));
        faces_.push_back(
            {n, shape.offset[j] - dot(shape.normal(j), local), dot(n, way), part, shape.is_internal[j] != 0});
    }
    begin_.push_back(static_cast<std::int32_t>(faces_.size()));
    way_ = std::max(way_, norm(way));
}

/// Clips the way by the faces of a part that is larger by `slack`.
std::optional<SolidAround::Stretch> SolidAround::stretch_in(std::int32_t part, double slack) const {
    Stretch in{0, 1, false};
    for (std::int32_t f = begin_[at(part)]; f < begin_[at(part) + 1]; ++f) {
        const double before = faces_[at(f)].depth_at(0) + slack, after = faces_[at(f)].depth_at(1) + slack;
        if (before < 0 && after < 0) {
            return std::nullopt;
        }
        if (before < 0) {
            in.begin = std::max(in.begin, before / (before - after));
        } else if (after < 0) {
            in.end = std::min(in.end, before / (before - after));
        }
    }
    return in.begin <= in.end ? std::optional(in) : std::nullopt;
}

/// Joins what the way has in the parts. Without the slack it has to meet one of them, or lie in the gap between two.
std::vector<SolidAround::Stretch> SolidAround::stretches() const {
    std::vector<Stretch> found;
    for (std::int32_t part = 0; at(part) + 1 < begin_.size(); ++part) {
        if (std::optional<Stretch> in = stretch_in(part, slack_)) {
            in->is_met = stretch_in(part, 0).has_value();
            found.push_back(*in);
        }
    }
    std::ranges::sort(found, {}, &Stretch::begin);
    std::vector<Stretch> joined;
    for (const Stretch& in : found) {
        if (joined.empty() || in.begin > joined.back().end) {
            joined.push_back(in);
        } else {
            joined.back().end = std::max(joined.back().end, in.end);
            joined.back().is_met = true;
        }
    }
    std::erase_if(joined, [](const Stretch& in) { return !in.is_met; });
    return joined;
}

bool SolidAround::holds(std::int32_t part, double s, const Vec3& place) const {
    for (std::int32_t f = begin_[at(part)]; f < begin_[at(part) + 1]; ++f) {
        if (faces_[at(f)].depth_at(s) + slack_ < dot(faces_[at(f)].normal, place)) {
            return false;
        }
    }
    return true;
}

bool SolidAround::is_open(double s, const Vec3& place) const {
    for (std::int32_t part = 0; at(part) + 1 < begin_.size(); ++part) {
        if (holds(part, s, place)) {
            return false;
        }
    }
    return true;
}

/// Search for the open water that is nearest at one moment: at the foot on a face, on the line where faces of two parts
/// meet, or at the point where those of three do.
class SolidAround::Search {
 public:
    Search(const SolidAround& solid, double s) : solid_(solid), s_(s), least_(solid.within_) {
        for (const Face& face : solid.faces_) {
            if (!face.is_internal) {
                planes_.push_back({face.normal, face.depth_at(s) + solid.open_, face.part});
            }
        }
    }

    std::optional<Vec3> nearest() {
        for (const Plane& plane : planes_) {
            if (plane.depth > 0) {
                offer(plane.depth * plane.normal);
            }
        }
        for (std::size_t a = 0; a < planes_.size(); ++a) {
            for (std::size_t b = a + 1; b < planes_.size(); ++b) {
                look_at_line(a, b);
            }
        }
        return least_ < solid_.within_ ? std::optional(nearest_) : std::nullopt;
    }

 private:
    struct Plane {
        Vec3 normal;
        double depth;  ///< of the particle below it [m]
        std::int32_t part;
    };

    void offer(const Vec3& place) {
        if (norm_squared(place) < least_ * least_ && solid_.is_open(s_, place)) {
            nearest_ = place;
            least_ = norm(place);
        }
    }

    /// The nearest point of two planes, unless one of the two alone has a nearer one; then those of three.
    void look_at_line(std::size_t a, std::size_t b) {
        const Plane &one = planes_[a], &other = planes_[b];
        if (one.part == other.part || std::abs(one.depth) >= least_ || std::abs(other.depth) >= least_) {
            return;
        }
        const double cosine = dot(one.normal, other.normal), sine_squared = 1 - cosine * cosine;
        if (sine_squared < parallel) {
            return;
        }
        const double along_one = (one.depth - cosine * other.depth) / sine_squared;
        const double along_other = (other.depth - cosine * one.depth) / sine_squared;
        const Vec3 place = along_one * one.normal + along_other * other.normal;
        if (norm_squared(place) >= least_ * least_) {
            return;
        }
        if (along_one >= 0 && along_other >= 0) {
            offer(place);
        }
        for (std::size_t c = b + 1; c < planes_.size(); ++c) {
            look_at_corner(one, other, planes_[c]);
        }
    }

    void look_at_corner(const Plane& one, const Plane& other, const Plane& third) {
        const double volume = dot(one.normal, cross(other.normal, third.normal));
        if (third.part == one.part || third.part == other.part || std::abs(third.depth) >= least_ ||
            volume * volume < parallel) {
            return;
        }
        const std::array<Vec3, 3> dual{1 / volume * cross(other.normal, third.normal),
                                       1 / volume * cross(third.normal, one.normal),
                                       1 / volume * cross(one.normal, other.normal)};
        const Vec3 corner = one.depth * dual[0] + other.depth * dual[1] + third.depth * dual[2];
        if (std::ranges::all_of(dual, [&](const Vec3& d) { return dot(corner, d) >= 0; })) {
            offer(corner);
        }
    }

    const SolidAround& solid_;
    double s_, least_;
    Vec3 nearest_{};
    std::vector<Plane> planes_;
};

/// Returns the vector to the nearest open water.
std::optional<Vec3> SolidAround::nearest_water(double s) const { return Search(*this, s).nearest(); }

/// Distance along a direction to where the solid ends; parts that touch go on in each other.
double SolidAround::end_of_solid(double s, const Vec3& direction) const {
    double end = 0;
    for (std::size_t round = 0; round < begin_.size(); ++round) {
        double farthest = end;
        for (std::int32_t part = 0; at(part) + 1 < begin_.size(); ++part) {
            if (!holds(part, s, end * direction)) {
                continue;
            }
            double exit = infinity;
            for (std::int32_t f = begin_[at(part)]; f < begin_[at(part) + 1]; ++f) {
                const double rate = dot(faces_[at(f)].normal, direction);
                if (rate > parallel) {
                    exit = std::min(exit, faces_[at(f)].depth_at(s) / rate);
                }
            }
            farthest = std::max(farthest, exit);
        }
        if (!(farthest > end) || std::isinf(farthest)) {
            return farthest;
        }
        end = farthest;
    }
    return end;
}

bool SolidAround::changes_sides(double from, double to, const Vec3& before, const Vec3& after) const {
    constexpr double away = -0.5, beyond_an_edge = 2;
    const double deepest = std::max(norm(before), norm(after));
    const Vec3 n = before / norm(before), m = after / norm(after), sum = n + m;
    const double twice_sine = norm(sum);
    if (dot(n, m) >= 0) {
        return false;
    }
    if (twice_sine * twice_sine < parallel) {
        return true;
    }
    const double end = std::max(end_of_solid(from, sum / twice_sine), end_of_solid(to, sum / twice_sine));
    return end > 2 * way_ && (dot(n, m) < away || end > beyond_an_edge * deepest / (0.5 * twice_sine));
}

bool SolidAround::is_gone_through() const {
    for (const Stretch& in : stretches()) {
        const double middle = 0.5 * (in.begin + in.end);
        const std::optional<Vec3> first = nearest_water(in.begin), half = nearest_water(middle),
                                  last = nearest_water(in.end);
        if (!first || !half || !last) {
            continue;
        }
        if (changes_sides(in.begin, middle, *first, *half) || changes_sides(middle, in.end, *half, *last)) {
            return true;
        }
    }
    return false;
}

}  // namespace riprap::coupling
