// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/summary.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "riprap/run/folder/provenance.hpp"

namespace riprap::run {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }

Json ledger_json(const Summary& summary) {
    const sim::Ledger& ledger = summary.ledger;
    Json json{{"time", ledger.time}};
    for (const Summary::Account& account : summary.accounts) {
        json[account.name] = account.value;
    }
    const Json sums{{"residual", ledger.residual},
                    {"turnover", ledger.turnover},
                    {"momentum", to_json(ledger.momentum)},
                    {"impulse", to_json(ledger.impulse)},
                    {"momentum_residual", to_json(ledger.momentum_residual)},
                    {"angular_momentum", to_json(ledger.angular_momentum)},
                    {"angular_impulse", to_json(ledger.angular_impulse)},
                    {"angular_momentum_residual", to_json(ledger.angular_momentum_residual)},
                    {"mass", ledger.mass}};
    json.update(sums);
    if (summary.has_fluid) {
        json.update(Json{{"fluid.artificial", ledger.fluid.artificial},
                         {"fluid.residual", ledger.fluid.residual},
                         {"fluid.coupling_gap", ledger.fluid.coupling_gap},
                         {"fluid.momentum", to_json(ledger.fluid.momentum)},
                         {"fluid.momentum_residual", to_json(ledger.fluid.momentum_residual)},
                         {"fluid.mass", ledger.fluid.mass}});
    }
    return json;
}

Json to_json(const ExpectResult& result) {
    return {{"name", result.name},        {"quantity", result.quantity}, {"reduce", result.reduce},
            {"unit", result.unit},        {"value", result.value},       {"time", result.time},
            {"low", result.low},          {"high", result.high},         {"verdict", to_string(result.verdict)},
            {"citation", result.citation}};
}

}  // namespace

std::string summary_json(const Summary& summary) {
    Json expects = Json::array();
    for (const ExpectResult& result : summary.expects) {
        expects.push_back(to_json(result));
    }
    const Json json{{"status", summary.status},
                    {"reason", summary.reason},
                    {"title", summary.title},
                    {"source", summary.source},
                    {"set", summary.overrides},
                    {"warnings", summary.warnings},
                    {"state_hash", fmt::format("{:016x}", summary.state_hash)},
                    {"steps", summary.steps},
                    {"time", summary.time},
                    {"time_step", summary.dt},
                    {"time_step_mean", summary.steps > 0 ? summary.time / static_cast<double>(summary.steps) : 0},
                    {"time_step_min", summary.counts.shortest > 0 ? summary.counts.shortest : summary.dt},
                    {"time_step_max", summary.counts.longest},
                    {"retries", summary.retries},
                    {"steps_above_bound", summary.counts.above_bound},
                    {"steps_unsettled", summary.counts.unsettled},
                    {"steps_with_open_friction", summary.counts.with_open_friction},
                    {"open_frictions", summary.counts.open_frictions},
                    {"steps_with_intruder", summary.counts.with_intruder},
                    {"water_through_walls", summary.counts.through_walls},
                    {"sound_steps_mean", summary.counts.sound_steps(summary.steps)},
                    {"solver_iterations", summary.counts.solver_iterations},
                    {"solver_iterations_max", summary.counts.most_iterations},
                    {"solver_residual_max", summary.counts.worst_residual},
                    {"wall_seconds", summary.wall_seconds},
                    {"predicted_seconds", summary.predicted_seconds},
                    {"seconds_per_step", summary.seconds_per_step},
                    {"bodies", summary.body_count},
                    {"particles", summary.particle_count},
                    {"ns_per_body_step", summary.cost},
                    {"memory_bytes", summary.memory_bytes},
                    {"threads", summary.threads},
                    {"resumes", summary.resumes},
                    {"ledger", ledger_json(summary)},
                    {"stages",
                     {{"find_pairs", summary.stages.find_pairs},
                      {"find_contacts", summary.stages.find_contacts},
                      {"contact_loads", summary.stages.contact_loads},
                      {"move_bodies", summary.stages.move_bodies},
                      {"water", summary.stages.fluid},
                      {"measure", summary.stages.measure}}},
                    {"expects", expects},
                    {"build", Json::parse(build_json())},
                    {"machine", Json::parse(machine_json())}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void write_summary(const RunFolder& folder, const Summary& summary) {
    io::write_file(folder.summary(), summary_json(summary));
}

}  // namespace riprap::run
