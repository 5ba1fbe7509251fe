// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/fluid/grid/plane.hpp"
#include "riprap/linear/multigrid.hpp"

namespace riprap::fluid::grid {

/// Share of every cell and face that solids leave open, and how solids move, at one time. Made by coupling/cut_cells
/// from the poses of bodies; all open where there are none.
struct OpenShares {
    bool has_bodies{false};
    std::vector<double> volume;                        ///< theta, open share of a cell, 0 to 1 [-]
    std::array<std::vector<double>, 3> area;           ///< open share of the face below the cell, 0 to 1 [-]
    std::vector<double> displacement;                  ///< d(theta V)/dt by the motion of solids [m^3/s]
    std::array<std::vector<double>, 3> body_velocity;  ///< of the solid at the face [m/s]
    std::array<std::vector<double>, 3> wall_distance;  ///< signed, of a face's centre from the solid, > 0 in fluid [m]
};

/// Open cells that solids shut off from the rest, and cells of the rest around them.
struct Pocket {
    std::vector<std::int64_t> cells, around;
};

/// Properties of the medium in cells and on faces, constant during a run.
struct MediumFields {
    bool has_stones{false};
    std::vector<double> porosity, linear, quadratic, added_mass,
        grain_size;  ///< in cells; linear in 1/m^2, quadratic 1/m
};

/// Buffers kept for speed, remade from Model and State at any time.
struct GridScratch {
    bool is_ready{false};
    MediumFields medium;
    OpenShares open;                                ///< at the end of the step
    std::vector<Pocket> pockets;                    ///< that `open` leaves
    std::vector<double> capacity, capacity_before;  ///< n theta V of cells [m^3]
    std::array<std::vector<double>, 3> area;        ///< open area of faces [m^2]
    std::array<std::vector<double>, 3> carrier;     ///< velocity that transports, [m/s]
    std::array<std::vector<double>, 3> water_flux;  ///< water through a face in the step, along +axis [m^3]
    /// Volume through a face while water moves [m^3], then mass through it [kg]: one memory, of which one name is
    /// empty.
    std::array<std::vector<double>, 3> flux, mass_flux;
    std::array<std::vector<double>, 3> predicted;  ///< velocity before the pressure [m/s]
    std::array<std::vector<double>, 3> wall_drag;  ///< 2 axes: shear of solids per velocity [kg/(m^3 s)]
    /// In the pores at the begin of the step; empty where that is `carrier` [m/s].
    std::array<std::vector<double>, 3> start_velocity;
    std::vector<double> start_fraction;     ///< at the begin of the step
    std::vector<double> end_fraction;       ///< of slivers beside solids, at the end of the step [-]
    std::vector<double> water;              ///< in cells [m^3]
    std::vector<std::uint8_t> colour;       ///< colour function of the dilation term, 0 or 1
    std::vector<CellPlane> plane;           ///< surface in mixed cells
    std::vector<double> mass, mass_before;  ///< in cells [kg]
    std::vector<double> viscosity;          ///< mu + mu_t in cells [Pa s]
    std::vector<double> fluidity;           ///< 1/viscosity [1/(Pa s)]
    std::vector<double> eddy_viscosity;     ///< nu_t [m^2/s]
    std::vector<double> curvature;          ///< of the surface in mixed cells; empty without tension [1/m]
    std::vector<double> rhs;                ///< of the pressure equation
    linear::FaceConductance conductance;    ///< of the pressure: volume per second that 1 Pa drives through a face
    linear::PoissonSolver solver;

    std::size_t bytes() const;
    const std::vector<double>& start_of(int a) const {
        const auto& given = start_velocity[static_cast<std::size_t>(a)];
        return given.empty() ? carrier[static_cast<std::size_t>(a)] : given;
    }
};

}  // namespace riprap::fluid::grid
