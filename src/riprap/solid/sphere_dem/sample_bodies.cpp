// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/sample_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "riprap/body/ground.hpp"
#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/solid/sphere_dem/box_samples.hpp"
#include "riprap/solid/sphere_dem/convex_samples.hpp"
#include "riprap/solid/sphere_dem/default_stiffness.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Extent of a shape along its axes [m].
Vec3 extent(const geometry::Polyhedron& shape) {
    Vec3 low = shape.vertices[0], high = low;
    for (const Vec3& v : shape.vertices) {
        low = min(low, v);
        high = max(high, v);
    }
    return high - low;
}

/// A box along the axes about its centre has eight vertices, each in a corner of its extent.
bool is_box(const geometry::Polyhedron& shape, const Vec3& size) {
    const double tolerance = 1e-9 * norm(size);
    const auto in_corner = [&](const Vec3& v) {
        return std::abs(std::abs(v.x) - 0.5 * size.x) < tolerance &&
               std::abs(std::abs(v.y) - 0.5 * size.y) < tolerance && std::abs(std::abs(v.z) - 0.5 * size.z) < tolerance;
    };
    return shape.vertices.size() == 8 && std::ranges::all_of(shape.vertices, in_corner);
}

/// Tells whether a body is one ball, or in the plane one disc.
bool is_round(const body::BodySet& bodies, const geometry::ShapeSet& shapes, std::size_t body) {
    return bodies.part_begin[body + 1] - bodies.part_begin[body] == 1 &&
           shapes.view(bodies.parts[at(bodies.part_begin[body])].shape).round_radius > 0;
}

/// Radius of the samples of a part that may be smaller than others [m].
double radius_in(const geometry::ConvexView& part, double radius) {
    return std::min(radius, part.inscribed_radius * (1 - 1e-9));
}

/// Holds what the samples of a scene have to meet.
struct Sampling {
    double radius{0};  ///< [m]
    bool is_planar{false};
    bool meets_triangles{false};
};

/// Radius of the samples of edges [m].
double sharp_radius(const geometry::ConvexView& part, double of_faces) {
    return std::min(sharp_share * of_faces, 0.25 * part.inscribed_radius);
}

/// Samples of the surface of a part, in its own frame.
geometry::Outcome<std::vector<SurfaceSample>> sample_part(const geometry::ShapeSet& shapes, ShapeId part,
                                                          const Sampling& sampling) {
    constexpr double most = 8e6;  // of one part
    const geometry::Polyhedron shape = shapes.polyhedron(part);
    const geometry::ConvexView view = shapes.view(part);
    const double r = radius_in(view, sampling.radius);
    if (const Vec3 size = extent(shape); is_box(shape, size)) {
        const BoxSampling box{size, r, sharp_radius(view, r), sampling.is_planar, sampling.meets_triangles};
        if (const double count = box_sample_count(box); count > most) {
            return geometry::GeometryProblem{
                fmt::format("a shell of about {:.2g} spheres of radius {:.3g} m", count, r),
                "larger spheres, at most 8 million of them"};
        }
        return box_samples(box);
    }
    if (const double count = sample_estimate(view, r); count > most) {
        return geometry::GeometryProblem{fmt::format("about {:.2g} samples of radius {:.3g} m", count, r),
                                         "larger spheres, at most 8 million of them"};
    }
    std::vector<SurfaceSample> samples = face_samples(view, r, sampling.is_planar, sampling.meets_triangles);
    const std::vector<SurfaceSample> edges = edge_samples(view, sharp_radius(view, r), r, sampling.is_planar);
    samples.insert(samples.end(), edges.begin(), edges.end());
    return samples;
}

/// Adds the samples of the edges and corners of a body that cannot move.
void add_edges(const SolidScene& scene, std::int32_t b, double radius, SphereSet& spheres) {
    const body::BodySet& bodies = scene.bodies;
    for (std::int32_t p = bodies.part_begin[at(b)]; p < bodies.part_begin[at(b) + 1]; ++p) {
        const body::Part& part = bodies.parts[at(p)];
        const geometry::ConvexView shape = scene.shapes.view(part.shape);
        if (shape.vertex_count == 0) {
            continue;  // a half-space
        }
        for (const SurfaceSample& sample : edge_samples(shape, sharp_radius(shape, radius), radius, bodies.is_planar)) {
            spheres.add_sample(BodyId{b}, part.local, sample, bodies.is_planar);
        }
    }
}

/// Radius of the sphere or disc of a body's volume, whatever its density.
double radius_of_volume(const body::BodySet& bodies, const geometry::ShapeSet& shapes, std::size_t body) {
    double volume = 0;
    for (std::int32_t p = bodies.part_begin[body]; p < bodies.part_begin[body + 1]; ++p) {
        volume += shapes.volume(bodies.parts[at(p)].shape);
    }
    return bodies.is_planar ? std::sqrt(volume / M_PI) : std::cbrt(0.75 * volume / M_PI);
}

}  // namespace

double radius_of_samples(const body::BodySet& bodies, const geometry::ShapeSet& shapes,
                         const SphereDemSettings& settings) {
    if (settings.sphere_radius) {
        return *settings.sphere_radius;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const body::Part& part : bodies.parts) {
        if (may_move(bodies, at(part.body.value))) {
            least = std::min(least, shapes.view(part.shape).inscribed_radius);
        }
    }
    return least / 3;
}

SphereSet sample_bodies(const SolidScene& scene, const SphereDemSettings& settings,
                        std::vector<SceneProblem>* problems) {
    constexpr std::int32_t most = 50'000'000;  // of all bodies
    const body::BodySet& bodies = scene.bodies;
    const geometry::ShapeSet& shapes = scene.shapes;
    std::vector<const body::GivenSpheres*> given(at(bodies.size()), nullptr);
    for (const body::GivenSpheres& of_body : scene.spheres) {
        given[at(of_body.body.value)] = &of_body;
    }
    SphereSet spheres;
    std::vector<std::uint8_t> is_sampled(at(bodies.size()), 0);
    const double radius = radius_of_samples(bodies, shapes, settings);
    Sampling sampling{radius, bodies.is_planar, false};
    bool is_any_sampled = false;  // else no sample of an edge meets anything
    for (std::int32_t b = 0; b < bodies.size() && settings.sampling == SphereSampling::surface; ++b) {
        is_any_sampled =
            is_any_sampled || (may_move(bodies, at(b)) && given[at(b)] == nullptr && !is_round(bodies, shapes, at(b)));
        sampling.meets_triangles = sampling.meets_triangles || body::is_ground(bodies, shapes, BodyId{b});
    }
    // A body that cannot be sampled stands as one sphere, for its problem to be told.
    const auto refuse = [&](std::int32_t body, const geometry::GeometryProblem& problem) {
        spheres.add(BodyId{body}, radius_of_volume(bodies, shapes, at(body)));
        if (problems != nullptr && problems->size() < 10) {
            problems->push_back({BodyId{body},
                                 fmt::format("spheres of {:.3g} m for the surface of '{}': {}", radius,
                                             bodies.name(BodyId{body}), problem.message),
                                 problem.allowed + "; another solid.sphere_radius, or 'spheres' of the body"});
        }
    };
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        if (given[at(b)] != nullptr) {
            for (const body::ShapeSphere& s : given[at(b)]->spheres) {
                spheres.add(BodyId{b}, s.radius, s.centre, s.face_normal);
            }
            continue;
        }
        if (!may_move(bodies, at(b))) {
            if (is_round(bodies, shapes, at(b))) {
                spheres.add(BodyId{b}, radius_of_volume(bodies, shapes, at(b)));
                continue;
            }
            if (is_any_sampled && !body::is_ground(bodies, shapes, BodyId{b})) {
                add_edges(scene, b, radius, spheres);
                is_sampled[at(b)] = 1;
            }
            continue;
        }
        if (settings.sampling == SphereSampling::one || is_round(bodies, shapes, at(b))) {
            spheres.add(BodyId{b}, radius_of_volume(bodies, shapes, at(b)));
            continue;
        }
        if (settings.sampling == SphereSampling::balls) {
            continue;
        }
        if (spheres.size() > most) {
            refuse(b, {fmt::format("there are {} already, of the bodies before it", spheres.size()),
                       fmt::format("at most {} in all", most)});
            continue;
        }
        is_sampled[at(b)] = 1;
        for (std::int32_t p = bodies.part_begin[at(b)]; p < bodies.part_begin[at(b) + 1]; ++p) {
            const body::Part& part = bodies.parts[at(p)];
            const auto samples = sample_part(shapes, part.shape, sampling);
            if (!samples) {
                refuse(b, samples.problems().front());
                break;
            }
            for (const SurfaceSample& sample : samples.value()) {
                spheres.add_sample(BodyId{b}, part.local, sample, bodies.is_planar);
            }
        }
    }
    spheres.finish(bodies.size());
    spheres.is_sampled = std::move(is_sampled);
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        if (spheres.is_sampled[at(b)] != 0 && !may_move(bodies, at(b))) {
            spheres.extent[at(b)] = std::numeric_limits<double>::infinity();
        }
    }
    return spheres;
}

namespace {

/// Returns the contact values of a material, completed by the settings.
contact::ContactMaterial own_values(const material::Material& material, const SphereDemSettings& settings) {
    contact::ContactMaterial own;
    own.youngs_modulus = material.youngs_modulus.value_or(modulus_of(settings));
    own.poisson_ratio = material.poisson_ratio.value_or(settings.poisson_ratio);
    own.restitution = material.restitution.value_or(settings.restitution);
    own.rolling_friction = material.rolling_friction.value_or(settings.rolling_friction);
    own.contact_ratio = settings.contact_ratio.value_or(own.contact_ratio);
    own.normal_stiffness = spring_of(settings);
    own.shear_ratio = settings.shear_ratio;
    return own;
}

/// Returns the mixed values of two materials, those that the case gives for the pair in place of them.
contact::ContactPair pair_of(const material::MaterialSet& materials, MaterialId a, MaterialId b,
                             const SphereDemSettings& settings) {
    const material::PairProperties& given = materials.pair(a, b);
    std::array two{own_values(materials[a], settings), own_values(materials[b], settings)};
    for (contact::ContactMaterial& one : two) {
        one.restitution = given.restitution.value_or(one.restitution);
        one.rolling_friction = given.rolling_friction.value_or(one.rolling_friction);
        one.contact_ratio = given.contact_ratio.value_or(one.contact_ratio);
        one.normal_stiffness = given.spring_stiffness.value_or(one.normal_stiffness);
        one.shear_ratio = given.spring_shear_ratio.value_or(one.shear_ratio);
    }
    const contact::ContactMixing mixing{.restitution = materials.restitution_mixing,
                                        .rolling = materials.rolling_mixing};
    contact::ContactPair pair =
        contact::mixed_pair(two[0], two[1], settings.laws.normal, mixing, settings.laws.allows_pull);
    const auto share = [&](MaterialId id) { return materials[id].kinetic_share.value_or(settings.kinetic_share); };
    pair.static_friction = given.friction;
    pair.kinetic_friction =
        given.kinetic_share.value_or(material::mix(materials.friction_mixing, share(a), share(b))) * given.friction;
    return pair;
}

}  // namespace

contact::ContactTable pair_table(const material::MaterialSet& materials, const SphereDemSettings& settings) {
    contact::ContactTable table(materials.size());
    for (std::int32_t a = 0; a < materials.size(); ++a) {
        for (std::int32_t b = a; b < materials.size(); ++b) {
            table.set_pair(MaterialId{a}, MaterialId{b}, pair_of(materials, MaterialId{a}, MaterialId{b}, settings));
        }
    }
    return table;
}

std::vector<double> cohesion_table(const material::MaterialSet& materials) {
    std::vector<double> table;
    bool is_any = false;
    for (std::int32_t a = 0; a < materials.size(); ++a) {
        for (std::int32_t b = 0; b < materials.size(); ++b) {
            table.push_back(materials.pair(MaterialId{a}, MaterialId{b}).cohesion);
            is_any = is_any || table.back() > 0;
        }
    }
    return is_any ? table : std::vector<double>{};
}

}  // namespace riprap::solid::sphere_dem
