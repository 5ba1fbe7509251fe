// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/check_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string_view>

#include "riprap/core/tint.hpp"
#include "riprap/coupling/grid_fluid/grid_parts.hpp"
#include "riprap/io/fluid_frame.hpp"
#include "riprap/io/scene_frame.hpp"
#include "riprap/run/expects.hpp"
#include "riprap/run/outputs.hpp"
#include "riprap/run/tipping_bias.hpp"
#include "riprap/scene/warnings/hard_impacts.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/quantity.hpp"
#include "riprap/sim/shown.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::run {

namespace {

/// Bytes of a number in a table, separator included.
constexpr double bytes_per_number = 19;

/// More steps than this take years: a slip in `end` or in a unit. Also below 2^53, so that steps still count exactly.
constexpr std::int64_t plausible_steps = 1'000'000'000'000;

/// Water as it will be: a lattice at rest is packed into much less than particles that have moved.
fluid::ParticleState stirred(const fluid::ParticleSettings& settings, fluid::ParticleState water) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share(-1, 1);
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        for (int axis = 0; axis < settings.domain.dimension; ++axis) {
            water.position[i][axis] += 0.2 * settings.spacing * share(random);
            water.velocity[i][axis] = 0.1 * settings.sound_speed * share(random);
        }
        water.density[i] = settings.rest_density * (1 + 0.01 * share(random));
    }
    return water;
}

double predicted_frame_bytes(const sim::Model& model, const sim::State& initial, const sim::State& state,
                             const sim::Scratch& scratch) {
    if (!model.output.vtk) {
        return 0;
    }
    const std::vector<io::DrawnPlane> planes = io::draw_planes(model, initial);
    const io::PolyData bodies = io::draw_bodies(model, initial, state, planes, scratch.contact_force());
    double bytes = static_cast<double>(io::encode_vtp(bodies, 0).size());
    if (model.particles() != nullptr) {
        io::put_fluid([&bytes](std::string_view piece) { bytes += static_cast<double>(piece.size()); },
                      model.particles()->settings(), stirred(model.particles()->settings(), state.fluid), 0);
    }
    if (model.output.contacts) {
        bytes +=
            static_cast<double>(io::encode_vtp(io::draw_contacts(shown_contacts(model, state, scratch)), 0).size());
    }
    return bytes;
}

bool has_countable_steps(const CaseCheck& check) { return check.steps <= plausible_steps; }

/// Steps where there are too many for an integer, which is then saturated.
double estimated_steps(const CaseCheck& check) {
    constexpr std::int64_t saturated = 1'000'000'000'000'000'000;
    return check.steps < saturated ? static_cast<double>(check.steps) : check.end / check.time_step;
}

/// Returns the first impact that is certainly too hard for its contact: the estimate errs by less than three times.
std::string certain_crush(const scene::LoadedCase& loaded) {
    constexpr double doubt = 3;
    for (const scene::HardImpact& impact : scene::find_hard_impacts(loaded.model, loaded.state)) {
        if (impact.energy > doubt * impact.capacity) {
            return text_of(impact, loaded.model);
        }
    }
    return "";
}

/// Returns a line on room for water that is not filled, or filled twice over, by a particle or more; empty else.
std::string room_text(const CaseCheck& check) {
    const double room = check.filled_volume + check.trimmed_volume;
    const double particle = check.filled_volume / static_cast<double>(check.particles);
    if (std::abs(check.trimmed_volume) < particle) {
        return {};
    }
    const auto share_text = [&](double volume, const char* what) {
        return std::abs(volume) < particle
                   ? std::string{}
                   : fmt::format("; {:.3g} {} ({:.2g} %) {}", std::abs(volume), check.is_planar ? "m^2" : "m^3",
                                 100 * std::abs(volume) / room, what);
    };
    if (check.trimmed_volume < 0) {
        return share_text(check.trimmed_volume, "more than there is room outside of solids");
    }
    return share_text(check.narrow_volume, "of the room outside of solids is too narrow for particles") +
           share_text(check.trimmed_volume - check.narrow_volume, "of the room outside of solids holds none");
}

/// Names the gaps that are too narrow for water and too wide for a joint.
std::string gaps_text(const CaseCheck& check) {
    const std::string low = fmt::format("{:.3g}", check.gaps.narrowest),
                      high = fmt::format("{:.3g}", check.gaps.widest);
    return fmt::format(
        "'{}' and '{}'{} are {} spacings apart: gaps of 0.25 to 2 spacings admit single particles, whose forces "
        "are noisy",
        check.beside_gap[0], check.beside_gap[1],
        check.gaps.pairs > 1
            ? fmt::format(" and {} more {}", check.gaps.pairs - 1, check.gaps.pairs > 2 ? "pairs" : "pair")
            : "",
        low == high ? low : low + " to " + high);
}

std::optional<CaseCheck::EarlyTipping> early_tipping(const sim::Model& model, const sim::State& state) {
    // The foot is that of overlaps, whose stiffness is a property of the material.
    const std::optional<TippingBias> bias =
        sim::tells_depth(model) ? largest_tipping_bias(model, state) : std::optional<TippingBias>();
    if (!bias) {
        return {};
    }
    constexpr double degree = M_PI / 180;
    const MaterialId material = model.bodies.material[static_cast<std::size_t>(bias->body.value)];
    return CaseCheck::EarlyTipping{model.bodies.name(bias->body), bias->above, bias->rigid / degree,
                                   bias->elastic / degree, bias->factor * model.materials[material].normal_stiffness};
}

/// "column" and 3 above tip 0.85 degrees early ...
std::string tipping_text(const CaseCheck::EarlyTipping& tipping) {
    const std::string who = tipping.above > 0 ? fmt::format("'{}' and the {} above it tip", tipping.body, tipping.above)
                                              : fmt::format("'{}' tips", tipping.body);
    return fmt::format(
        "{} at {:.3g} deg, {:.2g} deg before a rigid body ({:.3g}), as contacts are elastic; for 0.1 deg set "
        "normal_stiffness = {:.2g} Pa",
        who, tipping.elastic, tipping.rigid - tipping.elastic, tipping.rigid, tipping.stiffness);
}

}  // namespace

std::vector<std::string> sides_of(const sim::Model& model) {
    return std::visit(
        [](const auto& settings) {
            if constexpr (requires { absorbed_ranges(settings); }) {
                return absorbed_ranges(settings);
            } else {
                return std::vector<std::string>{};
            }
        },
        model.fluid);
}

std::string size_text(double bytes) {
    constexpr std::array<const char*, 5> units{"B", "kB", "MB", "GB", "TB"};
    std::size_t unit = 0;
    while (bytes >= 1000 && unit + 1 < units.size()) {
        bytes /= 1000;
        ++unit;
    }
    return fmt::format("{:.3g} {}", bytes, units[unit]);
}

CaseCheck check_case(const scene::LoadedCase& loaded) {
    const sim::Model& model = loaded.model;
    const ExpectWatch watch(model);
    sim::State first_state = loaded.state;
    const sim::TimeStepBound bound = sim::time_step_bound(model, first_state);
    CaseCheck check;
    check.title = model.title;
    check.bodies = model.bodies.size();
    check.parts = model.bodies.part_count();
    check.shapes = model.shapes.size();
    check.is_planar = model.bodies.is_planar;
    sim::Scratch scratch;
    const sim::TimeStep first = choose_time_step(model, first_state, scratch);
    check.time_step = first.dt;
    check.time_step_limit = bound.limit;
    check.limited_by = bound.reason;
    check.end = model.time.end;
    check.warnings = loaded.warnings;
    check.notes = loaded.notes;
    check.waves = loaded.waves;
    check.sides = sides_of(model);
    for (std::int32_t i = 0; i < model.bodies.size(); ++i) {
        if (model.bodies.drive[static_cast<std::size_t>(i)] == body::Drive::free) {
            check.free_bodies += 1;
            check.mass += model.bodies.mass[static_cast<std::size_t>(i)];
        }
    }
    check.tipping = early_tipping(model, loaded.state);
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
        const sim::TimeStepBound step = sim::step_bound(model, first_state);
        check.time_step_limit = step.limit;
        check.limited_by = step.reason;
    }
    check.steps = model.time.max_steps >= 0 ? std::min(first.steps_left, model.time.max_steps) : first.steps_left;
    if (!has_countable_steps(check)) {
        check.warnings.push_back(fmt::format(
            "about {:.2g} steps: no machine gets to the end; is `end` in the right unit?", estimated_steps(check)));
    }

    sim::State initial = loaded.state;
    sim::initialise(model, initial);
    sim::State state = initial;
    const sim::StepReport report = advance(model, state, scratch, check.time_step);
    check.refusal = report.status.ok() ? certain_crush(loaded) : report.status.with_remedy();
    check.contacts = report.contact_count;
    check.max_overlap = report.max_depth;
    check.max_potential = report.max_potential;
    check.memory_bytes = sim::memory_bytes(model, state, scratch);

    const auto times = [&](double interval) {
        const auto steps = static_cast<double>(check.steps);
        const double count = due_count(interval, check.time_step, steps);
        const bool is_end_due = steps == 0 || count > due_count(interval, check.time_step, steps - 1);
        return count + (is_end_due ? 0 : 1);
    };
    check.frames = model.output.vtk ? static_cast<std::int64_t>(times(frame_interval(model))) : 0;
    const auto columns = static_cast<double>(scene_columns(model).size() + sim::record_columns(model).size());
    check.output_bytes = static_cast<std::size_t>(static_cast<double>(check.frames) *
                                                      predicted_frame_bytes(model, initial, state, scratch) +
                                                  times(row_interval(model)) * columns * bytes_per_number);
    return check;
}

std::string check_text(const CaseCheck& check, bool is_coloured) {
    const std::string mass_unit = sim::unit_in("kg", check.is_planar);
    std::string text = fmt::format(
        "{}\n  bodies        {} ({} free, {:.6g} {}), {} convex parts, {} shapes\n"
        "  time step     {:.6g} s, at most {:.6g} s ({})\n  steps         {} to t = {:.6g} s\n"
        "  at time 0     {} contact{}, deepest overlap {:.3g} m ({:.2g} % of the inscribed radius)\n"
        "  memory        {}\n  output        {} in {} frames and the tables\n",
        check.title.empty() ? "(untitled)" : check.title, check.bodies, check.free_bodies, check.mass, mass_unit,
        check.parts, check.shapes, check.time_step, check.time_step_limit, check.limited_by,
        has_countable_steps(check) ? fmt::format("{}", check.steps)
                                   : fmt::format("about {:.2g}", estimated_steps(check)),
        check.end, check.contacts, check.contacts == 1 ? "" : "s", check.max_overlap, 100 * check.max_potential,
        size_text(static_cast<double>(check.memory_bytes)), size_text(static_cast<double>(check.output_bytes)),
        check.frames);
    if (check.particles > 0) {
        text += fmt::format(
            "  water         {} particles, {:.6g} {}, {} boundary particles{}\n"
            "  sound speed   {:.6g} m/s ({})\n",
            check.particles, check.water_mass, mass_unit, check.samples, room_text(check), check.sound_speed,
            check.sound_speed_reason);
    }
    if (check.tipping) {
        text += fmt::format("  tipping       {}\n", tipping_text(*check.tipping));
    }
    if (check.gaps.pairs > 0) {
        text += fmt::format("  gaps          {}\n", gaps_text(check));
    }
    for (const scene::PaddleWave& wave : check.waves) {
        text += fmt::format("  wave          of {}: {}\n", wave.paddle, scene::text_of(wave));
    }
    for (const std::string& side : check.sides) {
        text += fmt::format("  side          {}\n", side);
    }
    for (const CaseCheck::FaceGauge& face : check.face_gauges) {
        text += fmt::format("  gauge         {} in the face of {} towards ({:.3g}, {:.3g}, {:.3g})\n", face.gauge,
                            face.body, face.normal.x, face.normal.y, face.normal.z);
    }
    for (const std::string& note : check.notes) {
        text += "  read          " + note + '\n';
    }
    for (const std::string& warning : check.warnings) {
        text += fmt::format("  {} {}\n", tinted("warning:", Tint::caution, is_coloured), warning);
    }
    return text;
}

std::string check_json(const CaseCheck& check) {
    nlohmann::ordered_json json{{"title", check.title},
                                {"bodies", check.bodies},
                                {"free_bodies", check.free_bodies},
                                {"parts", check.parts},
                                {"shapes", check.shapes},
                                {"is_planar", check.is_planar},
                                {"mass", check.mass},
                                {"particles", check.particles},
                                {"boundary_particles", check.samples},
                                {"water_mass", check.water_mass},
                                {"trimmed_volume", check.trimmed_volume},
                                {"narrow_volume", check.narrow_volume},
                                {"narrow_gaps", check.gaps.pairs},
                                {"sound_speed", check.sound_speed},
                                {"time_step", check.time_step},
                                {"time_step_limit", check.time_step_limit},
                                {"limited_by", check.limited_by},
                                {"end", check.end},
                                {"steps", check.steps},
                                {"frames", check.frames},
                                {"contacts", check.contacts},
                                {"max_overlap", check.max_overlap},
                                {"max_potential", check.max_potential},
                                {"memory_bytes", check.memory_bytes},
                                {"output_bytes", check.output_bytes},
                                {"refusal", check.refusal},
                                {"sides", check.sides},
                                {"notes", check.notes},
                                {"warnings", check.warnings}};
    json["face_gauges"] = nlohmann::ordered_json::array();
    for (const CaseCheck::FaceGauge& face : check.face_gauges) {
        json["face_gauges"].push_back(
            {{"gauge", face.gauge}, {"body", face.body}, {"normal", {face.normal.x, face.normal.y, face.normal.z}}});
    }
    json["tipping"] = nullptr;
    if (check.tipping) {
        json["tipping"] = {{"body", check.tipping->body},
                           {"above", check.tipping->above},
                           {"rigid_slope", check.tipping->rigid},
                           {"elastic_slope", check.tipping->elastic},
                           {"stiffness_for_0.1_deg", check.tipping->stiffness}};
    }
    json["waves"] = nlohmann::ordered_json::array();
    for (const scene::PaddleWave& wave : check.waves) {
        json["waves"].push_back({{"paddle", wave.paddle},
                                 {"kind", scene::text_of(wave.kind)},
                                 {"height", wave.height},
                                 {"depth", wave.depth},
                                 {"period", wave.period},
                                 {"length", wave.length},
                                 {"celerity", wave.celerity},
                                 {"stroke", wave.stroke}});
    }
    if (!has_countable_steps(check)) {
        json["steps"] = estimated_steps(check);
    }
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace riprap::run
