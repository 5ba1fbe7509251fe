// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_water.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

namespace {

constexpr std::int64_t grain = 64;
/// Of the pressure in crowded water that a wall feels, at most.
constexpr double most_felt = 1.2;
/// Spacings that a joint opens until water that stands closely before it is no longer crowded but on its way in.
constexpr double mouth = 0.25;

/// Solids about a member.
struct Surroundings {
    Vec3 slope;   ///< G_others [1/m]
    Vec3 of_gap;  ///< what water between faces adds when it fills that [1/m]
    double gap;   ///< to the nearest face that looks at it; infinite: none [m]
};

/// @param others  see JointWater
Surroundings look_around(const JointPairs& pairs, std::size_t index, const JointSelf& self, const JointKernel& kernel,
                         std::vector<std::int32_t>& others) {
    const bool is_loose = pairs.members()[index].is_loose;
    const Four zero(0);
    Four3 slope, of_gap;
    Four gap(std::numeric_limits<double>::infinity());
    others.clear();
    const auto meet = [&](std::int32_t partner) {
        const bool is_joint = is_loose || partner != still_solid;
        const bool is_last = !others.empty() && others.back() == partner;  // members come solid by solid
        if (is_joint && !is_last && std::find(others.begin(), others.end(), partner) == others.end()) {
            others.push_back(partner);
        }
    };
    pairs.for_each_joined(index, self, [&](std::size_t number, const JointFour& near) {
        const SampleFour& other = pairs.fours()[number];
        const JointLinks link = kernel.link(near);
        const Four share = select(near.is_there, other.volume * link.slope, zero);
        slope = slope + share * link.apart;
        FourMask is_near = near.is_there & (link.slope < zero);
        const JointGaps gaps = kernel.gaps(self, other, near);
        if (gaps.is_any) {
            const JointLinks touching = kernel.touching(near, gaps);
            const Four3 change = (other.volume * touching.slope) * touching.apart - share * link.apart;
            of_gap = of_gap + Four3(select(gaps.are_there, change.x, zero), select(gaps.are_there, change.y, zero),
                                    select(gaps.are_there, change.z, zero));
            gap = select(gaps.are_there & (touching.slope < zero), min(gap, max(gaps.width, zero)), gap);
            is_near = is_near | kernel.do_closed_meet(near, gaps);
        }
        std::uint32_t left = bits_of(is_near);
        if (left != 0 && other.is_of_one_partner()) {
            meet(other.partner[0]);
            left = 0;
        }
        for (; left != 0; left &= left - 1) {
            meet(other.partner[static_cast<std::size_t>(__builtin_ctz(left))]);
        }
    });
    return {sum_of(slope), sum_of(of_gap), std::min({gap[0], gap[1], gap[2], gap[3]})};
}

/// Share of the open surroundings that particles fill. @param open of solids, @param water the same sum over the water
double covered(const Vec3& open, const Vec3& water) {
    const double square = dot(open, open);
    return square > 0 ? std::max(0.0, -dot(open, water) / square) : 0;
}

/// Which partners water stands at: loose solids by number + 1, first all others, which are one.
std::vector<std::uint8_t> find_wet_partners(const JointPairs& pairs, std::size_t bodies,
                                            const fluid::WaterAtWalls& water) {
    std::vector<std::uint8_t> is_wet(bodies + 1, 0);
    for (const JointMember& member : pairs.members()) {
        if (water.weight[at(member.sample)] > 0) {
            is_wet[at(partner_of(member) + 1)] = 1;
        }
    }
    return is_wet;
}

/// Of each four a bit for each member whose partner is wet.
std::vector<std::uint8_t> find_wet_members(const JointPairs& pairs, std::span<const std::uint8_t> is_partner_wet) {
    std::vector<std::uint8_t> wet(pairs.fours().size(), 0);
    parallel::for_each(static_cast<std::int64_t>(wet.size()), [&](std::int64_t number) {
        const SampleFour& four = pairs.fours()[at(number)];
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            const bool is_wet = four.member[lane] >= 0 && is_partner_wet[at(four.partner[lane] + 1)] != 0;
            wet[at(number)] = static_cast<std::uint8_t>(wet[at(number)] | (is_wet ? 1U << lane : 0U));
        }
    });
    return wet;
}

}  // namespace

void find_joint_water(const JointPairs& pairs, const SampleView& near, std::span<const Vec3> slopes,
                      const body::Motion& motion, const fluid::WaterAtWalls& water,
                      const fluid::ParticleSettings& settings, std::vector<JointWater>& found) {
    const std::vector<JointMember>& members = pairs.members();
    const JointKernel kernel(settings);
    found.resize(members.size());
    const std::vector<std::uint8_t> is_partner_wet = find_wet_partners(pairs, motion.pose.size(), water);
    const std::vector<std::uint8_t> are_wet = find_wet_members(pairs, is_partner_wet);
    parallel::for_each_uneven(static_cast<std::int64_t>(members.size()), grain, [&](std::int64_t index) {
        const JointMember& member = members[at(index)];
        JointWater& at_member = found[at(index)];
        // Where both sides are dry, all of the rim is, and the joint presses nothing apart.
        at_member.may_be_there = pairs.is_at_joint(at(index)) && (is_partner_wet[at(partner_of(member) + 1)] != 0 ||
                                                                  pairs.may_meet(at(index), are_wet));
        if (!at_member.may_be_there) {
            at_member.weight = 0;
            at_member.dry_share = 1;
            at_member.others.clear();
            return;
        }
        const JointSelf self = pairs.self(at(index));
        const Surroundings around = look_around(pairs, at(index), self, kernel, at_member.others);
        const auto sample = at(member.sample);
        const Quat& turn = motion.pose[at(near.body(sample).value)].orientation;
        const Vec3 &own = slopes[near.number(sample)], &n = self.normal, &of_water = water.slope[sample];
        const Vec3 open = (member.solid == still_solid ? own : rotate(turn, own)) + around.slope;
        at_member.rim = open - dot(open, n) * n;
        at_member.covered = covered(at_member.rim, of_water);
        // All that is not solid is open to the first layer; deeper ones see that layer end behind them as well.
        const bool is_first = near.depth(sample) < settings.spacing;
        const double filled = dot(of_water, n), room = is_first ? -dot(open, n) : dot(around.of_gap, n);
        at_member.dry_share = room > 0 && filled > 0 ? std::max(0.0, 1 - filled / room) : 1;

        const double share = covered(open, of_water);  // q
        const double ragged = std::max(0.0, (well_filled - share) / (1 - well_filled));
        const double crowding = (std::clamp(share, well_filled, most_felt) - 1) * std::max(0.0, 1 - ragged);
        const double trust = 1 - at_member.dry_share * std::min(1.0, around.gap / (mouth * settings.spacing));
        at_member.felt = (1 + trust * crowding) * water.pressure[sample];
        at_member.weight =
            is_first ? pairs.volume(at(index)) * dot(open, open) * std::min(1.0, share / well_filled) : 0;
    });
}

}  // namespace riprap::coupling
