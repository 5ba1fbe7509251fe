// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/side_view.hpp"

#include <algorithm>

namespace riprap::validation {

namespace {

struct Point {
    double x, y;
    friend auto operator<=>(const Point&, const Point&) = default;
};

double turn(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Corners of the convex hull, counter-clockwise: lower chain, then upper chain of the sorted points.
std::vector<Point> convex_outline(std::vector<Point> points) {
    std::sort(points.begin(), points.end());
    std::vector<Point> hull;
    const auto extend = [&hull](const Point& p, std::size_t fixed) {
        while (hull.size() >= fixed + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) {
            hull.pop_back();
        }
        hull.push_back(p);
    };
    for (const Point& p : points) {
        extend(p, 0);
    }
    const std::size_t lower = hull.size() - 1;
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) {
        extend(*p, lower);
    }
    return hull;  // the first point is repeated at the end: a closed curve
}

}  // namespace

std::vector<view::Curve> side_view(const sim::Model& model, const sim::State& state, const View& view) {
    std::vector<view::Curve> curves;
    for (const body::Part& part : model.bodies.parts) {
        const auto body = static_cast<std::size_t>(part.body.value);
        if (!body::is_free(model.bodies, part.body, state.time)) {
            continue;
        }
        const geometry::ConvexView shape = model.shapes.view(part.shape);
        std::vector<Point> points;
        for (std::int32_t v = 0; v < shape.vertex_count; ++v) {
            const Vec3 local = part.local.position + rotate(part.local.orientation, shape.vertex(v));
            const Vec3 x = state.bodies.position[body] + rotate(state.bodies.orientation[body], local);
            points.push_back({dot(x, view.right), dot(x, view.up)});
        }
        view::Curve curve;
        curve.color = 0;
        for (const Point& p : convex_outline(std::move(points))) {
            curve.x.push_back(p.x);
            curve.y.push_back(p.y);
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

view::Plot side_view_plot(const sim::Model& model, const sim::State& state, const View& view,
                          const std::string& title) {
    view::Plot plot;
    plot.title = title;
    plot.x.label = "[m]";
    plot.y.label = "[m]";
    plot.has_equal_scales = true;
    plot.curves = side_view(model, state, view);
    return plot;
}

}  // namespace riprap::validation
