// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace riprap::geometry {

/// A point of a plane.
struct PlanePoint {
    double u, v;  ///< [m]
};

/// A convex polygon, counter-clockwise; fewer than three corners = empty.
using PlanePolygon = std::vector<PlanePoint>;

/// The half-plane a u + b v <= c.
struct HalfPlane {
    double a, b, c;
};

/// Keeps the part of `polygon` inside `side`. `buffer` holds nothing of meaning.
void clip(PlanePolygon& polygon, const HalfPlane& side, PlanePolygon& buffer);

/// [m^2]
double area(const PlanePolygon& polygon);
/// Middle of the area of a polygon that has some.
PlanePoint centroid(const PlanePolygon& polygon);

/// A square about (0, 0) that reaches `reach` to every side.
PlanePolygon square(double reach);

/// A rectangle.
struct PlaneBox {
    PlanePoint low, high;
};
/// The rectangle about all corners; turned inside out where there are none.
PlaneBox bounds(std::span<const PlanePolygon> polygons);

/// The Voronoi cells of points in a rectangle: the part of it that is nearer to one point than to any other. Points
/// may lie outside. Exact; about 50 cuts a point when the points lie about `spacing` apart. Deterministic, in parallel.
std::vector<PlanePolygon> voronoi_cells(std::span<const PlanePoint> points, const PlaneBox& box, double spacing);

}  // namespace riprap::geometry
