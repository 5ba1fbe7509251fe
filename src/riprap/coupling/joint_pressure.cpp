// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joint_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"

namespace riprap::coupling {

namespace {

constexpr std::int64_t grain = 64;
/// h |t| that uneven samples leave inside a joint, at most: at seams sums are off by 4 % of those at a plane wall.
constexpr double uneven = 0.1;
/// Share of what is open at a wall that moving water fills with particles, at least.
constexpr double filled = 0.85;
/// Of the pressure in crowded water that a wall feels, at most.
constexpr double most_felt = 1.2;

/// Joints are between a loose solid and another, or all that is not loose: where a floor meets a wall water goes on.
std::int32_t partner_of(const JointMember& member) { return member.is_loose ? member.solid : still_solid; }

/// Whether some loose body meets water.
bool is_any_wet(const SampleView& near, const JointSolids& solids, const fluid::WaterAtWalls& water) {
    return parallel::reduce(
        near.size(), false,
        [&](std::int64_t i) { return water.weight[at(i)] > 0 && solids.is_loose[at(near.body(at(i)).value)] != 0; },
        [](bool a, bool b) { return a || b; });
}

}  // namespace

void JointPressure::find_openings(const SampleView& near, std::span<const Vec3> slopes, const BodyMotion& motion,
                                  const fluid::WaterAtWalls& water, const JointKernel& kernel) {
    const std::vector<JointMember>& members = pairs_.members();
    openings_.resize(members.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(members.size()), grain, [&](std::int64_t index) {
        const JointMember& member = members[at(index)];
        Opening& opening = openings_[at(index)];
        std::vector<std::int32_t>& others = opening.others;
        others.clear();
        Vec3 slope_of_others{};
        for (const std::int32_t j : pairs_.met_by(at(index))) {
            const JointMember& other = members[at(j)];
            const JointLink link = kernel.link(member, other);
            slope_of_others += other.volume * link.slope * link.apart;
            const bool is_joint = member.is_loose || other.is_loose;
            if (is_joint && std::find(others.begin(), others.end(), partner_of(other)) == others.end() &&
                (link.slope != 0 || kernel.closed(member, other, link).slope != 0)) {
                others.push_back(partner_of(other));
            }
        }
        const auto sample = at(member.sample);
        const Quat& turn = motion.pose[at(near.body(sample).value)].orientation;
        const Vec3 own =
            member.solid == still_solid ? slopes[near.number(sample)] : rotate(turn, slopes[near.number(sample)]);
        const Vec3 slope = own + slope_of_others;
        opening.rim = slope - dot(slope, member.normal) * member.normal;
        const double into_solid = -dot(own, member.normal), into_water = dot(water.slope[sample], member.normal);
        opening.dry_share = into_water > 0 && into_solid > 0 ? std::max(0.0, 1 - into_water / into_solid) : 1;
    });
}

void JointPressure::list_sides() {
    const std::vector<JointMember>& members = pairs_.members();
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> joints;
    side_begin_.assign(1, 0);
    sides_.clear();
    for (std::size_t i = 0; i < members.size(); ++i) {
        for (const std::int32_t other : openings_[i].others) {
            const std::int32_t own = partner_of(members[i]);
            const std::pair pair(std::min(own, other), std::max(own, other));
            const auto joint = joints.emplace(pair, static_cast<std::int32_t>(joints.size())).first->second;
            sides_.push_back({static_cast<std::int32_t>(i), other, joint, 0});
        }
        side_begin_.push_back(static_cast<std::int32_t>(sides_.size()));
    }
    rims_.resize(joints.size());
}

void JointPressure::find_rims(const SampleView& near, const fluid::WaterAtWalls& water,
                              const fluid::SphSettings& settings, const Vec3& gravity) {
    for (std::vector<RimPiece>& rim : rims_) {
        rim.clear();
    }
    const double h = settings.smoothing_length();
    for (const Side& side : sides_) {
        const JointMember& member = pairs_.members()[at(side.member)];
        const Vec3& t = openings_[at(side.member)].rim;
        const auto sample = at(member.sample);
        const double strength = h * norm(t) - uneven;
        if (strength > 0 && near.depth(sample) < settings.spacing) {
            const double covered = std::max(0.0, -dot(t, water.slope[sample]) / dot(t, t));
            const double share = std::min(1.0, covered / filled);
            const double weight = strength * near.volume(sample);
            const double felt = share > 0 ? std::min(most_felt, covered / share) : 0;
            rims_[at(side.joint)].push_back(
                {member.place, weight * share, weight * (1 - share), felt * water.pressure[sample]});
        }
    }
    // A dry piece higher than any water of the rim can rise drains nothing.
    const fluid::NearestImage nearest(settings.domain);
    for (std::vector<RimPiece>& rim : rims_) {
        const auto head_from_first = [&](const RimPiece& piece) {
            return settings.rest_density * dot(gravity, nearest(piece.place - rim.front().place));
        };
        double highest = 0;  // head of the water above that of the first piece [Pa]
        bool is_wet = false;
        for (const RimPiece& piece : rim) {
            if (piece.wet > 0) {
                const double head = piece.pressure - head_from_first(piece);
                highest = is_wet ? std::max(highest, head) : head;
                is_wet = true;
            }
        }
        for (RimPiece& piece : rim) {
            piece.dry = is_wet && highest + head_from_first(piece) > 0 ? piece.dry : 0;
        }
    }
}

double JointPressure::pressure_of(std::size_t member, std::int32_t other) const {
    for (auto k = at(side_begin_[member]); k < at(side_begin_[member + 1]); ++k) {
        if (sides_[k].other == other) {
            return sides_[k].pressure;
        }
    }
    return 0;
}

void JointPressure::find(const SampleView& near, std::span<const Vec3> slopes, const JointSolids& solids,
                         const BodyMotion& motion, const fluid::BoundaryParticles& walls,
                         const fluid::WaterAtWalls& water, const fluid::SphSettings& settings, const Vec3& gravity,
                         std::vector<Vec3>& force) {
    RIPRAP_ASSERT(near.size() == 0 || near.number(at(near.size()) - 1) < slopes.size(), "slopes are of the whole set");
    force.clear();
    if (!is_any_wet(near, solids, water)) {
        return;
    }
    pairs_.update(near, solids, motion, walls, settings);
    const JointKernel kernel(settings);
    find_openings(near, slopes, motion, water, kernel);
    list_sides();
    if (sides_.empty()) {
        return;
    }
    find_rims(near, water, settings, gravity);
    const std::vector<JointMember>& members = pairs_.members();
    const fluid::NearestImage nearest(settings.domain);
    const double blur = 0.25 * settings.spacing * settings.spacing;  // a piece of the rim is no point
    parallel::for_each_uneven(static_cast<std::int64_t>(sides_.size()), grain, [&](std::int64_t index) {
        Side& side = sides_[at(index)];
        double sum = 0, weights = 0;
        for (const RimPiece& piece : rims_[at(side.joint)]) {
            const Vec3 d = nearest(members[at(side.member)].place - piece.place);
            const double square = dot(d, d) + blur;
            const double nearness = 1 / (settings.domain.dimension == 2 ? std::sqrt(square) : square);
            weights += nearness * (piece.wet + piece.dry);
            sum += nearness * piece.wet * (piece.pressure + settings.rest_density * dot(gravity, d));
        }
        side.pressure = weights > 0 ? std::max(0.0, sum / weights) : 0;
    });
    force.assign(at(near.size()), {});
    parallel::for_each_uneven(static_cast<std::int64_t>(members.size()), grain, [&](std::int64_t index) {
        const JointMember& member = members[at(index)];
        Vec3 sum{};
        for (const std::int32_t j : pairs_.met_by(at(index))) {
            const JointMember& other = members[at(j)];
            const double pressure = pressure_of(at(index), partner_of(other)) + pressure_of(at(j), partner_of(member));
            if (pressure == 0) {
                continue;
            }
            const JointLink link = kernel.link(member, other);
            const double share = 0.5 * (openings_[at(index)].dry_share + openings_[at(j)].dry_share);
            const JointLink closed = share > 0 ? kernel.closed(member, other, link) : link;
            sum -=
                other.volume * pressure * ((1 - share) * link.slope * link.apart + share * closed.slope * closed.apart);
        }
        force[at(member.sample)] = member.volume * sum;
    });
}

std::size_t JointPressure::bytes() const {
    std::size_t bytes = pairs_.bytes() + bytes_of(openings_, side_begin_, sides_, rims_);
    for (const Opening& opening : openings_) {
        bytes += bytes_of(opening.others);
    }
    return bytes;
}

}  // namespace riprap::coupling
