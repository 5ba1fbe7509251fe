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

}  // namespace

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
        return grid.view().any_near(
            x, [&](std::int64_t j) { return norm_squared(nearest_(x - loose[at(j)])) < most * most; });
    };
    parallel::for_each_uneven(near.size(), grain, [&](std::int64_t i) {
        if (is_member[at(i)] == 0) {
            is_member[at(i)] = is_near_loose(walls.position[at(i)]) ? 1 : 0;
        }
    });
    members_.clear();
    fours_.assign((is_member.size() + four_size - 1) / four_size, {});
    for (std::size_t i = 0; i < is_member.size(); ++i) {
        if (is_member[i] != 0) {
            const auto body = at(near.body(i).value);
            const std::int32_t solid = solids.is_still[body] != 0 ? still_solid : near.body(i).value;
            const JointMember member{static_cast<std::int32_t>(i), solid, solids.is_loose[body] != 0};
            SampleFour& four = fours_[i / four_size];
            const std::size_t lane = i % four_size;
            four.member[lane] = static_cast<std::int32_t>(members_.size());
            four.partner[lane] = partner_of(member);
            four.volume.set(static_cast<std::int64_t>(lane), near.volume(i));
            four.depth.set(static_cast<std::int64_t>(lane), near.depth(i));
            members_.push_back(member);
        }
    }
    paired_at_.assign(walls.position.begin(), walls.position.begin() + near.size());
}

void JointPairs::place_samples(const SampleView& near, const body::Motion& motion,
                               const fluid::BoundaryParticles& walls) {
    parallel::for_each(static_cast<std::int64_t>(fours_.size()), [&](std::int64_t number) {
        SampleFour& four = fours_[at(number)];
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            if (four.member[lane] >= 0) {
                const std::size_t sample = at(number) * four_size + lane;
                four.place.set(lane, walls.position[sample]);
                four.normal.set(lane,
                                rotate(motion.pose[at(near.body(sample).value)].orientation, near.normal(sample)));
            }
        }
    });
}

void JointPairs::find_pairs(const fluid::ParticleSettings& settings) {
    std::vector<Vec3> places;
    places.reserve(members_.size());
    for (std::size_t i = 0; i < members_.size(); ++i) {
        places.push_back(self(i).place);
    }
    fluid::CellGrid grid;
    const double most = reach(settings, false);
    grid.build(places, settings.domain, most);
    const double near = settings.support_radius() + skin * settings.spacing;
    constexpr double facing = -0.5 + 2 * most_turn;  // what may come to -1/2 while pairs are kept
    std::vector<std::vector<std::uint32_t>> met(members_.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(members_.size()), grain, [&](std::int64_t i) {
        const JointMember& member = members_[at(i)];
        const JointSelf self = this->self(at(i));
        std::vector<std::uint32_t>& mine = met[at(i)];
        grid.for_each_near(self.place, [&](std::int64_t j) {
            const JointMember& other = members_[at(j)];
            const double apart = other.solid == member.solid ? most : norm(nearest_(self.place - places[at(j)]));
            if (apart < most) {
                const bool may_join = apart < near || dot(self.normal, this->self(at(j)).normal) < facing;
                mine.push_back(entry_of(at(other.sample), may_join));
            }
        });
        std::ranges::sort(mine);
        std::size_t kept = 0;
        for (const std::uint32_t entry : mine) {
            if (kept > 0 && four_of(mine[kept - 1]) == four_of(entry)) {
                mine[kept - 1] |= entry;
            } else {
                mine[kept++] = entry;
            }
        }
        mine.resize(kept);
    });
    begin_.assign(1, 0);
    begin_.reserve(met.size() + 1);
    for (const std::vector<std::uint32_t>& mine : met) {
        begin_.push_back(begin_.back() + static_cast<std::int64_t>(mine.size()));
    }
    entries_.resize(at(begin_.back()));
    parallel::for_each_uneven(static_cast<std::int64_t>(members_.size()), grain,
                              [&](std::int64_t i) { std::ranges::copy(met[at(i)], entries_.begin() + begin_[at(i)]); });
}

void JointPairs::find_who_is_at_joints() {
    is_at_joint_.resize(members_.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(members_.size()), grain, [&](std::int64_t i) {
        bool is_at_joint = members_[at(i)].is_loose;
        if (!is_at_joint) {
            for_each_met(at(i), [&](std::size_t four, const JointFour& near) {
                for (std::uint32_t left = bits_of(near.is_there); left != 0; left &= left - 1) {
                    const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
                    is_at_joint = is_at_joint || fours_[four].partner[lane] != still_solid;
                }
            });
        }
        is_at_joint_[at(i)] = is_at_joint ? 1 : 0;
    });
}

void JointPairs::update(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
                        const fluid::BoundaryParticles& walls, const fluid::ParticleSettings& settings) {
    const double reach = JointKernel::reach(settings);
    nearest_ = fluid::NearestImage(settings.domain);
    is_periodic_ = std::ranges::find(settings.domain.is_periodic, true) != settings.domain.is_periodic.end();
    square_of_reach_ = reach * reach;
    square_of_support_ = settings.support_radius() * settings.support_radius();
    const bool is_kept = is_up_to_date(near, solids, motion, walls, settings.spacing);
    if (!is_kept) {
        find_members(near, solids, walls, settings);
    }
    place_samples(near, motion, walls);
    if (!is_kept) {
        find_pairs(settings);
        posed_at_ = motion.pose;
    }
    find_who_is_at_joints();
}

std::size_t JointPairs::bytes() const {
    return bytes_of(members_, fours_, is_at_joint_, begin_, entries_, paired_at_, posed_at_);
}

}  // namespace riprap::coupling
