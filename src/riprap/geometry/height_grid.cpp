// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/height_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "riprap/core/index.hpp"
#include "riprap/geometry/marks_of_nothing.hpp"
#include "riprap/geometry/text_reader.hpp"

namespace riprap::geometry {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double same = 1e-6;  ///< of an interval: coordinates closer than this are equal

[[noreturn]] void refuse_at(const std::string& file, const Word& word, std::string message, std::string allowed) {
    throw CaseError(Diagnostic{{file, word.line, word.column}, std::move(message), std::move(allowed)});
}

double number_of(const std::string& file, const Word& word, std::string_view what) {
    const auto value = parse_number(word.text);
    if (!value || !std::isfinite(*value)) {
        refuse_at(file, word, fmt::format("{} is {}", what, word.is_empty() ? "missing" : quote(word.text)),
                  "a finite number");
    }
    return *value;
}

/// The lines before the heights of an ESRI ASCII grid.
struct EsriHead {
    std::optional<double> columns, rows, x, y, dx, dy;
    double nodata{-9999};
    bool x_is_corner{true}, y_is_corner{true};

    /// True where `key` is one of the head.
    bool take(const Word& key, double value) {
        const auto is = [&key](std::string_view name) { return is_same_keyword(key.text, name); };
        if (is("ncols")) {
            columns = value;
        } else if (is("nrows")) {
            rows = value;
        } else if (is("xllcorner") || is("xllcenter")) {
            x = value;
            x_is_corner = is("xllcorner");
        } else if (is("yllcorner") || is("yllcenter")) {
            y = value;
            y_is_corner = is("yllcorner");
        } else if (is("cellsize")) {
            dx = dy = value;
        } else if (is("dx")) {
            dx = value;
        } else if (is("dy")) {
            dy = value;
        } else if (is("nodata_value")) {
            nodata = value;
        } else {
            return false;
        }
        return true;
    }
    bool is_complete() const { return columns && rows && x && y && dx && dy; }
    bool is_sound() const {
        const auto is_count = [](double n) { return n >= 2 && n == std::floor(n) && n <= 1e9; };
        return is_count(*columns) && is_count(*rows) && *dx > 0 && *dy > 0 &&
               *columns * *rows <= static_cast<double>(most_heights);
    }
};

/// The places that a list of coordinates takes on an even scale.
struct Scale {
    double first{0}, step{0};
    std::int64_t count{0};
};

Scale scale_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const double extent = values.back() - values.front();
    double step = extent;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double gap = values[i] - values[i - 1];
        step = gap > 1e-9 * extent ? std::min(step, gap) : step;
    }
    const double intervals = step > 0 ? std::round(extent / step) : 0;
    // The smallest gap carries the rounding of the file; the mean of all does not.
    return {values.front(), intervals > 0 ? extent / intervals : 0, static_cast<std::int64_t>(intervals) + 1};
}

}  // namespace

HeightGrid read_esri_ascii(std::string_view text, const std::string& file, double scale) {
    text.remove_prefix(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    TextReader reader(text);
    EsriHead head;
    Word word = reader.peek_word();
    while (!word.is_empty() && std::isalpha(static_cast<unsigned char>(word.text.front())) != 0) {
        const Word key = reader.next_word();
        if (!head.take(key, number_of(file, reader.next_word_on_line(), key.text))) {
            refuse_at(file, key, fmt::format("{} is no key of an ESRI ASCII grid", quote(key.text)),
                      "ncols, nrows, xllcorner, yllcorner, cellsize, NODATA_value");
        }
        word = reader.peek_word();
    }
    if (!head.is_complete() || !head.is_sound()) {
        refuse(file, "the head of the grid is not complete, or its numbers make no grid",
               fmt::format("ncols and nrows of at least 2 and {} points together, xllcorner, yllcorner, cellsize",
                           most_heights));
    }
    HeightGrid grid;
    grid.columns = static_cast<std::int64_t>(*head.columns);
    grid.rows = static_cast<std::int64_t>(*head.rows);
    grid.dx = scale * *head.dx;
    grid.dy = scale * *head.dy;
    grid.x0 = scale * *head.x + (head.x_is_corner ? 0.5 * grid.dx : 0);
    grid.y0 = scale * *head.y + (head.y_is_corner ? 0.5 * grid.dy : 0);
    grid.z.resize(riprap::at(grid.columns * grid.rows));
    TextReader heights = reader;
    for (std::int64_t row = grid.rows - 1; row >= 0; --row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const double z = number_of(file, reader.next_word(), "a height");
            // Programs round the mark of the head and those of the rows differently.
            const bool is_none = std::abs(z - head.nodata) <= 1e-5 * std::abs(head.nodata);
            grid.z[riprap::at(row * grid.columns + column)] = is_none ? none : scale * z;
        }
    }
    if (const Word more = reader.next_word(); !more.is_empty()) {
        refuse_at(file, more, fmt::format("more than the {} heights of the head", grid.columns * grid.rows),
                  "ncols times nrows numbers");
    }
    if (const auto mark = find_mark_of_nothing(grid.z, std::max(grid.dx, grid.dy), scale)) {
        Word found;
        for (std::int64_t row = grid.rows - 1, left = 1; row >= 0 && left > 0; --row) {
            for (std::int64_t column = 0; column < grid.columns && left > 0; ++column) {
                found = heights.next_word();
                left = riprap::at(row * grid.columns + column) == mark->index ? 0 : 1;
            }
        }
        refuse_at(file, found, mark->message, fmt::format("NODATA_value {} in the head", found.text));
    }
    return grid;
}

bool is_esri_ascii(std::string_view text) {
    text.remove_prefix(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    const std::string_view word = TextReader(text).next_word().text;
    return is_same_keyword(word, "ncols") || is_same_keyword(word, "nrows");
}

HeightGrid read_xyz(std::string_view text, const std::string& file, double scale, const TableForm* form) {
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
        constexpr double off = 1e-2;  // of an interval
        if (std::abs(column - std::round(column)) > off || std::abs(row - std::round(row)) > off) {
            throw CaseError(Diagnostic{table.place(i, 0),
                                       fmt::format("point {} at ({:.9g}, {:.9g}) is off the grid of {:.6g} by {:.6g} m",
                                                   i + 1, along[0][i], along[1][i], x.step, y.step),
                                       "points of a rectangular grid, along x and y"});
        }
        const std::size_t n = riprap::at(std::llround(row) * x.count + std::llround(column));
        const double z = scale * table.at(i, 2);
        if (row_of[n] < count && z != grid.z[n]) {
            throw CaseError(
                Diagnostic{table.place(i, 2),
                           fmt::format("the height of ({:.9g}, {:.9g}) is {:.6g} m here and {:.6g} m in line {}",
                                       along[0][i], along[1][i], z, grid.z[n], table.lines[row_of[n]]),
                           "one height at each place"});
        }
        grid.z[n] = z;
        row_of[n] = i;
    }
    if (const auto mark = find_mark_of_nothing(grid.z, std::max(grid.dx, grid.dy), scale)) {
        throw CaseError(Diagnostic{table.place(row_of[mark->index], 2), mark->message,
                                   "leave out the lines of points without height"});
    }
    return grid;
}

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
