// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/keys/words.hpp"

namespace riprap::scene {

/// The spectrum of a sea.
enum class SpectrumKind : std::uint8_t { jonswap, pierson_moskowitz };

inline const Words<SpectrumKind>& spectra() {
    static const Words<SpectrumKind> words{{"jonswap", SpectrumKind::jonswap},
                                           {"pierson_moskowitz", SpectrumKind::pierson_moskowitz}};
    return words;
}

}  // namespace riprap::scene
