// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/vtk_layout.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "riprap/core/error.hpp"
#include "riprap/geometry/text/text_reader.hpp"
#include "riprap/io/base64.hpp"

namespace riprap::io {

namespace {

constexpr std::string_view blanks = " \n\r\t";

/// Runs of bytes behind a place of a file, each as it is or encoded by itself in base64.
class Runs {
 public:
    Runs(std::string_view text, bool is_raw) : text_(text), is_raw_(is_raw) {
        if (!is_raw) {
            text_.remove_prefix(std::min(text_.find_first_not_of(blanks), text_.size()));
        }
    }

    /// The first bytes of the next run, left in place.
    std::string peek(std::size_t size) const {
        const std::size_t length = length_of(size);
        return is_raw_ ? std::string(text_.substr(0, length)) : decode_base64(text_.substr(0, length)).substr(0, size);
    }
    std::string take(std::size_t size) {
        std::string bytes = peek(size);
        if (bytes.size() != size) {
            throw FileError("it ends within its bytes");
        }
        text_.remove_prefix(length_of(size));
        return bytes;
    }
    std::size_t left() const { return text_.size(); }

 private:
    std::size_t length_of(std::size_t size) const {
        const std::size_t length = is_raw_ ? size : (size + 2) / 3 * 4;
        if (size > text_.size() || length > text_.size()) {
            throw FileError("it ends within its bytes");
        }
        return length;
    }

    std::string_view text_;
    bool is_raw_;
};

/// Numbers of a header, little-endian as x86 and ARM have them.
std::vector<std::uint64_t> words_of(const std::string& bytes, std::size_t size) {
    std::vector<std::uint64_t> words(bytes.size() / size);
    for (std::size_t i = 0; i < words.size(); ++i) {
        std::memcpy(&words[i], bytes.data() + i * size, size);
    }
    if (words.empty()) {
        throw FileError("it ends within its header");
    }
    return words;
}

std::string unpacked(const std::string& packed, const std::vector<std::uint64_t>& head, std::size_t most_bytes) {
    constexpr std::size_t most_ratio = 1032;  // of zlib: a block cannot unpack to more
    const std::size_t blocks = head.size() - 3;
    std::string bytes;
    std::size_t from = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
        const std::uint64_t packed_size = head[3 + block];
        const std::uint64_t size = block + 1 == blocks && head[2] != 0 ? head[2] : head[1];
        if (packed_size > packed.size() - from || size / most_ratio > packed_size || size > most_bytes - bytes.size()) {
            throw FileError("a header that does not fit its blocks");
        }
        const std::size_t begin = bytes.size();
        bytes.resize(begin + size);
        auto done = static_cast<uLongf>(size);
        const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data() + begin), &done,
                                      reinterpret_cast<const Bytef*>(packed.data() + from), packed_size);
        if (status != Z_OK || done != size) {
            throw FileError("a damaged block");
        }
        from += packed_size;
    }
    return bytes;
}

std::string packed_bytes(Runs runs, std::size_t header_bytes, std::size_t most_bytes) {
    const std::uint64_t blocks = words_of(runs.peek(header_bytes), header_bytes)[0];
    if (blocks > runs.left() / header_bytes) {
        throw FileError("a header that promises more blocks than there are bytes");
    }
    const std::vector<std::uint64_t> head = words_of(runs.take(header_bytes * (3 + blocks)), header_bytes);
    std::uint64_t size = 0;
    for (std::size_t block = 3; block < head.size(); ++block) {
        size += std::min<std::uint64_t>(head[block], runs.left() + 1);
    }
    return unpacked(runs.take(size), head, most_bytes);
}

std::string plain_bytes(Runs runs, std::size_t header_bytes, std::size_t most_bytes) {
    const std::uint64_t size = words_of(runs.peek(header_bytes), header_bytes)[0];
    if (size > std::min(most_bytes, runs.left())) {
        throw FileError("a header that promises more bytes than there are");
    }
    return runs.take(header_bytes + size).substr(header_bytes);
}

template <class T>
std::vector<double> converted(const std::string& bytes) {
    std::vector<double> values(bytes.size() / sizeof(T));
    for (std::size_t i = 0; i < values.size(); ++i) {
        T value{};
        std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
        values[i] = static_cast<double>(value);
    }
    return values;
}

std::vector<double> converted(const std::string& bytes, std::string_view type) {
    if (type == "Float32") {
        return converted<float>(bytes);
    }
    if (type == "Float64") {
        return converted<double>(bytes);
    }
    if (type == "Int32") {
        return converted<std::int32_t>(bytes);
    }
    if (type == "Int64") {
        return converted<std::int64_t>(bytes);
    }
    throw FileError(fmt::format("values of type {}", geometry::quote(type)));
}

std::vector<double> numbers_in(std::string_view text, std::size_t most) {
    geometry::TextReader reader(text);
    std::vector<double> numbers;
    for (geometry::Word word = reader.next_word(); !word.is_empty() && numbers.size() <= most;
         word = reader.next_word()) {
        const auto number = geometry::parse_number(word.text);
        if (!number) {
            throw FileError(fmt::format("{} where a number should be", geometry::quote(word.text)));
        }
        numbers.push_back(*number);
    }
    return numbers;
}

}  // namespace

VtkLayout VtkLayout::of(std::string_view file) {
    const std::size_t begin = std::min(file.find("<VTKFile"), file.size());
    const std::string_view tag = file.substr(begin, file.find('>', begin) - begin);
    if (vtk_attribute(tag, "byte_order") == "BigEndian") {
        throw FileError("its bytes are in the other order (BigEndian)");
    }
    const std::string_view compressor = vtk_attribute(tag, "compressor");
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
        throw FileError(fmt::format("it is compressed by {}, which is not read; zlib is", geometry::quote(compressor)));
    }
    VtkLayout layout;
    layout.is_compressed = !compressor.empty();
    layout.header_bytes = vtk_attribute(tag, "header_type") == "UInt64" ? 8 : 4;
    if (const std::size_t at = file.find("<AppendedData"); at != std::string_view::npos) {
        const std::string_view opening = file.substr(at, file.find('>', at) - at);
        layout.is_raw = vtk_attribute(opening, "encoding") == "raw";
        const std::size_t mark = file.find('_', at + opening.size());
        layout.appended = mark == std::string_view::npos ? std::string_view{} : file.substr(mark + 1);
    }
    return layout;
}

std::vector<double> VtkLayout::numbers(const VtkElement& array, std::size_t most) const {
    const std::string_view format = vtk_attribute(array.tag, "format");
    const std::string_view content = array.content.substr(0, array.content.find('<'));  // notes of VTK may follow
    if (format == "ascii") {
        return numbers_in(content, most);
    }
    const bool is_appended = format == "appended";
    const auto offset = vtk_number<std::size_t>(vtk_attribute(array.tag, "offset"));
    if (is_appended ? !offset || *offset >= appended.size() : format != "binary") {
        throw FileError(is_appended ? "its offset leads out of the file" : "neither ascii, binary nor appended");
    }
    const Runs runs(is_appended ? appended.substr(*offset) : content, is_appended && is_raw);
    const std::size_t most_bytes = sizeof(double) * most;
    return converted(
        is_compressed ? packed_bytes(runs, header_bytes, most_bytes) : plain_bytes(runs, header_bytes, most_bytes),
        vtk_attribute(array.tag, "type"));
}

}  // namespace riprap::io
