// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/planar/convex_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "riprap/core/index.hpp"

namespace riprap::geometry {

namespace {

using Loop = std::vector<std::int32_t>;  ///< corners of a piece, counter-clockwise

constexpr double straight = 1e-9;  ///< sine of a turn that counts as none [-]

/// Sine of the turn at b on the way a, b, c: positive to the left.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - b) / (norm(b - a) * norm(c - b)); }

/// Least height of a triangle over its longest side, zero or less where it is none.
double quality(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double side = std::max({norm(b - a), norm(c - b), norm(a - c)});
    return cross(b - a, c - a) / (side * side);
}

bool holds(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& x) {
    return cross(b - a, x - a) >= 0 && cross(c - b, x - b) >= 0 && cross(a - c, x - c) >= 0;
}

/// Tells whether corner k of the rest can be cut off: no other corner lies in its triangle.
bool is_ear(const Polygon& polygon, const Loop& rest, std::size_t k) {
    const std::size_t n = rest.size(), before = (k + n - 1) % n, after = (k + 1) % n;
    for (std::size_t i = 0; i < n; ++i) {
        if (i != before && i != k && i != after &&
            holds(polygon[at(rest[before])], polygon[at(rest[k])], polygon[at(rest[after])], polygon[at(rest[i])])) {
            return false;
        }
    }
    return true;
}

std::vector<Loop> triangles_of(const Polygon& polygon) {
    Loop rest;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        rest.push_back(static_cast<std::int32_t>(k));
    }
    std::vector<Loop> triangles;
    while (rest.size() >= 3) {
        const std::size_t n = rest.size();
        std::size_t best = n;
        double most = straight;
        for (std::size_t k = 0; k < n; ++k) {
            const double q =
                quality(polygon[at(rest[(k + n - 1) % n])], polygon[at(rest[k])], polygon[at(rest[(k + 1) % n])]);
            if (q > most && is_ear(polygon, rest, k)) {
                most = q;
                best = k;
            }
        }
        if (best == n) {
            return {};
        }
        triangles.push_back({rest[(best + n - 1) % n], rest[best], rest[(best + 1) % n]});
        if (n == 3) {
            break;
        }
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
}

bool is_convex(const Polygon& polygon, const Loop& loop) {
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k) {
        if (!(turn(polygon[at(loop[k])], polygon[at(loop[(k + 1) % n])], polygon[at(loop[(k + 2) % n])]) > straight)) {
            return false;
        }
    }
    return true;
}

/// Two loops joined across the edge that runs from a to b in `first` and back in `second`; empty when there is none.
Loop joined(const Loop& first, const Loop& second) {
    for (std::size_t i = 0; i < first.size(); ++i) {
        const std::int32_t a = first[i], b = first[(i + 1) % first.size()];
        for (std::size_t j = 0; j < second.size(); ++j) {
            if (second[j] != b || second[(j + 1) % second.size()] != a) {
                continue;
            }
            Loop loop;
            for (std::size_t k = 1; k <= first.size(); ++k) {  // from b round to a
                loop.push_back(first[(i + k) % first.size()]);
            }
            for (std::size_t k = 2; k < second.size(); ++k) {  // and between a and b
                loop.push_back(second[(j + k) % second.size()]);
            }
            return loop;
        }
    }
    return {};
}

}  // namespace

std::vector<Polygon> convex_pieces(const Polygon& polygon) {
    std::vector<Loop> loops = triangles_of(polygon);
    for (std::size_t i = 0; i < loops.size(); ++i) {
        for (std::size_t j = i + 1; j < loops.size();) {
            const Loop both = joined(loops[i], loops[j]);
            if (both.empty() || !is_convex(polygon, both)) {
                ++j;
                continue;
            }
            loops[i] = both;
            loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(j));
            j = i + 1;  // what did not fit before may fit now
        }
    }
    std::vector<Polygon> pieces;
    for (const Loop& loop : loops) {
        Polygon piece;
        for (const std::int32_t corner : loop) {
            piece.push_back(polygon[at(corner)]);
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

}  // namespace riprap::geometry
