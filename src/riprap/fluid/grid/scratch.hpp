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
    std::vector<double> volume;  ///< theta, open share of a cell, 0 to 1 [-]
    /// Open share of the face below the cell, 0 to 1 [-]; set_open_shares makes Room::area of it and gives it up.
    std::array<std::vector<double>, 3> area;
    std::vector<double> displacement;                 ///< d(theta V)/dt by the motion of solids; empty: none [m^3/s]
    std::array<std::vector<float>, 3> body_velocity;  ///< of the solid at the face [m/s]
    std::array<std::vector<float>, 3> wall_distance;  ///< signed, of a face's centre from the solid, > 0 in fluid [m]
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

/// Room for fluid that stones and solids leave: written by set_open_shares, read by all stages.
struct Room {
    std::vector<double> capacity;             ///< n theta V of cells at the end of the step [m^3]
    std::vector<double> capacity_before;      ///< the same at its start; empty where solids stand [m^3]
    std::array<std::vector<double>, 3> area;  ///< open area of faces [m^2]

    const std::vector<double>& before() const { return capacity_before.empty() ? capacity : capacity_before; }

    std::size_t bytes() const;
};

/// Fluid at the start of the step: written by begin_step, which puts the mean velocity into `carrier` for what it
/// repeats.
struct StepStart {
    std::vector<double> fraction;                      ///< empty with one pass, which needs it no more [-]
    std::array<std::vector<double>, 3> carrier;        ///< velocity that transports [m/s]
    std::array<std::vector<double>, 3> pore_velocity;  ///< in the pores; empty where that is `carrier` [m/s]

    /// Returns the velocity in the pores along an axis.
    const std::vector<double>& velocity(int a) const {
        const auto& given = pore_velocity[static_cast<std::size_t>(a)];
        return given.empty() ? carrier[static_cast<std::size_t>(a)] : given;
    }
    std::size_t bytes() const;
};

/// Transport of water: written by move_water, read by find_masses and the momentum.
struct Transport {
    /// Volume through a face in the step [m^3]; its memory goes on to Inertia::mass_flux and back.
    std::array<std::vector<double>, 3> flux;
    /// Water through a face in the step, along +axis [m^3]; its memory goes on to Projection::predicted and back.
    std::array<std::vector<double>, 3> water_flux;
    std::vector<std::uint8_t> colour;  ///< colour function of the dilation term, 0 or 1
    CellPlanes plane;                  ///< surface in mixed cells

    std::size_t bytes() const;
};

/// Masses as momentum is carried with them: written by find_masses.
struct Inertia {
    std::vector<double> mass, mass_before;         ///< in cells [kg]
    std::array<std::vector<double>, 3> mass_flux;  ///< through a face in the step [kg]

    std::size_t bytes() const;
};

/// Stresses: written by find_viscosity, find_curvature and the turbulence, read by predict_velocity.
struct Stress {
    /// mu + mu_t in cells [Pa s]; its memory serves move_water and the pressure solver in between.
    std::vector<double> viscosity;
    std::vector<double> eddy_viscosity;  ///< nu_t; empty in laminar flow [m^2/s]
    std::vector<double> curvature;       ///< of the surface in mixed cells; empty without tension [1/m]

    std::size_t bytes() const;
};

/// Pressure equation: written by predict_velocity and project_velocity.
struct Projection {
    std::array<std::vector<double>, 3> predicted;  ///< velocity before the pressure [m/s]
    linear::FaceConductance conductance;           ///< volume per second that 1 Pa drives through a face
    bool has_operator{false};                      ///< the solver has taken this conductance
    double first_residual{0};                      ///< of the first solve of the step; 0: there was none yet
    linear::PoissonSolver solver;

    /// Right-hand side of the equation, in the memory of the residual that the solver makes of it.
    std::vector<double>& right() { return solver.work().r; }
    std::size_t bytes() const;
};

/// Buffers kept for speed, grouped by the stage that writes them; remade from Model and State at any time.
struct GridScratch {
    bool is_ready{false};
    MediumFields medium;
    OpenShares open;              ///< at the end of the step
    std::vector<Pocket> pockets;  ///< that `open` leaves
    Room room;
    StepStart start;
    Transport moved;
    Inertia inertia;
    Stress stress;
    Projection projection;

    std::size_t bytes() const;
};

}  // namespace riprap::fluid::grid
