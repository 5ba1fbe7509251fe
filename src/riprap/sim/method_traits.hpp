// SPDX-License-Identifier: Apache-2.0
#pragma once

// Asks the methods of a case what they state of themselves beyond a step, by the traits that their classes declare
// (solid/solid_traits.hpp, coupling/fluid_traits.hpp).

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/fluid/gauge/gauge.hpp"
#include "riprap/material/property.hpp"
#include "riprap/sim/settings.hpp"
#include "riprap/solid/pair_physics.hpp"

namespace riprap::sim {

struct Model;
struct State;

/// Does the ledger close from the first step on? Else what is dissipated is known over some steps only.
bool books_every_step(const Model& model);

/// Height by which a fluid may settle when it is let go: the spacing of particles [m].
double grain(const Model& model);

/// Mass of one particle of the fluid; 0 where it is not made of any [kg].
double grain_mass(const Model& model);

/// Returns the box that the fluid cannot leave; nullptr where it is unbounded.
const fluid::Domain* fluid_domain(const Model& model);

/// Returns the size of particles or cells of the fluid; 0 where it has none [m].
double fluid_spacing(const Model& model);

/// Returns the width of the narrowest cell of the fluid; 0 where it has none [m].
double cell_width(const Model& model);

/// Returns the share of the limit of its step that a fluid is to take; 0 where it has none [-].
double courant(const Model& model);

/// Bytes of what the settings of the fluid hold beside themselves.
std::size_t fluid_bytes(const Model& model);

/// Says how many cells the fluid has and how wide they are; empty where it has none.
std::string cells_text(const Model& model);

/// Says which waves sides of the fluid absorb, a line each.
std::vector<std::string> absorbed_ranges(const Model& model);

/// Do the first steps after bodies were let go grow from little, for the sake of the fluid?
bool starts_slowly(const Model& model);

/// Do walls of the fluid make up for the way of bodies that it did not see in the last step?
bool makes_up(const Model& model);

/// Is the step of the fluid that of the run?
bool fluid_leads(const Model& model);

/// Do bodies meet by their shapes?
bool meets_by_shapes(const Model& model);

/// Smallest radius of what a solid method lets stand for the shapes of bodies; infinity where nothing does [m].
double smallest_stand_in(const Model& model);

/// Does every contact tell how deep it is (ContactRow::potential), one a pair of parts?
bool tells_depth(const Model& model);

/// Does the solid method move planar scenes alone?
bool is_of_plane(const Model& model);

/// Returns the speed of a body that ends a run [m/s], and the determinant of a deformation that does [-]; 0 where the
/// solid method has no such bound.
double max_speed(const Model& model);
double max_stretch(const Model& model);

/// Returns the most rounds of the open-close iteration of the solid method; 0 where it has none.
int open_close(const Model& model);

/// Returns the step that a solid method wants, where it is implicit; else nullptr.
const double* step_of(const SolidSettings& solid);
double* step_of(SolidSettings& solid);

/// Returns the elasticity of the blocks of a solid method; nullptr where they have none.
const solid::affine::Elasticity* elasticity_of(const SolidSettings& solid);
solid::affine::Elasticity* elasticity_of(SolidSettings& solid);

/// Returns the properties of materials that the solid method reads, whatever bodies the scene has.
std::vector<material::PropertyUse> property_uses(const Model& model);

/// Does the solid method, with the settings of the case, read a property?
bool reads_property(const Model& model, material::Property property);

/// Does a physics of the solid method that bodies of the scene meet by read a property?
bool reads_among_bodies(const Model& model, material::Property property);

/// Returns the words of the solid methods that can read a property of materials.
std::vector<std::string_view> solids_that_read(material::Property property);

/// Returns the words of all solid methods.
std::vector<std::string_view> solid_words();

/// Returns the words of the solid methods in which bodies tip about their edges, not about a foot of overlaps: those
/// that meet by their shapes without telling a depth, and that move the bodies of this scene.
std::vector<std::string_view> solids_that_tip_about_edges(const Model& model);

/// Returns what the solid method with this word reads of materials at its defaults.
std::vector<material::PropertyUse> property_uses(std::string_view solid_word);

/// Returns the properties that the materials of the bodies lack for the solid method.
std::vector<solid::LackingProperty> lacking_properties(const Model& model);

/// Says why the solid method cannot move the scene.
std::vector<solid::SceneProblem> solid_problems(const Model& model, const body::BodyState& bodies);

/// Returns the bodies that meet others for which the solid method has no physics.
std::vector<solid::UnansweredBody> unanswered_bodies(const Model& model);

/// Returns the words of the solid methods that have a physics for all pairs that such a body lacks.
std::vector<std::string_view> solids_that_answer(const solid::UnansweredBody& unanswered);

/// Says why fields of the solid method that were read from a file are not of this scene; empty where they are.
std::string misfit_of_fields(const Model& model, const State& state);

/// Says how much fluid has left where it was let go; empty where none has.
std::string let_go_text(const Model& model, const State& state);

/// Does the fluid read gauges of a kind, by the readings that it offers?
bool reads_gauge(const Model& model, const fluid::GaugeKind& kind);

/// Returns the words of the fluids that read gauges of a kind.
std::vector<std::string_view> fluids_that_read(const fluid::GaugeKind& kind);

/// Abilities of a solid method besides moving bodies.
enum class SolidAbility : std::uint8_t { locks, fixed_points, bolts };

/// Does the solid method do what is asked for?
bool does(const Model& model, SolidAbility asks);

/// Returns the words of the solid methods that do.
std::vector<std::string_view> solids_that(SolidAbility asks);

}  // namespace riprap::sim
