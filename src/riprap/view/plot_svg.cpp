// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/plot_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "riprap/io/atomic_file.hpp"

namespace riprap::view {

namespace {

// Margins of the drawing [px]; the legend stands on the right, so its margin goes by the names of the curves.
constexpr double left = 84, top = 62, bottom = 58, least_right = 24;
constexpr double least_across = 120;  // of the area with the curves; a drawing that has less is made wider
// The colours of Okabe and Ito, as the curves of pages have them (page/src/colours.js).
constexpr std::array<const char*, color_count> palette{"#0072b2", "#e69f00", "#009e73", "#d55e00",
                                                       "#cc79a7", "#56b4e9", "#b3a125", "#888888"};

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '&':
                out += "&amp;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

/// Characters of a text in UTF-8.
double length_of(const std::string& text) {
    return static_cast<double>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Room for the names of the curves, in full: letters of 13 px are some 8 px wide.
double right_of(const Plot& plot) {
    double right = least_right;
    for (const Curve& curve : plot.curves) {
        right = curve.label.empty() ? right : std::max(right, 47 + 8.2 * length_of(curve.label) + 8);
    }
    return right;
}

/// Right and lower edge of the area with the curves [px].
double end_of_x(const Plot& plot) { return std::max(plot.width - right_of(plot), left + least_across); }
double end_of_y(const Plot& plot) { return std::max(plot.height - bottom, top + least_across); }

/// Maps values of one axis onto pixels.
struct Scale {
    double low, high;  ///< in the axis' unit, or its decimal logarithm
    double from, to;   ///< [px]
    bool is_log;
    double value(double v) const { return is_log ? std::log10(v) : v; }
    double pixel(double v) const { return from + (value(v) - low) / (high - low) * (to - from); }
};

struct Extent {
    double low{std::numeric_limits<double>::infinity()};
    double high{-std::numeric_limits<double>::infinity()};
    void take(double v) {
        if (std::isfinite(v)) {
            low = std::min(low, v);
            high = std::max(high, v);
        }
    }
    void widen(double share) {
        if (!(low <= high)) {
            low = 0;
            high = 1;
        }
        const double span = high > low ? high - low : std::max(std::abs(high), 1e-12);
        low -= share * span;
        high += share * span;
    }
};

Scale make_scale(const Plot& plot, bool is_x) {
    const Axis& axis = is_x ? plot.x : plot.y;
    Extent extent;
    for (const Curve& curve : plot.curves) {
        for (const double v : is_x ? curve.x : curve.y) {
            extent.take(axis.is_log ? (v > 0 ? std::log10(v) : std::nan("")) : v);
        }
    }
    extent.widen(is_x && !axis.is_log ? 0.01 : 0.05);
    return is_x ? Scale{extent.low, extent.high, left, end_of_x(plot), axis.is_log}
                : Scale{extent.low, extent.high, end_of_y(plot), top, axis.is_log};
}

/// Stretches the axis that has room to spare about its middle, until both have the same pixels per unit.
void make_equal(Scale& x, Scale& y) {
    const double density_x = (x.to - x.from) / (x.high - x.low), density_y = (y.from - y.to) / (y.high - y.low);
    Scale& wide = density_x > density_y ? x : y;
    const double factor = std::max(density_x, density_y) / std::min(density_x, density_y);
    const double middle = 0.5 * (wide.low + wide.high), half = 0.5 * factor * (wide.high - wide.low);
    wide.low = middle - half;
    wide.high = middle + half;
}

std::vector<double> ticks_of(const Scale& scale, int count) {
    if (!scale.is_log) {
        return axis_ticks(scale.low, scale.high, count);
    }
    std::vector<double> ticks;
    for (double power = std::ceil(scale.low); power <= scale.high; power += 1) {
        ticks.push_back(std::pow(10.0, power));
    }
    return ticks;
}

void draw_axes(const Plot& plot, const Scale& x, const Scale& y, std::string& out) {
    const double width = end_of_x(plot), height = end_of_y(plot);
    constexpr double apart = 70;  // [px] between two numbers of an axis
    for (const double v : ticks_of(x, std::min(8, static_cast<int>((width - left) / apart)))) {
        const double p = x.pixel(v);
        out += fmt::format("<line class='grid' x1='{0:.1f}' y1='{1}' x2='{0:.1f}' y2='{2}'/>\n", p, top, height);
        out += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>{:.6g}</text>\n", p, height + 18, v);
    }
    for (const double v : ticks_of(y, std::min(7, static_cast<int>((height - top) / (0.5 * apart))))) {
        const double p = y.pixel(v);
        out += fmt::format("<line class='grid' x1='{1}' y1='{0:.1f}' x2='{2}' y2='{0:.1f}'/>\n", p, left, width);
        out += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>{:.6g}</text>\n", left - 8, p + 4, v);
    }
    out += fmt::format("<rect class='frame' x='{}' y='{}' width='{}' height='{}'/>\n", left, top, width - left,
                       height - top);
    out += fmt::format("<text x='{}' y='{}' text-anchor='middle'>{}</text>\n", 0.5 * (left + width),
                       height + bottom - 16, escaped(plot.x.label));
    out += fmt::format("<text transform='translate(20 {}) rotate(-90)' text-anchor='middle'>{}</text>\n",
                       0.5 * (top + height), escaped(plot.y.label));
}

/// Points closer than this to the last one drawn are left out: a run has many more steps than a plot has pixels [px].
constexpr double smallest_move = 0.4;

std::string path_of(const Curve& curve, const Scale& x, const Scale& y) {
    std::string path;
    bool is_down = false;
    double last_x = 0, last_y = 0;
    const std::size_t count = std::min(curve.x.size(), curve.y.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double px = x.pixel(curve.x[i]), py = y.pixel(curve.y[i]);
        if (!std::isfinite(px) || !std::isfinite(py)) {
            is_down = false;
            continue;
        }
        if (is_down && i + 1 < count && std::hypot(px - last_x, py - last_y) < smallest_move) {
            continue;
        }
        path += fmt::format("{}{:.2f} {:.2f}", is_down ? "L" : "M", px, py);
        is_down = true;
        last_x = px;
        last_y = py;
    }
    return path;
}

void draw_curve(const Curve& curve, const char* color, const Scale& x, const Scale& y, std::string& out) {
    const bool has_points = curve.style == CurveStyle::points;
    if (curve.style != CurveStyle::markers && !has_points) {
        out += fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.8'{}/>\n", path_of(curve, x, y), color,
                           curve.style == CurveStyle::dashed ? " stroke-dasharray='6 4'" : "");
        return;
    }
    const std::size_t count = std::min(curve.x.size(), curve.y.size());
    const std::size_t stride = has_points ? 1 : std::max<std::size_t>(1, count / 30);
    for (std::size_t i = 0; i < count; i += stride) {
        const double px = x.pixel(curve.x[i]), py = y.pixel(curve.y[i]);
        if (std::isfinite(px) && std::isfinite(py)) {
            out += fmt::format(
                "<circle cx='{:.2f}' cy='{:.2f}' r='{:.1f}' fill='#ffffff' stroke='{}' stroke-width='1.6'/>\n", px, py,
                has_points ? 2.4 : 3.6, color);
        }
    }
}

void draw_legend(const Curve& curve, const char* color, double from, std::size_t line, std::string& out) {
    const double x = from + 16, y = top + 12 + 20 * static_cast<double>(line);
    if (curve.style == CurveStyle::markers || curve.style == CurveStyle::points) {
        out += fmt::format("<circle cx='{}' cy='{}' r='3.6' fill='#ffffff' stroke='{}' stroke-width='1.6'/>\n", x + 12,
                           y, color);
    } else {
        out += fmt::format("<line x1='{}' y1='{}' x2='{}' y2='{}' stroke='{}' stroke-width='1.8'{}/>\n", x, y, x + 24,
                           y, color, curve.style == CurveStyle::dashed ? " stroke-dasharray='6 4'" : "");
    }
    out += fmt::format("<text x='{}' y='{}'>{}</text>\n", x + 31, y + 4, escaped(curve.label));
}

struct Size {
    double width, height;
};

/// Size of the whole: letters of the title are some 10 px wide.
Size size_of(const Plot& plot) {
    Size size{std::max({end_of_x(plot) + right_of(plot), left + 10 * length_of(plot.title),
                        left + 8 * length_of(plot.subtitle)}),
              end_of_y(plot) + bottom};
    double lines = 0;
    for (const Curve& curve : plot.curves) {
        if (!curve.label.empty()) {
            lines += 1;
        }
    }
    size.height = std::max(size.height, top + 20 * lines + 16);
    return size;
}

}  // namespace

std::vector<double> axis_ticks(double low, double high, int count) {
    const double raw = (high - low) / std::max(count, 1);
    if (!(raw > 0) || !std::isfinite(raw)) {
        return {low};
    }
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    const double share = raw / power;
    const double step = power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
    std::vector<double> ticks;
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) {
        ticks.push_back(k * step + 0.0);  // no -0
    }
    return ticks;
}

std::string to_svg(const Plot& plot) {
    Scale x = make_scale(plot, true), y = make_scale(plot, false);
    if (plot.has_equal_scales) {
        make_equal(x, y);
    }
    const Size size = size_of(plot);
    std::string out = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}'>\n"
        "<style>text {{ font: 13px sans-serif; fill: #222222; }} .title {{ font-size: 16px; font-weight: bold; }}\n"
        ".subtitle {{ fill: #555555; }} .grid {{ stroke: #e4e4e4; }} .frame {{ fill: none; stroke: #777777; "
        "}}</style>\n"
        "<rect width='{0}' height='{1}' fill='#ffffff'/>\n",
        size.width, size.height);
    out += fmt::format("<text class='title' x='{}' y='26'>{}</text>\n", left, escaped(plot.title));
    out += fmt::format("<text class='subtitle' x='{}' y='46'>{}</text>\n", left, escaped(plot.subtitle));
    draw_axes(plot, x, y, out);
    out += fmt::format(
        "<clipPath id='area'><rect x='{}' y='{}' width='{}' height='{}'/></clipPath>\n<g clip-path='url(#area)'>\n",
        left, top, end_of_x(plot) - left, end_of_y(plot) - top);
    std::size_t next = 0;
    std::vector<const char*> colors;
    for (const Curve& curve : plot.curves) {
        const std::size_t index = curve.color >= 0 ? static_cast<std::size_t>(curve.color) : next++;
        colors.push_back(palette[index % palette.size()]);
        draw_curve(curve, colors.back(), x, y, out);
    }
    out += "</g>\n";
    std::size_t line = 0;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        if (!plot.curves[i].label.empty()) {
            draw_legend(plot.curves[i], colors[i], end_of_x(plot), line++, out);
        }
    }
    return out + "</svg>\n";
}

void write_svg(const std::filesystem::path& path, const Plot& plot) {
    if (path.has_parent_path()) {
        io::make_folder(path.parent_path());
    }
    io::write_file(path, to_svg(plot));
}

}  // namespace riprap::view
