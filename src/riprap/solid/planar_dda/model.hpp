// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "riprap/body/supports.hpp"
#include "riprap/solid/affine/surface.hpp"
#include "riprap/solid/planar_dda/settings.hpp"
#include "riprap/solid/planar_dda/unknowns.hpp"

namespace riprap::solid::planar_dda {

/// Blocks one metre thick and what holds them; constant during a run. Corners of all blocks lie in one list; corner k
/// and edge k (from corner k to the next one of its block) bear the same number, which names them in contacts.
struct Model {
    affine::Elasticity elasticity;  ///< of all blocks
    affine::Surfaces surfaces;
    PlaneState plane{PlaneState::stress};

    std::vector<std::int32_t> corner_begin{0};  ///< per block, and the end
    std::vector<Vec2> corner;                   ///< offset from the centroid, reference shape [m]
    std::vector<std::int32_t> corner_block, corner_next, corner_before;
    std::vector<std::uint8_t> is_convex;                  ///< per corner
    std::vector<std::int32_t> material;                   ///< per block
    std::vector<std::uint8_t> is_fixed;                   ///< per block: moves as told, not by forces
    std::vector<double> mass;                             ///< [kg]
    std::vector<double> area;                             ///< of the reference shape [m^2]
    std::vector<double> moment_xx, moment_yy, moment_xy;  ///< second moments over the area, reference shape [m^2]
    std::vector<double> width;  ///< twice the area over the perimeter: half the side of a square, about the thickness
                                ///< of a slab [m]

    std::vector<double> round_radius;  ///< per block: of the disc whose outline has its area; 0 = of none [m]

    std::vector<Vec2> offset;        ///< of the centroid from the origin of the body, body frame [m]
    std::vector<std::string> names;  ///< of blocks, for messages

    std::vector<body::FixedPoint> fixed_points;  ///< each with a stiffness; points of blocks count from centroids, as
                                                 ///< those of bolts [m]
    std::vector<body::Bolt> bolts;

    std::int32_t block_count() const { return static_cast<std::int32_t>(material.size()); }
    const affine::Surface& joint(std::int32_t block_a, std::int32_t block_b) const {
        return surfaces.of(material[static_cast<std::size_t>(block_a)], material[static_cast<std::size_t>(block_b)]);
    }
    const std::string& name_of(std::int32_t block) const { return names[static_cast<std::size_t>(block)]; }
};

}  // namespace riprap::solid::planar_dda
