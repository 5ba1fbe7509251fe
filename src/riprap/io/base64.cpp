// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/base64.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "riprap/core/error.hpp"

namespace riprap::io {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

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

void Base64Text::add(std::span<const unsigned char> bytes) {
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

void Base64Text::finish() {
    put_(encode_base64(left_));
    left_.clear();
}

}  // namespace riprap::io
