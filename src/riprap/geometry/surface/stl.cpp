// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/stl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "riprap/geometry/surface/number_grain.hpp"
#include "riprap/geometry/text/line_ends.hpp"
#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t record_size = 50;

std::uint32_t read_u32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) {
        value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

float read_f32(std::string_view bytes, std::size_t at) { return std::bit_cast<float>(read_u32(bytes, at)); }

bool is_usable(double value) { return std::isfinite(value) && std::abs(value) <= SurfaceLimits::coordinate; }

const std::string allowed_coordinate = fmt::format("finite numbers of at most {:g} m", SurfaceLimits::coordinate);

/// Counts the facets whose stated normal points to the other side of their winding.
class NormalCheck {
 public:
    void look_at(const Surface& surface, const Vec3& stated) {
        const std::size_t last = surface.vertices.size();
        const Vec3 a = surface.vertices[last - 3], b = surface.vertices[last - 2], c = surface.vertices[last - 1];
        if (dot(stated, cross(b - a, c - a)) < 0.0 && count_++ == 0) {
            first_ = surface.face_count() - 1;
        }
    }
    void report(Surface& surface) const {
        if (count_ > 0) {
            surface.add_note(surface.place_of(first_),
                             fmt::format("the stated normal of {} facets, first of {}, contradicts their winding",
                                         count_, surface.name_of(first_)),
                             "the winding is used");
        }
    }

 private:
    std::size_t count_{0};
    std::size_t first_{0};
};

void add_triangle(Surface& surface, const std::array<Vec3, 3>& corners, std::uint32_t place) {
    const auto first = static_cast<std::int32_t>(surface.vertices.size());
    surface.vertices.insert(surface.vertices.end(), corners.begin(), corners.end());
    surface.add_face(std::array{first, first + 1, first + 2}, static_cast<std::int32_t>(surface.body_names.size()) - 1,
                     place);
}

class AsciiStl {
 public:
    AsciiStl(std::string_view text, const std::string& file, double scale) : reader_(text), scale_(scale) {
        surface_.file = file;
    }

    Surface read() {
        for (Word word = reader_.next_word(); !word.is_empty(); word = reader_.next_word()) {
            if (is_same_keyword(word.text, "solid")) {
                read_solid(word);
            } else {
                problem(word, fmt::format("{} outside a solid", quote(word.text)), "\"solid\"");
                skip_until({"solid"});
            }
        }
        if (surface_.face_count() == 0 && problems_.is_empty()) {
            problems_.add(surface_.file, "no facets", "at least four facets that close a volume");
        }
        problems_.throw_if_any();
        normals_.report(surface_);
        return std::move(surface_);
    }

 private:
    void problem(const Word& at, std::string message, std::string allowed) {
        problems_.add(SourcePlace{surface_.file, at.line, at.column}, std::move(message), std::move(allowed));
    }

    void read_solid(const Word& solid) {
        const Word name = reader_.rest_of_line();
        if (surface_.body_names.size() >= SurfaceLimits::bodies) {
            problem(solid, "too many solids", fmt::format("at most {}", SurfaceLimits::bodies));
            problems_.throw_if_any();
        }
        surface_.body_names.push_back(name.is_empty() ? std::string{} : quote(name.text));
        while (true) {
            const Word word = reader_.next_word();
            if (is_same_keyword(word.text, "facet")) {
                read_facet(word);
            } else if (is_same_keyword(word.text, "endsolid")) {
                reader_.rest_of_line();
                return;
            } else if (word.is_empty()) {
                problem(word, "the file ends inside a solid", "\"endsolid\"");
                return;
            } else {
                problem(word, quote(word.text) + " inside a solid", "\"facet\" or \"endsolid\"");
                skip_until({"facet", "endsolid"});
            }
        }
    }

    void read_facet(const Word& facet) {
        if (surface_.face_count() >= SurfaceLimits::faces) {
            problem(facet, "too many facets", fmt::format("at most {}", SurfaceLimits::faces));
            problems_.throw_if_any();
        }
        const std::size_t problems_before = problems_.count();
        std::array<Vec3, 3> corners{};
        Vec3 stated;
        const bool has_form = expect("normal") && read_vector(stated, 1.0, false) && expect("outer") &&
                              expect("loop") && expect("vertex") && read_vector(corners[0], scale_, true) &&  //
                              expect("vertex") && read_vector(corners[1], scale_, true) &&                    //
                              expect("vertex") && read_vector(corners[2], scale_, true) &&                    //
                              expect("endloop") && expect("endfacet");
        if (!has_form) {
            skip_until({"endfacet", "facet", "endsolid"});
            if (is_same_keyword(reader_.peek_word().text, "endfacet")) {
                reader_.next_word();
            }
        }
        if (problems_.count() == problems_before) {
            add_triangle(surface_, corners, facet.line);
            normals_.look_at(surface_, stated);
        }
    }

    bool expect(std::string_view keyword) {
        const Word word = reader_.peek_word();
        if (!is_same_keyword(word.text, keyword)) {
            problem(word, word.is_empty() ? "the file ends inside a facet" : quote(word.text) + " inside a facet",
                    fmt::format("\"{}\"; a facet is a normal and an outer loop of three vertices", keyword));
            return false;
        }
        reader_.next_word();
        return true;
    }

    /// False if there are no three words that look like numbers; a bad value is a problem but keeps the form.
    bool read_vector(Vec3& vector, double scale, bool is_corner) {
        for (int axis = 0; axis < 3; ++axis) {
            const Word word = reader_.peek_word();
            const auto value = parse_number(word.text);
            if (!value) {
                problem(word, word.is_empty() ? "the file ends inside a facet" : quote(word.text) + " is no number",
                        "three numbers");
                return false;
            }
            reader_.next_word();
            vector[axis] = *value * scale;
            surface_.grain = std::max(surface_.grain, is_corner ? scale * grain_of(word.text) : 0.0);
            if (!is_usable(vector[axis])) {
                problem(word, fmt::format("{} scaled by {:g}", quote(word.text), scale), allowed_coordinate);
            }
        }
        return true;
    }

    void skip_until(std::initializer_list<std::string_view> keywords) {
        for (Word word = reader_.peek_word(); !word.is_empty(); word = reader_.peek_word()) {
            if (std::any_of(keywords.begin(), keywords.end(),
                            [&](std::string_view k) { return is_same_keyword(word.text, k); })) {
                return;
            }
            reader_.next_word();
        }
    }

    TextReader reader_;
    double scale_;
    Surface surface_;
    ProblemList problems_;
    NormalCheck normals_;
};

Surface read_binary_stl(std::string_view bytes, const std::string& file, double scale) {
    ProblemList problems;
    Surface surface;
    surface.file = file;
    surface.is_binary = true;
    surface.body_names.emplace_back();
    const std::uint64_t size = bytes.size();
    if (size < header_size) {
        refuse(file, fmt::format("{} bytes that are no ASCII STL", size),
               "a binary STL has at least 84 bytes, an ASCII STL begins with \"solid\"");
    }
    const std::uint64_t count = read_u32(bytes, 80);
    if (count == 0 || count > SurfaceLimits::faces) {
        problems.add(file, fmt::format("byte 80: {} facets stated", count),
                     fmt::format("1 to {}", SurfaceLimits::faces));
    }
    if (size != header_size + record_size * count) {
        problems.add(file,
                     fmt::format("byte 80: {} facets stated, which takes {} bytes, but the file has {}", count,
                                 header_size + record_size * count, size),
                     "84 bytes and 50 for each facet; is the file truncated?");
    }
    problems.throw_if_any();
    NormalCheck normals;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t begin = header_size + record_size * i;
        std::array<Vec3, 4> vector{};  // the stated normal, then three corners
        for (std::size_t k = 0; k < 12; ++k) {
            double& value = vector[k / 3][static_cast<int>(k % 3)];
            const float read = read_f32(bytes, begin + 4 * k);
            value = static_cast<double>(read) * (k < 3 ? 1.0 : scale);
            surface.grain = std::max(surface.grain, k < 3 ? 0.0 : scale * grain_of(read));
            if (!is_usable(value)) {
                problems.add(file, fmt::format("byte {}: {} in facet {}", begin + 4 * k, value, i + 1),
                             allowed_coordinate);
            }
        }
        add_triangle(surface, {vector[1], vector[2], vector[3]}, static_cast<std::uint32_t>(begin));
        normals.look_at(surface, vector[0]);
    }
    problems.throw_if_any();
    normals.report(surface);
    return surface;
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
    if (bytes.size() >= header_size && bytes.size() == header_size + record_size * std::uint64_t{read_u32(bytes, 80)}) {
        return true;
    }
    const std::string_view start = without_byte_order_mark(bytes).substr(0, 1024);
    const bool has_control_bytes =
        std::any_of(start.begin(), start.end(), [](char c) { return (c >= 0 && c < 9) || (c > 13 && c < 32); });
    return has_control_bytes || !is_same_keyword(TextReader(start).next_word().text, "solid");
}

Surface read_stl(std::string_view bytes, const std::string& file, double scale) {
    check_surface_input(file, bytes.size(), scale);
    const std::string_view text = without_byte_order_mark(bytes);
    const bool is_binary = is_binary_stl(bytes);
    const std::string with_line_feeds = !is_binary && has_bare_returns(text) ? line_feeds_in(text) : "";
    Surface surface = is_binary ? read_binary_stl(bytes, file, scale)
                                : AsciiStl(with_line_feeds.empty() ? text : with_line_feeds, file, scale).read();
    check_grain(surface);
    return surface;
}

}  // namespace riprap::geometry
