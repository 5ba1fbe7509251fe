// SPDX-License-Identifier: Apache-2.0
// Writes what `riprap check` found, for people and for programs.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "riprap/core/tint.hpp"
#include "riprap/run/check/check_case.hpp"
#include "riprap/run/remedy/remedy_text.hpp"
#include "riprap/sim/quantity.hpp"
#include "riprap/sim/shown.hpp"

namespace riprap::run {

namespace {

/// More steps than this take years: a slip in `end` or in a unit. Also below 2^53, so that steps still count exactly.
constexpr std::int64_t plausible_steps = 1'000'000'000'000;

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

/// What was found at time 0.
std::string start_text(const CaseCheck& check) {
    return check.is_tried ? fmt::format("{} contact{}, deepest overlap {:.3g} m ({:.2g} % of the inscribed radius)",
                                        check.contacts, check.contacts == 1 ? "" : "s", check.max_overlap,
                                        100 * check.max_potential)
                          : "not tried";
}

}  // namespace

/// "column" and 3 above tip 0.85 degrees early ...
std::string text_of(const CaseCheck::EarlyTipping& tipping) {
    const std::string who = tipping.above > 0 ? fmt::format("'{}' and the {} above it tip", tipping.body, tipping.above)
                                              : fmt::format("'{}' tips", tipping.body);
    return fmt::format(
        "{} at {:.3g} deg, {:.2g} deg before a rigid body ({:.3g}), as contacts are elastic; for 0.1 deg set "
        "normal_stiffness = {:.2g} Pa; {} turn blocks about their edges",
        who, tipping.elastic, tipping.rigid - tipping.elastic, tipping.rigid, tipping.stiffness,
        fmt::join(tipping.others, ", "));
}

std::string text_of(const CaseCheck::Overlap& overlap) {
    const PredictedOverlap& found = overlap.found;
    const std::string how =
        found.is_impact
            ? fmt::format("'{}' comes to '{}' with {:.3g} m/s and sinks in", overlap.body, overlap.other, found.speed)
            : fmt::format("'{}' sinks into '{}', on which it stands,", overlap.body, overlap.other);
    return fmt::format(
        "{} by {:.3g} m, {:.2g} % of an inscribed radius{}", how, found.overlap, 100 * found.share,
        found.share > large_overlap ? fmt::format("; {} makes it {:g} %", found.stiffness, 100 * large_overlap) : "");
}

std::string text_of(const CaseCheck::Impact& impact) {
    const ImpactStep& found = impact.found;
    return fmt::format("'{}' comes to '{}' with {:.3g} m/s and goes back with {:.2g} of it, for its step alone{}",
                       impact.body, impact.other, found.speed, found.back,
                       found.back < least_back ? fmt::format("; {} gives back {:g}",
                                                             assignment_below("solid.step", found.step), well_resolved)
                                               : "");
}

bool CaseCheck::has_countable_steps() const { return steps <= plausible_steps; }

double CaseCheck::estimated_steps() const {
    constexpr std::int64_t saturated = 1'000'000'000'000'000'000;
    return steps < saturated ? static_cast<double>(steps) : end / time_step;
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

std::string check_text(const CaseCheck& check, bool is_coloured) {
    const std::string mass_unit = sim::unit_in("kg", check.is_planar);
    std::string text = fmt::format(
        "{}\n  bodies        {} ({} free, {:.6g} {}), {} convex parts, {} shapes\n"
        "  time step     {:.6g} s, at most {:.6g} s ({})\n  steps         {} to t = {:.6g} s\n"
        "  at time 0     {}\n"
        "  memory        {}\n  output        {} in {} frames and the tables\n",
        check.title.empty() ? "(untitled)" : check.title, check.bodies, check.free_bodies, check.mass, mass_unit,
        check.parts, check.shapes, check.time_step, check.time_step_limit, check.limited_by,
        check.has_countable_steps() ? fmt::format("{}", check.steps)
                                    : fmt::format("about {:.2g}", check.estimated_steps()),
        check.end, start_text(check), size_text(static_cast<double>(check.memory_bytes)),
        size_text(static_cast<double>(check.output_bytes)), check.frames);
    if (check.particles > 0) {
        text += fmt::format(
            "  water         {} particles, {:.6g} {}, {} boundary particles{}\n"
            "  sound speed   {:.6g} m/s ({})\n",
            check.particles, check.water_mass, mass_unit, check.samples, room_text(check), check.sound_speed,
            check.sound_speed_reason);
    }
    if (check.substeps > 1) {
        text += fmt::format("  of bodies     {} steps within one of the water, of {:.6g} s or less ({})\n",
                            check.substeps, check.substep, check.substeps_reason);
    }
    if (check.tipping) {
        text += fmt::format("  tipping       {}\n", text_of(*check.tipping));
    }
    if (check.overlap) {
        text += fmt::format("  overlap       {}\n", text_of(*check.overlap));
    }
    if (check.impact) {
        text += fmt::format("  impact        {}\n", text_of(*check.impact));
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
    for (const std::string& spread : check.spreads) {
        text += fmt::format("  ensemble      {}\n", spread);
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
                                {"substeps", check.substeps},
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
                                {"spreads", check.spreads},
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
                           {"stiffness_for_0.1_deg", check.tipping->stiffness},
                           {"without_it", check.tipping->others}};
    }
    json["predicted_overlap"] = nullptr;
    if (check.overlap) {
        json["predicted_overlap"] = {{"body", check.overlap->body},         {"other", check.overlap->other},
                                     {"speed", check.overlap->found.speed}, {"overlap", check.overlap->found.overlap},
                                     {"share", check.overlap->found.share}, {"remedy", check.overlap->found.stiffness}};
    }
    json["impact"] = nullptr;
    if (check.impact) {
        json["impact"] = {{"body", check.impact->body},
                          {"other", check.impact->other},
                          {"speed", check.impact->found.speed},
                          {"share_back", check.impact->found.back},
                          {"step", check.impact->found.step}};
    }
    if (!check.is_tried) {
        for (const char* key : {"contacts", "max_overlap", "max_potential"}) {
            json[key] = nullptr;
        }
    }
    json["waves"] = nlohmann::ordered_json::array();
    for (const scene::PaddleWave& wave : check.waves) {
        json["waves"].push_back({{"paddle", wave.paddle},
                                 {"kind", wave.kind},
                                 {"height", wave.height},
                                 {"depth", wave.depth},
                                 {"period", wave.period},
                                 {"length", wave.length},
                                 {"celerity", wave.celerity},
                                 {"stroke", wave.stroke}});
    }
    if (!check.has_countable_steps()) {
        json["steps"] = check.estimated_steps();
    }
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace riprap::run
