// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/particle_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/coupling/particle_walls/closed_pocket.hpp"
#include "riprap/coupling/particle_walls/gauge_edges.hpp"
#include "riprap/coupling/particle_walls/walls.hpp"
#include "riprap/fluid/gauge/particle_reader.hpp"
#include "riprap/fluid/mps/rest_density.hpp"
#include "riprap/fluid/open/leaving.hpp"
#include "riprap/fluid/particle/sort.hpp"
#include "riprap/fluid/schemes.hpp"

namespace riprap::coupling {

ParticleMethod::ParticleMethod(const FluidScene& scene, const Settings& water, const FluidState& state,
                               Fields& /*fields*/, Scratch& scratch)
    : scene_(&scene), water_(&water), state_(state), scratch_(&scratch) {
    if (!scratch.scheme || scratch.made_for != &water) {
        scratch.made_for = &water;
        scratch.scheme = make_scheme(water.scheme);
        scratch.bodies = describe_bodies(scene.bodies, water);
        scratch.corners = find_corners(scene, water, state.bodies);
    }
}

namespace {

/// Completes the State of particles from the id `first` on, which have just been placed.
void begin_particles(const ParticleFluid& water, std::int64_t first, fluid::ParticleState& particles) {
    if (const auto* const mps = std::get_if<fluid::MpsSettings>(&water.scheme)) {
        fluid::mps::begin_with_pressure(*mps, first, particles);
    }
}

}  // namespace

void ParticleMethod::start() {
    start_openings(water_->open, water_->settings(), state_.particles, state_.open);
    begin_particles(*water_, 0, state_.particles);
}

StepLimit ParticleMethod::limit() const {
    const fluid::FluidTimeStep step = scratch_->scheme->limit(state_.particles);
    return {step.limit, false, step.reason};
}

void ParticleMethod::tidy(std::int64_t step) {
    const fluid::ParticleSettings& settings = water_->settings();
    const fluid::FlowClock& flow = state_.particles.flow;
    if (flow.is_under_way()) {
        return;  // its geometry goes by this order
    }
    // The first step behind a multiple of the interval that is not within a flow step.
    if (step % settings.sort_interval < std::max<std::int64_t>(1, flow.steps)) {
        sort_by_place(state_.particles, settings.domain, settings.spacing);
    }
}

void ParticleMethod::drive(const TimeSpan& span, std::vector<Vec3>& correction) {
    std::vector<Vec3>& rate = state_.bodies.drive_rate;
    correction = rate;
    absorb_waves(water_->absorptions, scene_->bodies, span.time, span.dt, water_->settings(), state_.particles,
                 state_.coupling.surge, state_.bodies);
    for (std::size_t b = 0; b < correction.size(); ++b) {
        correction[b] = (rate[b] - correction[b]) / span.dt;
    }
}

namespace {

/// Lets walls move as the water meets them: blocks keep their stretch, but not its rate. They ring with a period of a
/// few steps of the water or less, and what water answers to a velocity that has turned by the end of its step feeds
/// the ringing.
void meet(const body::Motion& motion, ParticleScratch& scratch) {
    scratch.motion = motion;
    scratch.motion.stretch_rate.assign(motion.stretch_rate.size(), {});
}

/// Tells whether all that water meets stands still, for good.
bool stays_as_it_is(const ParticleFluid& water, const WallBodies& bodies) {
    return water.wall == WallTreatment::boundary_particles && water.open.empty() &&
           std::all_of(bodies.is_still.begin(), bodies.is_still.end(), [](std::uint8_t is) { return is != 0; });
}

}  // namespace

Outcome ParticleMethod::begin(const TimeSpan& span, const body::Motion& now, const body::Motion& middle,
                              FluidStep& report) {
    ParticleScratch& scratch = *scratch_;
    found_ = {};

    double since_density = 0.5 * (state_.coupling.previous_dt + span.dt);  // the first density is half a step old
    meet(now, scratch);
    const Vec3 gravity = scene_->gravity.at(span.time);
    const bool has_two_clocks = scratch.scheme->has_two_clocks();
    double lasts = span.dt;
    if (has_two_clocks) {
        take_near_samples(state_.coupling, scratch);  // of the flow step before
        place_walls(*scene_, *water_, state_.open, span.time, 0, scratch);
        lasts = scratch.scheme->renew(state_.particles, scratch.walls, gravity, span,
                                      stays_as_it_is(*water_, scratch.bodies), since_density, found_);
    }
    report.particles.renewals = has_two_clocks && lasts > 0 ? 1 : 0;
    find_near_samples(*scene_, *water_, state_, span.dt, lasts, scratch);
    place_walls(*scene_, *water_, state_.open, span.time, 0, scratch);
    scratch.scheme->update_density(state_.particles, scratch.walls, gravity, since_density, found_);
    fluid::drift(water_->settings(), state_.particles, 0.5 * span.dt);

    meet(middle, scratch);
    place_walls(*scene_, *water_, state_.open, span.middle(), 0.5 * span.dt, scratch);
    scratch.scheme->begin_forces(state_.particles, scratch.walls, span, scene_->gravity.at(span.middle()), found_);
    if (found_.problem.empty()) {
        hold_loads(span);
    }
    return outcome();
}

/// Finds the loads that do not change while accelerations of bodies are iterated: of the guard before faces, and of
/// joints.
void ParticleMethod::hold_loads(const TimeSpan& span) {
    if (water_->wall != WallTreatment::boundary_particles) {
        return;
    }
    ParticleScratch& scratch = *scratch_;
    scratch.penalty.push(scene_->shapes, scene_->bodies, scratch.motion, water_->is_dry,
                         guard_settings(water_->settings(), span.dt), scratch.bodies.guard_share, state_.particles,
                         scratch.extra_force, scratch.held_loads);
    add_joint_loads(*water_, scratch, scene_->gravity.at(span.middle()));
}

void ParticleMethod::load(const TimeSpan& span, const body::Motion& middle, FluidLoads& loads) {
    ParticleScratch& scratch = *scratch_;
    meet(middle, scratch);
    place_walls(*scene_, *water_, state_.open, span.middle(), 0.5 * span.dt, scratch);
    const bool is_penalty = water_->wall == WallTreatment::penalty;
    if (is_penalty) {
        scratch.penalty.push(scene_->shapes, scene_->bodies, scratch.motion, water_->is_dry,
                             penalty_settings(water_->settings(), span.dt), {}, state_.particles, scratch.extra_force,
                             loads);
    }
    scratch.scheme->load_walls(state_.particles, scratch.walls, scene_->gravity.at(span.middle()));
    if (!is_penalty) {
        gather_wall_loads(*scene_, *water_, scratch, loads);
        loads.pressure += scratch.held_loads.pressure;
    }
}

namespace {

/// Account of the book of volume; schemes that count their density, and do not carry it on, have nothing in it.
constexpr Account volume_account(std::string_view name, std::string_view help) {
    return {name, Balance::aside, Booking::since_kick, help, false, "m^3"};
}

}  // namespace

std::span<const Account> ParticleMethod::accounts() {
    static constexpr std::array table{
        Account{"viscous", Balance::lost, Booking::across_kick,
                "by viscosity, the artificial one and the damping of sound with it"},
        Account{"collisions", Balance::lost, Booking::across_kick, "by collisions of particles that come too near",
                true},
        Account{"diffusion", Balance::lost, Booking::since_kick,
                "by the diffusion of density; may be negative for a while, as it is no friction", true},
        Account{"projection", Balance::lost, Booking::across_kick, "by a pressure that is solved for", true},
        Account{"shifting", Balance::lost, Booking::since_kick,
                "potential energy and that of compression that shifting took away", true},
        Account{"wall_exchange", Balance::lost, Booking::across_kick,
                "work of the mirrored wall pressure that no body feels (docs/theory/sph.md, 6)", true},
        Account{"straining", Balance::lost, Booking::across_kick,
                "below zero: work on the strain of blocks, whose rate walls do not have (docs/theory/coupling.md, 2)",
                true},
        Account{"absorbed", Balance::given, Booking::across_kick, "by sponges"},
        Account{"flow_work", Balance::given, Booking::across_kick, "of pressure at inflows and outflows"},
        Account{first_young_account, Balance::lost, Booking::since_kick,
                "compression that surfaces and walls let go where water tears off (docs/theory/sph.md, 4)", true},
        Account{"escape", Balance::lost, Booking::since_kick,
                "sound that leaves water caught between walls (docs/theory/sph.md, 4)", true},
        Account{"return", Balance::lost, Booking::since_kick,
                "by the return of the density to that of the places (docs/theory/wcmps.md, 6)", true},
        volume_account("volume_by_flow", "change of the volume m/rho of water by flow: how far it has spread"),
        volume_account("volume_by_diffusion", "the same by the diffusion of density"),
        volume_account("volume_by_tearing", "the same where surfaces tear; below zero: flow gives as much"),
        volume_account("volume_by_walls", "the same where water leaves walls"),
        volume_account("volume_by_escape", "the same where water is caught between walls"),
        volume_account("volume_by_shifting", "the same by shifting"),
        volume_account("volume_by_return", "the same by the return of the density to that of the places"),
        volume_account("volume_refused", "what shifting left alone, as it would be tension; no part of the sum"),
    };
    return table;
}

Outcome ParticleMethod::kick(const TimeSpan& span, FluidStep& report) {
    ParticleScratch& scratch = *scratch_;
    if (!water_->sponges.empty()) {
        push_sponges(water_->sponges, water_->settings(), state_.particles, span.dt, scratch.extra_force,
                     scratch.sponge);
    }
    scratch.scheme->kick(state_.particles, scratch.walls, scene_->gravity.at(span.middle()), span, scratch.extra_force,
                         found_);
    const double seam_work = span.dt * power_at_seams(*scene_, *water_, scratch);
    found_.work_on_solids += seam_work;  // walls mirrored as much more, which is no loss
    (scratch.scheme->for_bodies() != nullptr ? found_.pressure_loss : found_.wall_exchange) -= seam_work;
    const double joint_work = span.dt * joint_power(scratch);
    found_.work_on_solids += joint_work;  // by water that no particle stands for
    found_.work_external += joint_work;
    const double absorbed = water_->sponges.empty() ? 0 : absorbed_energy(state_.particles, span.dt, scratch.sponge);
    const double flow_work = span.dt * power_on_openings(scratch.walls, scratch.near_numbers.size());
    found_.work_on_solids -= flow_work;  // layers of openings are walls to the scheme, and sponges extra forces
    found_.work_external += absorbed;
    const fluid::FluidReport& of = found_;
    report.balance = of;
    report.own = {of.dissipated_viscous,
                  of.dissipated_collisions,
                  of.by_density.diffusion,
                  of.pressure_loss,
                  of.shifted,
                  of.wall_exchange,
                  0,  // straining: known once the blocks have moved
                  absorbed,
                  flow_work,
                  of.by_density.tearing,
                  of.by_density.escape,
                  of.by_density.returned,
                  of.volume.flow,
                  of.volume.diffusion,
                  of.volume.tearing,
                  of.volume.walls,
                  of.volume.escape,
                  of.volume.shifting,
                  of.volume.returned,
                  of.volume.refused};
    report.earlier = {of.earlier_heat, of.earlier_collisions, 0, 0, 0, of.earlier_exchange};
    report.particles.through_walls = scratch.penalty.passages();
    report.particles.intruder = find_intruder(scene_->bodies, *water_, scratch);
    return outcome();
}

namespace {

/// Counts what leaves through the top of the domain; more than is allowed is a problem. Water whose particles were
/// never counted, as where a test builds it by hand, lets nothing go.
void let_splash_go(const ParticleFluid& fluid, const Vec3& gravity, const TimeSpan& span, const fluid::OpenState& open,
                   fluid::ParticleState& water, fluid::Passage& passage) {
    if (!passage.problem.empty() || open.next_id < water.size()) {
        return;
    }
    const Vec3 pull = without_periodic(gravity, fluid.settings().domain);
    const fluid::Passage gone = fluid::let_go(fluid.settings(), pull, span.dt, water);
    passage.left += gone.left;
    passage.energy += gone.energy;
    passage.momentum += gone.momentum;
    const std::int64_t all = fluid::let_go_so_far(open, water), most = fluid::most_let_go(open);
    if (all > most) {
        passage.problem = fmt::format(
            "{} particles of water have left through the top of the domain by t = {:.6g} s; allowed: {}, {:g} % of "
            "all",
            all, span.end(), most, 100 * fluid::share_let_go);
        passage.remedy = "a higher fluid.domain holds them";
    }
}

}  // namespace

Outcome ParticleMethod::end(const TimeSpan& span, FluidStep& report) {
    ParticleScratch& scratch = *scratch_;
    fluid::drift(water_->settings(), state_.particles, 0.5 * span.dt);
    const double fastest = std::max(found_.max_speed, speed_of_joints(*water_, scratch.bodies.is_loose, scene_->bodies,
                                                                      state_.bodies, scratch.joints));
    state_.coupling.near_travel += 0.5 * span.dt * fastest + found_.max_shift;
    state_.coupling.previous_dt = span.dt;
    fluid::Passage passage;
    if (!water_->open.empty()) {
        const Vec3 gravity = without_periodic(scene_->gravity.at(span.end()), water_->settings().domain);
        const std::int64_t first = state_.open.next_id;
        passage = pass_openings(water_->open, water_->settings(), scratch.walls, scratch.near_numbers.size(), gravity,
                                span.end(), span.dt, state_.open, state_.particles);
        begin_particles(*water_, first, state_.particles);
    }
    let_splash_go(*water_, scene_->gravity.at(span.end()), span, state_.open, state_.particles, passage);
    report.transported = {passage.energy, passage.momentum};
    const bool carries_density = scratch.scheme->for_bodies() == nullptr;
    if (passage.problem.empty() && is_time_to_look(water_->settings(), state_.particles, span, carries_density)) {
        const RoomWalls walls{scene_->shapes, scene_->bodies, water_->is_dry, scratch.motion};
        return {crowded_pocket(walls, water_->settings(), state_.particles, span.end()), 0,
                "a way out for the water, less of it in the pocket at the start, or a motion that ends before"};
    }
    return {passage.problem, 0, passage.remedy};
}

namespace {

/// Particles between walls as gauges read them.
class WalledReader : public fluid::ParticleReader {
 public:
    explicit WalledReader(const GaugeQuery<ParticleMethod>& query)
        : ParticleReader(query.settings.settings(), query.particles), query_(query) {}
    double wall_pressure() const override {
        const ParticleScratch* const scratch = query_.scratch;
        if (query_.face == nullptr || scratch == nullptr || scratch->motion.pose.empty()) {
            return unknown;
        }
        const ParticleFluid& water = query_.settings;
        const fluid::ParticleSettings& settings = water.settings();
        return read_face(
            *query_.face,
            {query_.scene.shapes, query_.scene.bodies, water.is_dry, scratch->motion,
             SampleView(water.samples, scratch->near_numbers), scratch->walls, settings.domain, settings.spacing,
             settings.support_radius(), scratch->penalty.pushes()},
            {water.scheme, query_.particles, in_plane(query_.scene.gravity.at(query_.time), settings.domain)});
    }

 private:
    const GaugeQuery<ParticleMethod>& query_;
};

}  // namespace

fluid::GaugeReading ParticleMethod::read(const GaugeQuery<ParticleMethod>& query) {
    return query.gauge.kind->read(query.gauge, WalledReader(query));
}

}  // namespace riprap::coupling
