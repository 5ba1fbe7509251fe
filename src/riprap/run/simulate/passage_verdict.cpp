// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/passage_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/coupling/particle_walls/strays.hpp"
#include "riprap/fluid/open/leaving.hpp"
#include "riprap/scene/warnings/initial_overlaps.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/shown.hpp"
#include "riprap/solid/dem_settings.hpp"
#include "riprap/solid/driven_travel.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::run {

std::string water_passage(const sim::Model& model, const sim::State& state) {
    const coupling::ParticleFluid* const water = model.particles();
    if (water == nullptr) {
        return "";
    }
    const std::int64_t particles = state.fluid.size();
    const coupling::Strays strays = coupling::find_strays(model.shapes, model.bodies, state.bodies, water->is_dry,
                                                          state.fluid.position, water->settings().spacing);
    if (strays.count <= std::max<std::int64_t>(2, particles / 200)) {
        return "";
    }
    return fmt::format(
        "{} of {} particles of water lie more than a spacing deep in solids, the deepest {:.3g} m in {}, "
        "at t = {:.6g} s",
        strays.count, particles, strays.depth, model.bodies.name(strays.body), state.time);
}

sim::StepStatus passed_walls(const sim::Model& model, const sim::State& state, std::int64_t count,
                             const coupling::WallPassages& last) {
    const auto particles = static_cast<double>(state.fluid.size());
    if (last.count == 0 || static_cast<double>(count) <= std::max(2.0, share_through_walls * particles)) {
        return {};
    }
    return {fmt::format("{} of {} particles of water have gone through walls, the last through {}, at t = {:.6g} s",
                        count, state.fluid.size(), model.bodies.name(BodyId{last.body}), state.time),
            "thicker walls, a smaller fluid.spacing, or less force on water that cannot give way"};
}

std::string splash_text(const sim::Model& model, const sim::State& state) {
    if (std::string text = sim::let_go_text(model, state); !text.empty()) {
        return text;
    }
    const coupling::ParticleFluid* const water = model.particles();
    const std::int64_t gone = water != nullptr ? fluid::let_go_so_far(state.open, state.fluid) : 0;
    if (gone <= 0) {
        return "";
    }
    return fmt::format(
        "{} particle{} of water, {:.3g} % of it, left the domain through its top and {} let go: a higher domain keeps "
        "{}",
        gone, gone == 1 ? "" : "s", 100 * static_cast<double>(gone) / static_cast<double>(state.open.next_id),
        gone == 1 ? "was" : "were", gone == 1 ? "it" : "them");
}

namespace {

/// Does every overlap of the method have a contact that tells how deep it is? Points across a common plane, however
/// deep the bodies are, need not lie opposite each other.
bool is_field_deep(const sim::Model& model) {
    const auto* settings = std::get_if<solid::DemSettings>(&model.solid);
    return sim::tells_depth(model) &&
           (settings == nullptr || settings->pair_contact == solid::PairContact::distance_potential);
}

/// The deepest contact, where that is too deep.
std::string crossing_rows(const sim::Model& model, const sim::State& state,
                          const std::vector<contact::ShownContact>& rows) {
    std::size_t deepest = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        deepest = rows[i].potential > rows[deepest].potential ? i : deepest;
    }
    if (rows.empty() || !(rows[deepest].potential > solid::most_overlap)) {
        return "";  // within a step of water it was, and parted again
    }
    const contact::ShownContact& row = rows[deepest];
    return fmt::format(
        "{} and {} are {:.3g} m deep in each other, {:.3g} of an inscribed radius, at ({:.6g}, {:.6g}, "
        "{:.6g}) m, t = {:.6g} s: their contact cannot carry what they bring; allowed: {:.3g}",
        model.bodies.name(row.a), model.bodies.name(row.b), row.overlap, row.potential, row.point.x, row.point.y,
        row.point.z, state.time, solid::most_overlap);
}

/// The first two shapes that lie too deep in each other.
std::string crossing_shapes(const sim::Model& model, const sim::State& state) {
    for (const scene::InitialOverlap& overlap : scene::find_initial_overlaps(model, state, solid::most_overlap)) {
        return fmt::format(
            "{} and {} are {:.3g} m deep in each other, {:.3g} of the smaller inscribed radius, at t = {:.6g} s: their "
            "contact cannot carry what they bring; allowed: {:.3g}",
            model.bodies.name(overlap.a), model.bodies.name(overlap.b), overlap.depth, overlap.share, state.time,
            solid::most_overlap);
    }
    return "";
}

}  // namespace

std::string PassageWatch::look_now(const sim::Model& model, const sim::State& state) {
    return sim::meets_by_shapes(model) ? crossing_shapes(model, state) : "";
}

std::string PassageWatch::look(const sim::Model& model, const sim::State& state, const sim::Scratch& scratch,
                               const sim::StepReport& report, bool is_last) {
    if (sim::tells_depth(model)) {
        std::string problem = look_at_contacts(model, state, scratch, report);
        if (!problem.empty()) {
            return problem;
        }
    }
    if (!sim::meets_by_shapes(model)) {
        return "";
    }
    const double near = solid::most_approach * solid::smallest_radius(model.bodies, model.shapes);
    approached_ += std::max(report.dt * solid::approach_limit(model.bodies, model.shapes, state.bodies),
                            solid::driven_travel(model.bodies, model.shapes, state.time - report.dt, state.time));
    const bool is_held = is_field_deep(model) && model.time.is_automatic();  // by the depth of its contacts
    if (!is_last && (is_held || approached_ < near)) {
        return "";
    }
    approached_ = 0;
    // Spheres that stand for a body let its shape sink into others.
    if (!sim::tells_depth(model) && !std::isfinite(sim::smallest_stand_in(model))) {
        const std::vector<DeepPairs::Meeting> meetings = deep_meetings(model, state);
        if (std::string problem = deep_.look(model, state, meetings); !problem.empty()) {
            return problem;
        }
    }
    return crossing_shapes(model, state);
}

std::string PassageWatch::look_at_contacts(const sim::Model& model, const sim::State& state,
                                           const sim::Scratch& scratch, const sim::StepReport& report) {
    if (!(report.max_potential > deep_overlap)) {
        deep_.clear();
        return "";
    }
    const std::vector<contact::ShownContact> rows = shown_contacts(model, state, scratch);
    std::string passed = deep_.look(model, state, deep_meetings(model, state, rows, report.dt));
    std::string problem = crossing_rows(model, state, rows);
    return problem.empty() ? passed : problem;
}

}  // namespace riprap::run
