// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "riprap/scene/case/case_build.hpp"
#include "riprap/wave/irregular_wave.hpp"

namespace riprap::scene {

/// A sea as a wave maker states it.
struct Sea {
    double height;  ///< H_m0 [m]
    double period;  ///< T_p [s]
    double gamma;   ///< of JONSWAP; 1 is Pierson-Moskowitz [-]
    std::uint64_t seed;
    wave::Spectrum spectrum;  ///< empty: JONSWAP
};

/// Reads height, period, spectrum, spectrum_file, gamma and seed of `table`; nothing with a problem. A spectrum from a
/// file is scaled to the height where one is given.
std::optional<Sea> read_sea(CaseBuild& build, const Value& table);

/// The way of a piston that makes a sea (motion.wave_maker with wave = "irregular"), in rows to the end of the run;
/// nothing with a problem.
std::optional<body::SplineMotion> sea_motion(CaseBuild& build, const Value& table);

/// The sea of a table that sea_motion has accepted, with its peak period; nothing where the table is wrong.
struct PaddleSea {
    wave::IrregularWave waves;
    double period;  ///< of the peak [s]
};
std::optional<PaddleSea> paddle_sea(CaseBuild& build, const Value& table);

}  // namespace riprap::scene
