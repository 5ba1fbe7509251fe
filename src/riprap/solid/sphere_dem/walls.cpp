// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/walls.hpp"

#include <algorithm>
#include <array>

#include "riprap/contact/narrowphase/sphere_triangle.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/sphere_dem/wall_parts.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// A triangle that a sphere reaches.
struct Reached {
    WallContact contact;
    contact::TriangleFeature feature;
    std::array<std::int32_t, 2> vertices;  ///< of the edge, increasing; of a corner twice the same
    std::int32_t triangle;
};

Reached reach(const SphereModel& model, const Placed& placed, const contact::PartPair pair, std::int32_t parts) {
    const std::int32_t t = pair.b - parts;
    const Vec3* corner = &placed.corner[at(3 * t)];
    const std::int32_t* vertex = &model.triangles.vertices[at(3 * t)];
    const Vec3& centre = placed.center[at(pair.a)];
    const contact::TrianglePoint nearest = contact::nearest_on_triangle(corner[0], corner[1], corner[2], centre);
    const Vec3 into = nearest.point - centre;
    const double distance = norm(into);
    const Vec3 face = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const std::int32_t first = vertex[nearest.corner];
    const std::int32_t second =
        nearest.feature == contact::TriangleFeature::edge ? vertex[(nearest.corner + 1) % 3] : first;
    return {{pair.a, pair.b, distance > 0 ? into / distance : -normalized(face), nearest.point,
             placed.radius[at(pair.a)] - distance, 1, model.spheres.curvature[at(pair.a)], portion_of(model, pair.a)},
            nearest.feature,
            {std::min(first, second), std::max(first, second)},
            t};
}

/// May a contact at an edge or corner count? Only where it is the nearest feature of every reached triangle that has
/// it, and the triangle is the first of those.
bool counts(const SphereModel& model, const std::vector<Reached>& all, const Reached& one) {
    if (one.feature == contact::TriangleFeature::face) {
        return true;
    }
    for (const Reached& other : all) {
        const std::int32_t* vertex = &model.triangles.vertices[at(3 * other.triangle)];
        const auto has = [&](std::int32_t v) { return vertex[0] == v || vertex[1] == v || vertex[2] == v; };
        if (other.triangle == one.triangle || !has(one.vertices[0]) || !has(one.vertices[1])) {
            continue;
        }
        const bool is_same = other.feature == one.feature && other.vertices == one.vertices;
        if (!is_same || other.triangle < one.triangle) {
            return false;
        }
    }
    return true;
}

/// Contacts of the candidates [begin, end), all of one sphere.
void find_of_sphere(const SphereModel& model, const SphereScratch& scratch, std::size_t begin, std::size_t end,
                    std::vector<Reached>& reached, std::vector<WallContact>& out) {
    const Placed& placed = scratch.placed;
    const std::int32_t parts = model.bodies.part_count();
    reached.clear();
    std::vector<Touched> touched, missed;
    for (std::size_t p = begin; p < end; ++p) {
        const contact::PartPair pair = scratch.wall_pairs[p];
        if (pair.b >= parts) {
            const Reached one = reach(model, placed, pair, parts);
            if (one.contact.overlap > 0) {
                reached.push_back(one);
            }
            continue;
        }
        const Touched one = touch(model, placed, pair);
        (one.contact.overlap > 0 ? touched : missed).push_back(one);
    }
    const std::size_t first = out.size();
    add_parts(model, placed, touched, out);
    add_missed(model, placed, touched, missed, out);
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
              [](const WallContact& a, const WallContact& b) { return a.wall < b.wall; });
    for (const Reached& one : reached) {
        if (counts(model, reached, one)) {
            out.push_back(one.contact);
        }
    }
}

}  // namespace

void find_walls(const SphereModel& model, SphereScratch& scratch) {
    const auto count = static_cast<std::int64_t>(scratch.wall_pairs.size());
    constexpr std::int64_t share = 512;
    scratch.wall_chunks.resize(at((count + share - 1) / share));
    parallel::for_ranges(count, share, [&](std::int64_t begin, std::int64_t end) {
        std::vector<WallContact>& out = scratch.wall_chunks[at(begin / share)];
        out.clear();
        std::vector<Reached> reached;
        const auto sphere = [&](std::int64_t p) { return scratch.wall_pairs[at(p)].a; };
        // A sphere belongs to the range in which its first candidate lies.
        while (begin > 0 && begin < end && sphere(begin) == sphere(begin - 1)) {
            ++begin;
        }
        while (end < count && begin < end && sphere(end) == sphere(end - 1)) {
            ++end;
        }
        for (std::int64_t p = begin; p < end;) {
            std::int64_t q = p;
            while (q < end && sphere(q) == sphere(p)) {
                ++q;
            }
            find_of_sphere(model, scratch, at(p), at(q), reached, out);
            p = q;
        }
    });
    scratch.walls.clear();
    for (const auto& chunk : scratch.wall_chunks) {
        scratch.walls.insert(scratch.walls.end(), chunk.begin(), chunk.end());
    }
}

}  // namespace riprap::solid::sphere_dem
