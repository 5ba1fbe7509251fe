// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace riprap::fluid::grid {

/// Water by the books [m^3].
struct WaterBooks {
    double held{0};    ///< at the start plus what crossed the sides
    double ever{0};    ///< at the start plus what came in
    double let_go{0};  ///< left through sides that are open for air alone

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("grid.water_volume", self.held);
        visit("grid.water_ever", self.ever);
        visit("grid.water_let_go", self.let_go);
    }
};

/// Fields on the mesh, flat, ghosts included. velocity[a][i] is the filter velocity through the face below cell i.
struct GridState {
    std::vector<double> fraction;                 ///< of water in what is open in a cell, 0 to 1 [-]
    std::array<std::vector<double>, 3> velocity;  ///< [m/s]
    std::vector<double> pressure;                 ///< p - rho g.x [Pa]
    std::vector<double> turbulent_energy;         ///< k; empty when laminar [m^2/s^2]
    std::vector<double> dissipation_rate;         ///< epsilon; empty when laminar [m^2/s^3]
    double time{0};                               ///< [s]
    std::int64_t step{0};                         ///< taken so far [-]
    double last_step{0};                          ///< dt of the last step [s]
    WaterBooks water;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("grid.fraction", self.fraction);
        visit("grid.velocity_x", self.velocity[0]);
        visit("grid.velocity_y", self.velocity[1]);
        visit("grid.velocity_z", self.velocity[2]);
        visit("grid.pressure", self.pressure);
        visit("grid.turbulent_energy", self.turbulent_energy);
        visit("grid.dissipation_rate", self.dissipation_rate);
        visit("grid.time", self.time);
        visit("grid.step", self.step);
        visit("grid.last_step", self.last_step);
        WaterBooks::visit_fields(self.water, visit);
    }
};

}  // namespace riprap::fluid::grid
