// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/expect_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/scene/text/heading_units.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/number_files.hpp"
#include "riprap/sim/reductions.hpp"

namespace riprap::scene {

namespace {

/// Says whether numbers are in the unit of SI that a heading names, whatever they are.
geometry::UnitAnswer answer_to(std::string_view text) {
    const std::optional<Unit> unit = parse_heading_unit(text);
    if (!unit) {
        return {text == "-", true, "a unit of SI"};
    }
    return {true, true, std::abs(to_si(1, *unit) - 1) <= 1e-12 ? "" : "numbers in units of SI"};
}

/// Two columns, along and value.
geometry::TableForm form_of_curve() {
    geometry::TableForm form;
    form.columns = {{"along", {"along", "t", "time", "x"}}, {"value", {"value", "y"}}};
    form.most_rows = limits::table_rows;
    form.unit = [](std::size_t, std::string_view text) { return answer_to(text); };
    return form;
}

/// Warns of points of a curve over time that no run of the case reaches: before its start, or after its end.
void look_at_times(CaseBuild& build, const SourcePlace& place, const sim::Expect& expect) {
    const std::vector<double>& along = expect.curve.along;
    if (expect.curve.quantity != "time" || along.empty()) {
        return;
    }
    const auto [first, last] = std::minmax_element(along.begin(), along.end());
    if (*first < 0 || *last > build.model.time.end) {
        build.warnings.push_back(to_string(Diagnostic{
            place,
            fmt::format("the points of '{}' go from {:.6g} to {:.6g} s, where the run goes from 0 to {:.6g} s",
                        expect.name, *first, *last, build.model.time.end),
            "points within the run: those that it never reaches have no value"}));
    }
}

}  // namespace

bool read_curve(CaseBuild& build, const Value& table, sim::Expect& expect) {
    const Value* curve = table.find("curve");
    if (sim::is_of_curve(expect.reduce) != (curve != nullptr)) {
        build.problem(curve != nullptr ? curve->place : table.place,
                      "'curve' goes with reduce = \"rms\", \"mean_error\" and \"worst\"", "give both or none");
        return false;
    }
    if (curve == nullptr) {
        return true;
    }
    expect.curve.quantity = get_text(*curve, "along");
    expect.curve.shift = get_number(*curve, "shift");
    if (const Value* points = curve->find("points")) {
        for (const Value& point : points->items) {
            expect.curve.along.push_back(point.items[0].as_number());
            expect.curve.value.push_back(point.items[1].as_number());
        }
        look_at_times(build, points->place, expect);
        return true;
    }
    const Value& file = get(*curve, "file");
    const auto rows = read_numbers(build.files, file.text, form_of_curve(), file.place, build.problems, build.notes);
    for (std::size_t i = 0; rows && i < rows->row_count(); ++i) {
        expect.curve.along.push_back(rows->at(i, 0));
        expect.curve.value.push_back(rows->at(i, 1));
    }
    look_at_times(build, file.place, expect);
    return rows.has_value();
}

}  // namespace riprap::scene
