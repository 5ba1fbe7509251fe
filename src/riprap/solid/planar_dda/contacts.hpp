// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/solid/planar_dda/submatrices.hpp"

namespace riprap::solid::planar_dda {

/// A corner near an edge, for one step. `a` is the corner's block, `b` the edge's.
struct Contact {
    std::int32_t corner{-1}, edge{-1}, a{-1}, b{-1};
    Mode mode{Mode::open};
    bool is_bonded{false};
    bool is_round{false};     ///< of a disc; see round_touch.hpp
    double lock{0};           ///< see State::contact_lock [-]
    double multiplier{0};     ///< [N]
    double plastic_slip{0};   ///< see State::contact_plastic_slip [m]
    double bond_length{0};    ///< half of the length along which two faces overlap; 0 for a corner alone [m]
    double bond_slip{0};      ///< slip or gap by which the bond is lost; see affine/bonds.hpp [m]
    double edge_length{0};    ///< [m]
    double foot{0};           ///< of the corner along the edge, 0 to 1 [-]
    double share{1};          ///< of the joint's springs: 1/2 where the edge's corner bears the other half [-]
    double dashpot{0};        ///< [N s/m]
    affine::Surface joint{};  ///< springs times the share
    Vec2 place{};             ///< where it is shown [m]
    Linear gap{}, slip{};     ///< at the start of the step and what changes them
};

/// Places the corners of all blocks [m].
void place_corners(const Model& model, const State& state, std::vector<Vec2>& corners);

/// Buffers of the search.
struct ContactSearch {
    struct Box {
        double left, right, low, high;
    };
    std::vector<Box> boxes;
    std::vector<std::int32_t> order;
    std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
    std::vector<std::uint64_t> wanted, vetoed;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> twins;  ///< contacts that share a pair of corners, both orders
};

/// Pairs of blocks whose bounding boxes come closer than `reach` [m], at least one of them not fixed; a < b, sorted.
void find_pairs(const Model& model, const std::vector<Vec2>& corners, double reach, ContactSearch& search);

/// Finds every corner that may touch an edge within the step, sorted by corner and edge, with what the state remembers
/// of it. A corner meets an edge when its foot lies on the edge, the gap is within the reach of the search and the
/// corner's two edges lean into the edge's material by no more than the tolerance. Where two convex corners v and w are
/// near, the bodies overlap when v - w lies in the sum of the cone at w and the mirrored cone at v, whose two bounding
/// lines run along edges: the line with the larger gap is the entrance [Shi1988], and no other edge at v and w takes
/// part. Where the two lines are nearly one and either corner stands on the other's edge, both are entrances with half
/// of the springs each, so that neither block is preferred. Concave corners touch nothing by themselves. Contacts of
/// discs are those of round_touch.hpp.
/// @param dt  of the step, 0 = of none [s]
void find_contacts(const Model& model, const State& state, const Settings& settings, const std::vector<Vec2>& corners,
                   ContactSearch& search, std::vector<Contact>& contacts, double dt = 0);

}  // namespace riprap::solid::planar_dda
