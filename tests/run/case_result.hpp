// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <span>
#include <stdexcept>
#include <string>

#include "riprap/core/fields.hpp"
#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {

/// All that a case gives after some steps, as one text: the hash of the State, the values of its records and those of
/// its expected answers. @throws CaseError, or what a step was refused for
inline std::string result_of(const std::string& text, std::span<const std::string> overrides, int steps,
                             const std::string& folder = "/nonexistent") {
    Simulation simulation(scene::read_case_text(text, "case.toml", folder, overrides));
    for (int taken = 0; taken < steps && simulation.steps_left() > 0;) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        if (outcome.kind == StepOutcome::Kind::refused) {
            throw std::runtime_error(outcome.why.text);
        }
        taken += outcome.is_accepted() ? 1 : 0;
    }
    std::string result = fmt::format("{:016x}", hash_fields(simulation.state()));
    for (const sim::Column& column : sim::record_columns(simulation.model())) {
        result += fmt::format(" {}", sim::evaluate(column, simulation.now()));
    }
    for (const ExpectResult& answer : simulation.judge(true)) {
        result += fmt::format(" {}", answer.value);
    }
    return result;
}

}  // namespace riprap::run
