// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "riprap/scene/build/paddle_wave.hpp"
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

void build_materials(CaseBuild& build);
void build_contact(CaseBuild& build);  ///< after the bodies: mixing rules are asked for where materials are used
void build_settings(CaseBuild& build);
void build_bodies(CaseBuild& build);
void build_packs(CaseBuild& build);
void build_rock_masses(CaseBuild& build);
void build_sections(CaseBuild& build);
void build_fluid(CaseBuild& build);  ///< after all bodies: water fills what they leave
/// Sponges, inflows and outflows of the [fluid] in `table`; after depth and State of the water.
void build_openings(CaseBuild& build, const Value& table, coupling::ParticleFluid& fluid);
/// Reads whether water in joints is asked for, and checks that periods of the domain are long enough for it; after the
/// settings of the fluid.
void build_joints(CaseBuild& build, const Value& table, coupling::ParticleFluid& fluid);
void build_gauges(CaseBuild& build, const Value& list);  ///< after the fluid
void warn_of_densities(CaseBuild& build);                ///< of free bodies and of the water
void build_output(CaseBuild& build);                     ///< last: probes and expects look bodies up

/// Point `i` of the lattice with the counts of `table` (2 or 3 of them), its pitch and, where it has one, its stagger,
/// x fastest, from its first point.
class Lattice {
 public:
    explicit Lattice(const Value& table);
    std::int64_t size() const { return nx_ * ny_ * nz_; }
    bool is_flat() const { return nz_ == 1; }
    Vec3 point(std::int64_t i) const;

 private:
    std::int64_t nx_, ny_, nz_;
    Vec3 pitch_;
    double stagger_;
};

/// Reads fixed points and bolts; after all bodies.
void build_supports(CaseBuild& build);

/// Spheres that a case gives a body, in the frame of its shape.
struct BodySpheres {
    std::vector<body::ShapeSphere> spheres;
    std::optional<geometry::MassProperties> whole{};  ///< of their union, where mass and inertia are those of it
};

/// Reads the spheres of a body whose parts are known; nothing, with a problem, where they are refused.
std::optional<BodySpheres> read_spheres(CaseBuild& build, const Value& body_table, const body::NewBody& body);
/// Gives them to the body made of it, and their mass where they say so.
/// @param scale  of its shape against what the case gives
void give_spheres(CaseBuild& build, const BodySpheres& spheres, const body::NewBody& body, BodyId id, double scale);

/// Refuses bodies that start inside each other.
void check_overlaps(CaseBuild& build);

/// Refuses materials that lack what the contacts of the scene read, and warns of values that nothing reads.
void check_materials(CaseBuild& build);

/// Refuses what the solid method cannot move.
void check_solid_method(CaseBuild& build);

/// The turn that an orientation table means; the identity for null.
Quat orientation_of(const Value* table);

/// Adds the motion of a body to the model. @returns its index, or -1 with a problem.
std::int32_t add_motion(CaseBuild& build, const Value& motion);

/// The motion of a paddle, from wave theory; nothing, with a problem, when the wave cannot be made.
std::optional<body::PrescribedMotion> wave_maker_motion(CaseBuild& build, const Value& table);
/// The wave of that table; nothing for a sea, which has no period.
std::optional<PaddleWave> paddle_wave(const CaseBuild& build, const Value& table);
/// Returns the absorption of that paddle; nothing where it absorbs no waves.
std::optional<coupling::PaddleAbsorption> paddle_absorption(CaseBuild& build, const Value& table);

/// Loads act on bodies that follow forces, now or later, and there are not too many. False with a problem.
bool check_loads(CaseBuild& build, const Value& loads, const body::NewBody& body, std::int64_t copies);

/// Adds the loads of one body.
/// @param pose   of its shape as the case gives it
/// @param scale  of its shape against what the case gives
void add_loads(CaseBuild& build, const Value& loads, BodyId body, const Pose& pose, double scale);

/// Bodies and parts that the case asks for, from counts alone. A problem, and false, when above limits.hpp.
bool check_counts(const Value& root, std::vector<Diagnostic>& problems);

}  // namespace riprap::scene
