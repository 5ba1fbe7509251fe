// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/solid/lanes.hpp"
#include "riprap/solid/sphere_dem/contact_response.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"

namespace riprap::solid::sphere_dem {

/// Constants of all pairs of materials.
/// @tparam T  contacts side by side
template <class T>
class Surfaces {
 public:
    Surfaces(const contact::ContactTable& table, contact::NormalLaw law) : count_(table.size()) {
        for (std::int32_t a = 0; a < count_; ++a) {
            for (std::int32_t b = 0; b < count_; ++b) {
                pairs_.push_back(surface_pair(table.pair(MaterialId{a}, MaterialId{b}), law));
            }
        }
        const SurfacePair<double>& p = pairs_.front();
        first_ = {T(p.modulus),          T(p.shear_modulus),    T(p.ratio),
                  T(p.static_friction),  T(p.kinetic_friction), T(p.rolling_friction),
                  T(p.normal_stiffness), T(p.shear_ratio),      T(p.shear_damping)};
    }
    bool is_uniform() const { return count_ == 1; }
    const SurfacePair<T>& first() const { return first_; }

    /// @param a, b  materials of either side
    SurfacePair<T> of(const RowsOf<T>& a, const RowsOf<T>& b) const {
        SurfacePair<T> out = first_;
        for (std::int64_t lane = 0; lane < lanes_in<T>; ++lane) {
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
    SurfacePair<T> first_;
};

/// Sums of groups of contacts, folded in the order of the lanes.
struct WideSums {
    Eight elastic{}, friction{}, damping{}, rolling{}, deepest{};

    /// @param depth  overlap over the smaller radius [-]
    /// @param p      part of the group
    /// @param count  lanes of the part that hold a contact
    [[gnu::always_inline]] void add(const ContactResponse<Native>& response, Native depth, std::size_t p,
                                    std::int64_t count) {
        Native one_elastic = response.elastic, one_friction = response.friction_loss,
               one_damping = response.dashpot_power, one_rolling = response.rolling_loss;
        for (std::int64_t lane = count; lane < lanes_in<Native>; ++lane) {  // of the last group only
            for (Native* value : {&depth, &one_elastic, &one_friction, &one_damping, &one_rolling}) {
                value->set(lane, 0);
            }
        }
        elastic.part[p] += one_elastic.part[0];
        friction.part[p] += one_friction.part[0];
        damping.part[p] += one_damping.part[0];
        rolling.part[p] += one_rolling.part[0];
        deepest.part[p] = riprap::detail::greater(deepest.part[p], depth.part[0]);
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
