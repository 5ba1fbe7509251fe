// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/geometry/polyhedra/outcome.hpp"
#include "riprap/geometry/surface/surface.hpp"
#include "riprap/geometry/surface/triangle_mesh.hpp"
#include "riprap/scene/shapes/shape_kind.hpp"
#include "riprap/scene/text/case_files.hpp"
#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

/// Turns shape tables of the case into convex parts in the scene's ShapeSet, each distinct shape once.
class ShapeLibrary {
 public:
    ShapeLibrary(geometry::ShapeSet& shapes, CaseFiles& files, bool is_planar, std::vector<Diagnostic>& problems,
                 std::vector<std::string>& warnings, std::vector<std::string>& notes)
        : shapes_(shapes),
          files_(files),
          is_planar_(is_planar),
          problems_(problems),
          warnings_(warnings),
          notes_(notes) {}

    /// The shape with a diameter in the place of a mass, where it is an armour unit by its mass.
    Value sized(Value shape, double density) const;

    /// The parts of a body of this shape, `local` from the frame of the shape table; `scale` multiplies all lengths.
    /// Nothing, with a problem at the place of the table (once per table), when the shape is refused.
    std::optional<std::vector<body::Part>> parts(const Value& shape, double scale = 1);

    /// The convex pieces of a shape as polyhedra, in the frame of the table; not for half-spaces.
    ShapePieces pieces(const Value& shape);

    /// Adds one polyhedron as a shape of its own. @returns its part, `local` from the frame of the polyhedron.
    body::Part add(const geometry::Polyhedron& polyhedron);

    /// An `stl` or `obj` shape of any form, closed, in triangles, in the frame of the table.
    std::optional<geometry::Polyhedron> closed_surface(const Value& table, bool is_stl);

    static bool is_half_space(const Value& shape) { return kind_of(shape).role == ShapeRole::plane; }
    static bool is_ground(const Value& shape) { return kind_of(shape).role == ShapeRole::ground; }

    // Kinds of shapes are made with these.
    bool is_planar() const { return is_planar_; }
    void refuse(const SourcePlace& place, std::string message, std::string allowed) {
        problems_.push_back({place, std::move(message), std::move(allowed)});
    }
    /// The one piece that came out, or its problems at `place`.
    ShapePieces accept(geometry::Outcome<geometry::Polyhedron> outcome, const SourcePlace& place);
    ShapePieces make_union(const Value& list);
    ShapePieces make_armour(const Value& table);
    ShapePieces make_surface(const Value& table, bool is_stl);
    ShapePieces make_terrain(const Value& table);
    ShapePieces make_mesh(const Value& table);
    ShapePieces make_hull(const Value& table);

 private:
    /// Reads the bytes of a file; `file` is its name in messages, `scale` the metres of its unit.
    using SurfaceReader = geometry::Surface (*)(std::string_view bytes, const std::string& file, double scale);

    /// Convex pieces of a shape, counted from a place near them: coordinates of a map leave a shape few digits.
    struct Pieces {
        std::vector<geometry::Polyhedron> polyhedra;
        Vec3 origin{};
    };

    std::optional<Pieces> placed_pieces(const Value& shape);
    ShapePieces make(const Value& shape);
    ShapePieces make_profile(const Value& table);
    /// Ground over a mesh, and what the mesh is like among the notes.
    std::vector<geometry::Polyhedron> ground_of(geometry::TriangleMesh mesh, const std::string& file, double epsilon,
                                                double thickness, const std::optional<Vec3>& down);
    /// A surface as its file has it, its notes among the warnings.
    std::optional<geometry::Surface> read_surface(const Value& table, SurfaceReader reader);
    /// Says what the solids of a surface are like.
    void note_solids(const Value& path, const geometry::Surface& surface,
                     const std::vector<geometry::Polyhedron>& pieces);
    ShapePieces audited(const geometry::Surface& surface, bool is_repaired);

    geometry::ShapeSet& shapes_;
    CaseFiles& files_;
    bool is_planar_;
    std::vector<Diagnostic>& problems_;
    std::vector<std::string>& warnings_;
    std::vector<std::string>& notes_;  ///< what surfaces and tables are like
    std::map<std::string, std::optional<std::vector<body::Part>>> known_parts_;
    std::map<std::string, std::optional<Pieces>> known_pieces_;
    Vec3 origin_{};  ///< of the pieces that make() has returned
};

}  // namespace riprap::scene
