// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "riprap/io/output/output_kinds.hpp"
#include "riprap/sim/ledger_account.hpp"
#include "riprap/sim/ledger_table.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::run {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const io::Checkpoint& checkpoint, const std::string& why) {
    throw CheckpointError("checkpoint '" + checkpoint.name() + "': " + why);
}

void check_contacts(const io::Checkpoint& checkpoint, const sim::Model& model, const contact::ContactHistory& history) {
    const std::size_t count = history.size();
    if (history.feature.size() != count || history.normal.size() != count || history.shear_force.size() != count ||
        history.torsion.size() != count || history.shear_energy.size() != count || history.anchor.size() != count) {
        refuse(checkpoint, "the arrays of the contact history differ in length");
    }
    const auto part_count = static_cast<std::uint64_t>(model.bodies.part_count());
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t a = history.pair[i] >> 32U, b = history.pair[i] & 0xFFFFFFFFU;
        if (a >= b || b >= part_count) {
            refuse(checkpoint, fmt::format("contact {} is between parts {} and {} of {}", i, a, b, part_count));
        }
        if (i > 0 &&
            std::pair(history.pair[i - 1], history.feature[i - 1]) >= std::pair(history.pair[i], history.feature[i])) {
            refuse(checkpoint, fmt::format("contact {} is out of order", i));
        }
    }
}

/// The fields of the solid method are of the bodies of the case.
void check_solid_fields(const io::Checkpoint& checkpoint, const sim::Model& model, const sim::State& state) {
    const std::string misfit = sim::misfit_of_fields(model, state);
    if (!misfit.empty()) {
        refuse(checkpoint, misfit);
    }
}

void check_near_samples(const io::Checkpoint& checkpoint, const sim::Model& model,
                        const coupling::CouplingState& coupling) {
    const std::vector<std::int32_t>& near = coupling.near_samples;
    const std::int64_t count = model.particles() != nullptr ? model.particles()->samples.size() : 0;
    const bool is_rising = std::adjacent_find(near.begin(), near.end(), std::greater_equal<>()) == near.end();
    if (!is_rising || (!near.empty() && (near.front() < 0 || near.back() >= count))) {
        refuse(checkpoint, fmt::format("the samples of walls in reach of the water are not among the {} of the case in "
                                       "rising order",
                                       count));
    }
}

void check_orientations(const io::Checkpoint& checkpoint, const sim::State& state) {
    constexpr double tolerance = 1e-6;  // the integrator keeps unit quaternions to round-off
    for (std::size_t i = 0; i < state.bodies.orientation.size(); ++i) {
        const Quat& q = state.bodies.orientation[i];
        if (std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) > tolerance) {
            refuse(checkpoint, fmt::format("the orientation of body {} is not a rotation", i));
        }
    }
}

void check_record(const io::Checkpoint& checkpoint, const sim::Model& model, const RunRecord& record) {
    if (!(record.end > 0) || !std::isfinite(record.end)) {
        refuse(checkpoint, "the end of the run is not a positive number");
    }
    if (!(record.frame_interval > 0) || !(record.row_interval > 0) || record.next_frame < 0 || record.next_row < 0) {
        refuse(checkpoint, "an interval between outputs is not positive, or the next output is before time 0");
    }
    if (!(record.approached >= 0) || !(record.told_excess >= 0)) {
        refuse(checkpoint, "what the verdicts remember is below zero or not a number");
    }
    if (!record.deep.fits(model)) {
        refuse(checkpoint, "the pairs that are deep in each other do not belong to this case");
    }
    const auto is_length = [](double dt) { return dt > 0 && std::isfinite(dt); };
    if (!std::all_of(record.good.steps().begin(), record.good.steps().end(), is_length)) {
        refuse(checkpoint, "a step since the last judgement has no length");
    }
    if (record.csv_bytes.empty() || record.csv_bytes.size() > io::output_table_count()) {
        refuse(checkpoint, "the lengths of the tables are missing");
    }
}

/// Water that comes and goes has no length that is known beforehand, but its fields agree.
/// @param most  particles that there may be
void check_openings(const io::Checkpoint& checkpoint, const coupling::ParticleFluid& model, const sim::State& state,
                    std::int64_t most) {
    const fluid::ParticleState& water = state.fluid;
    const fluid::OpenState& open = state.open;
    const std::size_t count = water.position.size(), layers = open.position.size();
    const auto outflows = static_cast<std::int32_t>(model.open.outflows.size());
    if (water.velocity.size() != count || water.density.size() != count || water.dilution.size() != count ||
        (!water.shift.empty() && water.shift.size() != count) ||
        (!water.damping.empty() && water.damping.size() != count) || water.id.size() != count ||
        open.velocity.size() != layers || open.outflow.size() != layers || static_cast<std::int64_t>(count) > most) {
        refuse(checkpoint, "the fields of the water differ in length");
    }
    const fluid::FlowClock& flow = water.flow;
    const std::size_t frozen = flow.place.size();
    if ((frozen != 0 && frozen != count) || flow.velocity.size() != frozen || flow.density.size() != frozen ||
        flow.done < 0 || flow.steps < flow.done || (flow.is_under_way() && frozen != count)) {
        refuse(checkpoint, "the flow step of the water has other particles, or is over before it began");
    }
    const auto is_negative = [](std::int64_t n) { return n < 0; };
    for (const auto* counts : {&open.layers, &open.entered, &open.left}) {
        if (std::any_of(counts->begin(), counts->end(), is_negative)) {
            refuse(checkpoint, "an opening has counted less than nothing");
        }
    }
    if (open.next_id < static_cast<std::int64_t>(count) || open.next_id > std::numeric_limits<std::int32_t>::max()) {
        refuse(checkpoint,
               fmt::format("the next particle has the number {}, of {} that are there", open.next_id, count));
    }
    if (std::any_of(open.outflow.begin(), open.outflow.end(), [&](auto k) { return k < 0 || k >= outflows; })) {
        refuse(checkpoint, "water lies in an outflow that is not there");
    }
}

/// The sections of the last State that was judged begin with this.
constexpr std::string_view good_prefix = "judged.";

/// A State from the sections whose names begin with `prefix`. @throws CheckpointError
sim::State restore_state(const io::Checkpoint& checkpoint, const sim::Model& model, const sim::State& initial,
                         std::string_view prefix) {
    sim::State state = initial;
    const coupling::ParticleFluid* const water = model.particles();
    const bool is_open = water != nullptr;  // what splashes out of the domain is let go
    const auto has_fixed_length = [is_open](std::string_view name) {
        return name.starts_with("body.") ||
               (!is_open && name.starts_with("fluid.") && name != "fluid.shift" && name != "fluid.damping" &&
                !name.starts_with("fluid.flow_")) ||
               (name.starts_with("coupling.") && name != "coupling.near_samples") || name == "open.layers" ||
               name == "open.entered" || name == "open.left";
    };
    io::restore(checkpoint, state, has_fixed_length, prefix);
    if (checkpoint.is_old()) {  // walls may have other samples by now: those near are found anew
        state.coupling.near_samples.clear();
        state.coupling.near_travel = sim::State{}.coupling.near_travel;
    }
    if (!take_up_old_totals(accounts_of(model), state.ledger)) {
        refuse(checkpoint, fmt::format("section '{}ledger.totals' has {} entries, the case needs {}", prefix,
                                       state.ledger.totals.size(), initial.ledger.totals.size()));
    }
    const NonFinite wrong = find_non_finite(state);
    if (!wrong.name.empty()) {
        refuse(checkpoint, fmt::format("{}{}[{}] is not a finite number", prefix, wrong.name, wrong.entry));
    }
    const std::size_t shown = state.gauges.shown.size();
    if (shown != 0 && shown != 3 * model.output.gauges.size()) {
        refuse(checkpoint, fmt::format("section '{}gauges.shown' has {} entries, the case has {} gauges", prefix, shown,
                                       model.output.gauges.size()));
    }
    if (state.step < 0 || state.time < 0) {
        refuse(checkpoint, "time or step is negative");
    }
    const sim::StepControl& stepping = state.stepping;
    if (stepping.halvings < 0 || stepping.halvings > sim::max_halvings || stepping.accepted < 0) {
        refuse(checkpoint, fmt::format("the time step is halved {} times, {} steps ago; allowed: 0 to {} times",
                                       stepping.halvings, stepping.accepted, sim::max_halvings));
    }
    check_near_samples(checkpoint, model, state.coupling);
    if (is_open) {
        check_openings(checkpoint, *water, state,
                       water->open.empty() ? initial.fluid.size() : water->open.most_particles);
    }
    check_contacts(checkpoint, model, state.contacts);
    check_solid_fields(checkpoint, model, state);
    check_orientations(checkpoint, state);
    return state;
}

/// One checkpoint file, or the reason why it cannot be used.
struct Attempt {
    std::optional<Restart> restart;
    std::string reason;
};

Attempt try_checkpoint(const fs::path& path, const sim::Model& model, const sim::State& initial) {
    std::error_code unknown;  // what cannot even be looked at is read, and that says why
    if (!fs::exists(path, unknown) && !unknown) {
        return {std::nullopt, fmt::format("'{}' is missing", path.string())};
    }
    try {
        const io::Checkpoint checkpoint = io::Checkpoint::read(path);
        // An older version resolves the same case to other defaults, so its hash says nothing.
        if (checkpoint.is_old() || checkpoint.header().case_hash == model.case_hash) {
            return {restore_checkpoint(checkpoint, model, initial), {}};
        }
    } catch (const CheckpointError& error) {
        return {std::nullopt, error.what()};
    } catch (const FileError& error) {  // a bad sector, say
        return {std::nullopt, error.what()};
    }
    throw CheckpointError("checkpoint '" + path.string() +
                          "' belongs to another case; start this one with --force or in another folder with --out");
}

}  // namespace

void save_checkpoint(const RunFolder& folder, const sim::Model& model, const sim::State& state,
                     const RunRecord& record) {
    std::vector<io::Section> sections;
    std::deque<std::string> names;
    append_sections(state, sections);
    append_sections(record, sections);
    if (!record.good.steps().empty()) {
        append_sections(record.good.last().state, good_prefix, names, sections);
        append_sections(record.good.last(), good_prefix, names, sections);
    }
    io::write_sections(folder.checkpoint_latest(), {model.case_hash, state.step, state.time}, sections,
                       folder.checkpoint_previous());
}

Restart restore_checkpoint(const io::Checkpoint& checkpoint, const sim::Model& model, const sim::State& initial) {
    Restart restart{
        restore_state(checkpoint, model, initial, {}), {}, {}, checkpoint.header().case_hash != model.case_hash};
    restart.is_of_older_version = checkpoint.is_old();
    if (checkpoint.is_old()) {
        restart.notice = fmt::format(
            "checkpoint '{}' is of {}: the run goes on by the rules and defaults of this version, so its bits are not "
            "those that the other would have given",
            checkpoint.name(), io::writer_of(checkpoint.version()));
    }
    const auto any_length = [](std::string_view) { return false; };
    io::restore(checkpoint, restart.record, any_length);
    check_record(checkpoint, model, restart.record);
    const std::vector<double>& steps = restart.record.good.steps();
    if (!steps.empty()) {
        Standing good{restore_state(checkpoint, model, initial, good_prefix), {}, {}};
        io::restore(checkpoint, good, any_length, good_prefix);
        if (good.state.step + static_cast<std::int64_t>(steps.size()) != restart.state.step) {
            refuse(checkpoint, fmt::format("{} steps lie between step {}, which was judged, and step {}", steps.size(),
                                           good.state.step, restart.state.step));
        }
        restart.record.good.put_back(std::move(good));
    }
    return restart;
}

Restart load_checkpoint(const RunFolder& folder, const sim::Model& model, const sim::State& initial) {
    Attempt latest = try_checkpoint(folder.checkpoint_latest(), model, initial);
    if (latest.restart) {
        return std::move(*latest.restart);
    }
    Attempt previous = try_checkpoint(folder.checkpoint_previous(), model, initial);
    if (!previous.restart) {
        throw CheckpointError(latest.reason + "; " + previous.reason +
                              "; there is nothing to continue from, start again with --force");
    }
    std::error_code is_gone;
    fs::rename(folder.checkpoint_latest(), folder.checkpoint_damaged(), is_gone);
    if (is_gone && is_gone != std::errc::no_such_file_or_directory) {
        throw io::file_error("put aside", folder.checkpoint_latest(), is_gone.value());
    }
    const std::string upgrade = previous.restart->notice;
    previous.restart->notice = fmt::format("{}; continuing from the checkpoint before, at step {}{}{}", latest.reason,
                                           previous.restart->state.step, upgrade.empty() ? "" : "; ", upgrade);
    return std::move(*previous.restart);
}

}  // namespace riprap::run
