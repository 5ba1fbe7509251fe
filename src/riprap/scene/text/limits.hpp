// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

/// Limits of a case. Counts are checked before anything is allocated; the message names the limit.
namespace riprap::scene::limits {

inline constexpr std::size_t case_bytes = 4U << 20U;       ///< size of a case file
inline constexpr std::size_t table_bytes = 64U << 20U;     ///< size of a motion table or point list
inline constexpr std::size_t surface_bytes = 512U << 20U;  ///< size of an STL or OBJ file
inline constexpr int nesting = 32;                         ///< brackets within brackets
inline constexpr int key_segments = 16;                    ///< dots in one key
inline constexpr std::size_t values = 500'000;             ///< values in a case file
inline constexpr std::size_t text_bytes = 4096;            ///< of one text value
inline constexpr std::int64_t materials = 1000;            ///< their pairs are tabulated
inline constexpr std::int64_t bodies = 2'000'000;          ///< in a scene
inline constexpr std::int64_t parts = 4'000'000;           ///< convex parts in a scene
inline constexpr std::int64_t shape_vertices = 4096;       ///< of one convex shape given in the case
inline constexpr std::int64_t surface_faces = 2'000'000;   ///< of an STL or OBJ file
inline constexpr std::int64_t ground_cells = 500'000;      ///< triangles of one ground
inline constexpr std::int64_t union_parts = 4096;          ///< of one body
inline constexpr std::int64_t cells = 200'000;             ///< of one Voronoi pack
inline constexpr std::int64_t rock_blocks = 200'000;       ///< of one jointed rock mass
inline constexpr std::int64_t particles = 50'000'000;      ///< of a fluid, and as many again in its walls
inline constexpr std::int64_t fluid_regions = 64;          ///< of water at the start
inline constexpr std::int64_t table_rows = 1'000'000;      ///< of a motion table
inline constexpr std::int64_t loads = 2'000'000;           ///< point loads in a scene
inline constexpr std::size_t problems = 100;               ///< reported in one run

}  // namespace riprap::scene::limits
