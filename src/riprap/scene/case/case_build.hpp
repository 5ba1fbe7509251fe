// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "riprap/scene/case/paddle_wave.hpp"
#include "riprap/scene/text/case_files.hpp"
#include "riprap/scene/text/value.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::io {
struct OutputChoices;
}

namespace riprap::scene {

class ShapeLibrary;

/// A body that a wave maker moves.
struct WavePaddle {
    BodyId body;
    Vec3 direction;     ///< of the waves
    SourcePlace place;  ///< of the depth that the case gives
    PaddleWave wave;
};

/// A checked case while it becomes Model and State. The functions below share it, append problems and go on.
struct CaseBuild {
    const Value& root;  ///< resolved: every key has passed the key table
    bool is_planar;
    sim::Model& model;
    sim::State& state;
    io::OutputChoices& outputs;
    CaseFiles& files;
    ShapeLibrary& shapes;
    std::vector<Diagnostic>& problems;
    std::vector<std::string>& warnings;
    std::vector<std::string>& notes;
    std::map<std::string, MaterialId> materials{};
    std::map<std::string, SourcePlace> names{};  ///< of bodies, packs, rock masses and sections, and where they stand
    std::set<std::int32_t> used_materials{};
    std::vector<coupling::PaddleAbsorption> absorptions{};  ///< of paddles that have one
    std::vector<SourcePlace> absorption_places{};           ///< of their 'absorb'
    std::vector<WavePaddle> paddles{};
    std::optional<fluid::Domain> domain{};  ///< of the water, once it is known to be good
    bool has_all_bodies{true};              ///< none is missing for a problem of its own
    bool has_sound_bodies{true};            ///< none is too small, too large or too far away to be computed with
    std::map<const Value*, std::shared_ptr<const body::ForceTable>> force_tables{};  ///< of loads, by their tables
    std::set<std::string> records{};               ///< names of all probes, gauges and damage of the case
    std::vector<std::uint8_t> is_dry{}, sticks{};  ///< of bodies that say so, by body; those beyond the end do not

    void problem(const SourcePlace& place, std::string message, std::string allowed = "") {
        problems.push_back({place, std::move(message), std::move(allowed)});
    }
    /// Against gravity; along the last axis where there is none.
    Vec3 up() const;
    /// The material that `table` names; invalid, with a problem, when there is none.
    void material_problem(const Value& name);
    MaterialId material_of(const Value& table);
    /// The body that `name` is the name of; invalid, with a problem, when there is none.
    BodyId body_named(const Value& name);
    /// A place at the start, in the frame of a body from its centre of mass.
    Vec3 point_of(BodyId body, const Vec3& place) const {
        const auto b = static_cast<std::size_t>(body.value);
        return rotate_back(state.bodies.orientation[b], place - state.bodies.position[b]);
    }
    /// Notes the name of a body, pack or rock mass; a problem when it is taken.
    void claim_name(const Value& table);
    /// True for "NAME" and "NAME[17]" where NAME was claimed: there may be no such body only because of a problem.
    bool is_claimed(const std::string& body) const { return names.contains(body.substr(0, body.find('['))); }
};

}  // namespace riprap::scene
