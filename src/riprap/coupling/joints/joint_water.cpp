// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_water.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

namespace {

constexpr std::int64_t grain = 64;
/// Largest f, the pressure on a wall over that of crowded particles beside it [-].
constexpr double most_crowded = 1.2;
/// Gap of a joint from which on water that stands closely before it is not crowded but on its way in [spacings].
constexpr double entered_gap = 0.25;

/// Share of the open surroundings that particles fill. @param open of solids, @param water the same sum over the water
double covered(const Vec3& open, const Vec3& water) {
    const double square = dot(open, open);
    return square > 0 ? std::max(0.0, -dot(open, water) / square) : 0;
}

/// Of each four a bit for each sample that is loose or within reach of a loose one. Others have no part in joints but
/// shut off what these see; there are none without driven solids.
template <class Real>
std::vector<std::uint8_t> find_who_is_at_joints(const JointPairs& pairs, const JointSums<Real>& sums) {
    std::vector<std::uint8_t> bits(pairs.fours().size(), pairs.has_driven() ? 0 : 15);
    if (!pairs.has_driven()) {
        return bits;
    }
    std::vector<std::uint32_t> reached(pairs.slots().size());
    parallel::for_each_uneven(std::ssize(pairs.units()), 1, [&](std::int64_t number) {
        const JointUnit& unit = pairs.units()[at(number)];
        const auto slots = std::span(reached).subspan(at(unit.first_slot), at(unit.own_count + unit.other_count));
        if (unit.joint >= 0) {
            sums.reach(at(number), slots);
        }
    });
    for (std::size_t k = 0; k < bits.size(); ++k) {
        unsigned all = 0;
        for (const std::int32_t slot : pairs.slots_of(k)) {
            all |= reached[at(slot)];
        }
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            all |= pairs.fours()[k].is_loose[lane] != 0 ? 1U << lane : 0U;
        }
        bits[k] = static_cast<std::uint8_t>(all);
    }
    return bits;
}

}  // namespace

WetSolids find_wet_solids(const JointPairs& pairs, std::size_t bodies, const fluid::WaterAtWalls& water) {
    WetSolids found;
    found.is_wet.assign(bodies + 1, 0);
    found.is_wet_partner.assign(bodies + 1, 0);
    for (const JointFour& four : pairs.fours()) {
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            if (four.has(lane) && water.weight[four.sample(lane)] > 0) {
                found.is_wet[WetSolids::entry(four.solid[lane])] = 1;
                found.is_wet_partner[WetSolids::entry(four.partner(lane))] = 1;
            }
        }
    }
    found.meets_wet = found.is_wet;
    for (const JointUnit& unit : pairs.units()) {
        const std::size_t own = WetSolids::entry(unit.own_solid), other = WetSolids::entry(unit.other_solid);
        found.meets_wet[own] |= found.is_wet[other];
        found.meets_wet[other] |= found.is_wet[own];
    }
    return found;
}

template <class Real>
void find_joint_water(const JointPairs& pairs, const JointSums<Real>& sums, const SampleView& near,
                      std::span<const Vec3> slopes, const body::Motion& motion, const fluid::WaterAtWalls& water,
                      const fluid::ParticleSettings& settings, const WetSolids& wet,
                      std::vector<AroundSlot<Real>>& around, std::vector<std::uint8_t>& marks,
                      std::vector<JointWater>& found) {
    const auto meets_wet = [&](std::int32_t solid) {
        return solid != no_solid && wet.meets_wet[WetSolids::entry(solid)] != 0;
    };
    const std::vector<std::uint8_t> are_at_joints = find_who_is_at_joints(pairs, sums);
    make_room(around, pairs.slots().size());
    make_room(marks, pairs.slots().size());
    parallel::for_each_uneven(std::ssize(pairs.units()), 4, [&](std::int64_t number) {
        const JointUnit& unit = pairs.units()[at(number)];
        const std::size_t first = at(unit.first_slot), count = at(unit.own_count + unit.other_count);
        const std::span<std::uint8_t> of_unit = std::span(marks).subspan(first, count);
        std::ranges::fill(of_unit, std::uint8_t{0});
        if (meets_wet(unit.own_solid) || meets_wet(unit.other_solid)) {
            sums.look_around(at(number), std::span(around).subspan(first, count), of_unit);
        }
    });
    make_room(found, four_size * pairs.fours().size());
    parallel::for_each_uneven(std::ssize(pairs.fours()), grain, [&](std::int64_t number) {
        const JointFour& four = pairs.fours()[at(number)];
        std::fill_n(found.begin() + static_cast<std::ptrdiff_t>(four_size) * number, four_size, JointWater{});
        if (std::ranges::none_of(four.solid, meets_wet)) {
            return;
        }
        std::array<Four<Real>, 4> all{};
        Four<Real> gap;
        gap.fill(sums.far());
        for (const std::int32_t slot : pairs.slots_of(at(number))) {
            if (marks[at(slot)] == 0) {
                continue;
            }
            const AroundSlot<Real>& part = around[at(slot)];
            for (std::size_t k = 0; k < 4; ++k) {
                for (std::size_t lane = 0; lane < four_size; ++lane) {
                    all[k][lane] += part.sums[k][lane];
                }
            }
            for (std::size_t lane = 0; lane < four_size; ++lane) {
                gap[lane] = std::min(gap[lane], part.gap[lane]);
            }
        }
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            JointWater& here = found[at(number) * four_size + lane];
            if (!meets_wet(four.solid[lane]) || (are_at_joints[at(number)] >> lane & 1U) == 0) {
                continue;
            }
            const std::size_t sample = four.sample(lane);
            const Quat& turn = motion.pose[at(near.body(sample).value)].orientation;
            const Vec3 &own = slopes[near.number(sample)], &of_water = water.slope[sample];
            const Vec3 others{all[0][lane], all[1][lane], all[2][lane]}, n = rotate(turn, near.normal(sample));
            const Vec3 open = (four.solid[lane] == still_solid ? own : rotate(turn, own)) + others;
            here.rim = open - dot(open, n) * n;
            here.covered = covered(here.rim, of_water);
            // All that is not solid is open to the first layer; deeper ones see that layer end behind them as well.
            here.is_first = near.depth(sample) < settings.spacing;
            const double filled = dot(of_water, n), room = here.is_first ? -dot(open, n) : double{all[3][lane]};
            here.dry_share = room > 0 && filled > 0 ? std::max(0.0, 1 - filled / room) : 1;

            const double share = covered(open, of_water);  // q
            // f - 1 as far as water stands there, and as far as it is not on its way into the joint.
            const double lacking = std::max(0.0, (well_filled - share) / (1 - well_filled));
            const double crowding = (std::clamp(share, well_filled, most_crowded) - 1) * std::max(0.0, 1 - lacking);
            const double outside = 1 - here.dry_share * std::min(1.0, gap[lane] / (entered_gap * settings.spacing));
            here.felt = (1 + outside * crowding) * water.pressure[sample];
            here.weight =
                here.is_first ? near.volume(sample) * dot(open, open) * std::min(1.0, share / well_filled) : 0;
        }
    });
}

template void find_joint_water(const JointPairs&, const JointSums<float>&, const SampleView&, std::span<const Vec3>,
                               const body::Motion&, const fluid::WaterAtWalls&, const fluid::ParticleSettings&,
                               const WetSolids&, std::vector<AroundSlot<float>>&, std::vector<std::uint8_t>&,
                               std::vector<JointWater>&);
template void find_joint_water(const JointPairs&, const JointSums<double>&, const SampleView&, std::span<const Vec3>,
                               const body::Motion&, const fluid::WaterAtWalls&, const fluid::ParticleSettings&,
                               const WetSolids&, std::vector<AroundSlot<double>>&, std::vector<std::uint8_t>&,
                               std::vector<JointWater>&);

}  // namespace riprap::coupling
