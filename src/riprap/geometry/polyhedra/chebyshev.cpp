// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/chebyshev.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "riprap/core/error.hpp"

namespace riprap::geometry {

namespace {

/// Round-off allowed in a constraint of the scaled problem, whose numbers are of order one.
constexpr double slack_tolerance = 1e-15;
/// After elimination a row whose largest coefficient is below this is parallel to the plane it was cut with.
constexpr double parallel_tolerance = 1e-14;
/// No unknown of the scaled problem is larger.
constexpr double box_size = 2;

/// a . x <= b in D unknowns.
template <std::size_t D>
struct Row {
    std::array<double, D> a;
    double b;
};

template <std::size_t D>
using Point = std::array<double, D>;

template <std::size_t D>
double excess(const Row<D>& row, const Point<D>& x) {
    double sum = -row.b;
    for (std::size_t k = 0; k < D; ++k) {
        sum += row.a[k] * x[k];
    }
    return sum;
}

/// Rows of each dimension below the top one; kept between calls of one solve.
struct Workspace {
    std::vector<Row<1>> rows1;
    std::vector<Row<2>> rows2;
    std::vector<Row<3>> rows3;

    template <std::size_t D>
    std::vector<Row<D>>& rows() {
        if constexpr (D == 1) {
            return rows1;
        } else if constexpr (D == 2) {
            return rows2;
        } else {
            return rows3;
        }
    }
};

/// Maximise c . x in one unknown: an interval. Round-off may leave it empty by a hair; its middle is then the answer.
void maximise(const std::vector<Row<1>>& rows, const Point<1>& c, Workspace&, Point<1>& x) {
    double low = -box_size, high = box_size;
    for (const Row<1>& row : rows) {
        if (row.a[0] > parallel_tolerance) {
            high = std::min(high, row.b / row.a[0]);
        } else if (row.a[0] < -parallel_tolerance) {
            low = std::max(low, row.b / row.a[0]);
        }
    }
    if (low > high) {
        x[0] = 0.5 * (low + high);
    } else {
        x[0] = c[0] > 0 ? high : c[0] < 0 ? low : std::clamp(0.0, low, high);
    }
}

/// Substitutes unknown p of `row`, solved from the equality `cut`. The left-over slack keeps its meaning, a distance.
template <std::size_t D>
Row<D - 1> eliminate(const Row<D>& row, const Row<D>& cut, std::size_t p) {
    const double factor = row.a[p] / cut.a[p];
    Row<D - 1> result{};
    for (std::size_t k = 0, to = 0; k < D; ++k) {
        if (k != p) {
            result.a[to++] = row.a[k] - factor * cut.a[k];
        }
    }
    result.b = row.b - factor * cut.b;
    return result;
}

/// Maximise c . x subject to rows and |x_k| <= box_size. Rows are taken one by one; one that cuts off the best point so
/// far must be tight at the new best point, which is then sought on its plane, one dimension lower.
template <std::size_t D>
void maximise(const std::vector<Row<D>>& rows, const Point<D>& c, Workspace& work, Point<D>& x) {
    for (std::size_t k = 0; k < D; ++k) {
        x[k] = c[k] > 0 ? box_size : c[k] < 0 ? -box_size : 0;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row<D>& cut = rows[i];
        if (excess<D>(cut, x) <= slack_tolerance) {
            continue;
        }
        std::size_t p = 0;
        for (std::size_t k = 1; k < D; ++k) {
            p = std::abs(cut.a[k]) > std::abs(cut.a[p]) ? k : p;
        }
        if (std::abs(cut.a[p]) <= parallel_tolerance) {
            continue;  // off by round-off only; the final check looks at every row again
        }
        std::vector<Row<D - 1>>& lower = work.rows<D - 1>();
        lower.clear();
        Row<D> wall{};  // the box of the eliminated unknown is an ordinary row from here on
        wall.b = box_size;
        for (const double sign : {1.0, -1.0}) {
            wall.a[p] = sign;
            lower.push_back(eliminate<D>(wall, cut, p));
        }
        for (std::size_t j = 0; j < i; ++j) {
            lower.push_back(eliminate<D>(rows[j], cut, p));
        }
        Row<D> objective{};
        objective.a = c;
        Point<D - 1> y{};
        maximise(lower, eliminate<D>(objective, cut, p).a, work, y);

        double solved = cut.b;
        for (std::size_t k = 0, from = 0; k < D; ++k) {
            if (k != p) {
                x[k] = y[from++];
                solved -= cut.a[k] * x[k];
            }
        }
        x[p] = solved / cut.a[p];
    }
}

/// Fisher-Yates with a fixed 64-bit linear congruential generator, so that every platform does the same steps.
void shuffle(std::vector<Row<4>>& rows, std::uint64_t seed) {
    std::uint64_t state = seed;
    for (std::size_t i = rows.size(); i > 1; --i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        std::swap(rows[i - 1], rows[static_cast<std::size_t>((state >> 33) % i)]);
    }
}

/// The radius that centre x really has: the smallest distance to a field-carrying plane, negative where x is outside.
double radius_at(const std::vector<Row<4>>& rows, const Vec3& x) {
    double radius = std::numeric_limits<double>::infinity(), depth = radius;
    for (const Row<4>& row : rows) {
        const double h = row.b - (row.a[0] * x.x + row.a[1] * x.y + row.a[2] * x.z);
        (row.a[3] > 0 ? radius : depth) = std::min(row.a[3] > 0 ? radius : depth, h);
    }
    return depth < -10 * slack_tolerance ? std::min(radius, depth) : radius;
}

}  // namespace

InscribedSphere largest_inscribed_sphere(std::span<const Plane> faces, std::span<const std::uint8_t> is_internal,
                                         const Vec3& interior, double scale) {
    std::vector<Row<4>> rows(faces.size());
    for (std::size_t j = 0; j < faces.size(); ++j) {
        const Vec3& n = faces[j].normal;
        const bool carries_field = is_internal.empty() || is_internal[j] == 0;
        rows[j] = {{n.x, n.y, n.z, carries_field ? 1.0 : 0.0}, (faces[j].offset - dot(n, interior)) / scale};
    }
    Workspace work;
    Vec3 centre{};
    double radius = -std::numeric_limits<double>::infinity();
    // Another order helps only if round-off spoiled a nearly parallel cut; one pass is the rule.
    constexpr int attempts = 4;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        shuffle(rows, 0x5EEDULL + static_cast<std::uint64_t>(attempt));
        Point<4> x{};
        maximise<4>(rows, {0, 0, 0, 1}, work, x);
        const Vec3 found{x[0], x[1], x[2]};
        const double real = radius_at(rows, found);
        if (real > radius) {
            radius = real;
            centre = found;
        }
        if (std::abs(x[3] - real) <= 16 * slack_tolerance) {
            break;
        }
    }
    return {interior + scale * centre, scale * radius};
}

}  // namespace riprap::geometry
