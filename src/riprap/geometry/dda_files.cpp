// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/dda_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "riprap/geometry/dda_markup.hpp"

namespace riprap::geometry {

namespace {

constexpr std::int64_t most_entries = 10'000'000;

// Ranges of values: one column too few or too many in a row of bare numbers shows in them.
constexpr double most_friction = 89.999;  // degrees
constexpr const char* not_negative = "a number of 0 or more";
constexpr const char* ratio = "a Poisson's ratio from -1 to 0.5";
constexpr const char* friction_range = "an angle in degrees from 0 to below 90";

bool is_markup(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && bytes[first] == '<';
}

/// Turns words into numbers and reports those that are none.
class Numbers {
 public:
    Numbers(const std::string& file, ProblemList& problems) : file_(file), problems_(problems) {}

    double number(const Word& word, const char* what) {
        const std::optional<double> value = parse_number(word.text);
        if (value && std::isfinite(*value)) {
            return *value;
        }
        if (!has_ended(word, what)) {
            report(word, fmt::format("{} is {}, not a finite number", what, quote(word.text)));
        }
        return 0;
    }
    std::int64_t count(const Word& word, const char* what) {
        const std::optional<std::int64_t> value = parse_integer(word.text);
        if (value && *value >= 0 && *value <= most_entries) {
            return *value;
        }
        if (!has_ended(word, what)) {
            report(word, fmt::format("{} is {}", what, quote(word.text)),
                   fmt::format("an integer from 0 to {}", most_entries));
        }
        return 0;
    }
    /// A number that must be within a range.
    double number_in(const Word& word, const char* what, double low, double high, const char* allowed) {
        const double value = number(word, what);
        if (!(value >= low && value <= high)) {
            report(word, fmt::format("{} is {}", what, quote(word.text)), allowed);
        }
        return value;
    }
    void report(const Word& word, std::string message, std::string allowed = {}) {
        problems_.add(SourcePlace{file_, word.line, word.column}, std::move(message), std::move(allowed));
    }
    bool has_problems() const { return !problems_.is_empty(); }

    /// The numbers of an element's text, as many as asked for.
    template <std::size_t N>
    std::array<double, N> list(const MarkupElement& element) {
        std::array<double, N> values{};
        if (element.words.size() != N) {
            report({element.name, element.line, element.column},
                   fmt::format("<{}> holds {} numbers", element.name, element.words.size()), fmt::format("{}", N));
            return values;
        }
        for (std::size_t k = 0; k < N; ++k) {
            values[k] = number(element.words[k], "a coordinate or value");
        }
        return values;
    }
    /// The one number of an element's text, within a range.
    double value_in(const MarkupElement& element, double low, double high, const char* allowed) {
        const double value = list<1>(element)[0];
        if (!(value >= low && value <= high)) {
            report(element.words.empty() ? Word{element.name, element.line, element.column} : element.words[0],
                   fmt::format("<{}> is {:g}", element.name, value), allowed);
        }
        return value;
    }
    /// The value of an attribute; null, with a problem, where there is none.
    const Word* attribute(const MarkupElement& element, std::string_view key) {
        const Word* word = element.attribute(key);
        if (word == nullptr) {
            report({element.name, element.line, element.column}, fmt::format("<{}> has no {}", element.name, key));
        }
        return word;
    }
    double amount(const MarkupElement& element, std::string_view key) {
        const Word* word = attribute(element, key);
        return word == nullptr ? 0 : number_in(*word, std::string(key).c_str(), 0, HUGE_VAL, "a number of 0 or more");
    }
    std::int32_t whole(const MarkupElement& element, std::string_view key) {
        const Word* word = attribute(element, key);
        return word == nullptr ? 0 : static_cast<std::int32_t>(count(*word, std::string(key).c_str()));
    }

 private:
    /// Tells whether the text has no more words; reports that at the first one that is missing.
    bool has_ended(const Word& word, const char* what) {
        if (word.is_empty() && !is_end_told_) {
            report(word, fmt::format("the text ends before {}", what));
            is_end_told_ = true;
        }
        return word.is_empty();
    }

    const std::string& file_;
    ProblemList& problems_;
    bool is_end_told_{false};
};

bool has_flag(const MarkupElement& element, std::string_view key, std::string_view wanted) {
    const Word* word = element.attribute(key);
    return word != nullptr && is_same_keyword(word->text, wanted);
}

void note_unused(std::vector<std::string>& notes, const MarkupElement& element) {
    notes.push_back(fmt::format("line {}: <{}> is not used", element.line, element.name));
}

// --- geometry
// ---------------------------------------------------------------------------------------------------------

void read_points(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                 std::vector<Vec2>& points) {
    for (const std::size_t child : list.children) {
        const auto [x, y] = numbers.list<2>(elements[child]);
        points.push_back({x, y});
    }
}

void read_geometry_list(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                        DdaGeometry& geometry) {
    if (list.name == "Edgenodedist") {
        geometry.snap = numbers.amount(list, "distance");
    } else if (list.name == "Jointlist") {
        for (const std::size_t child : list.children) {
            const auto [x1, y1, x2, y2] = numbers.list<4>(elements[child]);
            geometry.joints.push_back({{x1, y1}, {x2, y2}, numbers.whole(elements[child], "type")});
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
            const auto [x1, y1, x2, y2] = numbers.list<4>(elements[child]);
            geometry.bolts.push_back({{x1, y1}, {x2, y2}, 0});
        }
    } else {
        note_unused(geometry.notes, list);
    }
}

void read_marked_geometry(std::string_view bytes, const std::string& file, ProblemList& problems,
                          DdaGeometry& geometry) {
    Numbers numbers(file, problems);
    const std::vector<MarkupElement> elements = read_markup(bytes, file, problems);
    bool has_geometry = false;
    for (const MarkupElement& element : elements) {
        if (element.name == "Geometry") {
            has_geometry = true;
            for (const std::size_t child : element.children) {
                read_geometry_list(elements, elements[child], numbers, geometry);
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
        line.begin.x = numbers.number(reader.next_word(), "x of a begin");
        line.begin.y = numbers.number(reader.next_word(), "y of a begin");
        line.end.x = numbers.number(reader.next_word(), "x of an end");
        line.end.y = numbers.number(reader.next_word(), "y of an end");
        line.type = has_type ? static_cast<std::int32_t>(numbers.count(reader.next_word(), "a type")) : 0;
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

// --- analysis
// ---------------------------------------------------------------------------------------------------------

DdaMaterial read_material(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                          std::vector<std::string>& notes) {
    DdaMaterial material;
    for (const std::size_t child : list.children) {
        const MarkupElement& element = elements[child];
        if (element.name == "Unitmass") {
            material.density = numbers.value_in(element, 0, HUGE_VAL, not_negative);
        } else if (element.name == "Unitweight") {
            material.unit_weight = numbers.value_in(element, 0, HUGE_VAL, not_negative);
        } else if (element.name == "Youngsmod") {
            material.youngs_modulus = numbers.value_in(element, 0, HUGE_VAL, not_negative);
        } else if (element.name == "Poissonratio") {
            material.poisson_ratio = numbers.value_in(element, -1, 0.5, ratio);
        } else if (element.name == "Istress") {
            material.stress = numbers.list<3>(element);
        } else if (element.name == "Ivelocity") {
            material.velocity = numbers.list<3>(element);
        } else {
            note_unused(notes, element);
        }
    }
    return material;
}

DdaJointProperties read_joint(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                              std::vector<std::string>& notes) {
    DdaJointProperties joint;
    for (const std::size_t child : list.children) {
        const MarkupElement& element = elements[child];
        if (element.name == "Friction") {
            joint.friction_angle = numbers.value_in(element, 0, most_friction, friction_range) * std::numbers::pi / 180;
        } else if (element.name == "Cohesion") {
            joint.cohesion = numbers.value_in(element, 0, HUGE_VAL, not_negative);
        } else if (element.name == "Tensile") {
            joint.tension = numbers.value_in(element, 0, HUGE_VAL, not_negative);
        } else {
            note_unused(notes, element);
        }
    }
    return joint;
}

/// Where records of three end among the words of a load: at each ';', else at the end of each line.
std::vector<std::size_t> ends_of_records(const MarkupElement& element) {
    std::vector<std::size_t> ends = element.marks;
    for (std::size_t k = 1; element.marks.empty() && k < element.words.size(); ++k) {
        if (element.words[k].line != element.words[k - 1].line) {
            ends.push_back(k);
        }
    }
    ends.push_back(element.words.size());
    return ends;
}

/// Reads records of time and two components. Several may stand between marks; none may be cut by one.
DdaLoadHistory read_load(const MarkupElement& element, Numbers& numbers) {
    DdaLoadHistory history;
    if (element.words.empty()) {
        numbers.report({element.name, element.line, element.column}, "a load without numbers",
                       "records of time and two components");
    }
    std::size_t begin = 0;
    for (const std::size_t end : ends_of_records(element)) {
        if ((end - begin) % 3 != 0) {
            numbers.report(element.words[begin], fmt::format("a record of {} numbers", end - begin),
                           "time and two components");
            return history;
        }
        for (; begin < end; begin += 3) {
            history.records.push_back({numbers.number(element.words[begin], "a time"),
                                       numbers.number(element.words[begin + 1], "a force along x"),
                                       numbers.number(element.words[begin + 2], "a force along y")});
        }
    }
    const Word* promised = element.attribute("numpoints");
    const auto count = static_cast<std::int64_t>(history.records.size());
    if (promised != nullptr && numbers.count(*promised, "numpoints") != count) {
        numbers.report(*promised, fmt::format("numpoints is {}, and {} records follow", quote(promised->text), count),
                       "the number of records");
    }
    return history;
}

void read_loads(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                std::vector<DdaLoadHistory>& loads) {
    for (const std::size_t child : list.children) {
        loads.push_back(read_load(elements[child], numbers));
    }
}

void read_setting(const std::vector<MarkupElement>& elements, const MarkupElement& element, Numbers& numbers,
                  DdaAnalysis& analysis) {
    if (element.name == "Analysistype") {
        analysis.is_dynamic = has_flag(element, "type", "dynamic");
    } else if (element.name == "Planestrain") {
        analysis.is_plane_strain = has_flag(element, "flag", "yes");
    } else if (element.name == "Numtimesteps") {
        analysis.step_count = numbers.whole(element, "timesteps");
    } else if (element.name == "Maxtimestep") {
        analysis.time_step = numbers.amount(element, "maxtimestep");
    } else if (element.name == "Maxdisplacement") {
        analysis.displacement_ratio = numbers.amount(element, "maxdisplacement");
    } else if (element.name == "Autopenalty") {
        analysis.penalty_factor = numbers.amount(element, "pfactor");
    } else if (element.name == "AConstants") {
        for (const std::size_t child : element.children) {
            if (elements[child].name == "ShearNormRatio") {
                analysis.shear_ratio = numbers.amount(elements[child], "value");
            } else {
                note_unused(analysis.notes, elements[child]);
            }
        }
    } else if (element.name == "Blockmaterial") {
        analysis.materials.push_back(read_material(elements, element, numbers, analysis.notes));
    } else if (element.name == "Jointproperties") {
        analysis.joints.push_back(read_joint(elements, element, numbers, analysis.notes));
    } else if (element.name == "Loadpointlist") {
        read_loads(elements, element, numbers, analysis.loads);
    } else {
        note_unused(analysis.notes, element);
    }
}

void read_marked_analysis(std::string_view bytes, const std::string& file, ProblemList& problems,
                          DdaAnalysis& analysis) {
    Numbers numbers(file, problems);
    const std::vector<MarkupElement> elements = read_markup(bytes, file, problems);
    bool has_analysis = false;
    for (const MarkupElement& element : elements) {
        if (element.name == "Analysis") {
            has_analysis = true;
            for (const std::size_t child : element.children) {
                read_setting(elements, elements[child], numbers, analysis);
            }
        }
    }
    if (!has_analysis) {
        problems.add(file, "there is no <Analysis>", "an analysis file of the 2D-DDA family");
    }
}

DdaMaterial read_bare_material(TextReader& reader, Numbers& numbers) {
    DdaMaterial material;
    const auto next = [&](const char* what, double low, double high, const char* allowed) {
        return numbers.number_in(reader.next_word(), what, low, high, allowed);
    };
    material.density = next("a unit mass", 0, HUGE_VAL, not_negative);
    material.unit_weight = next("a unit weight", 0, HUGE_VAL, not_negative);
    material.youngs_modulus = next("Young's modulus", 0, HUGE_VAL, not_negative);
    material.poisson_ratio = next("Poisson's ratio", -1, 0.5, ratio);
    std::array<double, 9> rest{};  // initial stress, its gradient (not used), initial velocity
    for (double& value : rest) {
        value = numbers.number(reader.next_word(), "a property of a block material");
    }
    material.stress = {rest[0], rest[1], rest[2]};
    material.velocity = {rest[6], rest[7], rest[8]};
    return material;
}

void read_bare_analysis(std::string_view bytes, const std::string& file, ProblemList& problems, DdaAnalysis& analysis) {
    Numbers numbers(file, problems);
    TextReader reader(bytes);
    analysis.is_dynamic = numbers.number(reader.next_word(), "the type of analysis") != 0;
    analysis.step_count = static_cast<std::int32_t>(numbers.count(reader.next_word(), "the number of steps"));
    const std::int64_t materials = numbers.count(reader.next_word(), "the number of block materials");
    const std::int64_t joints = numbers.count(reader.next_word(), "the number of joint materials");
    analysis.displacement_ratio = numbers.number(reader.next_word(), "the displacement ratio");
    analysis.time_step = numbers.number(reader.next_word(), "the largest time step");
    for (std::int64_t k = 0; k < materials && !numbers.has_problems(); ++k) {
        analysis.materials.push_back(read_bare_material(reader, numbers));
    }
    for (std::int64_t k = 0; k < joints && !numbers.has_problems(); ++k) {
        const double angle =
            numbers.number_in(reader.next_word(), "a friction angle", 0, most_friction, friction_range);
        const double cohesion = numbers.number_in(reader.next_word(), "a cohesion", 0, HUGE_VAL, not_negative);
        const double tension = numbers.number_in(reader.next_word(), "a tensile strength", 0, HUGE_VAL, not_negative);
        analysis.joints.push_back({angle * std::numbers::pi / 180, cohesion, tension});
    }
    if (const Word rest = reader.next_word(); !rest.is_empty() && !numbers.has_problems()) {
        analysis.notes.push_back(fmt::format("line {}: {} and what follows is not used", rest.line, quote(rest.text)));
    }
}

}  // namespace

DdaGeometry read_dda_geometry(std::string_view bytes, const std::string& file) {
    DdaGeometry geometry;
    ProblemList problems;
    (is_markup(bytes) ? read_marked_geometry : read_bare_geometry)(bytes, file, problems, geometry);
    problems.throw_if_any();
    geometry.notes.insert(
        geometry.notes.begin(),
        fmt::format("{} joints, {} fixed, {} load, {} measured, {} hole points, {} bolts", geometry.joints.size(),
                    geometry.fixed_lines.size(), geometry.load_points.size(), geometry.measured_points.size(),
                    geometry.hole_points.size(), geometry.bolts.size()));
    return geometry;
}

DdaAnalysis read_dda_analysis(std::string_view bytes, const std::string& file) {
    DdaAnalysis analysis;
    ProblemList problems;
    (is_markup(bytes) ? read_marked_analysis : read_bare_analysis)(bytes, file, problems, analysis);
    problems.throw_if_any();
    analysis.notes.insert(
        analysis.notes.begin(),
        fmt::format("{} steps of at most {} s, {} block materials, {} joint materials", analysis.step_count,
                    analysis.time_step, analysis.materials.size(), analysis.joints.size()));
    return analysis;
}

}  // namespace riprap::geometry
