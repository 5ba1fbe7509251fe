// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

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

void JointPressure::list_sides() {
    const std::vector<JointMember>& members = pairs_.members();
    std::unordered_map<std::uint64_t, std::int32_t> joints;
    std::pair<std::uint64_t, std::int32_t> last{};  // of the members before, which mostly have the same
    side_begin_.assign(1, 0);
    sides_.clear();
    for (std::size_t i = 0; i < members.size(); ++i) {
        for (const std::int32_t other : found_[i].others) {
            const std::int32_t own = partner_of(members[i]);
            const auto low = static_cast<std::uint32_t>(std::min(own, other)),
                       high = static_cast<std::uint32_t>(std::max(own, other));
            const std::uint64_t both = std::uint64_t{low} << 32U | high;
            if (last.first != both || joints.empty()) {
                last = *joints.emplace(both, static_cast<std::int32_t>(joints.size())).first;
            }
            sides_.push_back({static_cast<std::int32_t>(i), other, last.second, 0});
        }
        side_begin_.push_back(static_cast<std::int32_t>(sides_.size()));
    }
    rims_.resize(joints.size());
}

double JointPressure::felt_about(std::size_t member, const fluid::ParticleSettings& settings,
                                 const Vec3& gravity) const {
    const double reach = JointKernel::reach(settings);
    double sum = 0, weights = 0;
    const auto add = [&](std::size_t k, const Vec3& d, double square) {
        const JointWater& at_member = found_[k];
        if (!(at_member.weight > 0)) {
            return;
        }
        const double weight = at_member.weight * std::max(0.0, 1 - std::sqrt(square) / reach);
        weights += weight;
        sum += weight * (at_member.felt + settings.rest_density * dot(gravity, d));
    };
    add(member, {}, 0);
    pairs_.for_each_met(member, add);
    return weights > 0 ? std::max(0.0, sum / weights) : 0;
}

JointPressure::RimPiece JointPressure::rim_piece(const SampleView& near, std::size_t member,
                                                 const fluid::ParticleSettings& settings, const Vec3& gravity) const {
    const JointMember& self = pairs_.members()[member];
    const JointWater& at_member = found_[member];
    const double strength = settings.smoothing_length() * norm(at_member.rim) - uneven;
    if (!(strength > 0) || near.depth(at(self.sample)) >= settings.spacing) {
        return {};
    }
    const double share = std::min(1.0, at_member.covered / well_filled), weight = strength * self.volume;
    return {self.place, weight * share, weight * (1 - share), share > 0 ? felt_about(member, settings, gravity) : 0};
}

void JointPressure::find_rims(const SampleView& near, const fluid::ParticleSettings& settings, const Vec3& gravity) {
    for (std::vector<RimPiece>& rim : rims_) {
        rim.clear();
    }
    pieces_.resize(sides_.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(sides_.size()), grain, [&](std::int64_t k) {
        pieces_[at(k)] = rim_piece(near, at(sides_[at(k)].member), settings, gravity);
    });
    for (std::size_t k = 0; k < sides_.size(); ++k) {
        if (pieces_[k].wet + pieces_[k].dry > 0) {
            rims_[at(sides_[k].joint)].push_back(pieces_[k]);
        }
    }
    // A dry piece higher than any water of the rim can rise drains nothing.
    const fluid::NearestImage nearest(settings.domain);
    parallel::for_each_uneven(static_cast<std::int64_t>(rims_.size()), grain, [&](std::int64_t joint) {
        std::vector<RimPiece>& rim = rims_[at(joint)];
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

Vec3 JointPressure::force_on(std::size_t index, const JointKernel& kernel, const fluid::WaterAtWalls& water) const {
    const std::vector<JointMember>& members = pairs_.members();
    const JointMember& member = members[index];
    if (!found_[index].may_be_there) {
        return {};
    }
    Vec3 sum{};
    std::int32_t solid = member.solid;  // of the other members, which come solid by solid
    double own = 0, own_share = 0;
    pairs_.for_each_joined(index, [&](std::size_t j, const Vec3& apart, double square) {
        const JointMember& other = members[j];
        if (other.solid != solid) {
            solid = other.solid;
            own = pressure_of(index, partner_of(other));
            own_share = left_to_do(found_[index], water.pressure[at(member.sample)], own);
        }
        const double others = pressure_of(j, partner_of(member)), pressure = own + others;
        if (pressure == 0) {
            return;
        }
        const JointLink link = kernel.link(apart, square);
        const double share = 0.5 * (own_share + left_to_do(found_[j], water.pressure[at(other.sample)], others));
        const std::optional<JointGap> gap = share > 0 ? kernel.gap(member, other, link) : std::nullopt;
        const JointLink closed = gap ? kernel.closed(link, *gap) : link;
        sum -= other.volume * pressure * ((1 - share) * link.slope * link.apart + share * closed.slope * closed.apart);
    });
    return member.volume * sum;
}

void JointPressure::find(const SampleView& near, std::span<const Vec3> slopes, const JointSolids& solids,
                         const body::Motion& motion, const fluid::BoundaryParticles& walls,
                         const fluid::WaterAtWalls& water, const fluid::ParticleSettings& settings, const Vec3& gravity,
                         std::vector<Vec3>& force) {
    RIPRAP_ASSERT(near.size() == 0 || near.number(at(near.size()) - 1) < slopes.size(), "slopes are of the whole set");
    force.clear();
    if (!is_any_wet(near, solids, water)) {
        return;
    }
    pairs_.update(near, solids, motion, walls, settings);
    const JointKernel kernel(settings);
    find_joint_water(pairs_, near, slopes, motion, water, settings, found_);
    list_sides();
    if (sides_.empty()) {
        return;
    }
    find_rims(near, settings, gravity);
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
    force.resize(at(near.size()));
    parallel::for_each(near.size(), [&force](std::int64_t i) { force[at(i)] = {}; });
    parallel::for_each_uneven(static_cast<std::int64_t>(members.size()), grain, [&](std::int64_t index) {
        force[at(members[at(index)].sample)] = force_on(at(index), kernel, water);
    });
}

std::size_t JointPressure::bytes() const {
    std::size_t bytes = pairs_.bytes() + bytes_of(found_, side_begin_, sides_, pieces_, rims_);
    for (const JointWater& at_member : found_) {
        bytes += bytes_of(at_member.others);
    }
    return bytes;
}

}  // namespace riprap::coupling
