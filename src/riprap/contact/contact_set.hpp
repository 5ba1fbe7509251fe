// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/fields.hpp"

namespace riprap::contact {

/// Two parts that may touch, a < b.
struct PartPair {
    std::int32_t a, b;
    friend constexpr auto operator<=>(const PartPair&, const PartPair&) = default;
};

/// Normal contact between parts A and B, from a narrowphase. Forces act on A; B gets the opposite.
struct NormalContact {
    Vec3 force;        ///< normal force on A [N]
    Vec3 moment;       ///< of the normal pressure on A about `point` (its residual couple) [N m]
    Vec3 point;        ///< point of action, world [m]
    double area;       ///< S_c, projected contact area |vector area| [m^2]
    double stiffness;  ///< K_n, of the contact as a spring [N/m]
    double energy;     ///< elastic energy stored in the overlap [J]
    double depth;      ///< largest depth below a face of A or B [m]; the overlap reported to users
    double potential;  ///< largest normalised potential reached, 1 = at the Chebyshev centre [-]
    double
        spin_moment;  ///< pressure * distance to `point` over the patch, as (2/3) |F| sqrt(area/pi) [N m]; for torsion
};

/// The tangential and torsional springs of one contact, which survive from step to step.
struct ShearState {
    Vec3 normal;          ///< at the last step, from A to B [-]
    Vec3 shear_force;     ///< on A [N]
    double torsion;       ///< on A about the normal [N m]
    double shear_energy;  ///< [J]
    Vec3 anchor{};        ///< where the tangential spring acts, world [m]; used with torsion
};

/// Contacts that survive from step to step: State. Sorted by (pair, feature); one row per touching contact.
struct ContactHistory {
    std::vector<std::uint64_t> pair;     ///< a << 32 | b of the parts
    std::vector<std::uint64_t> feature;  ///< which contact of the pair: feature_key(); 0 where there is only one
    std::vector<Vec3> normal;            ///< of the last step, from A to B [-]
    std::vector<Vec3> shear_force;       ///< tangential spring force on A [N]
    std::vector<double> torsion;         ///< torsional spring moment on A about the normal [N m]
    std::vector<double> shear_energy;    ///< stored in both springs [J]
    std::vector<Vec3> anchor;            ///< where the tangential spring acts, world [m]

    std::size_t size() const { return pair.size(); }
    void resize(std::size_t count) {
        pair.resize(count);
        feature.resize(count);
        normal.resize(count);
        shear_force.resize(count);
        torsion.resize(count);
        shear_energy.resize(count);
        anchor.resize(count);
    }
    ShearState springs(std::size_t row) const {
        return {normal[row], shear_force[row], torsion[row], shear_energy[row], anchor[row]};
    }
    friend bool operator==(const ContactHistory&, const ContactHistory&) = default;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("contact.pair", self.pair);
        visit("contact.feature", self.feature);
        visit("contact.normal", self.normal);
        visit("contact.shear_force", self.shear_force);
        visit("contact.torsion", self.torsion);
        visit("contact.shear_energy", self.shear_energy);
        visit("contact.anchor", self.anchor);
    }
};

constexpr std::uint64_t pair_key(PartPair parts) {
    return static_cast<std::uint64_t>(parts.a) << 32 | static_cast<std::uint64_t>(parts.b);
}
/// Names one of several contacts of a pair: which vertex, edge or face of A meets which of B, in numbers of the
/// narrowphase's own choosing.
constexpr std::uint64_t feature_key(std::uint32_t of_a, std::uint32_t of_b) {
    return static_cast<std::uint64_t>(of_a) << 32 | of_b;
}

/// Forces, energies and losses of one contact in one step, for sums, ledger and output: Scratch. Rows are ordered as in
/// ContactHistory.
struct ContactRow {
    PartPair parts;
    Vec3 point;                   ///< where the force acts [m]
    Vec3 force;                   ///< total on A: normal + damping + shear; B gets the opposite [N]
    Vec3 moment;                  ///< couple on A in addition to (point - centre) x force [N m]
    double elastic_energy;        ///< stored in the overlap [J]
    double friction_loss;         ///< dissipated by sliding in this step [J]
    Vec3T<float> dashpot;         ///< part of `force` that dashpots add; for the ledger alone [N]
    Vec3T<float> dashpot_couple;  ///< part of `moment` that dashpots add [N m]
    float dashpot_power;          ///< of force and couple of the dashpots before the kick, < 0 where they dissipate [W]
    float omega_squared_a;        ///< share in the highest omega^2 of A's body, see stability.hpp [1/s^2]
    float omega_squared_b;
    float damping_a;  ///< share in the highest damping rate of A's body [1/s]
    float damping_b;
    float normal_force;  ///< size of the normal force, damping included [N]
    float shear_force;   ///< size of the tangential force [N]
    float overlap;       ///< [m]
    float potential;     ///< largest normalised potential [-]
    float area;          ///< [m^2]
    std::uint8_t is_sliding;
};

/// View of the contacts of a step in the order of their keys.
class ContactRows {
 public:
    class Iterator {
     public:
        explicit Iterator(const ContactRow* const* at) : at_(at) {}
        const ContactRow& operator*() const { return **at_; }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        friend bool operator==(const Iterator&, const Iterator&) = default;

     private:
        const ContactRow* const* at_;
    };

    ContactRows() = default;
    explicit ContactRows(std::span<const ContactRow* const> rows) : rows_(rows) {}
    std::size_t size() const { return rows_.size(); }
    bool empty() const { return rows_.empty(); }
    const ContactRow& operator[](std::size_t i) const { return *rows_[i]; }
    Iterator begin() const { return Iterator(rows_.data()); }
    Iterator end() const { return Iterator(rows_.data() + rows_.size()); }

 private:
    std::span<const ContactRow* const> rows_;
};

}  // namespace riprap::contact
