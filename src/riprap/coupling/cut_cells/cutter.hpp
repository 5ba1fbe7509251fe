// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "riprap/coupling/cut_cells/part_planes.hpp"
#include "riprap/coupling/cut_cells/split_cell.hpp"

namespace riprap::coupling {

/// A gap between two bodies that leaves less than this of a cell or of a face is a joint [-].
inline constexpr double joint_share = 0.05;

/// Collects cell by cell what parts of bodies close.
class Cutter {
 public:
    explicit Cutter(const fluid::grid::Mesh& mesh);
    void cut(const GridBody& body, std::int32_t number);
    /// Finds the cells that the bodies cut since the last call split, with those cut before.
    void find_splits();
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
    /// A convex part in a cell, and which planes of it cross the cell.
    struct PartInCell {
        std::int64_t cell;
        std::array<int, 3> place;
        std::int32_t body;
        std::uint32_t first, count;  ///< in part_planes_
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
    void find_walls();
    bool leads_around(const SplitCell& split, std::int32_t component) const;
    void close_splits();
    void turn_facets();
    bool hangs_together(std::span<const PartInCell> parts) const;
    const SplitCell* split_at(std::int64_t cell) const;
    std::int64_t beyond(const SplitCell& split, std::int32_t component) const;
    void close_joints();
    void show_sides();
    void sort_facets();
    bool is_joint(std::int64_t cell) const;
    bool is_narrow(int a, std::int64_t cell) const;
    void drop_covered_facets();
    bool fills(std::int32_t body, std::int64_t cell) const;
    bool holds(std::int32_t body, const Vec3& x) const;
    std::span<const PartInCell> parts_in(std::int64_t cell) const;
    void list_near_faces();

    const fluid::grid::Mesh* mesh_;
    double round_off_;  ///< a share of a face or cell below this is none, and one above 1 less this is 1 [-]
    CutBodies out_;
    std::array<std::vector<double>, 3> below_, above_;  ///< closed share of a face, seen from either side
    std::vector<std::int32_t> filled_;                  ///< the first body that fills a cell; -1 none
    std::vector<std::int32_t> touched_;                 ///< body in a cell; -1 none, -2 several
    struct FilledCell {
        std::array<int, 3> place;
        std::int32_t body;
    };
    std::vector<FilledCell> filled_cells_;
    std::vector<std::pair<std::int64_t, std::int32_t>> filled_again_;  ///< cells, and bodies that fill them too
    std::vector<OnFace> on_faces_;
    std::vector<std::uint8_t> on_sides_;  ///< of each body, a bit for each side of the domain that it may lie on
    std::vector<CutFacet> side_facets_;
    std::vector<geometry::Plane> across_, part_planes_;
    std::vector<PartInCell> parts_;  ///< those that find_splits has seen come first, by cells
    std::size_t seen_{0};            ///< of them
    std::vector<SplitCell> splits_;  ///< by cells
};

}  // namespace riprap::coupling
