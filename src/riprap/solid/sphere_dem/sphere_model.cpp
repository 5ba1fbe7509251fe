// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/sphere_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Spheres of a body that a plane across an axis touches from one side, within a tenth of their radius, each by its
/// portion; of a sampled body those that meet parts.
/// @param side  axis and sign: 2 axis + (1 = from below)
std::int32_t count_flat(const SphereSet& spheres, std::int32_t body, int side) {
    const double sign = side % 2 == 0 ? 1 : -1;
    const auto reach = [&](std::int32_t s) { return sign * spheres.local[at(s)][side / 2] + spheres.radius[at(s)]; };
    double most = -std::numeric_limits<double>::infinity();
    for (std::int32_t s = spheres.begin[at(body)]; s < spheres.begin[at(body) + 1]; ++s) {
        most = std::max(most, reach(s));
    }
    double count = 0, sharp = 0, of_sharp = 0;
    for (std::int32_t s = spheres.begin[at(body)]; s < spheres.begin[at(body) + 1]; ++s) {
        const bool is_flat = reach(s) > most - 0.1 * spheres.radius[at(s)];
        const bool is_of_face = spheres.face_normal[at(s)] != Vec3{};
        count += is_flat ? spheres.portion[at(s)] : 0;
        sharp += is_flat && (is_of_face || spheres.is_sharp(s)) ? spheres.portion[at(s)] : 0;
        of_sharp += spheres.is_sharp(s) ? 1 : 0;
    }
    return static_cast<std::int32_t>(std::ceil((of_sharp > 0 ? sharp : count) - 1e-9));
}

}  // namespace

void SphereSet::add(BodyId of, double sphere_radius, const Vec3& centre, const Vec3& normal, double law_radius) {
    body.push_back(of.value);
    radius.push_back(sphere_radius);
    curvature.push_back(law_radius > 0 ? law_radius : sphere_radius);
    local.push_back(centre);
    face_normal.push_back(normal);
    area.push_back(0);
    portion.push_back(1);
}

void SphereSet::add_sample(BodyId of, const Pose& part, const SurfaceSample& sample, bool is_planar) {
    Vec3 centre = to_world(part, sample.sphere.centre);
    centre.z = is_planar ? 0 : centre.z;
    add(of, sample.sphere.radius, centre, rotate(part.orientation, sample.sphere.face_normal), sample.law_radius);
    const double width = 2 * sample.law_radius;
    area.back() = sample.area;
    portion.back() = sample.area / (is_planar ? width : width * width);
}

void SphereSet::finish(std::int32_t body_count) {
    begin.assign(at(body_count) + 1, 0);
    has_clusters = false;
    for (const std::int32_t b : body) {
        ++begin[at(b) + 1];
    }
    for (std::size_t b = 0; b < at(body_count); ++b) {
        has_clusters = has_clusters || begin[b + 1] > 1;
        begin[b + 1] += begin[b];
    }
    is_sampled.assign(at(body_count), 0);
    extent.assign(at(body_count), 0);
    for (std::size_t s = 0; s < body.size(); ++s) {
        extent[at(body[s])] = std::max(extent[at(body[s])], norm(local[s]) + radius[s]);
    }
    flat_count.assign(at(body_count), 0);
    for (std::int32_t b = 0; b < body_count; ++b) {
        for (int side = 0; side < 6; ++side) {
            flat_count[at(b)] = std::max(flat_count[at(b)], count_flat(*this, b, side));
        }
    }
}

void TriangleSet::add(BodyId of, const std::vector<Vec3>& points, const std::vector<std::int32_t>& corner_indices) {
    for (std::size_t k = 0; k < corner_indices.size(); ++k) {
        if (k % 3 == 0) {
            body.push_back(of.value);
        }
        corners.push_back(points[at(corner_indices[k])]);
        vertices.push_back(vertex_count_ + corner_indices[k]);
    }
    vertex_count_ += static_cast<std::int32_t>(points.size());
}

}  // namespace riprap::solid::sphere_dem
