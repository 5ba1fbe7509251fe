// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

namespace {

constexpr std::int64_t grain = 64;
/// Angle that a body may turn before pairs are looked for again [rad].
constexpr double most_turn = 0.15;
/// Share of a spacing that two samples may come nearer before pairs are looked for again.
constexpr double skin = 0.5;
/// Spacings between faces that share a joint, at most: in wider gaps there is room for water.
constexpr double most_gap = 2;
/// Spacings beyond the support from which samples of faces brought together still meet.
constexpr double farther = 1.5;

}  // namespace

JointKernel::JointKernel(const fluid::ParticleSettings& settings)
    : kernel_(settings.smoothing_length(), settings.domain.dimension),
      square_of_support_(settings.support_radius() * settings.support_radius()),
      farthest_(reach(settings)),
      spacing_(settings.spacing) {}

double JointKernel::reach(const fluid::ParticleSettings& settings) {
    return settings.support_radius() + farther * settings.spacing;
}

std::optional<JointGap> JointKernel::gap_of_facing(const JointMember& i, const JointMember& j,
                                                   const JointLink& link) const {
    if (norm_squared(link.apart) > farthest_ * farthest_) {
        return std::nullopt;
    }
    const Vec3 across = i.normal - j.normal, n = across / norm(across);
    const double width = -dot(link.apart, n) - (i.depth + j.depth);
    return width < most_gap * spacing_ ? std::optional(JointGap{n, width}) : std::nullopt;
}

JointLink JointKernel::nearer(const JointLink& link, const Vec3& shift) const {
    const Vec3 apart = link.apart + shift;
    return {apart, kernel_.slope_over_r(norm(apart))};
}

JointLink JointKernel::closed(const JointLink& link, const JointGap& gap) const {
    const double shift = std::clamp(std::min(gap.width, most_gap * spacing_ - gap.width), 0.0, spacing_);
    return shift > 0 ? nearer(link, shift * gap.across) : link;
}

JointLink JointKernel::touching(const JointLink& link, const JointGap& gap) const {
    return gap.width > 0 ? nearer(link, gap.width * gap.across) : link;
}

double JointPairs::reach(const fluid::ParticleSettings& settings, bool has_driven) {
    // Where driven and still solids meet, what is near a loose body must see the other one to know that it ends there.
    return (has_driven ? 2 : 1) * JointKernel::reach(settings) + skin * settings.spacing;
}

bool JointPairs::is_up_to_date(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
                               const fluid::BoundaryParticles& walls, double spacing) const {
    if (paired_at_.size() != at(near.size()) || posed_at_.size() != motion.pose.size()) {
        return false;
    }
    const double least = std::cos(0.5 * most_turn);
    const bool has_turned = parallel::any_of(static_cast<std::int64_t>(posed_at_.size()), [&](std::int64_t b) {
        const Quat &now = motion.pose[at(b)].orientation, &then = posed_at_[at(b)].orientation;
        return !(std::abs(now.w * then.w + now.x * then.x + now.y * then.y + now.z * then.z) > least);
    });
    if (has_turned) {
        return false;
    }
    const double farthest = parallel::reduce(
        near.size(), 0.0,
        [&](std::int64_t i) {
            const bool is_still = solids.is_still[at(near.body(at(i)).value)] != 0;
            return is_still ? 0.0 : norm_squared(walls.position[at(i)] - paired_at_[at(i)]);
        },
        [](double a, double b) { return std::max(a, b); });
    return farthest < 0.25 * skin * skin * spacing * spacing;
}

void JointPairs::find_members(const SampleView& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                              const fluid::ParticleSettings& settings) {
    std::vector<std::uint8_t> is_member(at(near.size()), 0);
    std::vector<Vec3> loose;
    bool has_driven = false;
    for (std::size_t i = 0; i < is_member.size(); ++i) {
        const auto body = at(near.body(i).value);
        has_driven = has_driven || (solids.is_loose[body] == 0 && solids.is_still[body] == 0);
        if (solids.is_loose[body] != 0) {
            is_member[i] = 1;
            loose.push_back(walls.position[i]);
        }
    }
    const double most = reach(settings, has_driven);
    fluid::CellGrid grid;
    grid.build(loose, settings.domain, most);
    const auto is_near_loose = [&](const Vec3& x) {
        bool is_near = false;
        grid.for_each_near(x, [&](std::int64_t j) { is_near = is_near || norm(nearest_(x - loose[at(j)])) < most; });
        return is_near;
    };
    parallel::for_each_uneven(near.size(), grain, [&](std::int64_t i) {
        if (is_member[at(i)] == 0) {
            is_member[at(i)] = is_near_loose(walls.position[at(i)]) ? 1 : 0;
        }
    });
    members_.clear();
    for (std::size_t i = 0; i < is_member.size(); ++i) {
        if (is_member[i] != 0) {
            const auto body = at(near.body(i).value);
            const std::int32_t solid = solids.is_still[body] != 0 ? still_solid : near.body(i).value;
            members_.push_back({static_cast<std::int32_t>(i),
                                solid,
                                solids.is_loose[body] != 0,
                                near.volume(i),
                                near.depth(i),
                                {},
                                {}});
        }
    }
    paired_at_.assign(walls.position.begin(), walls.position.begin() + near.size());
}

void JointPairs::place_members(const SampleView& near, const body::Motion& motion,
                               const fluid::BoundaryParticles& walls) {
    parallel::for_each(static_cast<std::int64_t>(members_.size()), [&](std::int64_t i) {
        JointMember& member = members_[at(i)];
        const auto sample = at(member.sample);
        member.place = walls.position[sample];
        member.normal = rotate(motion.pose[at(near.body(sample).value)].orientation, near.normal(sample));
    });
}

void JointPairs::find_pairs(const fluid::ParticleSettings& settings) {
    std::vector<Vec3> places;
    for (const JointMember& member : members_) {
        places.push_back(member.place);
    }
    fluid::CellGrid grid;
    const double most = reach(settings, false);
    grid.build(places, settings.domain, most);
    const double near = settings.support_radius() + skin * settings.spacing;
    constexpr double facing = -0.5 + 2 * most_turn;  // what may come to -1/2 while pairs are kept
    std::vector<std::vector<std::int32_t>> met(members_.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(members_.size()), grain, [&](std::int64_t i) {
        const JointMember& member = members_[at(i)];
        std::vector<std::int32_t>& mine = met[at(i)];
        grid.for_each_near(member.place, [&](std::int64_t j) {
            const JointMember& other = members_[at(j)];
            const double apart = other.solid == member.solid ? most : norm(nearest_(member.place - other.place));
            if (apart < most) {
                const bool may_join = apart < near || dot(member.normal, other.normal) < facing;
                mine.push_back(static_cast<std::int32_t>(2 * j + (may_join ? 1 : 0)));
            }
        });
        std::sort(mine.begin(), mine.end());
    });
    pair_begin_.assign(1, 0);
    for (const std::vector<std::int32_t>& mine : met) {
        pair_begin_.push_back(pair_begin_.back() + static_cast<std::int64_t>(mine.size()));
    }
    pairs_.resize(at(pair_begin_.back()));
    parallel::for_each_uneven(static_cast<std::int64_t>(members_.size()), grain, [&](std::int64_t i) {
        std::ranges::copy(met[at(i)], pairs_.begin() + pair_begin_[at(i)]);
    });
}

void JointPairs::find_who_is_at_joints() {
    is_at_joint_.resize(members_.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(members_.size()), grain, [&](std::int64_t i) {
        bool is_at_joint = members_[at(i)].is_loose;
        if (!is_at_joint) {
            for_each_met(
                at(i), [&](std::size_t j, const Vec3&, double) { is_at_joint = is_at_joint || members_[j].is_loose; });
        }
        is_at_joint_[at(i)] = is_at_joint ? 1 : 0;
    });
}

void JointPairs::update(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
                        const fluid::BoundaryParticles& walls, const fluid::ParticleSettings& settings) {
    const double reach = JointKernel::reach(settings);
    nearest_ = fluid::NearestImage(settings.domain);
    square_of_reach_ = reach * reach;
    square_of_support_ = settings.support_radius() * settings.support_radius();
    const bool is_kept = is_up_to_date(near, solids, motion, walls, settings.spacing);
    if (!is_kept) {
        find_members(near, solids, walls, settings);
    }
    place_members(near, motion, walls);
    if (!is_kept) {
        find_pairs(settings);
        posed_at_ = motion.pose;
    }
    find_who_is_at_joints();
}

std::size_t JointPairs::bytes() const {
    return bytes_of(members_, is_at_joint_, pair_begin_, pairs_, paired_at_, posed_at_);
}

}  // namespace riprap::coupling
