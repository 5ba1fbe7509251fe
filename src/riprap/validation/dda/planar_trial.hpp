// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/solid/planar_dda/pieces.hpp"
#include "riprap/solid/planar_dda/state.hpp"

namespace riprap::validation {

/// A scene of planar DDA that a case builds and advances. Blocks are added before the first step.
class PlanarTrial {
 public:
    using Vec2 = geometry::Vec2;
    using Joint = solid::planar_dda::Joint;
    using Material = solid::planar_dda::Material;

    /// One material with one joint; more by add_material().
    PlanarTrial(const Material& material, const Joint& joint);

    /// A further material whose joints with all others are `joint`.
    std::int32_t add_material(const Material& material, const Joint& joint);
    std::int32_t add(const std::vector<Vec2>& corners, bool is_fixed = false, std::int32_t material = 0);
    std::int32_t add_box(const Vec2& low, const Vec2& size, bool is_fixed = false, std::int32_t material = 0);
    /// A regular polygon with one corner downwards, or one edge where is_flat.
    std::int32_t add_regular(const Vec2& center, double radius, int corners, bool is_flat = false,
                             std::int32_t material = 0);
    solid::planar_dda::Builder builder() { return {model, state}; }

    /// Advances by one step of `dt`. @throws std::runtime_error when the method refuses it however short
    void step();
    void run(double duration);

    Vec2 center(std::int32_t block) const;
    Vec2 velocity(std::int32_t block) const;
    void set_velocity(std::int32_t block, const Vec2& velocity);
    /// Largest and mean energy that the ledger misses, over the energy turned over [-].
    double ledger_error() const;
    /// Tells whether two blocks push each other.
    bool do_touch(std::int32_t first, std::int32_t second) const;

    solid::planar_dda::Model model;
    solid::planar_dda::State state;
    solid::planar_dda::Settings settings;
    solid::planar_dda::Scratch scratch;
    solid::planar_dda::StepReport report;
    Vec2 gravity{0, -9.81};
    double dt{1e-3}, time{0};

 private:
    void begin_ledger();
    bool has_begun_{false};
    double energy_at_start_{0}, balance_at_start_{0};
};

}  // namespace riprap::validation
