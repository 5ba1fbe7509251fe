// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/geometry/planar/planar_cut.hpp"

namespace riprap::geometry {

/// Content of a `.geo` file of the 2D-DDA family: lines to cut blocks along and points of interest.
struct DdaGeometry {
    double snap{0};  ///< least distance of an edge from a node [m]
    std::vector<PlanarJoint> joints;
    std::int32_t outline_count{0};  ///< so many joints at the beginning are the outline
    std::vector<PlanarJoint> material_lines;
    std::vector<PlanarJoint> fixed_lines;  ///< begin = end for a fixed point
    std::vector<Vec2> load_points, measured_points, hole_points, seismic_points;
    std::vector<PlanarJoint> bolts;
    std::vector<std::string> notes;  ///< what was read and what is not used
};

/// A block material: unit mass, weight, Young's modulus, Poisson's ratio, initial stress and velocity.
struct DdaMaterial {
    double density{0};                 ///< [kg/m^3]
    double unit_weight{0};             ///< downward body force [N/m^3]
    double youngs_modulus{0};          ///< [Pa]
    double poisson_ratio{0};           ///< [-]
    std::array<double, 3> stress{};    ///< x, y, xy [Pa]
    std::array<double, 3> velocity{};  ///< x, y, rotation [m/s, rad/s]
};
struct DdaJointProperties {
    double friction_angle{0};  ///< [rad]; degrees in the file
    double cohesion{0};        ///< [Pa]
    double tension{0};         ///< [Pa]
};
/// Force at a load point: time and components, in between linear.
struct DdaLoadHistory {
    std::vector<std::array<double, 3>> records;  ///< t, Fx, Fy [s, N]
};

/// Content of an `.ana` file: control parameters and materials.
struct DdaAnalysis {
    bool is_dynamic{true};
    bool is_plane_strain{false};
    std::int32_t step_count{0};
    double displacement_ratio{0};  ///< allowed displacement in a step over half the height of the domain [-]
    double time_step{0};           ///< largest [s]
    double penalty_factor{50};     ///< contact stiffness over Young's modulus [-]
    double shear_ratio{2.5};       ///< normal stiffness over shear stiffness [-]
    std::vector<DdaMaterial> materials;
    std::vector<DdaJointProperties> joints;
    std::vector<DdaLoadHistory> loads;
    std::vector<std::string> notes;
};

/// Reads a geometry file from memory, in the form of marked-up elements (`<Jointlist>`, `<Joint type="1"> x1 y1 x2
/// y2`) or in the older one of bare numbers (least distance; counts of joints, outline joints, material lines, bolts,
/// fixed, load, measured and hole points; then a line of numbers for each). Elements that are not known are
/// refused where they hold numbers or nearly have the name of one that is, and noted else.
/// @throws CaseError with every problem as file:line:column.
DdaGeometry read_dda_geometry(std::string_view bytes, const std::string& file);

/// Reads an analysis file. The form of bare numbers is: 0 static or 1 dynamic, number of steps, of block
/// materials and of joint materials, displacement ratio, largest time step, 13 numbers for each block material and
/// three for each joint material; more than one number behind these is refused. @throws CaseError
DdaAnalysis read_dda_analysis(std::string_view bytes, const std::string& file);

}  // namespace riprap::geometry
