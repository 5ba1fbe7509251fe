// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/solid/lanes.hpp"
#include "riprap/solid/sphere_dem/contact_response.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"

namespace riprap::solid::sphere_dem {

/// Constants of all pairs of materials.
class Surfaces {
 public:
    Surfaces(const contact::ContactTable& table, contact::NormalLaw law) : count_(table.size()) {
        for (std::int32_t a = 0; a < count_; ++a) {
            for (std::int32_t b = 0; b < count_; ++b) {
                pairs_.push_back(surface_pair(table.pair(MaterialId{a}, MaterialId{b}), law));
            }
        }
        const SurfacePair<double>& p = pairs_.front();
        first_ = {Eight(p.modulus),          Eight(p.shear_modulus),    Eight(p.ratio),
                  Eight(p.static_friction),  Eight(p.kinetic_friction), Eight(p.rolling_friction),
                  Eight(p.normal_stiffness), Eight(p.shear_ratio),      Eight(p.shear_damping)};
    }
    bool is_uniform() const { return count_ == 1; }
    const SurfacePair<Eight>& first() const { return first_; }

    /// Constants of eight contacts.
    /// @param a, b  materials of either side
    SurfacePair<Eight> of(const RowIndex& a, const RowIndex& b) const {
        SurfacePair<Eight> out = first_;
        for (std::int64_t lane = 0; lane < lanes; ++lane) {
            const SurfacePair<double>& p = pairs_[at(a.row[lane] * count_ + b.row[lane])];
            out.modulus.set(lane, p.modulus);
            out.shear_modulus.set(lane, p.shear_modulus);
            out.ratio.set(lane, p.ratio);
            out.static_friction.set(lane, p.static_friction);
            out.kinetic_friction.set(lane, p.kinetic_friction);
            out.rolling_friction.set(lane, p.rolling_friction);
            out.normal_stiffness.set(lane, p.normal_stiffness);
            out.shear_ratio.set(lane, p.shear_ratio);
            out.shear_damping.set(lane, p.shear_damping);
        }
        return out;
    }

 private:
    std::int32_t count_;
    std::vector<SurfacePair<double>> pairs_;
    SurfacePair<Eight> first_;
};

/// Sums of eight contacts at a time, folded in the order of the lanes.
struct WideSums {
    Eight elastic{}, friction{}, damping{}, rolling{}, deepest{};

    /// @param depth  overlap over the smaller radius [-]
    /// @param count  lanes that hold a contact
    [[gnu::always_inline]] void add(const ContactResponse<Eight>& response, Eight depth, std::int64_t count) {
        Eight one_elastic = response.elastic, one_friction = response.friction_loss,
              one_damping = response.damping_loss, one_rolling = response.rolling_loss;
        for (std::int64_t lane = count; lane < lanes; ++lane) {  // of the last group only
            for (Eight* value : {&depth, &one_elastic, &one_friction, &one_damping, &one_rolling}) {
                value->set(lane, 0);
            }
        }
        elastic += one_elastic;
        friction += one_friction;
        damping += one_damping;
        rolling += one_rolling;
        deepest = max(deepest, depth);
    }
    ContactSums fold() const {
        ContactSums sums;
        for (std::int64_t lane = 0; lane < lanes; ++lane) {
            sums += {elastic[lane], friction[lane], damping[lane], rolling[lane], deepest[lane]};
        }
        return sums;
    }
};

}  // namespace riprap::solid::sphere_dem
