// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/dda/planar_trial.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "riprap/core/index.hpp"

namespace riprap::validation {

using namespace solid::planar_dda;

PlanarTrial::PlanarTrial(const Material& material, const Joint& joint) {
    model.materials.push_back(material);
    model.set_joint(0, 0, joint);
}

std::int32_t PlanarTrial::add_material(const Material& material, const Joint& joint) {
    const auto before = static_cast<std::int32_t>(model.materials.size());
    Model old = model;
    model.materials.push_back(material);
    model.joints.assign(model.materials.size() * model.materials.size(), joint);
    for (std::int32_t a = 0; a < before; ++a) {
        for (std::int32_t b = 0; b < before; ++b) {
            model.joints[at(a) * model.materials.size() + at(b)] = old.joints[at(a) * at(before) + at(b)];
        }
    }
    return before;
}

std::int32_t PlanarTrial::add(const std::vector<Vec2>& corners, bool is_fixed, std::int32_t material) {
    const auto block = builder().add_block(corners, material, is_fixed);
    if (!block) {
        throw std::runtime_error(block.problems().front().message);
    }
    return block.value();
}

std::int32_t PlanarTrial::add_box(const Vec2& low, const Vec2& size, bool is_fixed, std::int32_t material) {
    return add({low, {low.x + size.x, low.y}, low + size, {low.x, low.y + size.y}}, is_fixed, material);
}

std::int32_t PlanarTrial::add_regular(const Vec2& center_at, double radius, int count, bool is_flat,
                                      std::int32_t material) {
    std::vector<Vec2> corners;
    for (int k = 0; k < count; ++k) {
        const double turn = 2 * std::numbers::pi * (k + (is_flat ? 0.5 : 0.0)) / count - std::numbers::pi / 2;
        corners.push_back(center_at + radius * Vec2{std::cos(turn), std::sin(turn)});
    }
    return add(corners, false, material);
}

void PlanarTrial::begin_ledger() {
    has_begun_ = true;
    energy_at_start_ = energies_of(model, state).total();
    balance_at_start_ = balance_of(state.accounts);
}

void PlanarTrial::step() {
    if (!has_begun_) {
        begin_ledger();
    }
    int count = 0;
    const Outcome outcome = advance_in_pieces(model, settings, {dt, gravity, {}, {}}, state, scratch, report, count);
    if (!outcome.ok()) {
        throw std::runtime_error(fmt::format("at {:.6g} s: {}", time, outcome.problem));
    }
    time += dt;
}

void PlanarTrial::run(double duration) {
    const auto count = static_cast<std::int64_t>(std::llround(duration / dt));
    for (std::int64_t k = 0; k < count; ++k) {
        step();
    }
}

geometry::Vec2 PlanarTrial::center(std::int32_t block) const { return {state.x[at(block)], state.y[at(block)]}; }
geometry::Vec2 PlanarTrial::velocity(std::int32_t block) const {
    return {state.rates[6 * at(block)], state.rates[6 * at(block) + 1]};
}

void PlanarTrial::set_velocity(std::int32_t block, const Vec2& v) {
    state.rates[6 * at(block)] = v.x;
    state.rates[6 * at(block) + 1] = v.y;
    has_begun_ = false;
}

double PlanarTrial::ledger_error() const {
    const Accounts& a = state.accounts;
    const double error = energies_of(model, state).total() - energy_at_start_ - (balance_of(a) - balance_at_start_);
    const double turnover = std::abs(a.work_gravity) + std::abs(a.work_loads) + std::abs(a.work_driven) +
                            a.friction_loss + a.dashpot_loss + a.newmark_loss + energy_at_start_;
    return turnover > 0 ? std::abs(error) / turnover : std::abs(error);
}

bool PlanarTrial::do_touch(std::int32_t first, std::int32_t second) const {
    double sum = 0;
    for (std::size_t k = 0; k < state.contact_corner.size(); ++k) {
        const std::int32_t a = model.corner_block[at(state.contact_corner[k])];
        const std::int32_t b = model.corner_block[at(state.contact_edge[k])];
        sum += (a == first && b == second) || (a == second && b == first) ? state.contact_force[k] : 0;
    }
    return std::abs(sum) > 0;
}

}  // namespace riprap::validation
