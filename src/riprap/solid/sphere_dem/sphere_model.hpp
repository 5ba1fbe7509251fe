// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/contact/law/contact_table.hpp"
#include "riprap/contact/law/frictions.hpp"
#include "riprap/solid/sphere_dem/sphere_settings.hpp"
#include "riprap/solid/sphere_dem/surface_sample.hpp"

namespace riprap::solid::sphere_dem {

/// Spheres by which bodies meet: Model. One entry per sphere, grouped by body in the order of the bodies.
struct SphereSet {
    std::vector<std::int32_t> body;
    std::vector<double> radius;       ///< [m]
    std::vector<double> curvature;    ///< R that the laws of contact take; of samples in edges that of the others [m]
    std::vector<Vec3> local;          ///< centre in the body frame [m]
    std::vector<Vec3> face_normal;    ///< outward normal of the face that the sphere lies in, body frame; 0 = none [-]
    std::vector<double> area;         ///< of the surface that a sample stands for; 0 of other spheres [m^2], plane: [m]
    std::vector<double> portion;      ///< area over that of a square of 2 R: by which its springs count [-]
    std::vector<std::int32_t> begin;  ///< first sphere of every body; body count + 1 entries, see finish
    /// Of each sphere among those of all bodies, ascending, where only some bodies are kept; empty: all are.
    std::vector<std::int32_t> number;
    /// Per body: most spheres that a plane across a body axis touches at once, within a tenth of their radius; see
    /// finish.
    std::vector<std::int32_t> flat_count;
    bool has_clusters{false};  ///< some body has several spheres; see finish
    /// Per body: 1 where its spheres are samples of its surface, which others meet as it is; none by finish.
    std::vector<std::uint8_t> is_sampled;
    /// Per body: of its spheres from the centre of mass, at most; infinite of sampled bodies that cannot move [m].
    std::vector<double> extent;

    std::int32_t size() const { return static_cast<std::int32_t>(radius.size()); }
    std::int32_t number_of(std::int32_t sphere) const {
        return number.empty() ? sphere : number[static_cast<std::size_t>(sphere)];
    }
    std::int32_t count_of(std::int32_t of) const {
        return begin[static_cast<std::size_t>(of) + 1] - begin[static_cast<std::size_t>(of)];
    }
    /// Do the spheres of body `a` meet the surface of body `b` itself, not its samples? Two packings of spheres that
    /// lie askew to each other push along the lines of their centres, sideways where faces meet head on. Of two bodies
    /// that are sampled the samples of the smaller one meet the face of the larger one.
    bool meets_surface(std::int32_t a, std::int32_t b) const {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        return is_sampled[j] != 0 && (is_sampled[i] == 0 || extent[i] < extent[j] || (extent[i] == extent[j] && a < b));
    }
    /// Is the sphere a sample of an edge or corner, smaller than those of faces?
    bool is_sharp(std::int32_t sphere) const {
        const auto s = static_cast<std::size_t>(sphere);
        return radius[s] < curvature[s];
    }
    /// Does a sphere meet the surface of body `b` itself? Edges and corners of two sampled bodies meet the surface of
    /// the other one either way: a brick lies on the edge of its support as well as on its own corners.
    bool touches(std::int32_t sphere, std::int32_t b) const {
        const std::int32_t a = body[static_cast<std::size_t>(sphere)];
        return meets_surface(a, b) || (is_sharp(sphere) && is_sampled[static_cast<std::size_t>(a)] != 0 &&
                                       is_sampled[static_cast<std::size_t>(b)] != 0);
    }
    /// @param law_radius  R of the laws of contact [m]; 0 = that of the sphere
    void add(BodyId of, double sphere_radius, const Vec3& centre = {}, const Vec3& normal = {}, double law_radius = 0);
    /// Adds a sample of a surface: its springs count by area/(2 R)^2, in the plane by area/(2 R), so that a face is as
    /// stiff per area wherever it is pressed.
    void add_sample(BodyId of, const Pose& part, const SurfaceSample& sample, bool is_planar);
    /// Fills what is per body and `has_clusters`; call once all spheres are added, in the order of their bodies.
    void finish(std::int32_t body_count);
};

/// Triangles of fixed or driven surfaces, open or closed: Model. Spheres meet them from either side.
struct TriangleSet {
    std::vector<std::int32_t> body;
    std::vector<Vec3> corners;           ///< three per triangle, body frame [m]
    std::vector<std::int32_t> vertices;  ///< three per triangle; equal numbers are one vertex of the surface

    std::int32_t size() const { return static_cast<std::int32_t>(body.size()); }
    /// Adds one surface of a body; vertex numbers count from those already there.
    void add(BodyId of, const std::vector<Vec3>& points, const std::vector<std::int32_t>& corner_indices);

 private:
    std::int32_t vertex_count_{0};
};

/// All that the method reads and never writes.
struct SphereModel {
    const body::BodySet& bodies;
    const geometry::ShapeSet& shapes;  ///< of polyhedral parts that spheres meet
    const SphereSet& spheres;
    const TriangleSet& triangles;
    const contact::ContactTable& table;
    SphereSettings settings{};
    /// Cohesion of pairs of materials, row after row [Pa]; empty where no pair has any.
    std::span<const double> cohesion{};
};

}  // namespace riprap::solid::sphere_dem
