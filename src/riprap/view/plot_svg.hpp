// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace riprap::view {

/// Colours that curves get in turn.
constexpr std::size_t color_count = 8;

/// Style of a curve: theory as a line, ours as markers on it; `points` draws every point, for scenes.
enum class CurveStyle { line, dashed, markers, points };

/// y over x, both in the unit of its axis. Points that are not finite break the line.
struct Curve {
    std::string label;
    std::vector<double> x, y;
    CurveStyle style{CurveStyle::line};
    int color{-1};  ///< index into the palette; -1 = next. Theory and ours of one set-up share a colour
};

struct Axis {
    std::string label;  ///< with unit: "time [s]"
    bool is_log{false};
};

/// A line chart. What the paper shows as a figure.
struct Plot {
    std::string title;
    std::string subtitle;  ///< verdict and source in words, under the title
    Axis x, y;
    std::vector<Curve> curves;
    double width{820}, height{500};  ///< of the drawing [px of 1/96 inch]; it grows where titles or names need more
    bool has_equal_scales{false};    ///< a metre is as long along x as along y: for drawings of a scene
};

/// The chart as one self-contained SVG document. Markers of dense curves are thinned to about 30.
std::string to_svg(const Plot& plot);

/// Writes it, making the folder where needed. @throws FileError
void write_svg(const std::filesystem::path& path, const Plot& plot);

/// Values at which an axis from low to high is marked: about `count` round numbers (1, 2 or 5 times a power of ten).
std::vector<double> axis_ticks(double low, double high, int count);

}  // namespace riprap::view
