// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/check/check_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "riprap/io/output/output_kinds.hpp"
#include "riprap/run/figures/expects.hpp"
#include "riprap/run/figures/spreads.hpp"
#include "riprap/run/remedy/end_causes.hpp"
#include "riprap/run/remedy/tipping_bias.hpp"
#include "riprap/run/simulate/outputs.hpp"
#include "riprap/scene/warnings/hard_impacts.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/quantity.hpp"
#include "riprap/sim/time_step.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::run {

namespace {

/// Bytes of a number in a table, separator included.
constexpr double bytes_per_number = 19;

/// Bytes of the equations of a block, measured where 8000 to 160 000 are solved together.
constexpr std::size_t bytes_per_solved_block = 65'000;

/// Steps of the bodies within one of the water above which hardly anything else is computed.
constexpr std::int64_t many_substeps = 1000;

/// Returns the first impact that is certainly too hard for its contact: the estimate errs by less than three times.
std::string certain_crush(const scene::LoadedCase& loaded) {
    constexpr double doubt = 3;
    if (loaded.model.has_fluid()) {
        return "";  // which carries and brakes bodies
    }
    for (const scene::HardImpact& impact : scene::find_hard_impacts(loaded.model, loaded.state)) {
        if (!impact.goes_round && impact.energy > doubt * impact.capacity) {
            return text_of(impact, loaded.model);
        }
    }
    return "";
}

/// True where pressure grows with depth all over a foot, by a stiffness that is a property of the material: the
/// distance potential without corners.
bool has_elastic_feet(const sim::Model& model) {
    const auto* settings = std::get_if<solid::DemSettings>(&model.solid);
    return settings != nullptr && settings->pair_contact == solid::PairContact::distance_potential &&
           (settings->contact.potential != contact::Potential::distance ||
            settings->contact.sides != contact::Sides::both);
}

std::optional<CaseCheck::EarlyTipping> early_tipping_of(const sim::Model& model, const sim::State& state) {
    const std::optional<TippingBias> bias =
        has_elastic_feet(model) ? largest_tipping_bias(model, state) : std::optional<TippingBias>();
    if (!bias) {
        return {};
    }
    constexpr double degree = M_PI / 180;
    const MaterialId material = model.bodies.material[static_cast<std::size_t>(bias->body.value)];
    return CaseCheck::EarlyTipping{model.bodies.name(bias->body),
                                   bias->above,
                                   bias->rigid / degree,
                                   bias->elastic / degree,
                                   bias->factor * model.materials[material].normal_stiffness,
                                   sim::solids_that_tip_about_edges(model),
                                   bias->lean / degree};
}

/// Predicts what contacts will do, and warns where that is much.
void predict_contacts(const scene::LoadedCase& loaded, CaseCheck& check) {
    const sim::Model& model = loaded.model;
    check.tipping = early_tipping_of(model, loaded.state);
    if (const auto found = largest_overlap(model, loaded.state)) {
        check.overlap = CaseCheck::Overlap{model.bodies.name(found->body), model.bodies.name(found->other), *found};
    }
    if (const auto found = shortest_impact(model, loaded.state)) {
        check.impact = CaseCheck::Impact{model.bodies.name(found->body), model.bodies.name(found->other), *found};
    }
    if (check.tipping && check.tipping->rigid - check.tipping->elastic > early_tipping &&
        check.tipping->lean > leans * check.tipping->elastic) {
        check.warnings.push_back(text_of(*check.tipping));
    }
    // Reading warns of impacts that a contact of the distance potential cannot hold at all.
    const bool is_told = sim::tells_depth(model) && check.overlap && check.overlap->found.is_impact &&
                         check.overlap->found.share > solid::most_overlap;
    if (check.overlap && check.overlap->found.share > large_overlap && !is_told) {
        check.warnings.push_back(text_of(*check.overlap));
    }
    if (check.impact && check.impact->found.back < least_back) {
        check.warnings.push_back(text_of(*check.impact));
    }
}

}  // namespace

CaseCheck check_case(const scene::LoadedCase& loaded) {
    const sim::Model& model = loaded.model;
    const ExpectWatch watch(model);
    sim::State first_state = loaded.state;
    sim::initialise(model, first_state);  // driven bodies move from the start
    const sim::TimeStepBound bound = sim::time_step_bound(model, first_state);
    CaseCheck check;
    check.title = model.title;
    check.bodies = model.bodies.size();
    check.parts = model.bodies.part_count();
    check.shapes = model.shapes.size();
    check.is_planar = model.bodies.is_planar;
    sim::Scratch scratch;
    const sim::TimeStep first = full_time_step(model, first_state, scratch);
    check.time_step = first.dt;
    const sim::TimeStepBound step = sim::step_bound(model, first_state);
    check.time_step_limit = step.limit;
    check.limited_by = step.reason;
    check.end = model.time.end;
    check.warnings = loaded.warnings;
    check.notes = loaded.notes;
    check.waves = loaded.waves;
    check.sides = sim::absorbed_ranges(model);
    for (const Spread& spread : spreads_of(loaded)) {
        check.spreads.push_back(text_of(spread));
    }
    for (std::int32_t i = 0; i < model.bodies.size(); ++i) {
        if (model.bodies.drive[static_cast<std::size_t>(i)] == body::Drive::free) {
            check.free_bodies += 1;
            check.mass += model.bodies.mass[static_cast<std::size_t>(i)];
        }
    }
    predict_contacts(loaded, check);
    if (model.particles() != nullptr) {
        check.particles = loaded.state.fluid.size();
        check.samples = model.particles()->samples.size();
        check.water_mass = static_cast<double>(check.particles) * model.particles()->settings().particle_mass;
        check.filled_volume = model.particles()->filled_volume;
        check.trimmed_volume = model.particles()->region_volume - model.particles()->filled_volume;
        check.narrow_volume = model.particles()->region_volume - model.particles()->reached_volume;
        check.sound_speed = model.particles()->settings().sound_speed;
        check.sound_speed_reason = model.particles()->sound_speed_reason;
        check.gaps = scene::find_narrow_gaps(model, loaded.state);
        if (check.gaps.pairs > 0) {
            check.beside_gap = {model.bodies.name(check.gaps.a), model.bodies.name(check.gaps.b)};
        }
        for (const fluid::Gauge& gauge : model.output.gauges) {
            if (gauge.face >= 0) {
                const coupling::FaceGauge& face = model.output.faces[static_cast<std::size_t>(gauge.face)];
                const Quat& turn = loaded.state.bodies.orientation[static_cast<std::size_t>(face.body.value)];
                check.face_gauges.push_back({gauge.name, model.bodies.name(face.body), rotate(turn, face.normal)});
            }
        }
    }
    check.steps = model.time.max_steps >= 0 ? std::min(first.steps_left, model.time.max_steps) : first.steps_left;
    if (!check.has_countable_steps()) {
        check.warnings.push_back(fmt::format(
            "about {:.2g} steps: no machine gets to the end; is `end` in the right unit?", check.estimated_steps()));
    }

    if (check.time_step > check.time_step_limit) {
        check.warnings.push_back(fmt::format("the forced step is {:.3g} times what is stable ({})",
                                             check.time_step / check.time_step_limit, check.limited_by));
    }

    const sim::State initial = first_state;
    sim::State state = initial;
    check.is_tried = !bound.is_wanted || check.bodies <= most_solved_by_check;
    const sim::StepReport report = check.is_tried ? advance(model, state, scratch, check.time_step) : sim::StepReport{};
    check.refusal = report.status.ok()
                        ? certain_crush(loaded)
                        : with_advice({model, initial, state, scratch, report, report.status}).with_remedy();
    check.substeps = report.substeps;
    if (report.substeps > 1) {
        check.substeps_reason = bound.reason;
        check.substep = sim::largest_time_step(model, bound);
    }
    if (report.substeps > many_substeps) {
        check.warnings.push_back(fmt::format(
            "bodies take {} steps within one of the water ({}): contacts that are so stiff cost most of the time",
            report.substeps, bound.reason));
    }
    check.contacts = report.contact_count;
    check.max_overlap = report.max_depth;
    check.max_potential = report.max_potential;
    check.memory_bytes = sim::memory_bytes(model, state, scratch);
    if (!check.is_tried) {
        check.memory_bytes += static_cast<std::size_t>(check.bodies) * bytes_per_solved_block;
        check.warnings.push_back(
            fmt::format("the first step of {} bodies is not tried: it solves equations for all of them, which takes "
                        "minutes and about {}",
                        check.bodies, size_text(static_cast<double>(check.memory_bytes))));
    }

    const auto times = [&](double interval) {
        const auto steps = static_cast<double>(check.steps);
        const double count = due_count(interval, check.time_step, steps);
        const bool is_end_due = steps == 0 || count > due_count(interval, check.time_step, steps - 1);
        return count + (is_end_due ? 0 : 1);
    };
    bool has_frames = false;
    double frame_bytes = 0;
    io::for_each_output(*loaded.outputs, [&](const auto& output) {
        has_frames = has_frames || output.has_frames();
        frame_bytes += output.frame_bytes({model, initial, state, &scratch, &report});
    });
    check.frames = has_frames ? static_cast<std::int64_t>(times(frame_interval(model))) : 0;
    const auto columns = static_cast<double>(io::scene_columns(model).size() + sim::record_columns(model).size());
    check.output_bytes = static_cast<std::size_t>(static_cast<double>(check.frames) * frame_bytes +
                                                  times(row_interval(model)) * columns * bytes_per_number);
    return check;
}

}  // namespace riprap::run
