// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/joints/joint_rim.hpp"
#include "riprap/coupling/joints/joint_water.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"

namespace riprap::coupling {

namespace {

constexpr std::int64_t grain = 64;
/// h |t| that uneven samples leave inside a joint, at most: at seams sums are off by 4 % of those at a plane wall.
constexpr double uneven = 0.1;
/// Reach of even_rim over the support, which the pieces of a rim lie apart across it at most.
constexpr double rim_reach = 2;

/// Tells whether some loose body meets water.
bool is_any_wet(const SampleView& near, const JointSolids& solids, const fluid::WaterAtWalls& water) {
    return parallel::any_of(near.size(), [&](std::int64_t i) {
        return water.weight[at(i)] > 0 && solids.is_loose[at(near.body(at(i)).value)] != 0;
    });
}

/// Returns u of a sample in a joint, the share of the joint's pressure that particles found there do not bring. Those
/// that press harder than the joint count for as much more of its room: squeezed between two faces they keep a pressure
/// that a film of water would lose.
double left_to_do(const JointWater& here, double water, double joint) {
    return joint > 0 ? std::max(0.0, 1 - (1 - here.dry_share) * std::max(1.0, water / joint)) : here.dry_share;
}

/// A piece of the rims of joints.
struct RimPiece {
    double wet{0}, dry{0};  ///< s V c and s V (1 - c)
    double pressure{0};     ///< of the water there [Pa]
};

/// Scene of a step.
struct JointScene {
    const SampleView& near;
    const fluid::BoundaryParticles& walls;
    const fluid::WaterAtWalls& water;
    const fluid::ParticleSettings& settings;
    const Vec3& gravity;
};

/// Pressures and forces of one step, in float or double.
template <class Real>
class JointStep {
 public:
    void find(const JointPairs& pairs, std::span<const PlacedFour<Real>> placed, std::span<const Vec3> slopes,
              const body::Motion& motion, const JointScene& scene, std::vector<Vec3>& force);
    std::size_t bytes() const {
        return bytes_of(around_, marks_, found_, shares_, pieces_, are_pieces_, felt_, felt_slots_, sides_, forces_);
    }

 private:
    void find_sides(const JointPairs& pairs);
    void find_pieces(const JointPairs& pairs, const JointScene& scene);
    void feel(const JointPairs& pairs, const JointSums<Real>& sums);
    void press(const JointPairs& pairs, const JointSums<Real>& sums, const JointScene& scene, std::size_t joint);
    void list_rim(const JointPairs& pairs, const JointScene& scene, std::size_t joint,
                  std::vector<RimFour<Real>>& rim) const;

    std::vector<AroundSlot<Real>> around_;  ///< of each slot
    std::vector<std::uint8_t> marks_;       ///< of each slot, what it holds
    std::vector<JointWater> found_;         ///< of each sample of each four
    std::vector<std::uint8_t> shares_;      ///< of each side, a bit for each sample that shares the joint
    std::vector<RimPiece> pieces_;          ///< of each sample of each four
    std::vector<std::uint8_t> are_pieces_;  ///< of each four, a bit for each sample that is one
    std::vector<FeltFour<Real>> felt_;      ///< of each four
    std::vector<FeltSlot<Real>> felt_slots_;
    std::vector<SideFour<Real>> sides_;  ///< of each side
    std::vector<ForceSlot<Real>> forces_;
    std::span<const PlacedFour<Real>> placed_;
};

/// Slots of a unit among those of all.
template <class T>
std::span<T> slots_of(std::vector<T>& all, const JointUnit& unit) {
    return std::span(all).subspan(at(unit.first_slot), at(unit.own_count + unit.other_count));
}

template <class Real>
void JointStep<Real>::find_sides(const JointPairs& pairs) {
    shares_.assign(pairs.sides().size(), 0);
    for (std::size_t k = 0; k < pairs.slots().size(); ++k) {
        const unsigned meets = marks_[k] & SlotMark::meets;
        if (meets != 0 && pairs.slots()[k].side >= 0) {
            std::uint8_t& shares = shares_[at(pairs.slots()[k].side)];
            shares = static_cast<std::uint8_t>(shares | meets);
        }
    }
}

/// Finds which samples are pieces of a rim, and what all feel.
template <class Real>
void JointStep<Real>::find_pieces(const JointPairs& pairs, const JointScene& scene) {
    std::vector<std::uint8_t> is_side(pairs.fours().size(), 0);  // bits
    for (std::size_t k = 0; k < shares_.size(); ++k) {
        std::uint8_t& bits = is_side[at(pairs.sides()[k].four)];
        bits = static_cast<std::uint8_t>(bits | shares_[k]);
    }
    make_room(pieces_, found_.size());
    make_room(are_pieces_, pairs.fours().size());
    make_room(felt_, pairs.fours().size());
    parallel::for_each(std::ssize(felt_), [&](std::int64_t four) {
        unsigned are_pieces = 0;
        FeltFour<Real>& felt = felt_[at(four)];
        felt = {};
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            const JointWater& here = found_[four_size * at(four) + lane];
            felt.weight[lane] = static_cast<Real>(here.weight);
            felt.felt[lane] = static_cast<Real>(here.felt);
            felt.is_felt = felt.is_felt || here.weight > 0;
            RimPiece& piece = pieces_[four_size * at(four) + lane];
            piece = {};
            if ((is_side[at(four)] >> lane & 1U) == 0 || !here.is_first) {
                continue;
            }
            const double strength = scene.settings.smoothing_length() * norm(here.rim) - uneven;
            if (strength > 0) {
                const double share = std::min(1.0, here.covered / well_filled);
                const double weight = strength * scene.near.volume(pairs.fours()[at(four)].sample(lane));
                piece = {weight * share, weight * (1 - share), 0};
                felt.is_asked = felt.is_asked || piece.wet > 0;
                are_pieces |= piece.wet + piece.dry > 0 ? 1U << lane : 0U;
            }
        }
        are_pieces_[at(four)] = static_cast<std::uint8_t>(are_pieces);
    });
}

/// Finds the pressure at the pieces of rims: the mean of what walls feel about them, carried to them as in water at
/// rest.
template <class Real>
void JointStep<Real>::feel(const JointPairs& pairs, const JointSums<Real>& sums) {
    make_room(felt_slots_, pairs.slots().size());
    parallel::for_each_uneven(std::ssize(pairs.units()), 4, [&](std::int64_t number) {
        const JointUnit& unit = pairs.units()[at(number)];
        sums.feel(at(number), felt_, slots_of(felt_slots_, unit), slots_of(marks_, unit));
    });
    parallel::for_each_uneven(std::ssize(felt_), grain, [&](std::int64_t four) {
        if (!felt_[at(four)].is_asked) {
            return;
        }
        std::array<double, four_size> weights{}, sum{};
        for (const std::int32_t slot : pairs.slots_of(at(four))) {
            for (std::size_t lane = 0; (marks_[at(slot)] & SlotMark::felt) != 0 && lane < four_size; ++lane) {
                weights[lane] += felt_slots_[at(slot)][0][lane];
                sum[lane] += felt_slots_[at(slot)][1][lane];
            }
        }
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            const JointWater& own = found_[four_size * at(four) + lane];
            const double all = own.weight + weights[lane];
            pieces_[four_size * at(four) + lane].pressure =
                all > 0 ? std::max(0.0, (own.weight * own.felt + sum[lane]) / all) : 0;
        }
    });
}

/// Lists the pieces of the rim of a joint, but for dry ones higher than any water of the rim can rise, which drain
/// nothing.
template <class Real>
void JointStep<Real>::list_rim(const JointPairs& pairs, const JointScene& scene, std::size_t joint,
                               std::vector<RimFour<Real>>& rim) const {
    struct Piece {
        std::size_t four, lane;
        double head;  ///< at rest, of its place beyond that of the first piece [Pa]
    };
    std::vector<Piece> pieces;
    std::vector<RimPart> parts;
    const fluid::NearestImage nearest(scene.settings.domain);
    const Vec3 pull = scene.settings.rest_density * scene.gravity;
    double highest = 0;  // head of the water above that of the first piece [Pa]
    bool is_wet = false;
    Vec3 origin{};
    const std::span<const JointSide> sides = pairs.sides_of(joint);
    const std::size_t first = at(pairs.joints()[joint].first_side);
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const auto four = at(sides[k].four);
        for (unsigned left = shares_[first + k] & are_pieces_[four]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
            const RimPiece& part = pieces_[four_size * four + lane];
            const Vec3& place = scene.walls.position[pairs.fours()[four].sample(lane)];
            origin = pieces.empty() ? place : origin;
            const Vec3 apart = nearest(place - origin);
            pieces.push_back({four, lane, dot(pull, apart)});
            const Vec3& inward = found_[four_size * four + lane].rim;
            parts.push_back({apart, inward / norm(inward), part.wet + part.dry});
            if (part.wet > 0) {
                const double head = part.pressure - pieces.back().head;
                highest = is_wet ? std::max(highest, head) : head;
                is_wet = true;
            }
        }
    }
    const std::vector<double> even = even_rim(parts, rim_reach * scene.settings.support_radius());
    std::size_t count = 0;
    rim.clear();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const Piece& piece = pieces[k];
        const RimPiece& part = pieces_[four_size * piece.four + piece.lane];
        const double wet = even[k] * part.wet, dry = is_wet && highest + piece.head > 0 ? even[k] * part.dry : 0;
        if (!(wet + dry > 0)) {
            continue;
        }
        const std::size_t lane = count++ % four_size;
        if (lane == 0) {
            rim.emplace_back();
        }
        RimFour<Real>& four = rim.back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            four.place[axis][lane] = placed_[piece.four].place[axis][piece.lane];
        }
        four.all[lane] = static_cast<Real>(wet + dry);
        four.wet[lane] = static_cast<Real>(wet);
        four.pushed[lane] = static_cast<Real>(wet * part.pressure);
    }
}

/// Finds the pressure in a joint, and the share of it that particles found there do not bring.
template <class Real>
void JointStep<Real>::press(const JointPairs& pairs, const JointSums<Real>& sums, const JointScene& scene,
                            std::size_t joint) {
    std::vector<RimFour<Real>> rim;
    list_rim(pairs, scene, joint, rim);
    const std::size_t first = at(pairs.joints()[joint].first_side);
    const std::span<const JointSide> sides = pairs.sides_of(joint);
    for (std::size_t k = 0; k < sides.size(); ++k) {
        if (shares_[first + k] == 0) {
            continue;  // which nobody reads
        }
        const auto four = at(sides[k].four);
        const Four<Real> pressure = rim.empty() ? Four<Real>{} : sums.pressure(four, rim);
        SideFour<Real>& side = sides_[first + k];
        side = {};
        for (unsigned left = shares_[first + k]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
            const double of_water = scene.water.pressure[pairs.fours()[four].sample(lane)];
            side.pressure[lane] = pressure[lane];
            side.left_to_do[lane] =
                static_cast<Real>(left_to_do(found_[four_size * four + lane], of_water, double{pressure[lane]}));
        }
    }
}

template <class Real>
void JointStep<Real>::find(const JointPairs& pairs, std::span<const PlacedFour<Real>> placed,
                           std::span<const Vec3> slopes, const body::Motion& motion, const JointScene& scene,
                           std::vector<Vec3>& force) {
    placed_ = placed;
    const JointSums<Real> sums(pairs, placed, scene.settings, scene.gravity);
    const WetSolids wet = find_wet_solids(pairs, motion.pose.size(), scene.water);
    find_joint_water(pairs, sums, scene.near, slopes, motion, scene.water, scene.settings, wet, around_, marks_,
                     found_);
    find_sides(pairs);
    if (std::ranges::find_if(shares_, [](std::uint8_t bits) { return bits != 0; }) == shares_.end()) {
        return;
    }
    find_pieces(pairs, scene);
    feel(pairs, sums);
    make_room(sides_, pairs.sides().size());
    const auto is_wet = [&](std::int64_t joint) {
        const Joint& here = pairs.joints()[at(joint)];
        return wet.is_wet_partner[WetSolids::entry(here.high)] != 0 ||
               wet.is_wet_partner[WetSolids::entry(here.low)] != 0;
    };
    parallel::for_each_uneven(std::ssize(pairs.joints()), 4, [&](std::int64_t joint) {
        if (is_wet(joint)) {
            press(pairs, sums, scene, at(joint));
        }
    });
    make_room(forces_, pairs.slots().size());
    parallel::for_each_uneven(std::ssize(pairs.units()), 4, [&](std::int64_t number) {
        const JointUnit& unit = pairs.units()[at(number)];
        if (unit.joint >= 0 && is_wet(unit.joint)) {
            sums.push(at(number), sides_, slots_of(forces_, unit), slots_of(marks_, unit));
        }
    });
    force.resize(at(scene.near.size()));
    parallel::for_each(scene.near.size(), [&force](std::int64_t i) { force[at(i)] = {}; });
    parallel::for_each_uneven(std::ssize(pairs.fours()), grain, [&](std::int64_t four) {
        std::array<Vec3, four_size> sum{};
        for (const std::int32_t slot : pairs.slots_of(at(four))) {
            for (std::size_t lane = 0; (marks_[at(slot)] & SlotMark::force) != 0 && lane < four_size; ++lane) {
                const ForceSlot<Real>& part = forces_[at(slot)];
                sum[lane] += Vec3{part[0][lane], part[1][lane], part[2][lane]};
            }
        }
        const JointFour& samples = pairs.fours()[at(four)];
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            if (samples.has(lane)) {
                const std::size_t i = samples.sample(lane);
                force[i] = -scene.near.volume(i) * sum[lane];
            }
        }
    });
}

}  // namespace

struct JointPressure::Work {
    JointPairs pairs;
    JointStep<float> fast;
    JointStep<double> plain;
    std::vector<PlacedFour<double>> placed_plainly;
};

JointPressure::JointPressure() : work_(std::make_unique<Work>()) {}
JointPressure::~JointPressure() = default;
JointPressure::JointPressure(JointPressure&&) noexcept = default;
JointPressure& JointPressure::operator=(JointPressure&&) noexcept = default;
void JointPressure::forget() { work_->pairs.forget(); }
std::size_t JointPressure::bytes() const {
    return work_->pairs.bytes() + work_->fast.bytes() + work_->plain.bytes() + bytes_of(work_->placed_plainly);
}

void JointPressure::find(const SampleView& near, std::span<const Vec3> slopes, const JointSolids& solids,
                         const body::Motion& motion, const fluid::BoundaryParticles& walls,
                         const fluid::WaterAtWalls& water, const fluid::ParticleSettings& settings, const Vec3& gravity,
                         bool is_plain, std::vector<Vec3>& force) {
    RIPRAP_ASSERT(near.size() == 0 || near.number(at(near.size()) - 1) < slopes.size(), "slopes are of the whole set");
    force.clear();
    if (!is_any_wet(near, solids, water)) {
        return;
    }
    work_->pairs.update(near, solids, motion, walls, settings);
    const JointScene scene{near, walls, water, settings, gravity};
    if (is_plain) {
        place_fours<double>(work_->pairs.fours(), near, motion, walls, work_->pairs.fixed(), work_->placed_plainly);
        work_->plain.find(work_->pairs, work_->placed_plainly, slopes, motion, scene, force);
    } else {
        work_->fast.find(work_->pairs, work_->pairs.placed(), slopes, motion, scene, force);
    }
}

}  // namespace riprap::coupling
