// SPDX-License-Identifier: Apache-2.0
// Waves that come in through sides of the domain and go out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "riprap/coupling/grid_fluid/grid_parts.hpp"
#include "riprap/fluid/grid/wave_side.hpp"
#include "riprap/wave/boussinesq_wave.hpp"
#include "riprap/wave/irregular_wave.hpp"
#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/second_order_wave.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::IncomingWaves;
using Kind = WavesAtSide::Kind;

/// A wave is resolved by so many cells over its height at least.
constexpr double least_cells = 5;
/// An absorber takes up waves with kd below this.
constexpr double longest_absorbed = M_PI / 10;
/// Height over depth at which a wave breaks [McCowan1894]; limit of wave theories without one of their own [-].
constexpr double breaking_share = 0.78;
/// Height over L tanh kd at which a wave breaks [Miche1944]; limit of a sea, by its peak [-].
constexpr double steepest = 0.142;

/// Distance from the crest at which a solitary wave has a thousandth of its height [m].
double foot_of(const std::function<double(double)>& elevation, double height, double depth) {
    double x = 0;
    while (elevation(x) > 1e-3 * height && x < 40 * depth) {
        x += 0.05 * depth;
    }
    return x;
}

/// Waves that grow from rest over a time.
IncomingWaves ramped(IncomingWaves waves, double ramp) {
    if (ramp <= 0) {
        return waves;
    }
    const auto share = [ramp](double t) {
        const double s = std::clamp(t / ramp, 0.0, 1.0);
        return s * s * (3 - 2 * s);
    };
    return {[=](double t) { return share(t) * waves.elevation(t); },
            [=](double above_bed, double t) {
                const wave::WaveVelocity v = waves.velocity(above_bed, t);
                return wave::WaveVelocity{share(t) * v.along, share(t) * v.up};
            }};
}

IncomingWaves waves_by_theory(const WavesAtSide& said, double gravity) {
    switch (said.kind) {
        case Kind::regular: {
            const wave::SteadyWave wave = wave::regular_wave(said.height, said.period, said.depth, gravity);
            return ramped(fluid::grid::waves_of(wave, said.crest_time < 0 ? 0.25 * said.period : said.crest_time),
                          said.ramp);
        }
        case Kind::second_order: {
            const wave::SecondOrderWave wave = wave::second_order_wave(said.height, said.period, said.depth, gravity);
            const double omega = wave.first.angular_frequency,
                         crest = said.crest_time < 0 ? 0.25 * said.period : said.crest_time;
            return ramped({[=](double t) { return wave.elevation(omega * (crest - t)); },
                           [=](double above_bed, double t) { return wave.velocity(omega * (crest - t), above_bed); }},
                          said.ramp);
        }
        case Kind::solitary: {
            const wave::SteadyWave wave = wave::solitary_wave(said.height, said.depth, gravity);
            const double foot = foot_of([&](double x) { return wave.elevation(x); }, said.height, said.depth);
            return fluid::grid::waves_of(wave, said.crest_time < 0 ? foot / wave.celerity : said.crest_time);
        }
        case Kind::boussinesq: {
            const wave::SolitaryWave wave{said.height, said.depth, gravity};
            const double c = wave.celerity();
            const double foot = foot_of([&](double x) { return wave.elevation(x); }, said.height, said.depth);
            const double crest = said.crest_time < 0 ? foot / c : said.crest_time;
            return {[=](double t) { return wave.elevation(c * (crest - t)); },
                    [=](double above_bed, double t) {
                        return wave::boussinesq_velocity(wave, c * (crest - t), above_bed);
                    }};
        }
        case Kind::irregular: {
            constexpr int components = 200;
            const wave::IrregularWave sea =
                said.spectrum.is_empty() ? wave::jonswap_sea(said.height, said.period, said.gamma, said.depth, gravity,
                                                             components, said.seed)
                                         : wave::sea_of(said.spectrum, said.depth, gravity, components, said.seed);
            return ramped({[sea](double t) { return sea.elevation(0, t); },
                           [sea](double above_bed, double t) { return sea.velocity(0, above_bed, t); }},
                          said.ramp);
        }
        case Kind::none:
            break;
    }
    return {[](double) { return 0.0; }, [](double, double) { return wave::WaveVelocity{0, 0}; }};
}

/// Widest cell along `up` within a wave height of the still level [m].
double cell_at_surface(const GridFluidSettings& settings, int up, double level, double height) {
    const fluid::grid::Mesh& mesh = settings.grid.mesh;
    double widest = 0;
    for (int i = 0; i < mesh.box.cells[at(up)]; ++i) {
        if (std::abs(mesh.centre(up, i) - level) < height) {
            widest = std::max(widest, mesh.h(up, i));
        }
    }
    return widest > 0 ? widest : settings.spacing;
}

/// Tells what a side cannot take of its waves, whatever their theory says; nothing where it can.
std::optional<KeyProblem> unfit(const GridFluidSettings& settings, const WavesAtSide& said, std::string_view key,
                                int up, double level) {
    const fluid::Domain& domain = settings.scene.domain;
    const double deepest = level - domain.low[up], slack = 1e-6 * settings.spacing;
    const char* const side = said.side % 2 == 0 ? "low" : "high";
    const char axis = "xyz"[said.side / 2];
    if (settings.grid.side[at(said.side)].kind == fluid::grid::SideKind::inflow) {
        return KeyProblem{key, fmt::format("two waves through the {} side of {}", side, axis),
                          "one [[fluid.wave]] to a side; absorb = true lets out what arrives there"};
    }
    if (said.depth > deepest + slack) {
        return KeyProblem{key,
                          fmt::format("a wave in {:.6g} m of water at the {} side of {}, where {:.6g} m stand above "
                                      "the bottom of the domain",
                                      said.depth, side, axis, deepest),
                          fmt::format("a depth of at most {:.6g} m, or a higher level", deepest)};
    }
    if ((said.kind == Kind::boussinesq || said.kind == Kind::irregular) && said.height >= breaking_share * said.depth) {
        return KeyProblem{
            key, fmt::format("a wave {:.4g} m high in {:.4g} m of water breaks", said.height, said.depth),
            fmt::format("heights below {:.4g} m, {} of the depth", breaking_share * said.depth, breaking_share)};
    }
    if (said.kind == Kind::irregular) {
        const wave::LinearWave peak =
            wave::linear_wave(said.height, said.period, said.depth, norm(settings.grid.gravity));
        const double highest = steepest * peak.length() * std::tanh(peak.kd());
        if (said.height >= highest) {
            return KeyProblem{key,
                              fmt::format("a sea {:.4g} m high whose peak at {:.4g} Hz is {:.4g} m long breaks",
                                          said.height, 1 / said.period, peak.length()),
                              fmt::format("less than {:.4g} m, 0.142 L tanh kd, or a longer period", highest)};
        }
    }
    return std::nullopt;
}

}  // namespace

int up_axis(const Vec3& up) {
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
        axis = std::abs(up[a]) > std::abs(up[axis]) ? a : axis;
    }
    return axis;
}

double still_level(const GridFluidSettings& settings) {
    double level = -1e300;
    for (const FillRegion& region : settings.scene.regions) {
        level = std::max(level, std::min(region.level, top_of(region, settings.scene.domain, settings.scene.up)));
    }
    return level;
}

std::vector<std::string> absorbed_ranges(const GridFluidSettings& settings) {
    std::vector<std::string> ranges;
    const double gravity = norm(settings.grid.gravity);
    for (const WavesAtSide& said : settings.scene.waves) {
        if (said.absorbs) {
            const double k = longest_absorbed / said.depth;
            ranges.push_back(fmt::format(
                "the {} side of {} absorbs waves of kd below {:.3g}: longer than {:.3g} m, of periods above {:.3g} s, "
                "in {:.4g} m of water",
                said.side % 2 == 0 ? "low" : "high", "xyz"[said.side / 2], longest_absorbed, 2 * M_PI / k,
                2 * M_PI / std::sqrt(gravity * k * std::tanh(longest_absorbed)), said.depth));
        }
    }
    return ranges;
}

std::vector<KeyProblem> add_waves(GridFluidSettings& settings) {
    std::vector<KeyProblem> problems;
    const int up = up_axis(settings.scene.up);
    const double level = still_level(settings), gravity = norm(settings.grid.gravity);
    for (std::size_t entry = 0; entry < settings.scene.waves.size(); ++entry) {
        const WavesAtSide& said = settings.scene.waves[entry];
        const std::string_view key = entry_key("wave", entry);
        if (settings.scene.up[up] < 1 - 1e-9 || said.side / 2 == up) {
            problems.push_back({key, "waves need gravity down one axis and a side beside it",
                                "gravity against x, y or z, and 'towards' along another axis"});
            continue;
        }
        if (const auto problem = unfit(settings, said, key, up, level)) {
            problems.push_back(*problem);
            continue;
        }
        if (said.kind != Kind::none) {
            const double cell = cell_at_surface(settings, up, level, said.height);
            if (said.height < least_cells * cell * (1 - 1e-9)) {
                const double cells = std::floor(100 * said.height / cell * (1 + 1e-9)) / 100;  // 4.99 is not 5
                problems.push_back(
                    {key,
                     fmt::format("a wave {:.4g} m high on cells of {:.4g} m: {:.3g} cells over its height", said.height,
                                 cell, cells),
                     fmt::format("at least {} cells: a spacing of {:.4g} m or less", least_cells,
                                 said.height / least_cells)});
            }
        }
        if (said.absorbs && said.period > 0 && said.kind != Kind::none) {
            const double kd = wave::linear_wave(said.height, said.period, said.depth, gravity).kd();
            if (kd > longest_absorbed) {
                problems.push_back({key, fmt::format("a side cannot absorb waves of kd = {:.3g}", kd),
                                    fmt::format("absorb = false and a [[fluid.sponge]], or waves of kd below {:.3g}",
                                                longest_absorbed)});
            }
        }
        try {
            settings.grid.side[at(said.side)] =
                fluid::grid::wave_side(settings.grid.mesh, said.side, up, level - said.depth, said.depth,
                                       waves_by_theory(said, gravity), said.absorbs);
        } catch (const wave::NoSuchWave& error) {
            problems.push_back({key, error.what(), "a lower wave, a longer period or deeper water"});
        }
    }
    return problems;
}

}  // namespace riprap::coupling
