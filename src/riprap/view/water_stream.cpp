// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/water_stream.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "riprap/view/chunk.hpp"

namespace riprap::view {

namespace {

using Numbers = std::vector<std::uint16_t>;

constexpr double largest_coordinate = 65535;
constexpr double largest_value = 255;

/// Prediction of a channel of a frame.
struct Guess {
    int past{0};  ///< frames it looks back to: 0, 1, 2
    bool uses_neighbour{false};
    std::uint8_t code() const { return static_cast<std::uint8_t>(2 * past + (uses_neighbour ? 1 : 0)); }
};

/// The frames before, as far as they hold the same particles.
struct Past {
    std::span<const std::uint16_t> last, before;
    int frames{0};  ///< how many of the two there are
    std::uint16_t guess(int past, std::size_t i) const {
        switch (past) {
            case 0:
                return 0;
            case 1:
                return last[i];
            default:
                return static_cast<std::uint16_t>(2 * last[i] - before[i]);
        }
    }
};

std::uint16_t zigzag(std::uint16_t difference) {
    const auto signed_value = static_cast<std::int16_t>(difference);
    return static_cast<std::uint16_t>(static_cast<unsigned>(difference) << 1U ^ (signed_value < 0 ? 0xFFFFU : 0U));
}
Numbers residuals(const Numbers& numbers, const Past& past, const Guess& guess) {
    Numbers out(numbers.size());
    std::uint16_t neighbour = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto difference = static_cast<std::uint16_t>(numbers[i] - past.guess(guess.past, i));
        out[i] = zigzag(static_cast<std::uint16_t>(difference - (guess.uses_neighbour ? neighbour : 0)));
        neighbour = difference;
    }
    return out;
}

/// About how many bits the residuals need.
std::uint64_t bits(const Numbers& residuals) {
    std::uint64_t sum = 0;
    for (const std::uint16_t r : residuals) {
        sum += static_cast<std::uint64_t>(std::bit_width(r));
    }
    return sum;
}

/// A channel of a frame as it is stored.
struct Coded {
    Guess guess;
    Numbers residuals;
};

/// By the guess that leaves the least to say.
Coded code_channel(const Numbers& numbers, const Past& past) {
    Coded best;
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (int code = 0; code < 2 * (past.frames + 1); ++code) {
        const Guess guess{code / 2, code % 2 != 0};
        Numbers tried = residuals(numbers, past, guess);
        if (const std::uint64_t cost = bits(tried); cost < least) {
            least = cost;
            best = {guess, std::move(tried)};
        }
    }
    return best;
}

/// Rounds to an integer in [0, largest]; numbers that are not finite become 0.
std::uint16_t rounded(double value, double largest) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(std::isfinite(value) ? value : 0.0, 0.0, largest)));
}

void append_number(std::uint32_t number, std::string& bytes) {
    for (unsigned k = 0; k < 4; ++k) {
        bytes += static_cast<char>(number >> (8 * k) & 255U);
    }
}

/// Returns how many frames before frame `f` of the group hold the same particles: at most 2.
int common_past(std::span<const WaterNumbers> frames, std::size_t f) {
    int depth = 0;
    while (depth < 2 && static_cast<std::size_t>(depth) < f &&
           frames[f - static_cast<std::size_t>(depth) - 1].id == frames[f].id) {
        ++depth;
    }
    return depth;
}

Past past_of(std::span<const WaterNumbers> frames, std::size_t f, std::size_t channel, int depth) {
    const auto channel_of = [&](std::size_t back) { return std::span(frames[f - back].channel[channel]); };
    Past past{.last = {}, .before = {}, .frames = depth};
    if (depth > 0) {
        past.last = channel_of(1);
    }
    if (depth > 1) {
        past.before = channel_of(2);
    }
    return past;
}

}  // namespace

double coordinate_step(double extent, double wanted) { return std::max(wanted, extent / largest_coordinate); }

WaterNumbers to_numbers(const WaterFrame& frame, const WaterScale& scale) {
    WaterNumbers numbers;
    numbers.id = frame.id;
    for (Numbers& channel : numbers.channel) {
        channel.reserve(frame.position.size());
    }
    const double pressure_range = scale.pressure_high - scale.pressure_low;
    for (std::size_t i = 0; i < frame.position.size(); ++i) {
        const Vec3 x = frame.position[i] - scale.origin;
        for (int axis = 0; axis < 3; ++axis) {
            numbers.channel[static_cast<std::size_t>(axis)].push_back(
                rounded(x[axis] / scale.step, largest_coordinate));
        }
        const double pressure = static_cast<double>(frame.pressure[i]) - scale.pressure_low;
        numbers.channel[3].push_back(rounded(largest_value * pressure / pressure_range, largest_value));
        numbers.channel[4].push_back(
            rounded(largest_value * static_cast<double>(frame.speed[i]) / scale.speed_high, largest_value));
    }
    return numbers;
}

// A group: how many frames; of each frame how many particles and how many frames before hold the same; then, channel by
// channel, the guesses of all frames, the low bytes of all residuals, the high bytes. What is alike stands together:
// zlib tells the bytes of one stretch apart by one code.

std::string encode_group(std::span<const WaterNumbers> frames) {
    std::string bytes;
    append_number(static_cast<std::uint32_t>(frames.size()), bytes);
    std::vector<int> depths;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        depths.push_back(common_past(frames, f));
        append_number(static_cast<std::uint32_t>(frames[f].id.size()), bytes);
        bytes += static_cast<char>(depths.back());
    }
    for (std::size_t c = 0; c < water_channels; ++c) {
        std::string low, high;
        for (std::size_t f = 0; f < frames.size(); ++f) {
            const Coded coded = code_channel(frames[f].channel[c], past_of(frames, f, c, depths[f]));
            bytes += static_cast<char>(coded.guess.code());
            for (const std::uint16_t r : coded.residuals) {
                low += static_cast<char>(r & 255U);
                high += static_cast<char>(r >> 8U);
            }
        }
        bytes += low + high;
    }
    return compress(bytes, true);
}

}  // namespace riprap::view
