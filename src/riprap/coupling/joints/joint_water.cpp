// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_water.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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
    Vec3 slope;                                           ///< G_others [1/m]
    Vec3 of_gap{};                                        ///< what water between faces adds when it fills that [1/m]
    double gap{std::numeric_limits<double>::infinity()};  ///< to the nearest opposite face [m]
};

/// @param others  see JointWater
Surroundings look_around(const JointPairs& pairs, std::size_t index, const JointKernel& kernel,
                         std::vector<std::int32_t>& others) {
    const std::vector<JointMember>& members = pairs.members();
    const JointMember& member = members[index];
    Surroundings found;
    others.clear();
    pairs.for_each_joined(index, [&](std::size_t j, const Vec3& apart, double square) {
        const JointMember& other = members[j];
        const JointLink link = kernel.link(apart, square);
        const Vec3 slope = link.slope * link.apart;
        found.slope += other.volume * slope;
        bool is_near = link.slope != 0;
        if (const std::optional<JointGap> gap = kernel.gap(member, other, link)) {
            const JointLink touching = kernel.touching(link, *gap);
            found.of_gap += other.volume * (touching.slope * touching.apart - slope);
            found.gap = touching.slope != 0 ? std::min(found.gap, std::max(0.0, gap->width)) : found.gap;
            is_near = is_near || kernel.closed(link, *gap).slope != 0;
        }
        const bool is_joint = is_near && (member.is_loose || other.is_loose);
        const bool is_last = !others.empty() && others.back() == partner_of(other);  // members come solid by solid
        if (is_joint && !is_last && std::find(others.begin(), others.end(), partner_of(other)) == others.end()) {
            others.push_back(partner_of(other));
        }
    });
    return found;
}

/// Share of the open surroundings that particles fill. @param open of solids, @param water the same sum over the water
double covered(const Vec3& open, const Vec3& water) {
    const double square = dot(open, open);
    return square > 0 ? std::max(0.0, -dot(open, water) / square) : 0;
}

/// Which partners water stands at: loose solids by number + 1, first all others.
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

}  // namespace

void find_joint_water(const JointPairs& pairs, const SampleView& near, std::span<const Vec3> slopes,
                      const body::Motion& motion, const fluid::WaterAtWalls& water,
                      const fluid::ParticleSettings& settings, std::vector<JointWater>& found) {
    const std::vector<JointMember>& members = pairs.members();
    const JointKernel kernel(settings);
    found.resize(members.size());
    const std::vector<std::uint8_t> is_wet = find_wet_partners(pairs, motion.pose.size(), water);
    const auto is_partner_wet = [&](std::size_t j) { return is_wet[at(partner_of(members[j]) + 1)] != 0; };
    parallel::for_each_uneven(static_cast<std::int64_t>(members.size()), grain, [&](std::int64_t index) {
        const JointMember& member = members[at(index)];
        JointWater& at_member = found[at(index)];
        // Where both sides are dry, all of the rim is, and the joint presses nothing apart.
        at_member.may_be_there =
            pairs.is_at_joint(at(index)) && (is_partner_wet(at(index)) || pairs.may_meet(at(index), is_partner_wet));
        if (!at_member.may_be_there) {
            at_member.weight = 0;
            at_member.others.clear();
            return;
        }
        const Surroundings around = look_around(pairs, at(index), kernel, at_member.others);
        const auto sample = at(member.sample);
        const Quat& turn = motion.pose[at(near.body(sample).value)].orientation;
        const Vec3 &own = slopes[near.number(sample)], &n = member.normal, &of_water = water.slope[sample];
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
        at_member.weight = is_first ? member.volume * dot(open, open) * std::min(1.0, share / well_filled) : 0;
    });
}

}  // namespace riprap::coupling
