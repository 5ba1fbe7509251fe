// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/joints/joint_kernel.hpp"
#include "riprap/coupling/joints/joint_search.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"

namespace riprap::coupling {

namespace {

constexpr std::int64_t grain = 64;
/// Angle that a body may turn before pairs are looked for again [rad].
constexpr double most_turn = 0.15;
/// Spacings that two samples may come nearer before pairs are looked for again, at most and at least.
constexpr double most_skin = 0.5, least_skin = 0.1;

/// Returns the distance within which members are looked for about loose bodies [m]. Where driven and still solids meet,
/// what is near a loose body must see the other one to know that it ends there.
double reach_with(double skin, const fluid::ParticleSettings& settings, bool has_driven) {
    return (has_driven ? 2 : 1) * JointKernelLimits(settings).reach + skin * settings.spacing;
}

}  // namespace

JointPairs::JointPairs() : skin_(least_skin) {}

double JointPairs::reach(const fluid::ParticleSettings& settings, bool has_driven) {
    return reach_with(most_skin, settings, has_driven);
}

/// Tells whether some body has turned farther than lists of faces that look at each other allow.
bool JointPairs::has_turned(const body::Motion& motion) const {
    const double least = std::cos(0.5 * most_turn);
    return parallel::any_of(static_cast<std::int64_t>(posed_at_.size()), [&](std::int64_t b) {
        const Quat &now = motion.pose[at(b)].orientation, &then = posed_at_[at(b)].orientation;
        return !(std::abs(now.w * then.w + now.x * then.x + now.y * then.y + now.z * then.z) > least);
    });
}

/// Returns the farthest way of a sample since lists were made [m].
double JointPairs::farthest_way(const SampleView& near, const JointSolids& solids,
                                const fluid::BoundaryParticles& walls) const {
    const double square = parallel::reduce(
        near.size(), 0.0,
        [&](std::int64_t i) {
            const bool is_still = solids.is_still[at(near.body(at(i)).value)] != 0;
            return is_still ? 0.0 : norm_squared(walls.position[at(i)] - paired_at_[at(i)]);
        },
        [](double a, double b) { return std::max(a, b); });
    return std::sqrt(square);
}

/// Tells whether the lists still hold all pairs; if not, chooses the skin of those that are to be made.
bool JointPairs::keep(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
                      const fluid::BoundaryParticles& walls, double spacing) {
    if (paired_at_.size() != at(near.size()) || posed_at_.size() != motion.pose.size()) {
        return false;
    }
    ++age_;
    const double way = farthest_way(near, solids, walls) / spacing;
    if (way < 0.5 * skin_ && !has_turned(motion)) {
        return true;
    }
    // A skin s makes the sums of a step dearer by s/2 and lasts s/(2 u) steps at a motion of u a step until lists,
    // which cost 2.5 such sums, are made anew: least in sum at s^2 = 10 u.
    if (way > 0) {
        skin_ = std::clamp(std::sqrt(10 * way / static_cast<double>(age_)), least_skin, most_skin);
    }
    return false;
}

void JointPairs::find_members(const SampleView& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                              const fluid::ParticleSettings& settings) {
    std::vector<std::uint8_t> is_member(at(near.size()), 0);
    std::vector<Vec3> loose;
    has_driven_ = false;
    for (std::size_t i = 0; i < is_member.size(); ++i) {
        const auto body = at(near.body(i).value);
        has_driven_ = has_driven_ || (solids.is_loose[body] == 0 && solids.is_still[body] == 0);
        if (solids.is_loose[body] != 0) {
            is_member[i] = 1;
            loose.push_back(walls.position[i]);
        }
    }
    const double most = reach_with(skin_, settings, has_driven_);
    const fluid::NearestImage nearest(settings.domain);
    fluid::CellGrid grid;
    grid.build(loose, settings.domain, most);
    const auto is_near_loose = [&](const Vec3& x) {
        return grid.view().any_near(
            x, [&](std::int64_t j) { return norm_squared(nearest(x - loose[at(j)])) < most * most; });
    };
    parallel::for_each_uneven(near.size(), grain, [&](std::int64_t i) {
        if (is_member[at(i)] == 0) {
            is_member[at(i)] = is_near_loose(walls.position[at(i)]) ? 1 : 0;
        }
    });
    fours_.clear();
    for (std::size_t first = 0; first < is_member.size(); first += four_size) {
        JointFour four{static_cast<std::int32_t>(first / four_size), {no_solid, no_solid, no_solid, no_solid}, {}};
        for (std::size_t lane = 0; lane < four_size && first + lane < is_member.size(); ++lane) {
            const BodyId body = near.body(first + lane);
            if (is_member[first + lane] != 0) {
                four.solid[lane] = solids.is_still[at(body.value)] != 0 ? still_solid : body.value;
                four.is_loose[lane] = solids.is_loose[at(body.value)];
            }
        }
        if (four.has(0) || four.has(1) || four.has(2) || four.has(3)) {
            fours_.push_back(four);
        }
    }
    paired_at_.assign(walls.position.begin(), walls.position.begin() + near.size());
}

namespace {

/// Appends what was found for some fours to what was found for those before.
template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void JointPairs::find_pairs(const fluid::BoundaryParticles& walls, const fluid::ParticleSettings& settings) {
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    std::vector<Vec3> places(four_size * fours_.size(), {nowhere, nowhere, nowhere});
    for (std::size_t k = 0; k < fours_.size(); ++k) {
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            if (fours_[k].has(lane)) {
                places[four_size * k + lane] = walls.position[fours_[k].sample(lane)];
            }
        }
    }
    fluid::BoxTree boxes;
    boxes.build(places, settings.domain);
    constexpr double slack = 1e-4;  // spacings, and of n_i . n_j: more than single precision can be off
    const double beyond = (skin_ + slack) * settings.spacing;
    const JointSearch search(
        fours_, placed_, fixed_, boxes,
        {static_cast<float>(JointKernelLimits(settings).reach + beyond),
         static_cast<float>(settings.support_radius() + beyond), static_cast<float>(-0.5 + 2 * most_turn + slack)});
    const std::vector<FourRange> ranges = ranges_of_fours(fours_);
    std::vector<FoundUnits> found(ranges.size());
    parallel::for_each_uneven(std::ssize(ranges), 1,
                              [&](std::int64_t range) { search.find(ranges[at(range)], found[at(range)]); });
    const auto clear = [&found](auto& all, auto part) {
        std::size_t count = 0;
        for (const FoundUnits& of_range : found) {
            count += (of_range.*part).size();
        }
        make_room(all, count);
        all.clear();
    };
    clear(units_, &FoundUnits::units);
    clear(slots_, &FoundUnits::slots);
    clear(met_, &FoundUnits::met);
    clear(joined_, &FoundUnits::joined);
    for (FoundUnits& of_range : found) {
        for (std::size_t k = 0; k < of_range.units.size(); ++k) {
            const JointUnit& unit = of_range.units[k];
            for (std::int32_t slot = 0; slot < unit.own_count + unit.other_count; ++slot) {
                of_range.slots[at(unit.first_slot + slot)].unit = static_cast<std::int32_t>(units_.size() + k);
            }
        }
        for (JointUnit unit : of_range.units) {
            unit.first_slot += static_cast<std::int32_t>(slots_.size());
            unit.first_met += std::ssize(met_);
            unit.first_joined += std::ssize(joined_);
            units_.push_back(unit);
        }
        append(slots_, of_range.slots);
        append(met_, of_range.met);
        append(joined_, of_range.joined);
        of_range = {};
    }
    list_joints();
    list_slots_of_fours();
}

/// Lists joints, ascending by partners, and all fours with part in each.
void JointPairs::list_joints() {
    std::vector<std::pair<std::uint64_t, std::int32_t>> units;  // by joint
    const auto partner = [&](const JointUnit& unit, std::int32_t solid, std::int32_t slot) {
        const JointFour& four = fours_[at(slots_[at(unit.first_slot + slot)].four)];
        return four.partner(static_cast<std::size_t>(std::ranges::find(four.solid, solid) - four.solid.begin()));
    };
    for (std::size_t k = 0; k < units_.size(); ++k) {
        const JointUnit& unit = units_[k];
        const std::int32_t own = partner(unit, unit.own_solid, 0),
                           other = partner(unit, unit.other_solid, unit.own_count);
        if (own != other) {  // both are not loose
            const auto [low, high] = std::minmax(own, other);
            units.emplace_back(static_cast<std::uint64_t>(high) << 32U | static_cast<std::uint32_t>(low - still_solid),
                               static_cast<std::int32_t>(k));
        }
    }
    std::ranges::sort(units);
    joints_.clear();
    sides_.clear();
    std::vector<std::int32_t> here;
    for (std::size_t begin = 0, end = 0; begin < units.size(); begin = end) {
        here.clear();
        const auto joint = static_cast<std::int32_t>(joints_.size());
        const auto first = static_cast<std::int32_t>(sides_.size());
        const std::uint64_t key = units[begin].first;
        for (; end < units.size() && units[end].first == key; ++end) {
            JointUnit& unit = units_[at(units[end].second)];
            unit.joint = joint;
            for (std::int32_t k = 0; k < unit.own_count + unit.other_count; ++k) {
                here.push_back(slots_[at(unit.first_slot + k)].four);
            }
        }
        std::ranges::sort(here);
        here.erase(std::unique(here.begin(), here.end()), here.end());
        joints_.push_back(
            {static_cast<std::int32_t>(key >> 32U), static_cast<std::int32_t>(key & 0xFFFFFFFFU) + still_solid, first});
        for (const std::int32_t four : here) {
            sides_.push_back({four, joint});
        }
        for (std::size_t k = begin; k < end; ++k) {
            const JointUnit& unit = units_[at(units[k].second)];
            for (std::int32_t slot = unit.first_slot; slot < unit.first_slot + unit.own_count + unit.other_count;
                 ++slot) {
                const auto place = std::ranges::lower_bound(here, slots_[at(slot)].four) - here.begin();
                slots_[at(slot)].side = first + static_cast<std::int32_t>(place);
            }
        }
    }
}

void JointPairs::list_slots_of_fours() {
    first_of_four_.assign(fours_.size() + 1, 0);
    for (const JointSlot& slot : slots_) {
        ++first_of_four_[at(slot.four) + 1];
    }
    for (std::size_t k = 0; k < fours_.size(); ++k) {
        first_of_four_[k + 1] += first_of_four_[k];
    }
    make_room(slots_of_fours_, slots_.size());
    std::vector<std::int32_t> next(first_of_four_.begin(), first_of_four_.end() - 1);
    for (std::size_t k = 0; k < slots_.size(); ++k) {
        slots_of_fours_[at(next[at(slots_[k].four)]++)] = static_cast<std::int32_t>(k);
    }
}

void JointPairs::update(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
                        const fluid::BoundaryParticles& walls, const fluid::ParticleSettings& settings) {
    const std::span<const Vec3> places = std::span(walls.position).first(at(near.size()));
    const fluid::Box box = fluid::box_of(places);
    fixed_ = fluid::FixedPoint({JointKernelLimits(settings).reach, settings.domain}, max(box.high - box.low, Vec3{}));
    const bool is_kept = keep(near, solids, motion, walls, settings.spacing);
    if (!is_kept) {
        find_members(near, solids, walls, settings);
    }
    place_fours<float>(fours_, near, motion, walls, fixed_, placed_);
    if (!is_kept) {
        find_pairs(walls, settings);
        posed_at_ = motion.pose;
        age_ = 0;
    }
}

std::size_t JointPairs::bytes() const {
    return bytes_of(fours_, placed_, joints_, sides_, units_, slots_) +
           bytes_of(met_, joined_, first_of_four_, slots_of_fours_, paired_at_, posed_at_);
}

}  // namespace riprap::coupling
