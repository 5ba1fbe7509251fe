// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "riprap/geometry/surface/number_grain.hpp"
#include "riprap/geometry/text/line_ends.hpp"
#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

constexpr std::array ignored_keywords = {"s",        "usemtl",   "mtllib", "maplib",     "usemap",   "bevel",
                                         "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj"};
constexpr std::array free_form_keywords = {"vp",   "cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",  "parm",
                                           "trim", "hole",   "scrv", "sp",   "end",  "con",  "ctech", "stech", "mg"};

template <class List>
bool is_one_of(std::string_view word, const List& list) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

class ObjReader {
 public:
    ObjReader(std::string_view text, const std::string& file, double scale) : reader_(text), scale_(scale) {
        surface_.file = file;
    }

    Surface read() {
        do {
            const Word keyword = next();
            if (!keyword.is_empty()) {
                read_statement(keyword);
            }
        } while (reader_.next_line());
        if (surface_.face_count() == 0 && problems_.is_empty()) {
            problems_.add(surface_.file, "no faces", "at least four faces that close a volume");
        }
        problems_.throw_if_any();
        if (dropped_count_ > 0) {
            const SourcePlace first{surface_.file, dropped_line_, 1};
            surface_.add_note(first,
                              fmt::format("{} points and lines, the first here, bound no volume", dropped_count_),
                              "they are not used");
        }
        surface_.grain = grain_;
        check_grain(surface_);
        return std::move(surface_);
    }

 private:
    void problem(const Word& at, std::string message, std::string allowed) {
        problems_.add(SourcePlace{surface_.file, at.line, at.column}, std::move(message), std::move(allowed));
    }

    /// The next word of the statement: stops at a comment, goes on to the next line after a lone backslash.
    Word next() {
        while (true) {
            Word word = reader_.next_word_on_line();
            if (word.text == "\\" && reader_.next_line()) {
                continue;
            }
            const std::size_t comment = word.text.find('#');
            if (comment != std::string_view::npos) {
                word.text = word.text.substr(0, comment);
                reader_.rest_of_line();
            }
            return word;
        }
    }

    void read_statement(const Word& keyword) {
        if (keyword.text == "v") {
            read_vertex(keyword);
        } else if (keyword.text == "f") {
            read_face(keyword);
        } else if (keyword.text == "vt") {
            texture_count_ += read_numbers(keyword, 1, 3).has_value() ? 1 : 0;
        } else if (keyword.text == "vn") {
            normal_count_ += read_numbers(keyword, 3, 3).has_value() ? 1 : 0;
        } else if (keyword.text == "o" || keyword.text == "g") {
            open_body(keyword);
        } else if (keyword.text == "p" || keyword.text == "l") {
            dropped_line_ = dropped_count_++ == 0 ? keyword.line : dropped_line_;
        } else if (is_one_of(keyword.text, free_form_keywords)) {
            problem(keyword, quote(keyword.text) + " belongs to free-form curves and surfaces",
                    "flat polygons; convert the file to polygons");
        } else if (!is_one_of(keyword.text, ignored_keywords)) {
            problem(keyword, "unknown statement " + quote(keyword.text), "v, vt, vn, f, o, g, s, usemtl, mtllib, p, l");
        }
    }

    /// Between `fewest` and `most` finite numbers up to the end of the statement.
    std::optional<std::array<double, 7>> read_numbers(const Word& keyword, std::size_t fewest, std::size_t most) {
        std::array<double, 7> numbers{};
        std::size_t count = 0;
        for (Word word = next(); !word.is_empty(); word = next()) {
            const auto value = parse_number(word.text);
            if (!value || !std::isfinite(*value)) {
                problem(word, quote(word.text) + " is no finite number", "finite numbers");
                return std::nullopt;
            }
            if (count < most) {
                numbers[count] = *value;
                grain_ = keyword.text == "v" && count < 3 ? std::max(grain_, scale_ * grain_of(word.text)) : grain_;
            }
            ++count;
        }
        if (count < fewest || count > most) {
            problem(keyword, fmt::format("{} numbers after {}", count, quote(keyword.text)),
                    fewest == most ? fmt::format("{}", fewest) : fmt::format("{} to {}", fewest, most));
            return std::nullopt;
        }
        return numbers;
    }

    void read_vertex(const Word& keyword) {
        if (surface_.vertices.size() >= SurfaceLimits::vertices) {
            problem(keyword, "too many vertices", fmt::format("at most {}", SurfaceLimits::vertices));
            problems_.throw_if_any();
        }
        // x y z, then an optional weight (used by curves only) or colour, or both.
        const auto numbers = read_numbers(keyword, 3, 7);
        Vec3 vertex;
        for (int axis = 0; numbers && axis < 3; ++axis) {
            vertex[axis] = (*numbers)[static_cast<std::size_t>(axis)] * scale_;
            if (!(std::abs(vertex[axis]) <= SurfaceLimits::coordinate)) {
                problem(keyword, fmt::format("coordinate {:g} m", vertex[axis]),
                        fmt::format("at most {:g} m", SurfaceLimits::coordinate));
            }
        }
        surface_.vertices.push_back(vertex);  // kept also when wrong, so that later indices mean what they say
    }

    /// One of the up to three indices of a corner, as a position from 0.
    std::optional<std::int32_t> read_index(const Word& word, std::string_view text, std::size_t defined,
                                           std::string_view kind) {
        const auto index = parse_integer(text);
        const auto count = static_cast<std::int64_t>(defined);
        if (!index || *index == 0 || *index > count || *index < -count) {
            problem(word, fmt::format("{} index {} in corner {}", kind, quote(text), quote(word.text)),
                    count == 0 ? fmt::format("none: no {} is defined yet", kind)
                               : fmt::format("1 to {} or -{} to -1: {} defined so far", count, count, count));
            return std::nullopt;
        }
        return static_cast<std::int32_t>(*index > 0 ? *index - 1 : count + *index);
    }

    std::optional<std::int32_t> read_corner(const Word& word) {
        std::array<std::string_view, 3> part{};
        std::size_t count = 0;
        for (std::string_view rest = word.text;; ++count) {
            const std::size_t slash = rest.find('/');
            if (count == 3 || (slash == std::string_view::npos && rest.empty())) {
                problem(word, "corner " + quote(word.text), "v, v/vt, v//vn or v/vt/vn");
                return std::nullopt;
            }
            part[count] = rest.substr(0, slash);
            if (slash == std::string_view::npos) {
                break;
            }
            rest.remove_prefix(slash + 1);
        }
        const auto vertex = read_index(word, part[0], surface_.vertices.size(), "vertex");
        const bool has_texture = part[1].empty() || read_index(word, part[1], texture_count_, "texture");
        const bool has_normal = part[2].empty() || read_index(word, part[2], normal_count_, "normal");
        return has_texture && has_normal ? vertex : std::nullopt;
    }

    void read_face(const Word& keyword) {
        std::vector<std::int32_t> corners;
        bool is_sound = true;
        for (Word word = next(); !word.is_empty(); word = next()) {
            const auto corner = read_corner(word);
            is_sound = is_sound && corner.has_value();
            if (corners.size() == SurfaceLimits::corners_of_a_face) {
                problem(word, "too many corners in one face",
                        fmt::format("at most {}", SurfaceLimits::corners_of_a_face));
                is_sound = false;
                break;
            }
            corners.push_back(corner.value_or(0));
        }
        if (corners.size() < 3) {
            problem(keyword, fmt::format("a face of {} corners", corners.size()), "at least 3");
            is_sound = false;
        }
        if (surface_.face_count() >= SurfaceLimits::faces ||
            surface_.face_vertex.size() + corners.size() > SurfaceLimits::corners) {
            problem(keyword, "too many faces",
                    fmt::format("at most {} with {} corners", SurfaceLimits::faces, SurfaceLimits::corners));
            problems_.throw_if_any();
        }
        if (is_sound) {
            if (surface_.body_names.empty()) {
                current_body_ = body_named("");
            }
            surface_.add_face(corners, current_body_, keyword.line);
        }
    }

    std::int32_t body_named(const std::string& name) {
        const auto [entry, is_new] = bodies_.try_emplace(name, static_cast<std::int32_t>(bodies_.size()));
        if (is_new) {
            surface_.body_names.push_back(name);
        }
        return entry->second;
    }

    void open_body(const Word& keyword) {
        if (surface_.body_names.size() >= SurfaceLimits::bodies) {
            problem(keyword, "too many objects and groups", fmt::format("at most {}", SurfaceLimits::bodies));
            problems_.throw_if_any();
        }
        const Word name = reader_.rest_of_line();
        const std::string_view text = name.text.substr(0, name.text.find('#'));
        current_body_ = body_named(text.empty() ? std::string{} : quote(text));
    }

    TextReader reader_;
    double scale_;
    Surface surface_;
    ProblemList problems_;
    std::map<std::string, std::int32_t> bodies_;
    std::int32_t current_body_{0};
    std::size_t texture_count_{0};
    std::size_t normal_count_{0};
    std::size_t dropped_count_{0};
    std::uint32_t dropped_line_{0};
    double grain_{0};
};

}  // namespace

Surface read_obj(std::string_view bytes, const std::string& file, double scale) {
    check_surface_input(file, bytes.size(), scale);
    const std::string_view text = without_byte_order_mark(bytes);
    const std::string with_line_feeds = has_bare_returns(text) ? line_feeds_in(text) : "";
    return ObjReader(with_line_feeds.empty() ? text : with_line_feeds, file, scale).read();
}

}  // namespace riprap::geometry
