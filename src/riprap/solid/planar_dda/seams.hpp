// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/contact_scene.hpp"

// Seams: places where the face that a corner stands on is continued by a face of the next block. Two blocks alone
// cannot tell what is hidden there: the corner is in by the overlap of its own spring, so the side of the next block
// has the larger gap and would be the entrance, although the block that the corner stands on covers it.

namespace riprap::solid::planar_dda {

/// A step up to this share of the narrower block's breadth 2 A/P is no step [-].
constexpr double step_share = 5e-4;
/// Nor is one up to twice the overlap of the corner, as far as that is up to this share [-].
constexpr double soft_step_share = 1e-2;
/// A joint up to this share wide is closed: what lies beyond continues the face [-].
constexpr double joint_share = 2.5e-2;

/// Answers which of two entrances at an angle third blocks leave open.
class Seams {
 public:
    Seams(const Scene& scene, const ContactSearch& search);

    struct Answer {
        enum class Kind {
            none,   ///< no seam
            clear,  ///< the other entrance is hidden
            weak    ///< the other entrance is hidden unless it is closed already: both would be hidden, by what either
                    ///< block stands on, or the corner hangs over a joint
        };
        Kind kind{Kind::none};
        bool is_first{false};
    };
    /// Asks of the convex corners v and w: where v's block stands on a third one whose face is continued at w, the
    /// entrance along that face is open and the other one is hidden; likewise with v and w changed.
    Answer open_entrance(std::int32_t v, std::int32_t w, const Key& first, const Key& second) const;

 private:
    /// A third block on which `stander` stands, and which the block of `other` continues.
    struct Seam {
        bool is_there{false}, is_closed{false}, hangs{false};
        Vec2 normal{};         ///< of the face stood on, outward [-]
        std::int32_t top{-1};  ///< edge at `other` that continues it
        double past{0};        ///< of `stander` beyond the end of that face [m]
        double step{0};        ///< of `other` above that face [m]
        double tolerance{0};   ///< of the step [m]
        bool carries_rather_than(const Seam& other) const;
    };
    /// What carries a corner that hangs beyond the end of a face: the end, under an edge of the corner's block.
    struct Bridge {
        bool is_there{false}, is_closed{false};
        double overlap{0};  ///< there [m]
    };
    Bridge bridge_over(std::int32_t stander, std::int32_t face, bool is_at_end) const;
    Seam find(std::int32_t stander, std::int32_t other) const;
    void look_at(std::int32_t third, std::int32_t stander, std::int32_t other, Seam& seam) const;
    bool leads_along(const Seam& seam, std::int32_t stander, const Key& first, const Key& second) const;
    Vec2 outward(std::int32_t edge) const;
    bool may_stand(std::int32_t corner, std::int32_t edge) const;
    void find_give();
    bool is_near(std::int32_t corner, std::int32_t block) const;

    const Scene* scene_;
    const ContactSearch* search_;
    std::vector<std::int32_t> begin_, neighbour_;
    std::vector<double> give_;  ///< largest overlap of every block at the end of the last step [m]
};

}  // namespace riprap::solid::planar_dda
