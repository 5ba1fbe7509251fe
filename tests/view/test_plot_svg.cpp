// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "riprap/view/plot_svg.hpp"

namespace riprap::view {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// True when every tag of the document is closed in order.
bool is_well_formed(const std::string& text) {
    std::vector<std::string> open;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos) {
            return false;
        }
        const std::string tag = text.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
        if (tag.front() == '/') {
            if (open.empty() || "/" + open.back() != tag) {
                return false;
            }
            open.pop_back();
        } else if (tag.back() != '/') {
            open.push_back(name);
        }
        at = end;
    }
    return open.empty();
}

Plot simple_plot() {
    Plot plot;
    plot.title = "speed & height <of a block>";
    plot.x.label = "time [s]";
    plot.y.label = "height [m]";
    plot.curves = {{"theory", {0, 1, 2}, {0, 1, 4}, CurveStyle::line, -1},
                   {"ours", {0, 1, 2}, {0, 1.1, std::nan("")}, CurveStyle::markers, -1}};
    return plot;
}

TEST(PlotSvg, is_well_formed_and_shows_labels_with_units) {
    const std::string svg = to_svg(simple_plot());
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(svg, HasSubstr("time [s]"));
    EXPECT_THAT(svg, HasSubstr("height [m]"));
    EXPECT_THAT(svg, HasSubstr("speed &amp; height &lt;of a block&gt;"));
    EXPECT_THAT(svg, HasSubstr(">theory<"));
}

double number_after(const std::string& text, const std::string& name) {
    const std::size_t at = text.find(name);
    return at == std::string::npos ? 0 : std::stod(text.substr(at + name.size()));
}

TEST(PlotSvg, grows_until_every_name_in_the_legend_is_inside) {
    Plot plot = simple_plot();
    const double width = number_after(to_svg(plot), "width='"), height = number_after(to_svg(plot), "height='");
    EXPECT_EQ(width, plot.width);
    plot.curves[0].label = std::string(120, 'e');
    EXPECT_NEAR(number_after(to_svg(plot), "width='"), 84 + 120 + 47 + 8.2 * 120 + 8, 1e-9);
    for (int i = 0; i < 38; ++i) {
        plot.curves.push_back({"one more", {0, 1}, {0, 1}, CurveStyle::line, -1});
    }
    const std::string svg = to_svg(plot);
    const double last = std::stod(svg.substr(svg.rfind(" y='") + 4));  // of the last name
    EXPECT_GT(last, height);
    EXPECT_GT(number_after(svg, "height='"), last + 5);
}

TEST(PlotSvg, has_the_size_that_is_asked_for_and_fewer_marks_where_it_is_small) {
    Plot plot = simple_plot();
    const auto marks = [&plot] {
        const std::string svg = to_svg(plot);
        std::size_t count = 0;
        for (std::size_t at = svg.find("class='grid'"); at != std::string::npos;
             at = svg.find("class='grid'", at + 1)) {
            ++count;
        }
        return count;
    };
    const std::size_t usual = marks();
    plot.title = plot.subtitle = "";
    plot.width = 400;
    plot.height = 240;
    EXPECT_EQ(number_after(to_svg(plot), "width='"), 400);
    EXPECT_EQ(number_after(to_svg(plot), "height='"), 240);
    EXPECT_LT(marks(), usual);
}

TEST(PlotSvg, leaves_out_what_is_not_finite) {
    const std::string svg = to_svg(simple_plot());
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(PlotSvg, draws_an_empty_and_a_constant_curve) {
    Plot plot = simple_plot();
    plot.curves = {{"nothing", {}, {}, CurveStyle::line, -1}, {"constant", {0, 1}, {3, 3}, CurveStyle::line, -1}};
    EXPECT_TRUE(is_well_formed(to_svg(plot)));
    EXPECT_THAT(to_svg(plot), Not(HasSubstr("nan")));
}

TEST(PlotSvg, logarithmic_axes_are_marked_at_powers_of_ten) {
    Plot plot = simple_plot();
    plot.x.is_log = true;
    plot.curves = {{"", {1, 1000}, {1, 2}, CurveStyle::line, -1}};
    EXPECT_THAT(to_svg(plot), HasSubstr(">100<"));
}

TEST(AxisTicks, are_round_numbers_inside_the_range) {
    EXPECT_THAT(axis_ticks(0, 1, 5), ElementsAre(0, 0.2, 0.4, testing::DoubleEq(0.6), 0.8, 1));
    EXPECT_THAT(axis_ticks(-3, 12, 3), ElementsAre(0, 5, 10));
}

}  // namespace
}  // namespace riprap::view
