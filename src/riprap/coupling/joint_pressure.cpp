// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joint_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"
#include "riprap/fluid/particle/kernel.hpp"

namespace riprap::coupling {

namespace {

constexpr std::int32_t still_solid = -1;  ///< all bodies that never move are one
constexpr std::int64_t grain = 64;

std::int32_t solid_of(const JointSolids& solids, BodyId body) {
    return solids.is_still[at(body.value)] != 0 ? still_solid : body.value;
}

bool is_loose(const JointSolids& solids, std::int32_t solid) {
    return solid != still_solid && solids.is_loose[at(solid)] != 0;
}

/// Share of a spacing that two solids may come nearer before pairs are looked for again.
constexpr double skin = 0.5;

/// Samples of two solids farther apart have nothing to do with each other before they are looked for again: faces are
/// brought together by a spacing.
double joint_reach(const fluid::SphSettings& settings) {
    return settings.support_radius() + (1 + skin) * settings.spacing;
}

/// Whether some loose body meets water.
bool is_any_wet(const SampleSet& near, const JointSolids& solids, const fluid::WaterAtWalls& water) {
    for (std::size_t i = 0; i < near.body.size(); ++i) {
        if (water.weight[i] > 0 && solids.is_loose[at(near.body[i].value)] != 0) {
            return true;
        }
    }
    return false;
}

/// A piece of the rim of a joint.
struct RimPiece {
    Vec3 place;
    double weight;    ///< s V
    double water;     ///< c
    double pressure;  ///< of the water there [Pa]
};

/// s n_ij, which brings together faces that look at each other.
/// @param d       x_i - x_j
/// @param depths  of both samples below their faces, together [m]
Vec3 closing(const Vec3& d, const Vec3& normal_i, const Vec3& normal_j, double depths, double spacing) {
    if (!(dot(normal_i, normal_j) < -0.5)) {
        return {};
    }
    const Vec3 across = normal_i - normal_j, n = across / norm(across);
    const double gap = -dot(d, n) - depths;
    return std::clamp(std::min(gap, 2 * spacing - gap), 0.0, spacing) * n;
}

/// p at x, harmonic in the joint.
double pressure_in_joint(const std::vector<RimPiece>& rim, const Vec3& x, const fluid::NearestImage& nearest,
                         const fluid::SphSettings& settings, const Vec3& gravity) {
    const double blur = 0.25 * settings.spacing * settings.spacing;  // a piece of the rim is no point
    double sum = 0, weights = 0;
    for (const RimPiece& piece : rim) {
        const Vec3 d = nearest(x - piece.place);
        const double square = dot(d, d) + blur;
        const double weight = piece.weight / (settings.domain.dimension == 2 ? std::sqrt(square) : square);
        weights += weight;
        if (piece.water > 0) {
            sum += weight * piece.water * (piece.pressure + settings.rest_density * dot(gravity, d));
        }
    }
    return weights > 0 ? std::max(0.0, sum / weights) : 0;
}

}  // namespace

template <class F>
void JointPressure::for_each_link(const SampleSet& near, const fluid::SphSettings& settings, std::size_t i,
                                  const F& f) const {
    const fluid::WendlandC2 kernel(settings.smoothing_length(), settings.domain.dimension);
    const fluid::NearestImage nearest(settings.domain);
    const Member& member = members_[i];
    const double depth = near.depth[at(member.sample)];
    for (auto k = at(pair_begin_[i]); k < at(pair_begin_[i + 1]); ++k) {
        const Member& other = members_[at(pairs_[k])];
        Link link{};
        link.d = nearest(member.place - other.place);
        link.closed = link.d + closing(link.d, member.normal, other.normal, depth + near.depth[at(other.sample)],
                                       settings.spacing);
        link.slope = kernel.slope_over_r(norm(link.d));
        link.slope_of_closed = kernel.slope_over_r(norm(link.closed));
        if (link.slope_of_closed != 0 || link.slope != 0) {
            f(at(pairs_[k]), link);
        }
    }
}

bool JointPressure::has_pairs_for(const SampleSet& near, const JointSolids& solids,
                                  const fluid::BoundaryParticles& walls, double spacing) const {
    if (paired_at_.size() != at(near.size())) {
        return false;
    }
    const double most = parallel::reduce(
        near.size(), 0.0,
        [&](std::int64_t i) {
            const bool is_still = solids.is_still[at(near.body[at(i)].value)] != 0;
            return is_still ? 0.0 : norm_squared(walls.position[at(i)] - paired_at_[at(i)]);
        },
        [](double a, double b) { return std::max(a, b); });
    return most < 0.25 * skin * skin * spacing * spacing;
}

void JointPressure::find_members(const SampleSet& near, const JointSolids& solids,
                                 const fluid::BoundaryParticles& walls, const fluid::SphSettings& settings) {
    std::vector<std::uint8_t> is_member(at(near.size()), 0);
    std::vector<Vec3> loose;
    for (std::size_t i = 0; i < is_member.size(); ++i) {
        if (solids.is_loose[at(near.body[i].value)] != 0) {
            is_member[i] = 1;
            loose.push_back(walls.position[i]);
        }
    }
    const double reach = joint_reach(settings);
    fluid::CellGrid grid;
    grid.build(loose, settings.domain, reach);
    const fluid::NearestImage nearest(settings.domain);
    parallel::for_each_uneven(near.size(), grain, [&](std::int64_t i) {
        if (is_member[at(i)] == 0) {
            const Vec3& x = walls.position[at(i)];
            grid.for_each_near(x, [&](std::int64_t j) {
                is_member[at(i)] |= static_cast<std::uint8_t>(norm(nearest(x - loose[at(j)])) < reach);
            });
        }
    });
    members_.clear();
    for (std::size_t i = 0; i < is_member.size(); ++i) {
        if (is_member[i] != 0) {
            members_.push_back({static_cast<std::int32_t>(i), solid_of(solids, near.body[i]), {}, {}, {}, 1});
        }
    }
    paired_at_ = walls.position;
    paired_at_.resize(at(near.size()));
}

void JointPressure::find_pairs(const SampleSet& near, const JointSolids& solids, const fluid::SphSettings& settings) {
    std::vector<Vec3> places;
    for (const Member& member : members_) {
        places.push_back(member.place);
    }
    fluid::CellGrid grid;
    grid.build(places, settings.domain, joint_reach(settings));
    const fluid::NearestImage nearest(settings.domain);
    const double reach = settings.support_radius() + skin * settings.spacing;
    std::vector<std::vector<std::int32_t>> met(members_.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(members_.size()), grain, [&](std::int64_t i) {
        const Member& member = members_[at(i)];
        const bool is_any = is_loose(solids, member.solid);
        std::vector<std::int32_t>& mine = met[at(i)];
        grid.for_each_near(member.place, [&](std::int64_t j) {
            const Member& other = members_[at(j)];
            if (other.solid == member.solid || !(is_any || is_loose(solids, other.solid))) {
                return;
            }
            const Vec3 d = nearest(member.place - other.place);
            const double depths = near.depth[at(member.sample)] + near.depth[at(other.sample)];
            const double least = std::max(0.0, norm(d) - settings.spacing);  // with faces brought together
            const bool is_across = dot(member.normal, other.normal) < 0;
            if (norm(d) < reach || (is_across && depths < reach && least < reach)) {
                mine.push_back(static_cast<std::int32_t>(j));
            }
        });
        std::sort(mine.begin(), mine.end());
    });
    pair_begin_.assign(1, 0);
    pairs_.clear();
    for (const std::vector<std::int32_t>& mine : met) {
        pairs_.insert(pairs_.end(), mine.begin(), mine.end());
        pair_begin_.push_back(static_cast<std::int64_t>(pairs_.size()));
    }
}

void JointPressure::place_members(const SampleSet& near, const BodyMotion& motion,
                                  const fluid::BoundaryParticles& walls) {
    parallel::for_each(static_cast<std::int64_t>(members_.size()), [&](std::int64_t i) {
        Member& member = members_[at(i)];
        const auto sample = at(member.sample);
        member.place = walls.position[sample];
        member.normal = rotate(motion.pose[at(near.body[sample].value)].orientation, near.normal[sample]);
    });
}

void JointPressure::find_sides(const SampleSet& near, std::span<const Vec3> slopes, const BodyMotion& motion,
                               const fluid::WaterAtWalls& water, const fluid::SphSettings& settings) {
    std::vector<std::vector<std::int32_t>> others(members_.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(members_.size()), grain, [&](std::int64_t index) {
        Member& member = members_[at(index)];
        std::vector<std::int32_t>& met = others[at(index)];
        Vec3 slope_of_others{};
        for_each_link(near, settings, at(index), [&](std::size_t j, const Link& link) {
            slope_of_others += near.volume[at(members_[j].sample)] * link.slope * link.d;
            if (std::find(met.begin(), met.end(), members_[j].solid) == met.end()) {
                met.push_back(members_[j].solid);
            }
        });
        const auto sample = at(member.sample);
        const Quat& turn = motion.pose[at(near.body[sample].value)].orientation;
        const Vec3 own = member.solid == still_solid ? slopes[sample] : rotate(turn, slopes[sample]);
        const Vec3 slope = own + slope_of_others;
        member.rim = slope - dot(slope, member.normal) * member.normal;
        const double into_solid = -dot(own, member.normal), into_water = dot(water.slope[sample], member.normal);
        member.dry_share = into_water > 0 && into_solid > 0 ? std::max(0.0, 1 - into_water / into_solid) : 1;
    });
    side_begin_.assign(1, 0);
    sides_.clear();
    for (std::size_t i = 0; i < members_.size(); ++i) {
        for (const std::int32_t other : others[i]) {
            sides_.push_back({static_cast<std::int32_t>(i), other, 0});
        }
        side_begin_.push_back(static_cast<std::int32_t>(sides_.size()));
    }
}

void JointPressure::find_pressures(const SampleSet& near, const fluid::WaterAtWalls& water,
                                   const fluid::SphSettings& settings, const Vec3& gravity) {
    const auto joint_of = [&](std::size_t side) {
        const std::int32_t solid = members_[at(sides_[side].member)].solid, other = sides_[side].other;
        return std::pair(std::min(solid, other), std::max(solid, other));
    };
    std::vector<std::size_t> order(sides_.size()), begin;
    for (std::size_t k = 0; k < order.size(); ++k) {
        order[k] = k;
    }
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return std::pair(joint_of(a), a) < std::pair(joint_of(b), b); });
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k == 0 || joint_of(order[k]) != joint_of(order[k - 1])) {
            begin.push_back(k);
        }
    }
    begin.push_back(order.size());
    const fluid::NearestImage nearest(settings.domain);
    const double h = settings.smoothing_length();
    parallel::for_each_uneven(static_cast<std::int64_t>(begin.size()) - 1, 1, [&](std::int64_t joint) {
        std::vector<RimPiece> rim;
        const std::span<const std::size_t> sides(order.data() + begin[at(joint)], order.data() + begin[at(joint) + 1]);
        for (const std::size_t side : sides) {
            const Member& member = members_[at(sides_[side].member)];
            const auto sample = at(member.sample);
            const double strength = h * norm(member.rim) - 0.1;
            if (strength > 0 && near.depth[sample] < settings.spacing) {
                const double share = -dot(member.rim, water.slope[sample]) / (0.85 * dot(member.rim, member.rim));
                rim.push_back({member.place, strength * near.volume[sample], std::clamp(share, 0.0, 1.0),
                               water.pressure[sample]});
            }
        }
        for (const std::size_t side : sides) {
            sides_[side].pressure =
                pressure_in_joint(rim, members_[at(sides_[side].member)].place, nearest, settings, gravity);
        }
    });
}

double JointPressure::pressure_of(std::size_t member, std::int32_t other) const {
    for (auto k = at(side_begin_[member]); k < at(side_begin_[member + 1]); ++k) {
        if (sides_[k].other == other) {
            return sides_[k].pressure;
        }
    }
    return 0;
}

void JointPressure::find(const SampleSet& near, std::span<const Vec3> slopes, const JointSolids& solids,
                         const BodyMotion& motion, const fluid::BoundaryParticles& walls,
                         const fluid::WaterAtWalls& water, const fluid::SphSettings& settings, const Vec3& gravity,
                         std::vector<Vec3>& force) {
    force.clear();
    if (!is_any_wet(near, solids, water)) {
        return;
    }
    const bool is_kept = has_pairs_for(near, solids, walls, settings.spacing);
    if (!is_kept) {
        find_members(near, solids, walls, settings);
    }
    place_members(near, motion, walls);
    if (!is_kept) {
        find_pairs(near, solids, settings);
    }
    find_sides(near, slopes, motion, water, settings);
    if (sides_.empty()) {
        return;
    }
    find_pressures(near, water, settings, gravity);
    force.assign(at(near.size()), {});
    parallel::for_each_uneven(static_cast<std::int64_t>(members_.size()), grain, [&](std::int64_t index) {
        const Member& member = members_[at(index)];
        Vec3 sum{};
        for_each_link(near, settings, at(index), [&](std::size_t j, const Link& link) {
            const Member& other = members_[j];
            const double pressure = pressure_of(at(index), other.solid) + pressure_of(j, member.solid);
            const double share = 0.5 * (member.dry_share + other.dry_share);
            sum -= near.volume[at(other.sample)] * pressure *
                   ((1 - share) * link.slope * link.d + share * link.slope_of_closed * link.closed);
        });
        force[at(member.sample)] = near.volume[at(member.sample)] * sum;
    });
}

std::size_t JointPressure::bytes() const {
    return bytes_of(members_, pair_begin_, pairs_, paired_at_, side_begin_, sides_);
}

}  // namespace riprap::coupling
