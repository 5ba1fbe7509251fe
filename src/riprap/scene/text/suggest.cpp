// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/suggest.hpp"

#include <algorithm>
#include <array>

namespace riprap::scene {

namespace {
constexpr std::size_t longest = 64;

/// Words of other programs, in small letters without '_', and what they are called here.
struct Alias {
    std::string_view word, key;
};
constexpr std::array aliases{
    Alias{"restitution", "damping_ratio"},
    Alias{"cor", "damping_ratio"},
    Alias{"dampingcoefficient", "damping_ratio"},
    Alias{"dp", "spacing"},
    Alias{"particlespacing", "spacing"},
    Alias{"coefh", "smoothing_ratio"},
    Alias{"hdp", "smoothing_ratio"},
    Alias{"coefsound", "sound_speed"},
    Alias{"speedsound", "sound_speed"},
    Alias{"c0", "sound_speed"},
    Alias{"cfl", "courant"},
    Alias{"cflnumber", "courant"},
    Alias{"rho", "density"},
    Alias{"rhop0", "density"},
    Alias{"mu", "friction_coefficient"},
    Alias{"kfric", "friction_coefficient"},
    Alias{"friction", "friction_coefficient"},
    Alias{"frictionangle", "friction_angle"},
    Alias{"phi", "friction_angle"},
    Alias{"kn", "normal_stiffness"},
    Alias{"jkn", "normal_stiffness"},
    Alias{"ks", "shear_stiffness"},
    Alias{"jks", "shear_stiffness"},
    Alias{"young", "youngs_modulus"},
    Alias{"poisson", "poisson_ratio"},
    Alias{"timemax", "end"},
    Alias{"tmax", "end"},
    Alias{"tend", "end"},
    Alias{"endtime", "end"},
    Alias{"duration", "end"},
    Alias{"dt", "time_step"},
    Alias{"deltat", "time_step"},
    Alias{"dtini", "time_step"},
    Alias{"g", "gravity"},
    Alias{"timeout", "interval"},
    Alias{"writeinterval", "interval"},
    Alias{"frameinterval", "interval"},
    Alias{"pos", "position"},
    Alias{"vel", "velocity"},
    Alias{"rot", "orientation"},
    Alias{"quaternion", "orientation"},
    Alias{"static", "fixed"},
    Alias{"kinematic", "motion"},
    Alias{"floating", "body"},
    Alias{"visco", "artificial_alpha"},
    Alias{"densitydt", "density_diffusion"},
};

/// The key that a word of another program means, if it is one of `known`; empty else.
std::string other_name(std::string_view word, const std::vector<std::string>& known) {
    std::string plain;
    for (const char c : word) {
        if (c != '_' && c != '-') {
            plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
    }
    for (const Alias& alias : aliases) {
        const auto found = std::find(known.begin(), known.end(), alias.key);
        if (alias.word == plain && found != known.end()) {
            return *found;
        }
    }
    return {};
}

}  // namespace

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
    if (std::string meant = other_name(word, known); !meant.empty()) {
        return meant;
    }
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
