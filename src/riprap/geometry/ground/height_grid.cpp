// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/ground/height_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "riprap/core/index.hpp"
#include "riprap/geometry/text/marks_of_nothing.hpp"
#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double same = 1e-6;  ///< of an interval: coordinates closer than this are equal
constexpr double off = 1e-2;   ///< of an interval: points this far off their place in a grid are taken to be there

/// The places that a list of coordinates takes on an even scale.
struct Scale {
    double first{0}, step{0};
    std::int64_t count{0};
};

Scale scale_of(std::vector<double> values) {
    // Twice what a point may be off its place, of the widest interval: coordinates nearer than this are one.
    constexpr double scatter = 2 * off;
    std::sort(values.begin(), values.end());
    const double extent = values.back() - values.front();
    double widest = 0, step = extent, begin = values.front();
    for (std::size_t i = 1; i < values.size(); ++i) {
        widest = std::max(widest, values[i] - values[i - 1]);
    }
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (values[i] - values[i - 1] > scatter * widest) {
            step = std::min(step, values[i] - begin);
            begin = values[i];
        }
    }
    const double intervals = step > 0 ? std::round(extent / step) : 0;
    // The smallest interval carries the rounding of the file; the mean of all does not.
    return {values.front(), intervals > 0 ? extent / intervals : 0, static_cast<std::int64_t>(intervals) + 1};
}

/// Refuses a scale with places that no point has: intervals that differ, of which the wide ones would be holes.
void check_evenness(const Scale& scale, const std::vector<double>& values, const NumberTable& table, std::size_t axis) {
    std::vector<char> is_taken(riprap::at(scale.count), 0);
    for (const double value : values) {
        is_taken[riprap::at(std::llround((value - scale.first) / scale.step))] = 1;
    }
    const auto free = std::find(is_taken.begin(), is_taken.end(), 0);
    if (free == is_taken.end()) {
        return;
    }
    const double after = scale.first + static_cast<double>(free - is_taken.begin() - 1) * scale.step;
    const auto next = std::find(free, is_taken.end(), 1);
    const double until = scale.first + static_cast<double>(next - is_taken.begin()) * scale.step;
    std::size_t row = 0;
    while (std::abs(values[row] - until) > 0.5 * scale.step) {
        ++row;
    }
    const char name = axis == 0 ? 'x' : 'y';
    throw CaseError(Diagnostic{
        table.place(row, axis),
        fmt::format("no point between {} = {:.9g} and {:.9g} m, where others are {:.6g} m apart", name, after, until,
                    scale.step),
        "even intervals along x and along y: heights interpolated to such a grid, or the points without height in it "
        "listed with a number that 'nodata' names"});
}

}  // namespace

HeightGrid read_xyz(std::string_view text, const std::string& file, double scale, const TableForm* form,
                    const NoHeight& no_height) {
    TableForm places = form != nullptr ? *form : table_of_places(most_heights);
    places.may_have_more = true;
    const NumberTable table = read_number_table(text, file, places);
    const std::size_t count = table.row_count();
    if (count < 4) {
        refuse(file, fmt::format("{} points", count), "at least 4, of a rectangular grid");
    }
    std::array<std::vector<double>, 2> along;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            along[axis].push_back(scale * table.at(i, axis));
        }
    }
    const Scale x = scale_of(along[0]), y = scale_of(along[1]);
    if (x.count < 2 || y.count < 2 || x.count * y.count > most_heights) {
        refuse(file, fmt::format("{} points span {} by {} places", count, x.count, y.count),
               "points of a rectangular grid, along x and y");
    }
    HeightGrid grid{x.count, y.count, x.first, y.first, x.step, y.step, {}, table.notes};
    grid.z.assign(riprap::at(x.count * y.count), none);
    std::vector<std::size_t> row_of(grid.z.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
        const double column = (along[0][i] - x.first) / x.step, row = (along[1][i] - y.first) / y.step;
        if (std::abs(column - std::round(column)) > off || std::abs(row - std::round(row)) > off) {
            throw CaseError(Diagnostic{table.place(i, 0),
                                       fmt::format("point {} at ({:.9g}, {:.9g}) is off the grid of {:.6g} by {:.6g} m",
                                                   i + 1, along[0][i], along[1][i], x.step, y.step),
                                       "points of a rectangular grid, along x and y"});
        }
        const std::size_t n = riprap::at(std::llround(row) * x.count + std::llround(column));
        const bool is_none = no_height.mark && is_same_mark(table.at(i, 2), *no_height.mark);
        const double z = is_none ? none : scale * table.at(i, 2);
        if (row_of[n] < count && z != grid.z[n] && !(is_none && std::isnan(grid.z[n]))) {
            throw CaseError(
                Diagnostic{table.place(i, 2),
                           fmt::format("the height of ({:.9g}, {:.9g}) is {:.6g} m here and {:.6g} m in line {}",
                                       along[0][i], along[1][i], z, grid.z[n], table.lines[row_of[n]]),
                           "one height at each place"});
        }
        grid.z[n] = z;
        row_of[n] = i;
    }
    check_evenness(x, along[0], table, 0);
    check_evenness(y, along[1], table, 1);
    const auto mark = no_height.is_certain
                          ? std::nullopt
                          : find_mark_of_nothing(grid.z, grid.columns, std::max(grid.dx, grid.dy), scale);
    if (mark) {
        throw CaseError(Diagnostic{
            table.place(row_of[mark->index], 2), mark->message,
            fmt::format("leave out the lines of points without height, or nodata = {:.9g}; nodata = \"none\" where it "
                        "is a height",
                        table.at(row_of[mark->index], 2))});
    }
    return grid;
}

bool is_same_mark(double value, double mark) { return std::abs(value - mark) <= 1e-5 * std::abs(mark); }

double HeightGrid::height(double x, double y) const {
    const double u = (x - x0) / dx, v = (y - y0) / dy;
    if (!(u >= -same && v >= -same && u <= static_cast<double>(columns - 1) + same &&
          v <= static_cast<double>(rows - 1) + same)) {
        return none;
    }
    const std::int64_t i = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(u)), 0, columns - 2);
    const std::int64_t j = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(v)), 0, rows - 2);
    const double s = std::clamp(u - static_cast<double>(i), 0.0, 1.0),
                 t = std::clamp(v - static_cast<double>(j), 0.0, 1.0);
    // On a line of the grid, to round-off, the points beside it do not count, be they missing.
    const auto part = [](double share, double value) {
        return share <= same && !std::isfinite(value) ? 0 : share * value;
    };
    return part((1 - s) * (1 - t), at(i, j)) + part(s * (1 - t), at(i + 1, j)) + part((1 - s) * t, at(i, j + 1)) +
           part(s * t, at(i + 1, j + 1));
}

HeightGrid cut_grid(const HeightGrid& grid, const Rectangle& region, double resolution) {
    HeightGrid cut = grid;
    cut.x0 = std::max(grid.x0, region.x_low);
    cut.y0 = std::max(grid.y0, region.y_low);
    const double width = std::min(grid.x_end(), region.x_high) - cut.x0;
    const double depth = std::min(grid.y_end(), region.y_high) - cut.y0;
    if (!(width > 0 && depth > 0)) {
        return {};
    }
    const auto intervals = [](double length, double step) {
        return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(length / step - same)));
    };
    cut.columns = intervals(width, resolution > 0 ? resolution : grid.dx) + 1;
    cut.rows = intervals(depth, resolution > 0 ? resolution : grid.dy) + 1;
    if (cut.columns * cut.rows > most_heights) {
        return {};
    }
    cut.dx = width / static_cast<double>(cut.columns - 1);
    cut.dy = depth / static_cast<double>(cut.rows - 1);
    cut.z.assign(riprap::at(cut.columns * cut.rows), none);
    for (std::int64_t j = 0; j < cut.rows; ++j) {
        for (std::int64_t i = 0; i < cut.columns; ++i) {
            cut.z[riprap::at(j * cut.columns + i)] =
                grid.height(cut.x0 + static_cast<double>(i) * cut.dx, cut.y0 + static_cast<double>(j) * cut.dy);
        }
    }
    return cut;
}

TriangleMesh mesh_of(const HeightGrid& grid, const Vec3& origin) {
    TriangleMesh mesh;
    std::vector<std::int32_t> number(grid.z.size(), -1);
    for (std::int64_t j = 0; j < grid.rows; ++j) {
        for (std::int64_t i = 0; i < grid.columns; ++i) {
            if (std::isfinite(grid.at(i, j))) {
                number[riprap::at(j * grid.columns + i)] = static_cast<std::int32_t>(mesh.points.size());
                mesh.points.push_back(Vec3{grid.x0 + static_cast<double>(i) * grid.dx,
                                           grid.y0 + static_cast<double>(j) * grid.dy, grid.at(i, j)} -
                                      origin);
            }
        }
    }
    const auto add = [&mesh](std::int32_t a, std::int32_t b, std::int32_t c) {
        if (a >= 0 && b >= 0 && c >= 0) {
            mesh.corners.push_back({a, b, c});
        }
    };
    for (std::int64_t j = 0; j + 1 < grid.rows; ++j) {
        for (std::int64_t i = 0; i + 1 < grid.columns; ++i) {
            const auto point = [&](std::int64_t di, std::int64_t dj) {
                return number[riprap::at((j + dj) * grid.columns + i + di)];
            };
            const std::int32_t a = point(0, 0), b = point(1, 0), c = point(1, 1), d = point(0, 1);
            const auto length = [&mesh](std::int32_t p, std::int32_t q) {
                return norm_squared(mesh.points[riprap::at(q)] - mesh.points[riprap::at(p)]);
            };
            const bool has_ac = a >= 0 && c >= 0, has_bd = b >= 0 && d >= 0;
            if (has_ac && (!has_bd || length(a, c) <= length(b, d))) {
                add(a, b, c);
                add(a, c, d);
            } else {
                add(a, b, d);
                add(b, c, d);
            }
        }
    }
    return mesh;
}

}  // namespace riprap::geometry
