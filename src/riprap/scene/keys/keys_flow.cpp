// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: flows that have a name, and sides of the domain.
#include <fmt/format.h>

#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/keys/flow_tables.hpp"

namespace riprap::scene {

using namespace form;

namespace {

template <class Law>
const Table& law_table() {
    static const std::string id = fmt::format("fluid.flow.{}", Law::word);
    static const std::string header = fmt::format("flow = {{ {} = {{ ... }} }}", Law::word);
    static const Table table{id, header, Law::help, rows_of(Law::keys())};
    return table;
}

}  // namespace

const Table& flow_table() {
    static const Table table = [] {
        Table made{
            "fluid.flow",
            "flow = { ... }",
            "A velocity that a formula gives, in the x-y plane: that of all water at the start, instead of those "
            "of the regions.",
            {}};
        Group one{GroupRule::exactly_one, {}};
        fluid::FlowLaws::for_each([&]<class Law>() {
            made.keys.push_back({Law::word, {form::table(law_table<Law>)}, std::string(Law::brief), {}});
            one.keys.push_back(Law::word);
        });
        made.groups = {one};
        return made;
    }();
    return table;
}

const Words<coupling::SideRule::Kind>& side_kinds() {
    using Kind = coupling::SideRule::Kind;
    static const Words<Kind> words{{"slip", Kind::slip},
                                   {"no_slip", Kind::no_slip},
                                   {"wall_function", Kind::wall_function},
                                   {"endless", Kind::endless},
                                   {"flow", Kind::flow}};
    return words;
}

const Table& side_table() {
    static const Table table{
        "fluid.side",
        "[[fluid.side]]",
        "A whole side of the domain, instead of what domain_walls and open_top say of it.",
        {required_key("side", {choice(ways())}, "Which: \"x\" is the high side along x, \"-x\" the low one."),
         required_key(
             "kind", {choice(side_kinds())},
             "slip, no_slip, wall_function: walls as of domain_walls. endless: the flow goes on beyond as it is "
             "inside, "
             "with the same pressure on all such sides, and what comes in is water: plates or a channel without end. "
             "flow: water comes in and goes out with the velocity of fluid.flow."),
         key_or("velocity", {vector(dimension::velocity)}, Value::of(Vec3{}), "Of a wall that slides along itself.")}};
    return table;
}

}  // namespace riprap::scene
