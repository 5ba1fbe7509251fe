// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/geometry/dda_files/dda_files.hpp"
#include "riprap/geometry/dda_files/dda_text.hpp"
#include "riprap/geometry/dda_files/dda_unread.hpp"

namespace riprap::geometry {

using namespace dda_text;

namespace {

// Ranges of values: one column too few or too many in a row of bare numbers shows in them.
constexpr double most_friction = 89.999;  // degrees
constexpr const char* ratio = "a Poisson's ratio from -1 to 0.5";
constexpr const char* friction_range = "an angle in degrees from 0 to below 90";

/// Elements that are read; Loadpointlist apart, each once.
const std::vector<std::string_view> settings{"Analysistype",    "Planestrain",  "Numtimesteps", "Maxtimestep",
                                             "Maxdisplacement", "Autopenalty",  "AConstants",   "Blockmaterial",
                                             "Jointproperties", "Loadpointlist"};
const std::vector<std::string_view> of_material{"Unitmass",     "Unitweight", "Youngsmod",
                                                "Poissonratio", "Istress",    "Ivelocity"};
const std::vector<std::string_view> of_joint{"Friction", "Cohesion", "Tensile"};

/// Tells which of two words an attribute is; another one is a problem.
bool is_first_of(const MarkupElement& element, std::string_view key, std::string_view one, std::string_view other,
                 Numbers& numbers) {
    const Word* word = numbers.attribute(element, key);
    if (word == nullptr || is_same_keyword(word->text, other)) {
        return false;
    }
    if (!is_same_keyword(word->text, one)) {
        numbers.report(*word, fmt::format("{} is {}", key, quote(word->text)), fmt::format("{} or {}", one, other));
    }
    return true;
}

/// Reports a second element of the same name among those `known`, of materials and joints of the same type: one of both
/// would go unread.
void refuse_second(const std::vector<MarkupElement>& elements, const MarkupElement& parent,
                   const MarkupElement& element, const std::vector<std::string_view>& known, Numbers& numbers) {
    if (std::find(known.begin(), known.end(), element.name) == known.end() || element.name == "Loadpointlist") {
        return;
    }
    const bool is_typed = element.name == "Blockmaterial" || element.name == "Jointproperties";
    const auto type_of = [is_typed](const MarkupElement& one) {
        const Word* word = is_typed ? one.attribute("type") : nullptr;
        return word == nullptr ? std::string_view{} : word->text;
    };
    for (const std::size_t child : parent.children) {
        const MarkupElement& other = elements[child];
        if (&other == &element) {
            return;
        }
        if (other.name == element.name && type_of(other) == type_of(element)) {
            numbers.report({element.name, element.line, element.column},
                           fmt::format("a second <{}>{}; the first is in line {}", element.name,
                                       is_typed ? fmt::format(" of type {}", quote(type_of(element))) : "", other.line),
                           "each once");
            return;
        }
    }
}

DdaMaterial read_material(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                          std::vector<std::string>& notes) {
    DdaMaterial material;
    for (const std::size_t child : list.children) {
        const MarkupElement& element = elements[child];
        refuse_second(elements, list, element, of_material, numbers);
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
            take_unread(elements, element, of_material, numbers, notes);
        }
    }
    return material;
}

DdaJointProperties read_joint(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                              std::vector<std::string>& notes) {
    DdaJointProperties joint;
    for (const std::size_t child : list.children) {
        const MarkupElement& element = elements[child];
        refuse_second(elements, list, element, of_joint, numbers);
        if (element.name == "Friction") {
            joint.friction_angle = numbers.value_in(element, 0, most_friction, friction_range) * std::numbers::pi / 180;
        } else if (element.name == "Cohesion") {
            joint.cohesion = numbers.value_in(element, 0, HUGE_VAL, not_negative);
        } else if (element.name == "Tensile") {
            joint.tension = numbers.value_in(element, 0, HUGE_VAL, not_negative);
        } else {
            take_unread(elements, element, of_joint, numbers, notes);
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

/// True where the numbers of one line could be records of a time and one component too: both times increase.
bool may_be_pairs(const std::vector<Word>& words, std::size_t begin, std::size_t end) {
    if (end == begin || (end - begin) % 6 != 0) {
        return false;
    }
    const auto is_increasing = [&](std::size_t width) {
        for (std::size_t k = begin + width; k < end; k += width) {
            if (!(parse_number(words[k].text) > parse_number(words[k - width].text))) {
                return false;
            }
        }
        return true;
    };
    return is_increasing(2) && is_increasing(3);
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
        if (element.attribute("numpoints") == nullptr && may_be_pairs(element.words, begin, end)) {
            numbers.report(element.words[begin],
                           fmt::format("{} numbers could be {} records of two or {} of three", end - begin,
                                       (end - begin) / 2, (end - begin) / 3),
                           "';' after each record of time and two components, or their number as numpoints");
            return history;
        }
        for (; begin < end; begin += 3) {
            const auto time = parse_number(element.words[begin].text);
            if (time && !history.records.empty() && !(*time > history.records.back()[0])) {
                numbers.report(element.words[begin],
                               fmt::format("time {} does not follow {}", *time, history.records.back()[0]),
                               "increasing times");
            }
            history.records.push_back({numbers.number(element.words[begin], "a time"),
                                       numbers.number(element.words[begin + 1], "a force along x"),
                                       numbers.number(element.words[begin + 2], "a force along y")});
        }
    }
    compare_counts(element, static_cast<std::int64_t>(history.records.size()), "records", numbers);
    return history;
}

void read_loads(const std::vector<MarkupElement>& elements, const MarkupElement& list, Numbers& numbers,
                std::vector<DdaLoadHistory>& loads) {
    for (const std::size_t child : list.children) {
        loads.push_back(read_load(elements[child], numbers));
    }
    compare_counts(list, static_cast<std::int64_t>(list.children.size()), "entries", numbers);
}

void read_setting(const std::vector<MarkupElement>& elements, const MarkupElement& element, Numbers& numbers,
                  DdaAnalysis& analysis) {
    if (element.name == "Analysistype") {
        analysis.is_dynamic = is_first_of(element, "type", "dynamic", "static", numbers);
    } else if (element.name == "Planestrain") {
        analysis.is_plane_strain = is_first_of(element, "flag", "yes", "no", numbers);
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
                take_unread(elements, elements[child], {"ShearNormRatio"}, numbers, analysis.notes);
            }
        }
    } else if (element.name == "Blockmaterial") {
        analysis.materials.push_back(read_material(elements, element, numbers, analysis.notes));
    } else if (element.name == "Jointproperties") {
        analysis.joints.push_back(read_joint(elements, element, numbers, analysis.notes));
    } else if (element.name == "Loadpointlist") {
        read_loads(elements, element, numbers, analysis.loads);
    } else {
        take_unread(elements, element, settings, numbers, analysis.notes);
    }
}

void read_marked_analysis(std::string_view bytes, const std::string& file, ProblemList& problems,
                          DdaAnalysis& analysis) {
    Numbers numbers(file, problems);
    const std::vector<MarkupElement> elements = read_markup(bytes, file, problems);
    bool has_analysis = false;
    for (const MarkupElement& element : elements) {
        if (element.name == "Analysis") {
            if (has_analysis) {
                numbers.report({element.name, element.line, element.column}, "a second <Analysis>", "one");
            }
            has_analysis = true;
            for (const std::size_t child : element.children) {
                refuse_second(elements, element, elements[child], settings, numbers);
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
    const Word rest = reader.next_word();
    if (rest.is_empty() || numbers.has_problems()) {
        return;
    }
    std::size_t count = 1;  // one number may be the factor of the over-relaxation
    for (; !reader.next_word().is_empty(); ++count) {
    }
    if (count > 1) {
        numbers.report(rest, fmt::format("{} numbers follow the last joint material, and are not read", count),
                       "loads as <Loadpointlist> of the marked-up form, or [[section.load]] of the case");
    } else {
        analysis.notes.push_back(fmt::format("line {}: {} is not used", rest.line, quote(rest.text)));
    }
}

}  // namespace

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
