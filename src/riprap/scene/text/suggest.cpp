// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/suggest.hpp"

#include <algorithm>
#include <array>

namespace riprap::scene {

namespace {
constexpr std::size_t longest = 64;
}

int edit_distance(std::string_view a, std::string_view b) {
    a = a.substr(0, longest);
    b = b.substr(0, longest);
    std::array<std::array<int, longest + 1>, longest + 1> d{};
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = static_cast<int>(i + j);
                continue;
            }
            const int replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
    std::string best;
    int best_distance = 1 << 20;
    for (const std::string& candidate : known) {
        int distance = edit_distance(word, candidate);
        const bool is_part =
            word.size() >= 3 && candidate.size() >= 3 &&
            (candidate.find(word) != std::string::npos || word.find(candidate) != std::string_view::npos);
        const int allowed = std::max<int>(1, static_cast<int>(std::max(word.size(), candidate.size())) / 3);
        if (is_part) {
            distance = std::min(distance, allowed);
        }
        if (distance <= allowed && distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

}  // namespace riprap::scene
