// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/joint_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"

namespace riprap::geometry {

namespace {

/// A block being cut, with a key made of the seed and of all decisions that led to it.
struct Piece {
    Polyhedron shape;
    std::uint64_t key;
};

std::vector<GeometryProblem> check(const Polyhedron& region, std::span<const JointSet> sets,
                                   const JointingOptions& options) {
    std::vector<GeometryProblem> problems;
    const auto require = [&](bool is_good, std::string message, std::string allowed) {
        if (!is_good) {
            problems.push_back({std::move(message), std::move(allowed)});
        }
    };
    require(region.faces.size() >= 4, "the region to cut is empty", "a closed convex polyhedron");
    require(options.minimum_volume >= 0.0 && std::isfinite(options.minimum_volume),
            fmt::format("minimum volume {:g} m^3", options.minimum_volume), "a finite number, at least 0");
    require(options.maximum_blocks >= 1, fmt::format("at most {} blocks", options.maximum_blocks), "at least 1");
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const JointSet& set = sets[s];
        const auto named = [&](const char* what, double value) {
            return fmt::format("joint set {}: {} {:g}", s + 1, what, value);
        };
        require(is_finite(set.normal) && std::abs(norm(set.normal) - 1.0) < 1e-9,
                named("length of the normal", norm(set.normal)), "1");
        require(std::isfinite(set.spacing) && set.spacing > 0.0, named("spacing [m]", set.spacing), "above 0");
        require(set.spacing_scatter >= 0.0 && set.spacing_scatter < 1.0, named("scatter", set.spacing_scatter),
                "0 <= scatter < 1");
        require(set.persistence >= 0.0 && set.persistence <= 1.0, named("persistence", set.persistence), "0 to 1");
        require(is_finite(set.origin) && std::isfinite(set.offset), named("offset [m]", set.offset),
                "a finite offset and origin");
    }
    return problems;
}

/// Positions of the joints of one set along its normal.
class JointPositions {
 public:
    JointPositions(const JointSet& set, std::uint64_t key) : set_(set), key_(key) {}

    /// Joints counted from the origin to the far end of the range, whether they meet it or not.
    double count_to_reach(const Range& range) const {
        const double start = dot(set_.normal, set_.origin) + set_.offset;
        const double reach = std::max({range.high - start, start - range.low, range.high - range.low});
        return reach / (set_.spacing * (1.0 - set_.spacing_scatter));
    }

    struct Joint {
        std::int64_t number;
        double offset;
    };
    /// Joints strictly inside the range, in ascending order.
    std::vector<Joint> inside(const Range& range) const {
        const double start = dot(set_.normal, set_.origin) + set_.offset;
        std::vector<Joint> joints;
        if (set_.spacing_scatter == 0.0) {
            auto number = static_cast<std::int64_t>(std::ceil((range.low - start) / set_.spacing));
            for (; at(start, number) < range.high; ++number) {
                joints.push_back({number, at(start, number)});
            }
        } else {
            Joint joint{0, start};
            while (joint.offset > range.low) {
                joints.push_back(joint);
                joint.offset -= spacing(joint.number--);
            }
            std::reverse(joints.begin(), joints.end());
            joint = {1, start + spacing(1)};
            while (joint.offset < range.high) {
                joints.push_back(joint);
                joint.offset += spacing(++joint.number);
            }
        }
        std::erase_if(joints, [&](const Joint& j) { return j.offset <= range.low || j.offset >= range.high; });
        return joints;
    }

 private:
    double at(double start, std::int64_t number) const { return start + static_cast<double>(number) * set_.spacing; }
    /// Distance from joint number-1 to joint number [m].
    double spacing(std::int64_t number) const {
        const double u = unit_interval(mix_bits(key_, static_cast<std::uint64_t>(number)));
        return set_.spacing * (1.0 + set_.spacing_scatter * (2.0 * u - 1.0));
    }

    const JointSet& set_;
    std::uint64_t key_;
};

class Jointing {
 public:
    Jointing(const Polyhedron& region, const JointingOptions& options)
        : options_(options), region_scale_(length_scale(region.vertices)) {
        pieces_.push_back({region, options.seed});
    }

    /// False if there would be too many blocks.
    bool cut(std::size_t set_number, const JointSet& set, const std::vector<JointPositions::Joint>& joints) {
        rock_.joint_count += static_cast<std::int64_t>(joints.size());
        std::vector<Piece> cut_pieces;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const auto left = static_cast<std::int64_t>(pieces_.size() - i - 1);
            pieces_[i].key = mix_bits(pieces_[i].key, set_number);  // a block that no joint cut draws anew in each set
            if (!cut_piece(std::move(pieces_[i]), set, joints, left, cut_pieces)) {
                return false;
            }
        }
        pieces_ = std::move(cut_pieces);
        return true;
    }

    JointedRock finish() {
        rock_.blocks.reserve(pieces_.size());
        for (Piece& piece : pieces_) {
            const double volume = mass_properties(piece.shape).volume;
            if (rock_.blocks.empty() || volume < rock_.smallest_volume) {
                rock_.smallest_volume = volume;
                rock_.smallest_block = static_cast<std::int32_t>(rock_.blocks.size());
            }
            rock_.blocks.push_back(std::move(piece.shape));
        }
        return std::move(rock_);
    }

 private:
    /// Slices one block from its lowest joint upwards; what remains above meets the next joint.
    bool cut_piece(Piece piece, const JointSet& set, const std::vector<JointPositions::Joint>& joints,
                   std::int64_t pieces_left, std::vector<Piece>& cut_pieces) {
        const Range range = range_along(piece.shape, set.normal);
        const double margin = cut_tolerance * region_scale_;
        auto joint = std::upper_bound(joints.begin(), joints.end(), range.low + margin,
                                      [](double low, const auto& j) { return low < j.offset; });
        for (; joint != joints.end() && joint->offset < range.high - margin; ++joint) {
            const std::uint64_t draw = mix_bits(piece.key, static_cast<std::uint64_t>(joint->number));
            if (unit_interval(draw) >= set.persistence) {
                continue;
            }
            CutPieces halves = cut_convex(piece.shape, {set.normal, joint->offset});
            if (!halves.is_cut()) {
                continue;
            }
            if (options_.minimum_volume > 0.0 && (mass_properties(halves.below).volume < options_.minimum_volume ||
                                                  mass_properties(halves.above).volume < options_.minimum_volume)) {
                ++rock_.skipped_cuts;
                continue;
            }
            cut_pieces.push_back({std::move(halves.below), mix_bits(draw, 1)});
            piece = {std::move(halves.above), mix_bits(draw, 2)};
            if (static_cast<std::int64_t>(cut_pieces.size()) + 1 + pieces_left > options_.maximum_blocks) {
                return false;
            }
        }
        cut_pieces.push_back(std::move(piece));
        return true;
    }

    const JointingOptions& options_;
    double region_scale_;
    std::vector<Piece> pieces_;
    JointedRock rock_;
};

}  // namespace

Vec3 joint_normal(double dip, double dip_direction) {
    return {std::sin(dip_direction) * std::sin(dip), std::cos(dip_direction) * std::sin(dip), std::cos(dip)};
}

Outcome<JointedRock> cut_by_joint_sets(const Polyhedron& region, std::span<const JointSet> sets,
                                       const JointingOptions& options) {
    if (auto problems = check(region, sets, options); !problems.empty()) {
        return problems;
    }
    // Joints of sets that cross all others cut so many blocks; sets of like directions cut fewer.
    double blocks = 1;
    for (const JointSet& set : sets) {
        const Range range = range_along(region, set.normal);
        blocks *= 1 + set.persistence * std::floor((range.high - range.low) / set.spacing);
    }
    const auto too_many = [&](std::size_t s, const char* what) {
        return GeometryProblem{
            fmt::format("joint set {}: {}; all sets together make up to {:.2g}", s + 1, what, blocks),
            fmt::format("at most {} blocks; a wider spacing or a smaller region", options.maximum_blocks)};
    };
    Jointing jointing(region, options);
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const Range range = range_along(region, sets[s].normal);
        const JointPositions positions(sets[s], mix_bits(options.seed, s));
        // Every joint that meets the region cuts at least one block when persistence is 1.
        if (positions.count_to_reach(range) > static_cast<double>(options.maximum_blocks)) {
            return too_many(s, "more joints between the origin and the far end of the region than blocks are allowed");
        }
        if (!jointing.cut(s, sets[s], positions.inside(range))) {
            return too_many(s, "cuts the region into too many blocks");
        }
    }
    return jointing.finish();
}

}  // namespace riprap::geometry
