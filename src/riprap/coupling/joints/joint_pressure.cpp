// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/joints/joint_water.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"

namespace riprap::coupling {

namespace {

constexpr std::int64_t grain = 64;
/// h |t| that uneven samples leave inside a joint, at most: at seams sums are off by 4 % of those at a plane wall.
constexpr double uneven = 0.1;
/// Tells whether some loose body meets water.
bool is_any_wet(const SampleView& near, const JointSolids& solids, const fluid::WaterAtWalls& water) {
    return parallel::any_of(near.size(), [&](std::int64_t i) {
        return water.weight[at(i)] > 0 && solids.is_loose[at(near.body(at(i)).value)] != 0;
    });
}

/// u of a member in a joint: what the water found there leaves to do. Particles that press harder than the joint count
/// for as much more of the room as they do: squeezed between two faces they hold a pressure that a film would let go.
double left_to_do(const JointWater& at_member, double water, double joint) {
    return joint > 0 ? std::max(0.0, 1 - (1 - at_member.dry_share) * std::max(1.0, water / joint))
                     : at_member.dry_share;
}

}  // namespace

struct JointPressure::Work {
    /// A member as part of the joint with one of those.
    struct Side {
        std::int32_t member, other;
        std::int32_t joint;
        double pressure;    ///< p [Pa]
        double left_to_do;  ///< u [-]
    };
    /// Holds what four samples feel of the water, see JointWater.
    struct FeltFour {
        Four weight{0.0}, felt{0.0};
    };
    /// A piece of the rim of a joint.
    struct RimPiece {
        Vec3 place;
        double wet, dry;  ///< s V c and s V e (1 - c)
        double pressure;  ///< of the water there [Pa]
    };

    /// Four samples as parts of the joint with one solid.
    struct SideFour {
        std::int32_t other;
        Four pressure{0.0}, left_to_do{0.0};  ///< as of Side
    };

    void list_sides();
    void spread_sides();
    void spread_felt();
    /// The piece of a rim that a member is; nothing where it is none.
    RimPiece rim_piece(const SampleView& near, std::size_t member, const fluid::ParticleSettings& settings,
                       const Vec3& gravity) const;
    void find_rims(const SampleView& near, const fluid::ParticleSettings& settings, const Vec3& gravity);
    /// Mean of what walls feel about a member, carried to it as in water at rest [Pa].
    double felt_about(std::size_t member, const fluid::ParticleSettings& settings, const Vec3& gravity) const;
    /// Returns the member as part of the joint with `other`; without pressure where it has no part in one.
    Side side_of(std::size_t member, std::int32_t other) const;
    /// Returns a four as parts of the joint with `other`.
    SideFour sides_of_four(std::size_t number, std::int32_t other) const;
    Vec3 force_on(std::size_t member, const JointKernel& kernel) const;

    JointPairs pairs;
    std::vector<JointWater> found;         ///< of each member
    std::vector<std::int32_t> side_begin;  ///< of each member in sides, one more at the end
    std::vector<Side> sides;
    std::vector<std::int32_t> side_four_begin;  ///< of each four in side_fours, one more at the end
    std::vector<SideFour> side_fours;
    std::vector<Four> dry_shares;  ///< u of each four where it has no side
    std::vector<FeltFour> felt;
    std::vector<RimPiece> pieces;             ///< of each member
    std::vector<std::vector<RimPiece>> rims;  ///< of each joint
    void find(const SampleView& near, std::span<const Vec3> slopes, const JointSolids& solids,
              const body::Motion& motion, const fluid::BoundaryParticles& walls, const fluid::WaterAtWalls& water,
              const fluid::ParticleSettings& settings, const Vec3& gravity, std::vector<Vec3>& force);
    std::size_t bytes() const;
};

void JointPressure::Work::list_sides() {
    const std::vector<JointMember>& members = pairs.members();
    std::unordered_map<std::uint64_t, std::int32_t> joints;
    std::pair<std::uint64_t, std::int32_t> last{};  // of the members before, which mostly have the same
    side_begin.assign(1, 0);
    sides.clear();
    for (std::size_t i = 0; i < members.size(); ++i) {
        for (const std::int32_t other : found[i].others) {
            const std::int32_t own = partner_of(members[i]);
            const auto low = static_cast<std::uint32_t>(std::min(own, other)),
                       high = static_cast<std::uint32_t>(std::max(own, other));
            const std::uint64_t both = std::uint64_t{low} << 32U | high;
            if (last.first != both || joints.empty()) {
                last = *joints.emplace(both, static_cast<std::int32_t>(joints.size())).first;
            }
            sides.push_back({static_cast<std::int32_t>(i), other, last.second, 0, 0});
        }
        side_begin.push_back(static_cast<std::int32_t>(sides.size()));
    }
    rims.resize(joints.size());
}

/// Copies sides into fours, for sums over them.
void JointPressure::Work::spread_sides() {
    const std::vector<SampleFour>& fours = pairs.fours();
    const auto count = static_cast<std::int64_t>(fours.size());
    std::vector<std::vector<SideFour>> found_at(fours.size());
    dry_shares.resize(fours.size(), Four(0));
    parallel::for_each_uneven(count, grain, [&](std::int64_t number) {
        std::vector<SideFour>& here = found_at[at(number)];
        Four& dry = dry_shares[at(number)];
        const SampleFour& four = fours[at(number)];
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            const auto k = static_cast<std::int64_t>(lane);
            dry.set(k, four.member[lane] >= 0 ? found[at(four.member[lane])].dry_share : 0);
        }
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            for (auto k = four.member[lane] < 0 ? 0 : side_begin[at(four.member[lane])];
                 four.member[lane] >= 0 && k < side_begin[at(four.member[lane]) + 1]; ++k) {
                const Side& side = sides[at(k)];
                auto place = std::ranges::find(here, side.other, &SideFour::other);
                if (place == here.end()) {
                    place = here.insert(here.end(), {side.other, Four(0), dry});
                }
                place->pressure.set(static_cast<std::int64_t>(lane), side.pressure);
                place->left_to_do.set(static_cast<std::int64_t>(lane), side.left_to_do);
            }
        }
    });
    side_four_begin.assign(1, 0);
    side_fours.clear();
    for (const std::vector<SideFour>& here : found_at) {
        side_fours.insert(side_fours.end(), here.begin(), here.end());
        side_four_begin.push_back(static_cast<std::int32_t>(side_fours.size()));
    }
}

/// Copies what members feel into fours, for sums over it.
void JointPressure::Work::spread_felt() {
    felt.assign(pairs.fours().size(), {});
    parallel::for_each(static_cast<std::int64_t>(felt.size()), [&](std::int64_t number) {
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            const std::int32_t member = pairs.fours()[at(number)].member[lane];
            if (member >= 0 && found[at(member)].weight > 0) {
                felt[at(number)].weight.set(static_cast<std::int64_t>(lane), found[at(member)].weight);
                felt[at(number)].felt.set(static_cast<std::int64_t>(lane), found[at(member)].felt);
            }
        }
    });
}

double JointPressure::Work::felt_about(std::size_t member, const fluid::ParticleSettings& settings,
                                       const Vec3& gravity) const {
    const Four3 pull(settings.rest_density * gravity);
    const Four per_reach(1 / JointKernel::reach(settings));
    Four sum(0), weights(0);
    pairs.for_each_met(member, [&](std::size_t number, const JointFour& near) {
        const FeltFour& four = felt[number];
        const Four nearness = max(Four(1) - sqrt(near.square) * per_reach, Four(0));
        const Four weight = select(near.is_there, four.weight * nearness, Four(0));
        weights += weight;
        sum += weight * (four.felt + dot(pull, near.apart));
    });
    const JointWater& own = found[member];
    const double own_weight = std::max(0.0, own.weight);
    const double all = own_weight + sum_of(weights);
    return all > 0 ? std::max(0.0, (own_weight * own.felt + sum_of(sum)) / all) : 0;
}

JointPressure::Work::RimPiece JointPressure::Work::rim_piece(const SampleView& near, std::size_t member,
                                                             const fluid::ParticleSettings& settings,
                                                             const Vec3& gravity) const {
    const JointMember& self = pairs.members()[member];
    const JointWater& at_member = found[member];
    if (side_begin[member] == side_begin[member + 1] || near.depth(at(self.sample)) >= settings.spacing) {
        return {};
    }
    const double strength = settings.smoothing_length() * norm(at_member.rim) - uneven;
    if (!(strength > 0)) {
        return {};
    }
    const double share = std::min(1.0, at_member.covered / well_filled), weight = strength * pairs.volume(member);
    return {pairs.self(member).place, weight * share, weight * (1 - share),
            share > 0 ? felt_about(member, settings, gravity) : 0};
}

void JointPressure::Work::find_rims(const SampleView& near, const fluid::ParticleSettings& settings,
                                    const Vec3& gravity) {
    for (std::vector<RimPiece>& rim : rims) {
        rim.clear();
    }
    spread_felt();
    pieces.resize(found.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(pieces.size()), grain, [&](std::int64_t member) {
        pieces[at(member)] = rim_piece(near, at(member), settings, gravity);
    });
    for (const Side& side : sides) {
        const RimPiece& piece = pieces[at(side.member)];
        if (piece.wet + piece.dry > 0) {
            rims[at(side.joint)].push_back(piece);
        }
    }
    // A dry piece higher than any water of the rim can rise drains nothing.
    const fluid::NearestImage nearest(settings.domain);
    parallel::for_each_uneven(static_cast<std::int64_t>(rims.size()), grain, [&](std::int64_t joint) {
        std::vector<RimPiece>& rim = rims[at(joint)];
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
        std::erase_if(rim, [](const RimPiece& piece) { return !(piece.wet + piece.dry > 0); });
    });
}

JointPressure::Work::Side JointPressure::Work::side_of(std::size_t member, std::int32_t other) const {
    for (auto k = at(side_begin[member]); k < at(side_begin[member + 1]); ++k) {
        if (sides[k].other == other) {
            return sides[k];
        }
    }
    return {static_cast<std::int32_t>(member), other, -1, 0, found[member].dry_share};
}

JointPressure::Work::SideFour JointPressure::Work::sides_of_four(std::size_t number, std::int32_t other) const {
    for (auto k = at(side_four_begin[number]); k < at(side_four_begin[number + 1]); ++k) {
        if (side_fours[k].other == other) {
            return side_fours[k];
        }
    }
    return {other, Four(0), dry_shares[number]};
}

Vec3 JointPressure::Work::force_on(std::size_t index, const JointKernel& kernel) const {
    if (!found[index].may_be_there) {
        return {};
    }
    const JointSelf self = pairs.self(index);
    const std::int32_t partner = partner_of(pairs.members()[index]);
    Four3 sum;
    Side own = side_of(index, still_solid);  // of the partner last met: members come solid by solid
    pairs.for_each_joined(index, self, [&](std::size_t number, const JointFour& near) {
        const SampleFour& other = pairs.fours()[number];
        const SideFour others = sides_of_four(number, partner);
        Four pressure = others.pressure, share = others.left_to_do;
        if (other.is_of_one_partner()) {
            own = other.partner[0] == own.other ? own : side_of(index, other.partner[0]);
            pressure += Four(own.pressure);
            share += Four(own.left_to_do);
        } else {
            for (std::uint32_t left = bits_of(near.is_there); left != 0; left &= left - 1) {
                const auto lane = static_cast<std::int64_t>(__builtin_ctz(left));
                own = side_of(index, other.partner[at(lane)]);
                pressure.set(lane, own.pressure + pressure[lane]);
                share.set(lane, own.left_to_do + share[lane]);
            }
        }
        pressure = select(near.is_there, pressure, Four(0));
        if (bits_below(Four(0), pressure) == 0) {
            return;
        }
        const JointLinks link = kernel.link(near);
        const JointGaps gaps = kernel.gaps(self, other, near);
        const Four strength = other.volume * pressure;
        if (!gaps.is_any) {
            sum = sum - (strength * link.slope) * link.apart;
            return;
        }
        const JointLinks closed = kernel.closed(near, gaps);
        share = select(gaps.are_there, Four(0.5) * share, Four(0));
        sum = sum - (strength * (Four(1) - share) * link.slope) * link.apart;
        const Four brought = select(gaps.are_there, strength * share * closed.slope, Four(0));
        sum = sum - Four3(select(gaps.are_there, brought * closed.apart.x, Four(0)),
                          select(gaps.are_there, brought * closed.apart.y, Four(0)),
                          select(gaps.are_there, brought * closed.apart.z, Four(0)));
    });
    return pairs.volume(index) * sum_of(sum);
}

void JointPressure::Work::find(const SampleView& near, std::span<const Vec3> slopes, const JointSolids& solids,
                               const body::Motion& motion, const fluid::BoundaryParticles& walls,
                               const fluid::WaterAtWalls& water, const fluid::ParticleSettings& settings,
                               const Vec3& gravity, std::vector<Vec3>& force) {
    RIPRAP_ASSERT(near.size() == 0 || near.number(at(near.size()) - 1) < slopes.size(), "slopes are of the whole set");
    force.clear();
    if (!is_any_wet(near, solids, water)) {
        return;
    }
    pairs.update(near, solids, motion, walls, settings);
    const JointKernel kernel(settings);
    find_joint_water(pairs, near, slopes, motion, water, settings, found);
    list_sides();
    if (sides.empty()) {
        return;
    }
    find_rims(near, settings, gravity);
    const std::vector<JointMember>& members = pairs.members();
    const fluid::NearestImage nearest(settings.domain);
    const double blur = 0.25 * settings.spacing * settings.spacing;  // a piece of the rim is no point
    parallel::for_each_uneven(static_cast<std::int64_t>(sides.size()), grain, [&](std::int64_t index) {
        Side& side = sides[at(index)];
        const Vec3 place = pairs.self(at(side.member)).place;
        double sum = 0, weights = 0;
        for (const RimPiece& piece : rims[at(side.joint)]) {
            const Vec3 d = nearest(place - piece.place);
            const double square = dot(d, d) + blur;
            const double nearness = 1 / (settings.domain.dimension == 2 ? std::sqrt(square) : square);
            weights += nearness * (piece.wet + piece.dry);
            sum += nearness * piece.wet * (piece.pressure + settings.rest_density * dot(gravity, d));
        }
        side.pressure = weights > 0 ? std::max(0.0, sum / weights) : 0;
        const JointWater& water_there = found[at(side.member)];
        side.left_to_do = left_to_do(water_there, water.pressure[at(members[at(side.member)].sample)], side.pressure);
    });
    spread_sides();
    force.resize(at(near.size()));
    parallel::for_each(near.size(), [&force](std::int64_t i) { force[at(i)] = {}; });
    parallel::for_each_uneven(static_cast<std::int64_t>(members.size()), grain, [&](std::int64_t index) {
        force[at(members[at(index)].sample)] = force_on(at(index), kernel);
    });
}

std::size_t JointPressure::Work::bytes() const {
    std::size_t bytes = pairs.bytes() + bytes_of(found, side_begin, sides, pieces, rims) + bytes_of(felt) +
                        bytes_of(side_four_begin, side_fours, dry_shares);
    for (const JointWater& at_member : found) {
        bytes += bytes_of(at_member.others);
    }
    return bytes;
}

JointPressure::JointPressure() : work_(std::make_unique<Work>()) {}
JointPressure::~JointPressure() = default;
JointPressure::JointPressure(JointPressure&&) noexcept = default;
JointPressure& JointPressure::operator=(JointPressure&&) noexcept = default;
void JointPressure::forget() { work_->pairs.forget(); }
std::size_t JointPressure::bytes() const { return work_->bytes(); }

void JointPressure::find(const SampleView& near, std::span<const Vec3> slopes, const JointSolids& solids,
                         const body::Motion& motion, const fluid::BoundaryParticles& walls,
                         const fluid::WaterAtWalls& water, const fluid::ParticleSettings& settings, const Vec3& gravity,
                         std::vector<Vec3>& force) {
    work_->find(near, slopes, solids, motion, walls, water, settings, gravity, force);
}

}  // namespace riprap::coupling
