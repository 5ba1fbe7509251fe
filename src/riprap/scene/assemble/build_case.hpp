// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

void build_materials(CaseBuild& build);
void build_contact(CaseBuild& build);  ///< after the bodies: mixing rules are asked for where materials are used
void build_settings(CaseBuild& build);
void build_strength(CaseBuild& build);  ///< after the contact
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

/// Loads act on bodies that follow forces, now or later, and there are not too many. False with a problem.
bool check_loads(CaseBuild& build, const Value& loads, const body::NewBody& body, std::int64_t copies);

/// Adds the loads of one body.
/// @param pose   of its shape as the case gives it
/// @param scale  of its shape against what the case gives
void add_loads(CaseBuild& build, const Value& loads, BodyId body, const Pose& pose, double scale);

}  // namespace riprap::scene
