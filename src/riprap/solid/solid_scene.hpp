// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/body/gravity.hpp"
#include "riprap/body/multisphere.hpp"
#include "riprap/body/point_loads.hpp"
#include "riprap/body/supports.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/material/material_set.hpp"
#include "riprap/solid/kick_report.hpp"
#include "riprap/solid/solid_times.hpp"

namespace riprap::solid {

/// Parts of the Model that every solid method reads.
struct SolidScene {
    const geometry::ShapeSet& shapes;
    const material::MaterialSet& materials;
    const body::BodySet& bodies;
    const body::Gravity& gravity;
    std::span<const body::PointLoad> point_loads;
    std::span<const body::FixedPoint> fixed_points{};
    std::span<const body::Bolt> bolts{};
    std::span<const body::GivenSpheres> spheres{};
    double end{0};  ///< of the run [s]
    /// By which strengths in `materials` are divided now; tables made of them are made again where it changes [-]
    double strength_divisor{1};
};

/// Why a method cannot move a scene.
struct SceneProblem {
    BodyId body{};  ///< at fault; invalid: the scene as a whole
    std::string message, allowed;
};

/// Parts of the State that every solid method may change. Methods with fields of their own get them besides.
struct SolidState {
    body::BodyState& bodies;
    contact::ContactHistory& contacts;  ///< of methods whose contacts are between parts
    /// A contact's sliding between two kicks lasts (previous_dt + dt)/2; 0 in the first piece of a run [s]
    double& previous_dt;
};

/// Tells how much of the ledger a step works out. The elastic energy of an overlap is a function of the pose and costs
/// more than its force, so a run asks for it only where a row is written. It changes no bit of the State.
enum class Measure {
    energy,  ///< everything
    flow,    ///< all but the elastic energy and the residual
};

/// Report of a solid method on one piece of a step.
struct SolidReport {
    KickReport kick;      ///< energies, momenta and work of the bodies
    double kick_time{0};  ///< at which the energies hold [s]
    /// Share of the works, losses and impulses of the piece that lies before kick_time: 1/2 where energies hold in the
    /// middle of a piece, 1 where they hold at its end [-].
    double kick_share{0.5};
    Vec3 gravity{};           ///< then [m/s^2]
    bool has_stored{true};    ///< the stored energies were measured
    double elastic{0};        ///< stored in overlaps [J]
    double shear{0};          ///< stored in tangential springs [J]
    double friction_loss{0};  ///< since the last kick [J]
    double damping_loss{0};   ///< of contact dashpots in this piece [J]
    std::vector<double> own;  ///< amounts of the accounts that the method names itself, in their order [J]
    double dt_bound{std::numeric_limits<double>::infinity()};  ///< step that the contacts as they are allow [s]
    double max_potential{0};                                   ///< deepest normalised overlap [-]
    double max_depth{0};                                       ///< [m]
    std::int64_t contact_count{0};
    std::int64_t open_frictions{0};  ///< sliding contacts whose friction was still changing as the iteration ended
    std::int64_t pair_count{0};      ///< candidates in the pair cache: Scratch, no quantity of a record
    bool pairs_rebuilt{false};
};

}  // namespace riprap::solid
