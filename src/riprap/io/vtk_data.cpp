// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/vtk_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "riprap/core/error.hpp"

namespace riprap::io {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
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

/// Base64 of bytes that come in pieces: threes are made across their ends.
class Base64 {
 public:
    explicit Base64(const TextSink& put) : put_(put) {}
    void add(std::span<const unsigned char> bytes) {
        if (!left_.empty()) {
            const std::size_t count = std::min(3 - left_.size(), bytes.size());
            left_.insert(left_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
            bytes = bytes.subspan(count);
            if (left_.size() < 3) {
                return;
            }
            finish();
        }
        const std::size_t whole = bytes.size() / 3 * 3;
        put_(encode_base64(bytes.first(whole)));
        left_.assign(bytes.begin() + static_cast<std::ptrdiff_t>(whole), bytes.end());
    }
    void finish() {
        put_(encode_base64(left_));
        left_.clear();
    }

 private:
    const TextSink& put_;
    std::vector<unsigned char> left_;
};

std::array<std::int8_t, 256> make_decoder() {
    std::array<std::int8_t, 256> decoder{};
    decoder.fill(-1);
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        decoder[static_cast<unsigned char>(alphabet[i])] = static_cast<std::int8_t>(i);
    }
    return decoder;
}

}  // namespace

std::string encode_base64(std::span<const unsigned char> bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        const std::uint32_t word = static_cast<std::uint32_t>(bytes[i]) << 16 |
                                   (count > 1 ? static_cast<std::uint32_t>(bytes[i + 1]) << 8 : 0U) |
                                   (count > 2 ? static_cast<std::uint32_t>(bytes[i + 2]) : 0U);
        text += alphabet[word >> 18];
        text += alphabet[word >> 12 & 63];
        text += count > 1 ? alphabet[word >> 6 & 63] : '=';
        text += count > 2 ? alphabet[word & 63] : '=';
    }
    return text;
}

std::string decode_base64(std::string_view text) {
    static const std::array<std::int8_t, 256> decoder = make_decoder();
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    if (text.size() % 4 != 0) {
        throw FileError("base64 text of " + std::to_string(text.size()) + " characters, not a multiple of 4");
    }
    for (std::size_t i = 0; i < text.size(); i += 4) {
        const bool is_last = i + 4 == text.size();
        const int padding = is_last && text[i + 3] == '=' ? (text[i + 2] == '=' ? 2 : 1) : 0;
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const bool is_padding = k >= 4U - static_cast<unsigned>(padding);
            const std::int8_t value = is_padding ? std::int8_t{0} : decoder[static_cast<unsigned char>(text[i + k])];
            if (value < 0) {
                throw FileError("a character that is not base64 at " + std::to_string(i + k));
            }
            word = word << 6 | static_cast<std::uint32_t>(value);
        }
        bytes += static_cast<char>(word >> 16 & 255);
        if (padding < 2) {
            bytes += static_cast<char>(word >> 8 & 255);
        }
        if (padding < 1) {
            bytes += static_cast<char>(word & 255);
        }
    }
    return bytes;
}

void encode_vtk_array(std::span<const unsigned char> bytes, const TextSink& put) {
    const std::vector<std::vector<unsigned char>> blocks = compress_blocks(bytes);
    std::vector<std::uint64_t> head{blocks.size(), block_bytes, bytes.size() % block_bytes};
    for (const std::vector<unsigned char>& block : blocks) {
        head.push_back(block.size());
    }
    put(encode_base64(as_bytes_of(std::span<const std::uint64_t>(head))));
    Base64 text(put);
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
