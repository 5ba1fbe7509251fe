// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/contact/broadphase/broadphase.hpp"
#include "riprap/contact/broadphase/giants.hpp"

namespace riprap::contact {

/// Candidate pairs kept over many steps. They are found with a skin s, so that a pair left out is at least s away;
/// while the two largest displacements since then add up to at most s, no such pair can have come to touch, and the
/// list is complete (docs/theory/broadphase.md). Giants that move or turn count with the distance by which their
/// planes can have come closer to any part.
///
/// The list is Scratch: it holds every touching pair at every step and is always sorted, so a consumer that acts on
/// touching pairs only gets the same bits whenever the list was last rebuilt.
class PairCache {
 public:
    struct Settings {
        double skin{0};         ///< s >= 0 [m]
        double grid_factor{2};  ///< gamma > 1 of MultilevelGrid [-]
    };

    /// Makes the pairs complete for the parts as they are now; searches anew only where it must.
    /// Giants are the same parts in the same order from call to call, or the search is done anew.
    /// @returns true when the search was done anew
    bool update(const PartBounds& bounds, std::span<const Giant> giants, const Settings& settings);

    /// True when a touching pair could be missing: parts have moved too far, or parts, radii, mobility, giants or
    /// settings are no longer those of the last search.
    bool needs_rebuild(const PartBounds& bounds, std::span<const Giant> giants, const Settings& settings);

    /// Candidates a < b, sorted by (a, b).
    std::span<const PartPair> pairs() const { return pairs_; }

    /// Numbers of the pairs that `part` belongs to, increasing: the fixed order in which its loads are added.
    std::span<const std::int32_t> pairs_of(std::int32_t part) const {
        const auto p = static_cast<std::size_t>(part);
        return std::span(incident_).subspan(incident_begin_[p], incident_begin_[p + 1] - incident_begin_[p]);
    }
    /// Numbers of the pairs of parts [first, last), as one list: part by part. A body's parts are neighbours.
    std::span<const std::int32_t> pairs_of(std::int32_t first, std::int32_t last) const {
        const std::size_t begin = incident_begin_[static_cast<std::size_t>(first)];
        return std::span(incident_).subspan(begin, incident_begin_[static_cast<std::size_t>(last)] - begin);
    }

    std::int64_t rebuild_count() const { return rebuild_count_; }  ///< searches so far
    std::size_t bytes() const;                                     ///< memory held

 private:
    bool is_same_scene(const PartBounds& bounds, std::span<const Giant> giants, const Settings& settings) const;
    bool have_parts_moved_too_far(const PartBounds& bounds, std::span<const Giant> giants);
    void remember(const PartBounds& bounds, std::span<const Giant> giants, const Settings& settings);
    void link_parts_to_pairs(std::int32_t part_count);

    std::vector<PartPair> pairs_;
    std::vector<std::uint32_t> incident_begin_{0};  ///< part count + 1 entries into incident_
    std::vector<std::int32_t> incident_;

    // The scene of the last search.
    std::uint64_t scene_{0};
    Settings settings_;
    std::vector<Vec3> center_;
    std::vector<double> radius_;
    std::vector<std::int32_t> body_;
    std::vector<std::uint8_t> is_mobile_;
    GiantPlanes planes_;
    std::vector<double> largest_guest_;   ///< per giant: radius of the largest finite part it may meet [m]
    std::vector<std::uint8_t> is_giant_;  ///< per part
    std::int64_t rebuild_count_{0};

    GiantPlanes planes_now_;  ///< buffer
};

/// Median of the finite radii [m], the length that a default skin is a fraction of; 0 without any.
double median_radius(std::span<const double> radius);

}  // namespace riprap::contact
