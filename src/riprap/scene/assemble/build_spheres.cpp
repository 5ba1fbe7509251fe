// SPDX-License-Identifier: Apache-2.0
// Spheres by which a body is met, and bodies that weigh as much as theirs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/number_files.hpp"

namespace riprap::scene {

namespace {

using Spheres = std::optional<std::vector<body::ShapeSphere>>;

Spheres accept(CaseBuild& build, const geometry::Outcome<body::Multisphere>& shape, const SourcePlace& place) {
    for (const geometry::GeometryProblem& problem : shape.problems()) {
        build.problem(place, problem.message, problem.allowed);
    }
    return shape ? Spheres(shape.value().spheres) : std::nullopt;
}

Spheres read_list(CaseBuild& build, const Value& table, const Value& file) {
    const double unit = get_word(table, "units", length_units());
    std::vector<ReadColumn> columns = columns_of_places();
    columns.push_back({{"radius", {"radius", "r"}}, dimension::length});
    const auto text = build.files.read(file.text, limits::table_bytes, file.place, build.problems);
    if (!text || !read_numbers(build.files, file.text, form_of(columns, limits::table_rows, unit), file.place,
                               build.problems, build.notes)) {
        return std::nullopt;  // the heading of lengths in other units among the reasons
    }
    Spheres spheres = accept(build, body::read_sphere_list(*text, file.text), file.place);
    for (std::size_t i = 0; spheres && i < spheres->size(); ++i) {
        body::ShapeSphere& sphere = (*spheres)[i];
        sphere.centre *= unit;
        sphere.radius *= unit;
        if (build.is_planar && sphere.centre.z != 0) {
            build.problem(file.place,
                          fmt::format("sphere {} lies at z = {:.6g} m in a planar scene", i + 1, sphere.centre.z),
                          "z = 0: discs");
            return std::nullopt;
        }
    }
    return spheres;
}

/// Edge lengths of the box that a shape is; nothing where it is none.
std::optional<Vec3> box_of(const Value& shape) {
    if (const Value* box = shape.find("box")) {
        return to_vector(*box);
    }
    if (const Value* cube = shape.find("cube")) {
        return Vec3{cube->as_number(), cube->as_number(), cube->as_number()};
    }
    return std::nullopt;
}

Spheres make_shell(CaseBuild& build, const Value& shape, const Value& count) {
    const std::optional<Vec3> size = box_of(shape);
    if (!size) {
        build.problem(count.place, "a shell of spheres is for boxes",
                      "shape = { box = ... } or { cube = ... }, or 'fill'");
        return std::nullopt;
    }
    const double shortest = build.is_planar ? std::min(size->x, size->y) : std::min({size->x, size->y, size->z});
    const double radius = 0.5 * shortest / static_cast<double>(count.integer);
    return accept(build, build.is_planar ? body::rectangle_shell(*size, radius) : body::box_shell(*size, radius),
                  count.place);
}

Spheres make_ring(CaseBuild& build, const Value& shape, const Value& table, const Value& count) {
    const Value* disc = shape.find("sphere");
    if (!build.is_planar || disc == nullptr) {
        build.problem(count.place, "a ring of spheres is for discs", "shape = { sphere = R } with dimension = 2");
        return std::nullopt;
    }
    const double radius = disc->as_number(), half = std::sin(M_PI / static_cast<double>(count.integer));
    const double own = get_number_or(table, "ring_radius", radius * half / (1 + half));
    return accept(build, body::ring(radius, own, static_cast<int>(count.integer), 1), count.place);
}

/// Joins convex parts to one surface: by solid angles every point of a part is inside.
geometry::Polyhedron surface_of(const CaseBuild& build, const std::vector<body::Part>& parts) {
    geometry::Polyhedron all;
    for (const body::Part& part : parts) {
        const geometry::Polyhedron one = geometry::moved(build.model.shapes.polyhedron(part.shape), part.local);
        const auto first = static_cast<std::int32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), one.vertices.begin(), one.vertices.end());
        for (std::vector<std::int32_t> face : one.faces) {
            for (std::int32_t& vertex : face) {
                vertex += first;
            }
            all.faces.push_back(std::move(face));
        }
    }
    return all;
}

/// Depth of a point below the faces of the part that it lies deepest in, negative outside; end faces of planar prisms
/// are no faces [m].
double depth_in(const CaseBuild& build, const std::vector<body::Part>& parts, const Vec3& point) {
    double deepest = -std::numeric_limits<double>::infinity();
    for (const body::Part& part : parts) {
        const geometry::ConvexView shape = build.model.shapes.view(part.shape);
        const Vec3 x = to_body(part.local, point);
        double depth = std::numeric_limits<double>::infinity();
        for (int j = 0; j < shape.face_count; ++j) {
            if (!build.is_planar || std::abs(shape.normal_z[j]) < 0.5) {
                depth = std::min(depth, shape.offset[j] - dot(shape.normal(j), x));
            }
        }
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

/// Refuses spheres whose centres the shape does not hold, and warns where one sticks out of it.
bool lie_inside(CaseBuild& build, const Value& table, const body::NewBody& body,
                const std::vector<body::ShapeSphere>& spheres) {
    double farthest = 0;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const double depth = depth_in(build, body.parts, spheres[i].centre);
        if (depth < -1e-9 * spheres[i].radius) {
            build.problem(
                table.place,
                fmt::format("sphere {} of '{}' has its centre {:.3g} m outside of the shape", i + 1, body.name, -depth),
                "spheres with their centres inside: water and what is shown keep the shape");
            return false;
        }
        farthest = std::max(farthest, 1 - depth / spheres[i].radius);
    }
    if (farthest > 0.1) {
        build.warnings.push_back(to_string(Diagnostic{
            table.place,
            fmt::format(
                "a sphere of '{}' sticks out of its shape by {:.0f} % of its radius: contacts begin before faces "
                "meet",
                body.name, 100 * farthest),
            ""}));
    }
    return true;
}

/// Warns where spheres stay far behind a face: a body that lies on it sinks in by so much.
void warn_of_bare_faces(CaseBuild& build, const Value& table, const body::NewBody& body,
                        const std::vector<body::ShapeSphere>& spheres) {
    constexpr double allowed = 0.1;  // of the inscribed radius
    double barest = 0, radius = 0;
    for (const body::Part& part : body.parts) {
        const geometry::ConvexView shape = build.model.shapes.view(part.shape);
        radius = std::max(radius, shape.inscribed_radius);
        for (int j = 0; j < shape.face_count; ++j) {
            if (shape.is_internal[j] != 0 || (build.is_planar && std::abs(shape.normal_z[j]) > 0.5)) {
                continue;
            }
            double reached = -std::numeric_limits<double>::infinity();
            for (const body::ShapeSphere& sphere : spheres) {
                reached = std::max(reached, dot(shape.normal(j), to_body(part.local, sphere.centre)) + sphere.radius);
            }
            barest = std::max(barest, shape.offset[j] - reached);
        }
    }
    if (barest > allowed * radius) {
        build.warnings.push_back(to_string(Diagnostic{
            table.place,
            fmt::format(
                "the spheres of '{}' stay {:.3g} m behind a face of its shape, whose inscribed radius is {:.3g} "
                "m: so deep it sinks into what it lies on",
                body.name, barest, radius),
            ""}));
    }
}

/// Finds the integrals over the union; nothing, with a problem, where they cannot be used.
std::optional<geometry::MassProperties> weigh(CaseBuild& build, const Value& body_table, const body::NewBody& body,
                                              const std::vector<body::ShapeSphere>& spheres) {
    const SourcePlace place = get(get(body_table, "spheres"), "mass_of").place;
    if (build.is_planar || body.drive == body::Drive::driven) {
        build.problem(
            place, build.is_planar ? "spheres have no mass per metre of width" : "a body with a motion needs no mass",
            "mass_of = \"shape\"");
        return std::nullopt;
    }
    const geometry::MassProperties whole = body::union_of_spheres(spheres);
    double volume = 0;
    for (const body::Part& part : body.parts) {
        volume += build.model.shapes.volume(part.shape);
    }
    if (std::abs(whole.volume / volume - 1) > 0.1) {
        build.warnings.push_back(to_string(Diagnostic{
            place,
            fmt::format(
                "the spheres of '{}' have {:.0f} % of the volume of its shape: it {} and floats as its shape does",
                body.name, 100 * whole.volume / volume,
                body_table.find("mass") != nullptr ? "weighs what is given, turns as they do" : "weighs as they do"),
            ""}));
    }
    return whole;
}

}  // namespace

std::optional<BodySpheres> read_spheres(CaseBuild& build, const Value& body_table, const body::NewBody& body) {
    const Value &table = get(body_table, "spheres"), &shape = get(body_table, "shape");
    if (ShapeLibrary::is_half_space(shape) || ShapeLibrary::is_ground(shape)) {
        build.problem(table.place, fmt::format("'{}' is a half-space or ground", body.name), "leave out 'spheres'");
        return std::nullopt;
    }
    if (const Value* radius = table.find("ring_radius"); radius != nullptr && table.find("ring") == nullptr) {
        build.problem(radius->place, "'ring_radius' is of a 'ring', and there is none", "leave it out");
        return std::nullopt;
    }
    Spheres spheres;
    if (const Value* file = table.find("file")) {
        spheres = read_list(build, table, *file);
    } else if (const Value* count = table.find("shell")) {
        spheres = make_shell(build, shape, *count);
    } else if (const Value* around = table.find("ring")) {
        spheres = make_ring(build, shape, table, *around);
    } else if (const Value& spacing = get(table, "fill"); build.is_planar) {
        build.problem(spacing.place, "a lattice of spheres fills no section", "'shell', 'ring' or 'file'");
    } else {
        spheres = accept(build, body::fill_surface(surface_of(build, body.parts), spacing.as_number()), spacing.place);
    }
    if (!spheres || !lie_inside(build, table, body, *spheres)) {
        return std::nullopt;
    }
    warn_of_bare_faces(build, table, body, *spheres);
    BodySpheres found{std::move(*spheres)};
    if (get_text(table, "mass_of") == "spheres") {
        found.whole = weigh(build, body_table, body, found.spheres);
        if (!found.whole) {
            return std::nullopt;
        }
    }
    return found;
}

void give_spheres(CaseBuild& build, const BodySpheres& spheres, const body::NewBody& body, BodyId id, double scale) {
    body::BodySet& bodies = build.model.bodies;
    body::BodyState& state = build.state.bodies;
    const auto i = at(id.value);
    const auto first = at(bodies.part_begin[i]);
    Vec3 centre = body.parts.front().local.position - bodies.parts[first].local.position;  // of mass, in the shape
    if (spheres.whole) {
        const Vec3 moved = scale * spheres.whole->centroid;
        const double cube = scale * scale * scale;
        const Mat3 second = (cube * scale * scale) * spheres.whole->second_moment;
        const SymmetricEigen eigen = symmetric_eigen(body.density * geometry::inertia_from_second_moment(second));
        bodies.mass[i] = body.density * cube * spheres.whole->volume;
        bodies.principal_moments[i] = eigen.values;
        bodies.principal_axes[i] = from_matrix(eigen.axes);
        for (std::size_t p = first; p < at(bodies.part_begin[i + 1]); ++p) {
            bodies.parts[p].local.position -= moved - centre;
        }
        state.position[i] = to_world(body.pose, moved);
        state.angular_momentum[i] = angular_momentum_of(bodies, id, state.orientation[i], body.angular_velocity);
        centre = moved;
    }
    body::GivenSpheres given{id, spheres.spheres};
    for (body::ShapeSphere& sphere : given.spheres) {
        sphere.centre = scale * sphere.centre - centre;
        sphere.radius *= scale;
    }
    build.model.spheres.push_back(std::move(given));
}

}  // namespace riprap::scene
