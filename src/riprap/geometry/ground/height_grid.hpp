// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/geometry/surface/triangle_mesh.hpp"
#include "riprap/geometry/text/number_table.hpp"

namespace riprap::geometry {

/// Heights on a rectangular grid of points, the first in the south-west, x (east) fastest. NaN where there is none.
struct HeightGrid {
    std::int64_t columns{0}, rows{0};
    double x0{0}, y0{0};               ///< of the first point [m]
    double dx{0}, dy{0};               ///< between points [m]
    std::vector<double> z;             ///< [m]
    std::vector<std::string> notes{};  ///< what the reader found that the user may not expect

    double at(std::int64_t column, std::int64_t row) const {
        return z[static_cast<std::size_t>(row * columns + column)];
    }
    double x_end() const { return x0 + dx * static_cast<double>(columns - 1); }
    double y_end() const { return y0 + dy * static_cast<double>(rows - 1); }
    /// Bilinear between the four points around (x, y); NaN outside, and where one of those points has no height.
    double height(double x, double y) const;
};

/// Points that a grid may have.
inline constexpr std::int64_t most_heights = 4'000'000;

/// Holds what a case says of heights that stand for none.
struct NoHeight {
    std::optional<double> mark{};  ///< this number of the file
    bool is_certain{false};        ///< there is no other: no height is suspected
};

/// True for the number of a mark; programs round it differently in heads and rows.
bool is_same_mark(double value, double mark);

/// Reads an ESRI ASCII grid: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx, dy),
/// optionally NODATA_value, then the rows from north to south. Heights are those of the middles of cells. Lines that
/// end elsewhere than rows do are refused.
/// @param scale  metres per unit of the file, of all three coordinates [m]
/// @throws CaseError with file:line:column, also for heights that are a mark for none (marks_of_nothing.hpp)
HeightGrid read_esri_ascii(std::string_view text, const std::string& file, double scale,
                           const NoHeight& no_height = {});

/// Tells whether a text begins as an ESRI ASCII grid does.
bool is_esri_ascii(std::string_view text);

/// Reads x, y, z per line (number_table.hpp) of the points of a rectangular grid in any order; points of the rectangle
/// that are not listed have no height. Columns beyond the third are passed over. Places that no point at all has along
/// x or y are refused: intervals that differ.
/// @param form  of the columns, as table_of_places() gives it; null for that
/// @throws CaseError with file:line:column, also for two heights at one place and for marks of none
HeightGrid read_xyz(std::string_view text, const std::string& file, double scale, const TableForm* form = nullptr,
                    const NoHeight& no_height = {});

/// A rectangle of the plane [m].
struct Rectangle {
    double x_low{-std::numeric_limits<double>::infinity()}, y_low{-std::numeric_limits<double>::infinity()};
    double x_high{std::numeric_limits<double>::infinity()}, y_high{std::numeric_limits<double>::infinity()};
};

/// The part of a grid in `region`, its edges on the rectangle where that lies within the grid, and its points about
/// `resolution` apart where that is above zero (a whole number of intervals each way), with bilinear heights.
HeightGrid cut_grid(const HeightGrid& grid, const Rectangle& region, double resolution);

/// Two triangles per cell of four heights, the shorter diagonal between them; one where one height is missing.
/// Points are counted from `origin` [m].
TriangleMesh mesh_of(const HeightGrid& grid, const Vec3& origin);

}  // namespace riprap::geometry
