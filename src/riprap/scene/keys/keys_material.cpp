// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: materials and contact. The physics of the solid methods say which properties they read.
#include "riprap/material/property_keys.hpp"
#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/settings.hpp"

namespace riprap::scene {

using namespace form;

namespace {

/// Names the solid methods that read a property: none by name where all do.
Key with_readers(Key row, material::Property property) {
    row.methods = sim::solids_that_read(property);
    if (row.methods.empty()) {
        throw InternalError("no solid method reads '" + std::string(row.name) + "'");
    }
    if (row.methods.size() == std::variant_size_v<sim::SolidSettings>) {
        row.methods.clear();
    }
    return row;
}

template <class To>
void add_rows(const std::vector<material::PropertyKey<To>>& keys, Table& table) {
    const To defaults{};
    for (const material::PropertyKey<To>& key : keys) {
        table.keys.push_back(with_readers(key_of(key.key.row, key.key.get(defaults)), key.property));
    }
    table.groups = {{GroupRule::at_most_one, {"friction_coefficient", "friction_angle"}},
                    {GroupRule::at_most_one, {"shear_ratio", "shear_stiffness"}}};
}

const Table& contact_pair_table() {
    static const Table table = [] {
        Table made{"contact.pair",
                   "[[contact.pair]]",
                   "Values for one pair of materials, instead of the mixed ones.",
                   {required_key("materials", {list(name(), 2, 2)},
                                 "The two materials; twice the same for contacts within one.")}};
        add_rows(material::pair_keys(), made);
        return made;
    }();
    return table;
}

}  // namespace

const Table& material_table() {
    static const Table table = [] {
        Table made{
            "material",
            "[material.NAME]",
            "Substance of a block and behaviour of its surface. Contact values of two materials follow from [contact]. "
            "A value that the chosen solid method does not read is told by a warning.",
            {required_key("density", {number(dimension::density, positive())}, "Mass per volume of solid.")}};
        add_rows(material::material_keys(), made);
        return made;
    }();
    return table;
}

const Table& contact_table() {
    using material::Property;
    static const Table table{
        "contact",
        "[contact]",
        "Rules by which the values of two materials become those of a contact. Codes differ silently here, so the "
        "rules must be "
        "given where materials differ in values that the solid method reads. Stiffness ratio and damping use the mean, "
        "the kinetic share friction_mixing.",
        {with_readers(optional_key("friction_mixing", {choice(mixing_rules())},
                                   "Rule for the friction coefficient and the kinetic share of spheres; required when "
                                   "materials differ in either that the solid method reads."),
                      Property::friction),
         with_readers(optional_key("cohesion_mixing", {choice(mixing_rules())},
                                   "Rule for cohesion; required when materials differ in it."),
                      Property::cohesion),
         with_readers(optional_key("restitution_mixing", {choice(mixing_rules())},
                                   "Rule for restitution; required when materials differ in it."),
                      Property::restitution),
         with_readers(optional_key("rolling_mixing", {choice(mixing_rules())},
                                   "Rule for the rolling friction of spheres; required when materials differ in it."),
                      Property::rolling_friction),
         key_or("max_initial_overlap", {number(dimension::plain, positive())}, Value::of(0.1),
                "Bodies that start deeper in each other than this share of the smaller inscribed radius are refused."),
         key_or("pair", {table_list(contact_pair_table)}, Value::array(), "Values for one pair of materials.")}};
    return table;
}

}  // namespace riprap::scene
