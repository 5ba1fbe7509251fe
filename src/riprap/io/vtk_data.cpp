// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/vtk_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/io/base64.hpp"

namespace riprap::io {

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18;
constexpr int compression_level = 1;  // the next levels cost three times the time for a few percent

template <class T>
std::span<const unsigned char> as_bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const unsigned char*>(values.data()), values.size_bytes()};
}

void put_element(const TextSink& put, std::string_view name, std::string_view type, int components,
                 std::span<const unsigned char> bytes, std::size_t tuples = 0) {
    std::string head = "        <DataArray type=\"";
    head += type;
    head += "\" Name=\"";
    head += name;
    if (components > 1) {
        head += "\" NumberOfComponents=\"" + std::to_string(components);
    }
    if (tuples > 0) {
        head += "\" NumberOfTuples=\"" + std::to_string(tuples);
    }
    head += "\" format=\"binary\">";
    put(head);
    encode_vtk_array(bytes, put);
    put("</DataArray>\n");
}

std::string element(std::string_view name, std::string_view type, int components, std::span<const unsigned char> bytes,
                    std::size_t tuples = 0) {
    std::string text;
    put_element([&text](std::string_view piece) { text += piece; }, name, type, components, bytes, tuples);
    return text;
}

/// Compressed blocks, each as large as it is: one vector for all would grow to twice their size.
std::vector<std::vector<unsigned char>> compress_blocks(std::span<const unsigned char> bytes) {
    std::vector<std::vector<unsigned char>> blocks;
    std::vector<unsigned char> packed(compressBound(static_cast<uLong>(block_bytes)));
    for (std::size_t begin = 0; begin < bytes.size(); begin += block_bytes) {
        const std::size_t size = std::min(block_bytes, bytes.size() - begin);
        auto packed_size = static_cast<uLongf>(packed.size());
        const int status =
            compress2(packed.data(), &packed_size, bytes.data() + begin, static_cast<uLong>(size), compression_level);
        if (status != Z_OK) {
            throw InternalError("zlib could not compress a block: " + std::to_string(status));
        }
        blocks.emplace_back(packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(packed_size));
    }
    return blocks;
}

}  // namespace

void encode_vtk_array(std::span<const unsigned char> bytes, const TextSink& put) {
    const std::vector<std::vector<unsigned char>> blocks = compress_blocks(bytes);
    std::vector<std::uint64_t> head{blocks.size(), block_bytes, bytes.size() % block_bytes};
    for (const std::vector<unsigned char>& block : blocks) {
        head.push_back(block.size());
    }
    put(encode_base64(as_bytes_of(std::span<const std::uint64_t>(head))));
    Base64Text text(put);
    for (const std::vector<unsigned char>& block : blocks) {
        text.add(block);
    }
    text.finish();
}

std::string encode_vtk_array(std::span<const unsigned char> bytes) {
    std::string text;
    encode_vtk_array(bytes, [&text](std::string_view piece) { text += piece; });
    return text;
}

std::string decode_vtk_array(std::string_view text, std::size_t most_bytes) {
    constexpr std::size_t word = sizeof(std::uint64_t);
    constexpr std::size_t max_ratio = 1032;  // of zlib: a block cannot unpack to more
    constexpr std::size_t max_block = std::size_t{1} << 28U;
    const auto words_of = [](const std::string& bytes, std::size_t least) {
        std::vector<std::uint64_t> words(bytes.size() / word);
        if (words.size() < least) {  // padding makes a text hold fewer bytes than its length promises
            throw FileError("it ends within its header");
        }
        std::memcpy(words.data(), bytes.data(), words.size() * word);
        return words;
    };
    const std::size_t start = text.find_first_not_of(" \n\r\t");
    const std::size_t stop = text.find_last_not_of(" \n\r\t");
    text = start == std::string_view::npos ? std::string_view{} : text.substr(start, stop - start + 1);
    if (text.size() < 12) {
        throw FileError("no header");
    }
    const std::uint64_t block_count = words_of(decode_base64(text.substr(0, 12)), 1)[0];
    const std::uint64_t max_count = text.size() / word;  // a size per block stands in the header
    if (block_count > max_count) {
        throw FileError("a header that promises more blocks than there are bytes");
    }
    const std::size_t head_characters = (word * (3 + block_count) + 2) / 3 * 4;
    if (text.size() < head_characters) {
        throw FileError("it ends within its header");
    }
    const std::vector<std::uint64_t> head = words_of(decode_base64(text.substr(0, head_characters)), 3 + block_count);
    const std::string packed = decode_base64(text.substr(head_characters));
    std::string bytes;
    std::size_t from = 0;
    for (std::size_t block = 0; block < block_count; ++block) {
        const bool is_last = block + 1 == block_count;
        const std::uint64_t packed_size = head[3 + block], size = is_last && head[2] != 0 ? head[2] : head[1];
        if (packed_size > packed.size() - from || size > max_block || size > max_ratio * packed_size) {
            throw FileError("it ends within a block, or its header is damaged");
        }
        const std::size_t at = bytes.size();
        if (size > most_bytes - at) {
            throw FileError("it unpacks to more than " + std::to_string(most_bytes) + " bytes");
        }
        bytes.resize(at + size);
        auto unpacked_size = static_cast<uLongf>(size);
        const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data() + at), &unpacked_size,
                                      reinterpret_cast<const Bytef*>(packed.data() + from), packed_size);
        if (status != Z_OK || unpacked_size != size) {
            throw FileError("a damaged block");
        }
        from += packed_size;
    }
    return bytes;
}

void put_vtk_array(const TextSink& put, std::string_view name, std::span<const float> values, int components) {
    put_element(put, name, "Float32", components, as_bytes_of(values));
}
void put_vtk_array(const TextSink& put, std::string_view name, std::span<const std::int32_t> values) {
    put_element(put, name, "Int32", 1, as_bytes_of(values));
}
void put_vtk_array(const TextSink& put, std::string_view name, std::span<const Vec3> values) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    put_element(put, name, "Float64", 3, as_bytes_of(values));
}

std::string vtk_array(std::string_view name, std::span<const float> values, int components) {
    return element(name, "Float32", components, as_bytes_of(values));
}
std::string vtk_array(std::string_view name, std::span<const double> values, int components) {
    return element(name, "Float64", components, as_bytes_of(values));
}
std::string vtk_array(std::string_view name, std::span<const std::int32_t> values, int components) {
    return element(name, "Int32", components, as_bytes_of(values));
}
std::string vtk_array(std::string_view name, std::span<const std::int64_t> values, int components) {
    return element(name, "Int64", components, as_bytes_of(values));
}
std::string vtk_array(std::string_view name, std::span<const std::uint8_t> values, int components) {
    return element(name, "UInt8", components, as_bytes_of(values));
}
std::string vtk_field_array(std::string_view name, std::span<const double> values, int components) {
    return element(name, "Float64", components, as_bytes_of(values),
                   values.size() / static_cast<std::size_t>(components));
}

}  // namespace riprap::io
