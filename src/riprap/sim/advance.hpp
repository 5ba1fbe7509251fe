// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <string>

#include "riprap/coupling/fluid_loads.hpp"
#include "riprap/coupling/fluid_step.hpp"
#include "riprap/sim/ledger.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"
#include "riprap/sim/time_step.hpp"
#include "riprap/solid/explicit_dem.hpp"

namespace riprap::sim {

struct ScratchData;

/// Buffers kept only for speed. A fresh Scratch gives the same bits as an old one.
class Scratch {
 public:
    Scratch();
    ~Scratch();
    Scratch(Scratch&&) noexcept;
    Scratch& operator=(Scratch&&) noexcept;
    ScratchData& data() { return *data_; }
    const ScratchData& data() const { return *data_; }
    /// Sum of contact forces and of their moments about the centre of mass on every body in the last step [N, N m].
    const std::vector<Vec3>& contact_force() const;
    const std::vector<Vec3>& contact_torque() const;
    const body::Loads& contact_loads() const;
    /// Forces of the fluid on every body in the last step, and their moments about the centre of mass, pressure and
    /// viscosity apart; empty without a fluid.
    const coupling::FluidLoads& fluid_loads() const;
    /// Drops everything but the stage times: for after a step that was refused.
    void forget();

 private:
    std::unique_ptr<ScratchData> data_;
};

/// Seconds spent in each stage since the Scratch was made.
struct StageTimes {
    double find_pairs{0}, find_contacts{0}, contact_loads{0}, move_bodies{0}, fluid{0}, measure{0};
};

/// Reason why a step could not be accepted; `text` empty = all is well.
struct StepStatus {
    std::string text;    ///< quantity, body and time, e.g. "speed of block[3] is 2.1e6 m/s at t = 0.01 s"
    std::string remedy;  ///< what to change in the case, where that follows from the reason; else empty
    bool ok() const { return text.empty(); }
    /// The text, and after a semicolon the remedy where there is one.
    std::string with_remedy() const { return remedy.empty() ? text : text + "; " + remedy; }
};

/// Report of one step.
struct StepReport {
    StepStatus status;
    Ledger ledger;            ///< complete where Measure asks for it
    double dt{0};             ///< [s]
    double dt_bound{0};       ///< step that the contacts as they are now allow [s]; infinity without contacts
    double max_speed{0};      ///< [m/s]
    double max_potential{0};  ///< deepest normalised overlap [-]
    double max_depth{0};      ///< [m]
    std::int64_t contact_count{0};
    std::int64_t open_frictions{0};  ///< sliding contacts whose friction was still changing as the iteration ended
    std::int64_t pair_count{0};      ///< candidates in the pair cache: Scratch, no quantity of a record
    bool pairs_rebuilt{false};
    std::int64_t substeps{1};           ///< steps of the solids within this one of the fluid
    std::int64_t fluid_passes{0};       ///< force passes of the fluid: more than one where light bodies need it
    double fluid_residual{0};           ///< of the accelerations of light bodies, over |a| + |g| [-]
    std::int64_t solver_iterations{0};  ///< of the fluid's pressure equation, all passes and spans
    double solver_residual{0};    ///< residual of that equation over its right-hand side, largest of the spans [-]
    bool is_fluid_settled{true};  ///< false where fluid_residual was still too large after the last pass
    double max_fluid_speed{0};    ///< [m/s]
    double fluid_dt_bound{std::numeric_limits<double>::infinity()};  ///< what the fluid allows a step that is fixed [s]
    coupling::ParticleFindings particles;                            ///< of fluids of particles alone
};

using solid::Measure;

/// Takes one step of a scene: any solid method with any fluid method (docs/architecture.md). The fluid goes first, over
/// one span or several, to the loads that it puts on bodies where they will be at mid-step; the bodies follow in one
/// piece or several under those loads, held over the step; then the fluid ends its last span. A piece that a solid
/// method refuses is taken back and cut finer. On failure State may be non-finite: the caller keeps the last good one.
/// The first step of a run measures the energy whatever is asked.
///
/// @param dt     of choose_time_step, or any other [s]
/// @param loads  on the bodies besides contacts, gravity and Model::loads, held over the step; none where there is a
///               fluid
StepReport advance(const Model& model, State& state, Scratch& scratch, double dt, Measure measure = Measure::energy,
                   const body::LoadView& loads = {});

/// Sets driven bodies to their pose and velocity at state.time and starts the ledger. Call once on a fresh State.
void initialise(const Model& model, State& state);

StageTimes stage_times(const Scratch& scratch);

/// Bytes of Model, State and Scratch in all, counted from their arrays as they are: what bodies and particles stand
/// for, and, once steps were taken, all buffers and lists of neighbours. Not in it: the program, the copies of the
/// State that a driver keeps, the buffers of a sort, what is written.
std::size_t memory_bytes(const Model& model, const State& state, const Scratch& scratch);

/// Hash of the final State: equal at any thread count and after restart.
inline std::uint64_t state_hash(const State& state) { return hash_fields(state); }

}  // namespace riprap::sim
