// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads pieces of the page again, as page/src/chunk.js and page/src/water.js do.

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/view/water_stream.hpp"

namespace riprap::view {

/// The bytes of a zlib stream, of which there are `most` at most.
inline std::string decompress(std::string_view packed, std::size_t most) {
    std::string bytes(std::min(most, std::size_t{1} << 26U), '\0');
    auto size = static_cast<uLongf>(bytes.size());
    if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                   static_cast<uLong>(packed.size())) != Z_OK) {
        throw std::runtime_error("a piece of the page is cut or damaged");
    }
    bytes.resize(size);
    return bytes;
}

/// Undoes split_planes.
inline std::string join_planes(std::string_view planes, std::size_t width) {
    const std::size_t count = planes.size() / width;
    std::string words(count * width, '\0');
    for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = planes[i % width * count + i / width];
    }
    return words;
}

/// Undoes difference_rows.
inline void restore_rows(std::string& bytes, std::size_t row) {
    for (std::size_t i = row; i < bytes.size(); ++i) {
        bytes[i] = static_cast<char>(bytes[i] ^ bytes[i - row]);
    }
}

template <class T>
std::vector<T> values_of(std::string_view bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

/// The channels of a group of frames; ids are not stored.
inline std::vector<WaterNumbers> decode_group(std::string_view packed) {
    const std::string bytes = decompress(packed, std::size_t{1} << 26U);
    std::size_t at = 0;
    const auto byte = [&] { return static_cast<std::uint8_t>(bytes.at(at++)); };
    const auto number = [&] {
        std::uint32_t value = 0;
        for (unsigned k = 0; k < 4; ++k) {
            value |= static_cast<std::uint32_t>(byte()) << (8 * k);
        }
        return value;
    };
    std::vector<WaterNumbers> frames(number());
    std::vector<std::size_t> counts;
    std::size_t all = 0;
    for (std::size_t f = 0; f < frames.size(); ++f, ++at) {  // past the number of frames with the same particles
        counts.push_back(number());
        all += counts.back();
    }
    for (std::size_t c = 0; c < water_channels; ++c) {
        const std::size_t guesses = at;
        std::size_t low = at + frames.size(), high = low + all;
        for (std::size_t f = 0; f < frames.size(); ++f) {
            const int guess = bytes.at(guesses + f), past = guess / 2;
            std::vector<std::uint16_t>& channel = frames[f].channel[c];
            std::uint16_t neighbour = 0;
            for (std::size_t i = 0; i < counts[f]; ++i, ++low, ++high) {
                const unsigned code = static_cast<std::uint8_t>(bytes.at(low)) |
                                      static_cast<unsigned>(static_cast<std::uint8_t>(bytes.at(high))) << 8U;
                const auto residual = static_cast<std::uint16_t>(code >> 1U ^ ((code & 1U) != 0 ? 0xFFFFU : 0U));
                neighbour = static_cast<std::uint16_t>(residual + (guess % 2 != 0 ? neighbour : 0));
                const int last = past > 0 ? frames[f - 1].channel[c].at(i) : 0;
                const int before = past > 1 ? frames[f - 2].channel[c].at(i) : 0;
                channel.push_back(static_cast<std::uint16_t>(neighbour + (past > 1 ? 2 * last - before : last)));
            }
        }
        at = high;
    }
    return frames;
}

/// [m]
inline Vec3 position_of(const WaterNumbers& numbers, std::size_t i, const WaterScale& scale) {
    return scale.origin + scale.step * Vec3{static_cast<double>(numbers.channel[0][i]),
                                            static_cast<double>(numbers.channel[1][i]),
                                            static_cast<double>(numbers.channel[2][i])};
}

}  // namespace riprap::view
