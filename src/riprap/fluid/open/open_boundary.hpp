// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"

namespace riprap::fluid {

// Where water enters and leaves. Behind each opening lie layers of particles as deep as a support, which the fluid sees
// as boundary particles that move, so pressure at the opening is that of the water in front of it unless the case gives
// it. A layer of an inflow that has come to its plane becomes water; water that has passed the plane of an outflow
// becomes part of its layers, or is gone where it has none. Every particle in or out is counted. Momentum and energy go
// with it, and the boundary particles do the work of the pressure (docs/theory/sph.md, "Open boundaries").

/// A rectangle across an axis: a line in two dimensions.
struct Opening {
    std::string name;
    Vec3 low{}, high{};  ///< corners; equal along `axis` [m]
    int axis{0};
    double way{1};  ///< +1 where water flows along the axis, -1 where against it

    Vec3 direction() const {
        Vec3 d{};
        d[axis] = way;
        return d;
    }
    /// Signed distance past the plane, along the flow [m].
    double past(const Vec3& x) const { return way * (x[axis] - low[axis]); }
    bool is_across(const Vec3& x, int dimension) const;
};

/// Water that enters at a given speed, which grows over `ramp` as (1 - cos(pi t/ramp))/2.
struct Inflow {
    Opening opening;
    double speed{0};         ///< [m/s]
    double ramp{0};          ///< [s]
    std::vector<Vec3> rows;  ///< where particles pass the plane [m]

    double speed_at(double time) const;
    double acceleration_at(double time) const;
    /// Length of the water that has come in by then [m].
    double distance_at(double time) const;
};

/// Condition at an outflow.
enum class OutflowKind : std::uint8_t {
    free,   ///< nothing: it is gone. For water that falls or runs faster than its waves
    speed,  ///< it is drawn off at a given speed
    level,  ///< still water of a given level: its pressure; layers go with the water
};

struct Outflow {
    Opening opening;
    OutflowKind kind{OutflowKind::free};
    double speed{0};    ///< [m/s]
    double level{0};    ///< height of the surface along `up` from the origin [m]
    Vec3 up{0, 0, 1};   ///< against gravity [-]
    double gravity{0};  ///< [m/s^2]
};

/// Model.
struct OpenBoundaries {
    std::vector<Inflow> inflows;
    std::vector<Outflow> outflows;
    std::int64_t most_particles{0};  ///< more than that end the run

    bool empty() const { return inflows.empty() && outflows.empty(); }
};

/// State of the openings.
struct OpenState {
    std::vector<std::int64_t> layers;   ///< that have entered, per inflow
    std::vector<std::int64_t> entered;  ///< particles, per inflow
    std::vector<std::int64_t> left;     ///< particles, per outflow, then back through each inflow
    std::int64_t next_id{0};            ///< of the next particle that enters
    std::vector<Vec3> position;         ///< of particles in the layers of outflows [m]
    std::vector<Vec3> velocity;         ///< [m/s]
    std::vector<std::int32_t> outflow;  ///< which one each is in

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("open.layers", self.layers);
        visit("open.entered", self.entered);
        visit("open.left", self.left);
        visit("open.next_id", self.next_id);
        visit("open.position", self.position);
        visit("open.velocity", self.velocity);
        visit("open.outflow", self.outflow);
    }
};

/// Water that passed the openings in one step: positive into the domain.
struct Passage {
    std::int64_t entered{0}, left{0};  ///< particles
    double energy{0};                  ///< kinetic, potential and internal [J]
    Vec3 momentum{};                   ///< [kg m/s]
    std::string problem;               ///< why there can be no more particles
    std::string remedy;                ///< what to change in the case, where that follows from the problem
};

/// The opening whose layers x lies among: that of an inflow, or of an outflow that has layers; nullptr where there is
/// none.
const Opening* opening_with_layers_at(const OpenBoundaries& open, const ParticleSettings& settings, const Vec3& x);

/// The places of an opening at which rows of particles pass: a lattice from its low corner on, below `level` along
/// `up`.
std::vector<Vec3> rows_of(const Opening& opening, const ParticleSettings& settings, const Vec3& up, double level);

/// Starts the State of the openings for water that is already there: behind an outflow of a given speed or level it
/// goes on as its mirror image, so that it does not begin with a free surface.
void start_openings(const OpenBoundaries& open, const ParticleSettings& settings, const ParticleState& water,
                    OpenState& state);

/// Appends all layers to `walls`, which hold those of solids: as they are at `time`, `ahead` seconds after the State.
/// Called for two times of a step with as many entries both times.
void place_openings(const OpenBoundaries& open, const OpenState& state, const ParticleSettings& settings, double time,
                    double ahead, BoundaryParticles& walls);

/// Ends a step of length `dt` at `time`: layers move on; water passes in, in the order of inflows and rows, with the
/// density of the pressure that its boundary particles had; water passes out in the order of the State.
/// @param first    index in `walls` of the first entry of place_openings
/// @param gravity  without its components along periodic axes [m/s^2]
Passage pass_openings(const OpenBoundaries& open, const ParticleSettings& settings, const BoundaryParticles& walls,
                      std::size_t first, const Vec3& gravity, double time, double dt, OpenState& state,
                      ParticleState& water);

/// Power of the water on the layers of openings, from entry `first` on [W].
double power_on_openings(const BoundaryParticles& walls, std::size_t first);

}  // namespace riprap::fluid
