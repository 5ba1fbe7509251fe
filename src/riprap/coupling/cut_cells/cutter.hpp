// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "riprap/coupling/cut_cells/part_planes.hpp"

namespace riprap::coupling {

/// Collects cell by cell what parts of bodies close.
class Cutter {
 public:
    explicit Cutter(const fluid::grid::Mesh& mesh);
    void cut(const GridBody& body, std::int32_t number);
    /// Turns closed areas of the two sides of each face into open shares, and what bodies show into facets.
    CutBodies finish(const std::vector<GridBody>& bodies) &&;

 private:
    /// A piece of a body's surface, or of a section through it, that lies on a face of the mesh.
    struct OnFace {
        std::int64_t face;
        std::int32_t body;
        std::int8_t axis;
        bool is_below;   ///< the body is below the face
        bool is_on_rim;  ///< nothing but the outside is beyond
        double area;     ///< [m^2]
        std::array<Vec3, 3> middle;
    };
    void note_sides(const std::vector<PartPlanes>& parts, std::int32_t number);
    void cut_cell(const PartPlanes& part, std::int32_t number, const std::array<int, 3>& place);
    void add_face(const geometry::Polyhedron& piece, const std::vector<std::int32_t>& face, std::int32_t number,
                  const std::array<int, 3>& place);
    void find_distances(const PartPlanes& part, const GridBody& body, std::int32_t number, std::array<int, 3> first,
                        std::array<int, 3> last);
    void close_cell(std::int32_t number, const std::array<int, 3>& place);
    void show_filled_cells();
    void show_faces();
    void close_shares();
    void close_joints();
    void show_sides();
    void sort_facets();
    bool is_joint(std::int64_t cell) const;
    bool is_narrow(int a, std::int64_t cell) const;
    void find_joints();
    void list_near_faces();

    const fluid::grid::Mesh* mesh_;
    CutBodies out_;
    std::array<std::vector<double>, 3> below_, above_;  ///< closed share of a face, seen from either side
    std::vector<std::int32_t> filled_;                  ///< body that fills a cell; -1 none
    std::vector<std::int32_t> touched_;                 ///< body in a cell; -1 none, -2 several
    std::vector<std::array<int, 3>> filled_cells_;
    std::vector<OnFace> on_faces_;
    std::vector<std::uint8_t> on_sides_;  ///< of each body, a bit for each side of the domain that it may lie on
    std::vector<CutFacet> side_facets_;
    std::vector<geometry::Plane> across_;
};

}  // namespace riprap::coupling
