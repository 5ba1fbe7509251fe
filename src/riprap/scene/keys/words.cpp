// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/words.hpp"

namespace riprap::scene {

const Words<Way>& ways() {
    static const Words<Way> words{{"x", {0, true}},   {"-x", {0, false}}, {"y", {1, true}},
                                  {"-y", {1, false}}, {"z", {2, true}},   {"-z", {2, false}}};
    return words;
}

const Words<double>& length_units() {
    static const Words<double> words{{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}};
    return words;
}

const Words<material::Mixing>& mixing_rules() {
    using material::Mixing;
    static const Words<Mixing> words{{"minimum", Mixing::minimum},
                                     {"maximum", Mixing::maximum},
                                     {"mean", Mixing::mean},
                                     {"geometric", Mixing::geometric},
                                     {"harmonic", Mixing::harmonic}};
    return words;
}

const Words<coupling::WavesAtSide::Kind>& side_waves() {
    using Kind = coupling::WavesAtSide::Kind;
    static const Words<Kind> words{{"regular", Kind::regular},     {"second_order", Kind::second_order},
                                   {"solitary", Kind::solitary},   {"boussinesq", Kind::boussinesq},
                                   {"irregular", Kind::irregular}, {"none", Kind::none}};
    return words;
}

const Words<geometry::ArmourUnit>& armour_units() {
    using geometry::ArmourUnit;
    static const Words<ArmourUnit> words{{"cube", ArmourUnit::cube},
                                         {"tetrapod", ArmourUnit::tetrapod},
                                         {"accropode", ArmourUnit::accropode},
                                         {"dolos", ArmourUnit::dolos},
                                         {"core_loc", ArmourUnit::core_loc}};
    return words;
}

const Words<fluid::grid::PorousClosure>& porous_closures() {
    using fluid::grid::PorousClosure;
    static const Words<PorousClosure> words{
        {"ding", PorousClosure::ding}, {"van_gent", PorousClosure::van_gent}, {"engelund", PorousClosure::engelund}};
    return words;
}

}  // namespace riprap::scene
