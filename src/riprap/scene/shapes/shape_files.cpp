// SPDX-License-Identifier: Apache-2.0
// Shapes that need a hull, a file or an audit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "riprap/geometry/polyhedra/convex_hull.hpp"
#include "riprap/geometry/polyhedra/flatten_polygons.hpp"
#include "riprap/geometry/polyhedra/sound_part.hpp"
#include "riprap/geometry/surface/mesh_facts.hpp"
#include "riprap/geometry/surface/obj.hpp"
#include "riprap/geometry/surface/stl.hpp"
#include "riprap/geometry/surface/surface_audit.hpp"
#include "riprap/geometry/surface/triangle_mesh.hpp"
#include "riprap/scene/case/case_build.hpp"
#include "riprap/scene/case/orientation.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/number_files.hpp"

namespace riprap::scene {

using geometry::Polyhedron;

namespace {
void move_to_center_of_mass(std::vector<Polyhedron>& pieces) {
    Vec3 moment{};
    double volume = 0;
    for (const Polyhedron& piece : pieces) {
        const geometry::MassProperties mass = geometry::mass_properties(piece);
        moment += mass.volume * mass.centroid;
        volume += mass.volume;
    }
    for (Polyhedron& piece : pieces) {
        piece = geometry::moved(piece, {-(moment / volume), Quat{}});
    }
}
}  // namespace

ShapePieces ShapeLibrary::make_hull(const Value& table) {
    std::vector<Vec3> points;
    if (const Value* file = table.find("file")) {
        const double unit = get_word(table, "units", length_units());
        const auto rows = read_numbers(files_, file->text, form_of(columns_of_places(), limits::table_rows, unit),
                                       file->place, problems_, notes_);
        if (!rows) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < rows->row_count(); ++i) {
            points.push_back(unit * Vec3{rows->at(i, 0), rows->at(i, 1), rows->at(i, 2)});
        }
    } else {
        for (const Value& point : get(table, "points").items) {
            points.push_back(to_vector(point));
        }
    }
    const auto [low, high] = geometry::box_of(points);
    if (geometry::is_far(low, high)) {
        origin_ = low;
        for (Vec3& x : points) {
            x -= origin_;
        }
    }
    return accept(geometry::convex_hull(points), table.place);
}

ShapePieces ShapeLibrary::audited(const geometry::Surface& surface, bool is_repaired) {
    geometry::SurfaceAuditOptions options;
    options.fix_orientation = options.drop_collapsed = is_repaired;
    const geometry::SurfaceAudit audit = geometry::audit_surface(surface, options);
    problems_.insert(problems_.end(), audit.problems.begin(), audit.problems.end());
    if (!audit.problems.empty()) {
        return std::nullopt;
    }
    for (std::size_t i = surface.notes.size(); i < audit.notes.size(); ++i) {  // those of the file are told
        warnings_.push_back(to_string(audit.notes[i]));
    }
    std::vector<Polyhedron> pieces;
    for (const geometry::SurfacePart& part : audit.parts) {
        pieces.push_back(part.polyhedron);
    }
    return pieces;
}

std::optional<geometry::Surface> ShapeLibrary::read_surface(const Value& table, SurfaceReader reader) {
    const Value& path = get(table, "file");
    const auto bytes = files_.read(path.text, limits::surface_bytes, path.place, problems_);
    if (!bytes) {
        return std::nullopt;
    }
    const double scale = get_word(table, "units", length_units()) * get_number(table, "scale");
    geometry::Surface surface;
    try {
        surface = reader(*bytes, path.text, scale);
    } catch (const CaseError& error) {
        add_problems_of(error, path.place, problems_);
        return std::nullopt;
    }
    for (const Diagnostic& note : surface.notes) {
        warnings_.push_back(to_string(note));
    }
    return surface;
}

void ShapeLibrary::note_solids(const Value& path, const geometry::Surface& surface,
                               const std::vector<Polyhedron>& pieces) {
    const auto [low, high] = geometry::box_of_faces(surface);
    const bool is_single = surface.grain > 0;
    notes_.push_back(
        fmt::format("{}: x {:.9g} to {:.9g}, y {:.9g} to {:.9g}, z {:.9g} to {:.9g} m; {} faces, {} convex part{}",
                    path.text, low.x, high.x, low.y, high.y, low.z, high.z, surface.face_count(), pieces.size(),
                    pieces.size() == 1 ? "" : "s"));
    notes_.push_back(fmt::format(
        "{}: {}", path.text,
        geometry::precision_text(
            low, high, is_single ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon(),
            is_single ? "the file's single precision" : "double precision")));
    if (const std::size_t apart = geometry::count_apart(pieces); apart > 1) {
        warnings_.push_back(to_string(Diagnostic{
            path.place,
            fmt::format("the {} closed solids of {} do not touch and move as one rigid body", apart, path.text),
            "a file and a body for each that is to move by itself"}));
    }
}

ShapePieces ShapeLibrary::make_surface(const Value& table, bool is_stl) {
    const auto surface = read_surface(table, is_stl ? geometry::read_stl : geometry::read_obj);
    if (!surface) {
        return std::nullopt;
    }
    auto pieces = audited(*surface, get_boolean(table, "repair"));
    if (!pieces) {
        return std::nullopt;
    }
    note_solids(get(table, "file"), *surface, *pieces);
    const auto [low, high] = geometry::box_of_faces(*surface);
    if (geometry::is_far(low, high)) {
        origin_ = low;
        for (Polyhedron& piece : *pieces) {
            for (Vec3& x : piece.vertices) {
                x -= origin_;
            }
        }
    }
    double way = 0;
    for (Polyhedron& piece : *pieces) {
        way = std::max(way, geometry::flatten_polygons(piece));
    }
    if (way > 0) {
        notes_.push_back(
            fmt::format("{}: corners were up to {:.2g} m beside the planes of their faces, and are put "
                        "into them",
                        get(table, "file").text, way));
    }
    if (get_boolean(table, "center")) {
        move_to_center_of_mass(*pieces);
        origin_ = {};
    }
    return pieces;
}

std::optional<Polyhedron> ShapeLibrary::closed_surface(const Value& table, bool is_stl) {
    const auto surface = read_surface(table, is_stl ? geometry::read_stl : geometry::read_obj);
    if (!surface) {
        return std::nullopt;
    }
    geometry::SurfaceAuditOptions options;
    options.drop_collapsed = true;
    std::vector<Diagnostic> notes;
    const std::vector<Diagnostic> found = geometry::audit_closed_surface(*surface, options, notes);
    problems_.insert(problems_.end(), found.begin(), found.end());
    if (!found.empty()) {
        return std::nullopt;
    }
    geometry::TriangleMesh mesh = geometry::mesh_of(*surface);
    Vec3 moment{};
    double volume = 0;
    for (std::int32_t t = 0; t < mesh.size(); ++t) {  // of the tetrahedra from the origin to each triangle
        const Vec3 &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
        const double part = dot(a, cross(b, c)) / 6;
        moment += 0.25 * part * (a + b + c);
        volume += part;
    }
    if (get_boolean(table, "center")) {
        for (Vec3& x : mesh.points) {
            x -= moment / volume;
        }
    }
    Polyhedron closed{std::move(mesh.points), {}, {}};
    for (const auto& corners : mesh.corners) {
        closed.faces.emplace_back(corners.begin(), corners.end());
    }
    return closed;
}

namespace {

/// Adds a convex piece as a closed shell of its own.
void add_piece(const Polyhedron& piece, std::int32_t line, geometry::Surface& surface) {
    const auto body = static_cast<std::int32_t>(surface.body_names.size());
    surface.body_names.emplace_back();
    const auto first = static_cast<std::int32_t>(surface.vertices.size());
    surface.vertices.insert(surface.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    for (std::vector<std::int32_t> loop : piece.faces) {
        for (std::int32_t& vertex : loop) {
            vertex += first;
        }
        surface.add_face(loop, body, static_cast<std::uint32_t>(line));
    }
}

}  // namespace

Value ShapeLibrary::sized(Value shape, double density) const {
    Value* armour = shape.find("armour");
    const Value* mass = armour != nullptr ? armour->find("mass") : nullptr;
    if (mass != nullptr) {
        const double volume = mass->as_number() / density;
        armour->set("nominal_diameter", Value::of(is_planar_ ? std::sqrt(volume) : std::cbrt(volume)));
        std::erase_if(armour->entries, [](const Entry& entry) { return entry.key == "mass"; });
    }
    return shape;
}

ShapePieces ShapeLibrary::make_armour(const Value& table) {
    const geometry::ArmourUnit unit = get_word(table, "unit", armour_units());
    if (const Value* mass = table.find("mass")) {  // of a body ShapeLibrary::sized has made a diameter of it
        problems_.push_back({mass->place, "a unit by its mass, but nothing here has a density", "nominal_diameter"});
        return std::nullopt;
    }
    const double diameter = get_number(table, "nominal_diameter");
    constexpr double least = 1e-6;  // [m], of the surface that its parts are audited as
    if (!(diameter >= least && diameter <= geometry::most_extent)) {
        problems_.push_back({table.place, fmt::format("an armour unit of nominal diameter {:.3g} m", diameter),
                             fmt::format("from {:g} to {:g} m", least, geometry::most_extent)});
        return std::nullopt;
    }
    geometry::Surface surface;
    surface.file = table.place.file;
    for (const Polyhedron& piece :
         is_planar_ ? geometry::planar_armour_unit(unit, diameter) : geometry::armour_unit(unit, diameter)) {
        add_piece(piece, table.place.line, surface);
    }
    return audited(surface, false);
}

ShapePieces ShapeLibrary::make_union(const Value& list) {
    geometry::Surface surface;
    surface.file = list.place.file;
    bool is_good = true;
    for (const Value& part : list.items) {
        if (is_ground(get(part, "shape"))) {
            problems_.push_back({part.place, "ground cannot be a part of a union", "a body of its own"});
            is_good = false;
            continue;
        }
        const auto some = pieces(get(part, "shape"));
        if (!some) {
            is_good = false;
            continue;
        }
        const Pose pose{get_vector(part, "position"), orientation_of(part.find("orientation"))};
        for (const Polyhedron& piece : *some) {
            add_piece(geometry::moved(piece, pose), part.place.line, surface);
        }
    }
    if (!is_good) {
        return std::nullopt;
    }
    const std::size_t before = problems_.size();
    auto all = audited(surface, false);
    for (std::size_t i = before; i < problems_.size(); ++i) {
        problems_[i].place = problems_[i].place.line > 0 ? problems_[i].place : list.place;
    }
    return all;
}

}  // namespace riprap::scene
