// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_sums.hpp"

#include <algorithm>

#include "riprap/core/index.hpp"

namespace riprap::coupling {

namespace {

/// Least of each of one four, over those of the other,
template <class Real>
void lessen_own(Four<Real>& four, Sixteen<Real> lanes) {
    std::array<Real, fluid::lane_count> all;
    lanes.store(all.data());
    for (std::size_t l = 0; l < all.size(); ++l) {
        four[l / four_size] = std::min(four[l / four_size], all[l]);
    }
}
/// and the other way.
template <class Real>
void lessen_others(Four<Real>& four, Sixteen<Real> lanes) {
    using Lane4 = Wide<Real, four_size>;
    std::array<Real, fluid::lane_count> all;
    lanes.store(all.data());
    Lane4 least = Lane4::load(four.data());
    for (std::size_t l = 0; l < all.size(); l += four_size) {
        least = min(least, Lane4::load(all.data() + l));
    }
    least.store(four.data());
}

/// A bit for each of one four with some pair, and for each of the other.
std::uint32_t own_with_pairs(std::uint32_t pairs) {
    const std::uint32_t any = (pairs | pairs >> 1U | pairs >> 2U | pairs >> 3U) & 0x1111U;
    return (any | any >> 3U | any >> 6U | any >> 9U) & 15U;
}
std::uint32_t others_with_pairs(std::uint32_t pairs) {
    return (pairs | pairs >> 4U | pairs >> 8U | pairs >> 12U) & 15U;
}

}  // namespace

/// Four samples that look at others.
template <class Real>
struct JointSums<Real>::Own {
    std::array<fluid::IntLanes, 3> place;
    std::array<Lanes, 3> normal;
    Lanes depth, volume, far;
};

template <class Real>
JointSums<Real>::JointSums(const JointPairs& pairs, std::span<const PlacedFour<Real>> placed,
                           const fluid::ParticleSettings& settings, const Vec3& gravity)
    : pairs_(pairs), placed_(placed), limits_(settings), kernel_(settings), is_planar_(settings.domain.dimension == 2) {
    const double blur = 0.25 * settings.spacing * settings.spacing;  // a piece of the rim is no point
    blur_ = static_cast<Real>(blur);
    for (int axis = 0; axis < 3; ++axis) {
        quantum_[at(axis)] = Lanes(pairs.fixed().quantum()[axis]);
        pull_[at(axis)] = Lanes(settings.rest_density * gravity[axis]);
    }
    for (std::size_t bits = 0; bits < far_.size(); ++bits) {
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            const bool counts = (bits >> lane & 1U) != 0;
            far_[bits][lane] = counts ? 0 : static_cast<Real>(1e3 * limits_.reach * limits_.reach);
        }
    }
}

template <class Real>
typename JointSums<Real>::Own JointSums<Real>::own_of(const JointSlot& slot) const {
    const PlacedFour<Real>& here = placed_[at(slot.four)];
    Own own;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        own.place[axis] = fluid::targets_in_lanes(here.place[axis].data());
        own.normal[axis] = own_in_lanes<Real>(here.normal[axis]);
    }
    own.depth = own_in_lanes<Real>(here.depth);
    own.volume = own_in_lanes<Real>(here.volume);
    own.far = own_in_lanes<Real>(far_[slot.lanes]);
    return own;
}

template <class Real>
std::array<Sixteen<Real>, 3> JointSums<Real>::apart(const Own& own, const PlacedFour<Real>& other) const {
    std::array<Lanes, 3> d;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const fluid::IntLanes there = fluid::candidates_in_lanes(other.place[axis].data());
        d[axis] = difference_in_lanes<Real>(own.place[axis], there) * quantum_[axis];
    }
    return d;
}

template <class Real>
JointLanes<Real> JointSums<Real>::lanes_of(const Own& own, const JointSlot& other) const {
    const std::array<Lanes, 3> d = apart(own, placed_[at(other.four)]);
    return {d, own.far + others_in_lanes<Real>(far_[other.lanes]) + dot(d, d)};
}

template <class Real>
template <class Begin, class Meet, class End>
void JointSums<Real>::for_each_entry(const JointUnit& unit, std::span<const JointEntry> entries, const Begin& begin,
                                     const Meet& meet, const End& end) const {
    const std::span<const JointSlot> slots =
        std::span(pairs_.slots()).subspan(at(unit.first_slot), at(unit.own_count + unit.other_count));
    for (std::size_t k = 0; k < entries.size();) {
        const std::uint32_t own = entries[k].own();
        if (!begin(own, slots[own])) {
            for (; k < entries.size() && entries[k].own() == own; ++k) {
            }
            continue;
        }
        for (; k < entries.size() && entries[k].own() == own; ++k) {
            const std::size_t other = at(unit.own_count) + entries[k].other();
            meet(other, slots[other]);
        }
        end(own);
    }
}

// Calls for each pair of fours cost a tenth of it, of this sum and the next.
template <class Real>
[[gnu::flatten]] void JointSums<Real>::look_around(std::size_t number, std::span<AroundSlot<Real>> slots,
                                                   std::span<std::uint8_t> marks) const {
    AroundSlot<Real> nothing;
    nothing.gap.fill(far());
    Own own;
    std::array<Lanes, 4> sum;
    Lanes gap;
    std::uint32_t meets = 0;
    bool is_anything = false;
    const Lanes zero(0), none(far());
    for_each_entry(
        pairs_.units()[number], pairs_.joined(number),
        [&](std::size_t, const JointSlot& slot) {
            own = own_of(slot);
            sum.fill(zero);
            gap = none;
            meets = 0;
            is_anything = false;
            return true;
        },
        [&](std::size_t place, const JointSlot& slot) {
            const PlacedFour<Real>& other = placed_[at(slot.four)];
            const JointLanes<Real> met = lanes_of(own, slot);
            std::array<Lanes, 3> normal;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                normal[axis] = others_in_lanes<Real>(other.normal[axis]);
            }
            const JointGaps<Real> gaps =
                kernel_.gaps(met, own.normal, normal, own.depth + others_in_lanes<Real>(other.depth));
            if (gaps.open == 0 && !kernel_.do_meet(met)) {
                return;
            }
            const Lanes volume = others_in_lanes<Real>(other.volume);
            const Lanes slope = kernel_.slope(met), there = volume * slope, back = -own.volume * slope;
            std::uint32_t pairs = negative_bits<Real>(slope);
            std::array<Lanes, 4> from;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                sum[axis] += there * met.apart[axis];
                from[axis] = back * met.apart[axis];
            }
            from[3] = zero;
            AroundSlot<Real>& at_other = slots[place];
            if (marks[place] == 0) {
                at_other = nothing;
            }
            is_anything = true;
            if (gaps.bits != 0) {
                Lanes here;
                if (gaps.open == 0) {  // they are together already
                    here = select(gaps.are_there & (slope < zero), zero, none);
                } else {
                    const Lanes shift = max(gaps.width, zero);
                    const JointLinks<Real> touching = kernel_.nearer(met, shift, gaps);
                    const Lanes to_own =
                        touching.slope * dot(touching.apart, own.normal) - slope * dot(met.apart, own.normal);
                    const Lanes to_other =
                        slope * dot(met.apart, normal) - touching.slope * dot(touching.apart, normal);
                    sum[3] += select(gaps.are_there, volume * to_own, zero);
                    from[3] = select(gaps.are_there, own.volume * to_other, zero);
                    here = select(gaps.are_there & (touching.slope < zero), shift, none);
                    pairs |= kernel_.do_closed_meet(met, gaps);
                }
                gap = min(gap, here);
                lessen_others<Real>(at_other.gap, here);
            }
            add_to_others<Real, 4>(at_other.sums, from);
            meets |= pairs;
            marks[place] = static_cast<std::uint8_t>(marks[place] | SlotMark::around | others_with_pairs(pairs));
        },
        [&](std::size_t place) {
            if (is_anything) {
                slots[place] = nothing;
                add_to_own<Real, 4>(slots[place].sums, sum);
                lessen_own<Real>(slots[place].gap, gap);
                marks[place] = static_cast<std::uint8_t>(SlotMark::around | own_with_pairs(meets));
            }
        });
}

template <class Real>
[[gnu::flatten]] void JointSums<Real>::feel(std::size_t number, std::span<const FeltFour<Real>> felt,
                                            std::span<FeltSlot<Real>> slots, std::span<std::uint8_t> marks) const {
    const JointUnit& unit = pairs_.units()[number];
    bool is_felt = false, is_asked = false;
    for (std::int32_t k = 0; k < unit.own_count + unit.other_count; ++k) {
        const FeltFour<Real>& four = felt[at(pairs_.slots()[at(unit.first_slot + k)].four)];
        is_felt = is_felt || four.is_felt;
        is_asked = is_asked || four.is_asked;
    }
    if (!is_felt || !is_asked) {
        return;
    }
    const Lanes per_reach(1 / limits_.reach), zero(0), one(1);
    const auto mark = [&](std::size_t place) {
        if ((marks[place] & SlotMark::felt) == 0) {
            slots[place] = {};
            marks[place] |= SlotMark::felt;
        }
    };
    Own own;
    Lanes weight, pressure;
    std::array<Lanes, 2> sum;
    const FeltFour<Real>* here = nullptr;
    for_each_entry(
        unit, pairs_.met(number),
        [&](std::size_t, const JointSlot& slot) {
            here = &felt[at(slot.four)];
            own = own_of(slot);
            weight = own_in_lanes<Real>(here->weight);
            pressure = own_in_lanes<Real>(here->felt);
            sum.fill(zero);
            return here->is_asked || here->is_felt;
        },
        [&](std::size_t place, const JointSlot& slot) {
            const FeltFour<Real>& there = felt[at(slot.four)];
            if (!(here->is_asked && there.is_felt) && !(here->is_felt && there.is_asked)) {
                return;
            }
            const JointLanes<Real> met = lanes_of(own, slot);
            const Lanes nearness = max(one - root(met.square) * per_reach, zero);
            const Lanes head = dot(pull_, met.apart);
            const Lanes of_other = nearness * others_in_lanes<Real>(there.weight), of_own = nearness * weight;
            sum[0] += of_other;
            sum[1] += of_other * (others_in_lanes<Real>(there.felt) + head);
            mark(place);
            add_to_others<Real, 2>(slots[place], {of_own, of_own * (pressure - head)});
        },
        [&](std::size_t place) {
            mark(place);
            add_to_own<Real, 2>(slots[place], sum);
        });
}

template <class Real>
void JointSums<Real>::push(std::size_t number, std::span<const SideFour<Real>> sides, std::span<ForceSlot<Real>> slots,
                           std::span<std::uint8_t> marks) const {
    const Lanes zero(0), one(1), half(0.5);
    for (std::size_t place = 0; place < slots.size(); ++place) {
        if ((marks[place] & SlotMark::meets) != 0) {
            slots[place] = {};
            marks[place] |= SlotMark::force;
        }
    }
    Own own;
    Lanes pressure, share;
    std::array<Lanes, 4> sum;
    for_each_entry(
        pairs_.units()[number], pairs_.joined(number),
        [&](std::size_t place, const JointSlot& slot) {
            if ((marks[place] & SlotMark::meets) == 0) {
                return false;
            }
            own = own_of(slot);
            pressure = own_in_lanes<Real>(sides[at(slot.side)].pressure);
            share = own_in_lanes<Real>(sides[at(slot.side)].left_to_do);
            sum.fill(zero);
            return true;
        },
        [&](std::size_t place, const JointSlot& slot) {
            if ((marks[place] & SlotMark::meets) == 0) {
                return;
            }
            const SideFour<Real>& side = sides[at(slot.side)];
            const Lanes both = pressure + others_in_lanes<Real>(side.pressure);
            if (bits_below(zero, both) == 0) {
                return;
            }
            const PlacedFour<Real>& other = placed_[at(slot.four)];
            const JointLanes<Real> met = lanes_of(own, slot);
            std::array<Lanes, 3> normal;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                normal[axis] = others_in_lanes<Real>(other.normal[axis]);
            }
            const JointGaps<Real> gaps =
                kernel_.gaps(met, own.normal, normal, own.depth + others_in_lanes<Real>(other.depth));
            if (gaps.open == 0 && !kernel_.do_meet(met)) {
                return;
            }
            std::array<Lanes, 3> push;
            const Lanes strength = both * kernel_.slope(met);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                push[axis] = strength * met.apart[axis];
            }
            if (gaps.open != 0) {
                const JointLinks<Real> closed = kernel_.closed(met, gaps);
                const Lanes left =
                    select(gaps.are_there, half * (share + others_in_lanes<Real>(side.left_to_do)), zero);
                const Lanes as_it_is = (one - left) * strength, brought = both * left * closed.slope;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    push[axis] =
                        as_it_is * met.apart[axis] + select(gaps.are_there, brought * closed.apart[axis], zero);
                }
            }
            const Lanes volume = others_in_lanes<Real>(other.volume);
            std::array<Lanes, 4> back;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                sum[axis] += volume * push[axis];
                back[axis] = -own.volume * push[axis];
            }
            back[3] = zero;
            add_to_others<Real, 4>(slots[place], back);
        },
        [&](std::size_t place) { add_to_own<Real, 4>(slots[place], sum); });
}

template <class Real>
void JointSums<Real>::reach(std::size_t number, std::span<std::uint32_t> slots) const {
    std::ranges::fill(slots, 0);
    Own own;
    std::uint32_t met = 0;
    for_each_entry(
        pairs_.units()[number], pairs_.met(number),
        [&](std::size_t, const JointSlot& slot) {
            own = own_of(slot);
            met = 0;
            return true;
        },
        [&](std::size_t place, const JointSlot& slot) {
            const std::uint32_t pairs = bits_below(lanes_of(own, slot).square, Lanes(limits_.reach * limits_.reach));
            met |= pairs;
            slots[place] |= others_with_pairs(pairs);
        },
        [&](std::size_t place) { slots[place] = own_with_pairs(met); });
}

template <class Real>
Four<Real> JointSums<Real>::pressure(std::size_t four, std::span<const RimFour<Real>> rim) const {
    std::array<fluid::IntLanes, 3> place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        place[axis] = fluid::targets_in_lanes(placed_[four].place[axis].data());
    }
    Lanes sum(0), weights(0);
    for (const RimFour<Real>& pieces : rim) {
        std::array<Lanes, 3> d;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const fluid::IntLanes there = fluid::candidates_in_lanes(pieces.place[axis].data());
            d[axis] = difference_in_lanes<Real>(place[axis], there) * quantum_[axis];
        }
        const Lanes square = Lanes(blur_) + dot(d, d);
        const Lanes nearness = is_planar_ ? inverse_root(square) : inverse(square);
        weights += nearness * others_in_lanes<Real>(pieces.all);
        sum += nearness * (others_in_lanes<Real>(pieces.pushed) + others_in_lanes<Real>(pieces.wet) * dot(pull_, d));
    }
    Four<Real> all{}, pushed{};
    add_to_own<Real>(all, weights);
    add_to_own<Real>(pushed, sum);
    for (std::size_t lane = 0; lane < four_size; ++lane) {
        pushed[lane] = all[lane] > 0 ? std::max(Real(0), pushed[lane] / all[lane]) : Real(0);
    }
    return pushed;
}

template class JointSums<float>;
template class JointSums<double>;

}  // namespace riprap::coupling
