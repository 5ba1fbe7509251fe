// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::validation::zhao {

/// Frictionless row of equal cubes at rest in contact, hit along its axis by one more: the exact law of their flat
/// faces, F(d) = K (d - 2 d^2/a + 4 d^3/(3 a^2)) (docs/theory/distance-potential.md), K the stiffness of the contact
/// [N/m], a the edge.
struct CubeChain {
    int count;                   ///< blocks at rest [-]
    double mass, edge;           ///< of one block [kg], [m]
    double stiffness;            ///< K [N/m]
    double speed;                ///< of the projectile [m/s]
    bool has_edge_effect{true};  ///< false: linear springs
};

struct ChainAnswer {
    double separation_time;  ///< when the last block leaves its neighbour [s]
    double last_speed;       ///< of the last block then [m/s]
};

/// Integrates the chain (classical Runge-Kutta, 1e-4 of sqrt(m/K) per step) until the last block is free.
ChainAnswer solve_chain(const CubeChain& chain);

}  // namespace riprap::validation::zhao
