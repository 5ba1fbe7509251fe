// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/geometry/dda_files/dda_files.hpp"
#include "riprap/geometry/dda_files/dda_text.hpp"
#include "riprap/geometry/dda_files/dda_unread.hpp"

namespace riprap::geometry {

using namespace dda_text;

namespace {

/// Reports a line that ends where it begins.
void refuse_no_length(const Vec2& begin, const Vec2& end, const Word& word, Numbers& numbers) {
    if (begin == end && !numbers.has_problems()) {
        numbers.report(word, fmt::format("a line from ({:.9g}, {:.9g}) to the same point", begin.x, begin.y),
                       "two ends apart");
    }
}

void read_points(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                 std::vector<Vec2>& points) {
    for (const std::size_t child : list.children) {
        const auto [x, y] = numbers.list<2>(elements[child]);
        points.push_back({x, y});
    }
}

/// The two ends of a line. One without length would be left out when blocks are cut, unsaid.
PlanarJoint read_line(const MarkupElement& element, Numbers& numbers, std::int32_t type) {
    const auto [x1, y1, x2, y2] = numbers.list<4>(element);
    if (!element.words.empty()) {
        refuse_no_length({x1, y1}, {x2, y2}, element.words.front(), numbers);
    }
    return {{x1, y1}, {x2, y2}, type};
}

void read_geometry_list(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                        DdaGeometry& geometry) {
    if (list.name == "Edgenodedist") {
        geometry.snap = numbers.amount(list, "distance");
    } else if (list.name == "Jointlist") {
        for (const std::size_t child : list.children) {
            const std::int32_t type = numbers.whole(elements[child], "type");
            geometry.joints.push_back(read_line(elements[child], numbers, type));
        }
    } else if (list.name == "Fixedpointlist") {
        for (const std::size_t child : list.children) {
            if (elements[child].name == "Line") {
                const auto [x1, y1, x2, y2] = numbers.list<4>(elements[child]);
                geometry.fixed_lines.push_back({{x1, y1}, {x2, y2}, 0});
            } else {
                const auto [x, y] = numbers.list<2>(elements[child]);
                geometry.fixed_lines.push_back({{x, y}, {x, y}, 0});
            }
        }
    } else if (list.name == "Loadpointlist") {
        read_points(elements, list, numbers, geometry.load_points);
    } else if (list.name == "Measuredpointlist") {
        read_points(elements, list, numbers, geometry.measured_points);
    } else if (list.name == "Holepointlist") {
        read_points(elements, list, numbers, geometry.hole_points);
    } else if (list.name == "Seispointlist" || list.name == "Seismicpointlist") {
        read_points(elements, list, numbers, geometry.seismic_points);
    } else if (list.name == "Boltlist") {
        for (const std::size_t child : list.children) {
            geometry.bolts.push_back(read_line(elements[child], numbers, 0));
        }
    } else if (list.name == "Matlinelist") {
        note_unused(geometry.notes, list);  // blocks of a section are of one material
    } else {
        take_unread(elements, list,
                    {"Edgenodedist", "Jointlist", "Fixedpointlist", "Loadpointlist", "Measuredpointlist",
                     "Holepointlist", "Seispointlist", "Seismicpointlist", "Boltlist", "Matlinelist"},
                    numbers, geometry.notes);
    }
}

void read_marked_geometry(std::string_view bytes, const std::string& file, ProblemList& problems,
                          DdaGeometry& geometry) {
    Numbers numbers(file, problems);
    const std::vector<MarkupElement> elements = read_markup(bytes, file, problems);
    bool has_geometry = false;
    for (const MarkupElement& element : elements) {
        if (element.name == "Geometry") {
            if (has_geometry) {
                numbers.report({element.name, element.line, element.column}, "a second <Geometry>", "one");
            }
            has_geometry = true;
            for (const std::size_t child : element.children) {
                const MarkupElement& list = elements[child];
                read_geometry_list(elements, list, numbers, geometry);
                if (list.name.ends_with("list")) {
                    compare_counts(list, static_cast<std::int64_t>(list.children.size()), "entries", numbers);
                }
            }
        }
    }
    if (!has_geometry) {
        problems.add(file, "there is no <Geometry>", "a geometry file of the 2D-DDA family");
    }
}

/// Lines "x1 y1 x2 y2 type" or without the type.
void read_bare_lines(TextReader& reader, Numbers& numbers, std::int64_t count, bool has_type,
                     std::vector<PlanarJoint>& lines) {
    for (std::int64_t k = 0; k < count && !numbers.has_problems(); ++k) {
        PlanarJoint line;
        const Word first = reader.next_word();
        line.begin.x = numbers.number(first, "x of a begin");
        line.begin.y = numbers.number(reader.next_word(), "y of a begin");
        line.end.x = numbers.number(reader.next_word(), "x of an end");
        line.end.y = numbers.number(reader.next_word(), "y of an end");
        line.type = has_type ? static_cast<std::int32_t>(numbers.count(reader.next_word(), "a type")) : 0;
        if (has_type) {  // a fixed point is a line without length
            refuse_no_length(line.begin, line.end, first, numbers);
        }
        lines.push_back(line);
    }
}

void read_bare_points(TextReader& reader, Numbers& numbers, std::int64_t count, std::vector<Vec2>& points) {
    for (std::int64_t k = 0; k < count && !numbers.has_problems(); ++k) {
        const double x = numbers.number(reader.next_word(), "x of a point");
        points.push_back({x, numbers.number(reader.next_word(), "y of a point")});
    }
}

void read_bare_geometry(std::string_view bytes, const std::string& file, ProblemList& problems, DdaGeometry& geometry) {
    Numbers numbers(file, problems);
    TextReader reader(bytes);
    geometry.snap = numbers.number_in(reader.next_word(), "the least distance of an edge from a node", 0, HUGE_VAL,
                                      "a distance of 0 or more");
    const std::int64_t joints = numbers.count(reader.next_word(), "the number of joints");
    const Word outline = reader.next_word();
    geometry.outline_count = static_cast<std::int32_t>(numbers.count(outline, "the number of outline joints"));
    if (geometry.outline_count > joints) {
        numbers.report(outline, fmt::format("{} outline joints among {} joints", geometry.outline_count, joints),
                       "at most as many as joints");
    }
    const std::int64_t materials = numbers.count(reader.next_word(), "the number of material lines");
    const std::int64_t bolts = numbers.count(reader.next_word(), "the number of bolts");
    const std::int64_t fixed = numbers.count(reader.next_word(), "the number of fixed points");
    const std::int64_t loads = numbers.count(reader.next_word(), "the number of load points");
    const std::int64_t measured = numbers.count(reader.next_word(), "the number of measured points");
    const std::int64_t holes = numbers.count(reader.next_word(), "the number of hole points");
    read_bare_lines(reader, numbers, joints, true, geometry.joints);
    read_bare_lines(reader, numbers, materials, true, geometry.material_lines);
    read_bare_lines(reader, numbers, bolts, true, geometry.bolts);
    read_bare_lines(reader, numbers, fixed, false, geometry.fixed_lines);
    read_bare_points(reader, numbers, loads, geometry.load_points);
    read_bare_points(reader, numbers, measured, geometry.measured_points);
    read_bare_points(reader, numbers, holes, geometry.hole_points);
    if (const Word rest = reader.next_word(); !rest.is_empty() && !numbers.has_problems()) {
        numbers.report(rest, fmt::format("{} follows the last point", quote(rest.text)), "the end of the text");
    }
}

}  // namespace

namespace {

/// "; x 0 to 40, y 0 to 20 m" of the joints; empty where there are none.
std::string extent_text(const DdaGeometry& geometry) {
    if (geometry.joints.empty()) {
        return "";
    }
    Vec2 low = geometry.joints.front().begin, high = low;
    for (const PlanarJoint& joint : geometry.joints) {
        for (const Vec2& x : {joint.begin, joint.end}) {
            low = {std::min(low.x, x.x), std::min(low.y, x.y)};
            high = {std::max(high.x, x.x), std::max(high.y, x.y)};
        }
    }
    return fmt::format("; x {:.9g} to {:.9g}, y {:.9g} to {:.9g} m", low.x, high.x, low.y, high.y);
}

}  // namespace

DdaGeometry read_dda_geometry(std::string_view bytes, const std::string& file) {
    DdaGeometry geometry;
    ProblemList problems;
    (is_markup(bytes) ? read_marked_geometry : read_bare_geometry)(bytes, file, problems, geometry);
    problems.throw_if_any();
    geometry.notes.insert(
        geometry.notes.begin(),
        fmt::format("{} joints, {} fixed, {} load, {} measured, {} hole points, {} bolts{}", geometry.joints.size(),
                    geometry.fixed_lines.size(), geometry.load_points.size(), geometry.measured_points.size(),
                    geometry.hole_points.size(), geometry.bolts.size(), extent_text(geometry)));
    return geometry;
}

}  // namespace riprap::geometry
