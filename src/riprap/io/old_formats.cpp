// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/old_formats.hpp"

#include <algorithm>
#include <array>

namespace riprap::io {

namespace {

constexpr std::array later_fields{
    LaterField{"run.approached", 2, ""},
    LaterField{"run.told_excess", 2, ""},
    LaterField{"run.steps_since_judged", 2, ""},
    LaterField{"run.deep_pair", 3, ""},
    LaterField{"run.deep_point_a", 3, ""},
    LaterField{"run.deep_point_b", 3, ""},
    LaterField{"run.deep_normal_a", 3, ""},
    LaterField{"run.deep_normal_b", 3, ""},
    LaterField{"block_contact.plastic_slip", 4, "block_contact.pair"},
    LaterField{"contact_plastic_slip", 4, "contact_lock"},
    LaterField{"coupling.missed_way", 5, ""},
    LaterField{"coupling.missed_turn", 5, ""},
    LaterField{"coupling.untold_way", 5, ""},
    LaterField{"coupling.untold_turn", 5, ""},
    LaterField{"gauges.shown", 6, ""},
    LaterField{"fluid.flow_place", 6, ""},
    LaterField{"fluid.flow_velocity", 6, ""},
    LaterField{"fluid.flow_density", 6, ""},
    LaterField{"fluid.flow_done", 6, ""},
    LaterField{"fluid.flow_steps", 6, ""},
    LaterField{"fluid.flow_span", 6, ""},
    LaterField{"fluid.flow_travel", 6, ""},
    LaterField{"fluid.flow_stamp", 6, ""},
    LaterField{"run.renewals", 6, ""},
    LaterField{"fluid.damping", 7, ""},
};

}  // namespace

const LaterField* later_field(std::uint32_t version, std::string_view name) {
    const auto* found = std::find_if(later_fields.begin(), later_fields.end(), [&](const LaterField& field) {
        return field.name == name && version < field.since;
    });
    return found == later_fields.end() ? nullptr : found;
}

std::string_view writer_of(std::uint32_t version) {
    constexpr std::array<std::string_view, 8> writers{
        "no Riprap",
        "Riprap 0.1 and 0.2",
        "a Riprap on the way to 0.3",
        "a Riprap on the way to 0.3",
        "a Riprap on the way to 0.3",
        "a Riprap on the way to 0.3",
        "a Riprap on the way to 0.3",
        "Riprap 0.3",
    };
    return version < writers.size() ? writers[version] : "a later Riprap";
}

}  // namespace riprap::io
