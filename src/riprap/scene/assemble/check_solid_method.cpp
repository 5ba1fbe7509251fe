// SPDX-License-Identifier: Apache-2.0
// Asks the solid method what it cannot move.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/body/locks.hpp"
#include "riprap/core/index.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/sim/method_traits.hpp"

namespace riprap::scene {

namespace {

/// Says which pairs of kinds the method has no physics for, and which methods have one.
solid::SceneProblem unanswered_problem(const sim::Model& model, const solid::UnansweredBody& unanswered) {
    const auto name = [](solid::BodyKind kind) { return solid::kind_names[static_cast<std::size_t>(kind)]; };
    std::string pairs, words;
    for (const solid::BodyKind other : unanswered.others) {
        pairs += fmt::format("{}{} on {}", pairs.empty() ? "" : " and for ", name(unanswered.kind), name(other));
    }
    for (const std::string_view method : sim::solids_that_answer(unanswered)) {
        words += fmt::format("{}\"{}\"", words.empty() ? "" : ", ", method);
    }
    return {unanswered.body,
            fmt::format("'{}' meets others by its {}, and this method has no physics for {}",
                        model.bodies.name(unanswered.body), name(unanswered.kind), pairs),
            words.empty() ? "no method has" : "solid.method = " + words};
}

}  // namespace

void check_solid_method(CaseBuild& build) {
    const sim::Model& model = build.model;
    std::vector<solid::SceneProblem> problems = sim::solid_problems(model, build.state.bodies);
    for (const solid::UnansweredBody& body : sim::unanswered_bodies(model)) {
        problems.push_back(unanswered_problem(model, body));
    }
    // Rigid bodies have six degrees of freedom, blocks that deform twelve, of which no guide is made.
    for (std::int32_t b = 0; b < model.bodies.size() && !sim::does(model, sim::SolidAbility::locks); ++b) {
        if (locks_of(model.bodies, at(b)).any()) {
            problems.push_back({BodyId{b}, "this method locks no degrees of freedom of a body",
                                fmt::format("leave out 'locked', or solid.method = \"{}\"",
                                            fmt::join(sim::solids_that(sim::SolidAbility::locks), "\" or \""))});
        }
    }
    const Value& solid = get(build.root, "solid");
    const Value* method = solid.find("method");
    for (const solid::SceneProblem& problem : problems) {
        // a message that begins with a key is about that key
        const Value* key = solid.find(problem.message.substr(0, problem.message.find(' ')));
        SourcePlace place = key != nullptr ? key->place : method != nullptr ? method->place : solid.place;
        if (problem.body.is_valid()) {
            place = build.names[model.bodies.names[at(model.bodies.name_id[at(problem.body.value)])]];
        }
        build.problem(place, problem.message, problem.allowed);
    }
}

}  // namespace riprap::scene
