// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/keys/words.hpp"

namespace riprap::scene {

/// The wave of a paddle that makes a sea: read by sea_motion, not among wave_kinds(), whose waves have one period.
inline constexpr std::string_view irregular_wave = "irregular";

/// The spectrum of a sea.
enum class SpectrumKind : std::uint8_t { jonswap, pierson_moskowitz };

inline const Words<SpectrumKind>& spectra() {
    static const Words<SpectrumKind> words{{"jonswap", SpectrumKind::jonswap},
                                           {"pierson_moskowitz", SpectrumKind::pierson_moskowitz}};
    return words;
}

}  // namespace riprap::scene
