// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/analysis/sea_reflection.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/record_spectrum.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::wave {

namespace {

using Complex = std::complex<double>;

constexpr double faded = 0.05;               ///< of the record at either end
constexpr double lowest = 0.5, highest = 4;  ///< frequencies looked at, over that of the peak
constexpr double bound_from = 1.8;           ///< frequencies from which on bound waves count, over that of the peak
constexpr double least_rows = 4;             ///< in a period
constexpr double least_sight = 0.0955;       ///< sin^2(2 pi 0.05)
constexpr std::size_t most_rows = 1U << 15U;
constexpr std::size_t waves_in_band = 40;  ///< a fortieth of the peak wide at most

/// Both trains at one frequency.
struct Trains {
    double angular_frequency, wave_number;
    double sight;  ///< D [-]
    Complex incident, reflected;
    double incident_square, reflected_square;  ///< |I|^2, |R|^2 without what noise adds [m^2]
    double noise;                              ///< s^2 of one gauge [m^2]
    double seen;                               ///< mean of |a_m|^2 over the gauges [m^2]
};

/// Least squares over the gauges.
Trains split(const std::vector<double>& place, const std::vector<Complex>& a, double omega, double k) {
    Complex twice{}, forward{}, back{};
    const auto n = static_cast<double>(a.size());
    Trains trains{omega, k, 0, {}, {}, 0, 0, 0, 0};
    for (std::size_t m = 0; m < a.size(); ++m) {
        const Complex phase = std::polar(1.0, k * place[m]);
        twice += phase * phase;
        forward += std::conj(phase) * a[m];
        back += phase * a[m];
        trains.seen += std::norm(a[m]) / n;
    }
    trains.sight = 1 - std::norm(twice) / (n * n);
    if (!(trains.sight >= least_sight)) {
        return trains;
    }
    trains.incident = (n * forward - std::conj(twice) * back) / (n * n * trains.sight);
    trains.reflected = (n * back - twice * forward) / (n * n * trains.sight);
    if (a.size() > 2) {
        double left = 0;
        for (std::size_t m = 0; m < a.size(); ++m) {
            const Complex phase = std::polar(1.0, k * place[m]);
            left += std::norm(a[m] - trains.incident * phase - trains.reflected * std::conj(phase));
        }
        trains.noise = left / (n - 2);
    }
    const double raised = trains.noise / (n * trains.sight);
    trains.incident_square = std::norm(trains.incident) - raised;
    trains.reflected_square = std::norm(trains.reflected) - raised;
    return trains;
}

/// Joins blind frequencies that follow each other.
std::vector<BlindBand> blind_bands(const std::vector<Trains>& all, double spacing) {
    double total = 0;
    for (const Trains& one : all) {
        total += one.seen;
    }
    std::vector<BlindBand> bands;
    bool is_blind = false;
    for (const Trains& one : all) {
        const double f = one.angular_frequency / (2 * std::numbers::pi);
        if (one.sight >= least_sight) {
            is_blind = false;
            continue;
        }
        if (!is_blind) {
            bands.push_back({f - 0.5 * spacing, f, 0, 0});
        }
        is_blind = true;
        bands.back().high = f + 0.5 * spacing;
        bands.back().share += total > 0 ? one.seen / total : 0;
    }
    return bands;
}

/// Averages over bands of `width` frequencies, blind ones left out of the mean.
void set_spectra(const std::vector<Trains>& all, std::size_t width, double spacing, double weight,
                 SeaReflection& found) {
    for (std::size_t begin = 0; begin < all.size(); begin += width) {
        double incident = 0, reflected = 0, frequency = 0;
        int count = 0;
        for (std::size_t j = begin; j < std::min(all.size(), begin + width); ++j) {
            if (all[j].sight >= least_sight) {
                incident += all[j].incident_square;
                reflected += all[j].reflected_square;
                frequency += all[j].angular_frequency / (2 * std::numbers::pi);
                ++count;
            }
        }
        if (count > 0) {
            found.frequency.push_back(frequency / count);
            found.incident.push_back(std::max(0.0, 0.5 * incident / (count * spacing * weight)));
            found.reflected.push_back(std::max(0.0, 0.5 * reflected / (count * spacing * weight)));
        }
    }
}

/// Heights, periods and noise by the sums over all frequencies that are not blind; K_r by those of free waves.
/// @param free  frequency below which no bound waves count for K_r [rad/s]
void set_sums(const std::vector<Trains>& all, double weight, double free, SeaReflection& found) {
    double incident = 0, reflected = 0, longer = 0, noise = 0, seen = 0, comes = 0, goes = 0;
    for (const Trains& one : all) {
        if (one.sight >= least_sight) {
            incident += 0.5 * one.incident_square / weight;
            reflected += 0.5 * one.reflected_square / weight;
            longer += 0.5 * one.incident_square / weight * 2 * std::numbers::pi / one.angular_frequency;
            noise += 0.5 * one.noise / weight;
            seen += 0.5 * one.seen / weight;
            comes += one.angular_frequency < free ? one.incident_square : 0;
            goes += one.angular_frequency < free ? one.reflected_square : 0;
        }
    }
    found.incident_height = 4 * std::sqrt(std::max(0.0, incident));
    found.reflected_height = 4 * std::sqrt(std::max(0.0, reflected));
    found.coefficient = std::sqrt(std::max(0.0, goes) / comes);
    found.energy_period = longer / incident;
    found.noise = noise / seen;
    found.peak_period = weighted_peak_period({found.frequency, found.incident});
}

/// The incident surface at the first gauge, by the sum of its trains; what was faded is cut off.
EvenRecord incident_at(const std::vector<Trains>& all, const EvenRecord& like, double place) {
    EvenRecord record{like.start, like.step, std::vector<double>(like.rows.size(), 0.0)};
    for (const Trains& one : all) {
        const Complex turn = std::polar(1.0, -one.angular_frequency * like.step);
        Complex now = one.incident * std::polar(1.0, one.wave_number * place - one.angular_frequency * like.start);
        for (double& row : record.rows) {
            row += now.real();
            now *= turn;
        }
    }
    const auto cut = static_cast<std::ptrdiff_t>(std::ceil(faded * static_cast<double>(record.rows.size())));
    record.rows.erase(record.rows.end() - cut, record.rows.end());
    record.rows.erase(record.rows.begin(), record.rows.begin() + cut);
    record.start += static_cast<double>(cut) * record.step;
    return record;
}

}  // namespace

SeaReflection reflect_sea(const SeaRecord& record) {
    SeaReflection found{};
    std::vector<EvenRecord> gauges;
    std::vector<double> place;
    double peak = 0, weight = 0;
    for (std::size_t m = 0; m < record.levels.size(); ++m) {
        EvenRecord even = even_record(record.time, record.levels[m], std::min(record.time.size(), most_rows));
        const double period = weighted_peak_period(spectrum_of(record.time, record.levels[m], 1));
        if (!even.rows.empty() && std::isfinite(period)) {
            weight = fade(even, faded);
            gauges.push_back(std::move(even));
            place.push_back(record.place[m]);
            peak += 1 / period;
        }
    }
    if (gauges.size() < 2) {
        return found;
    }
    peak /= static_cast<double>(gauges.size());
    const EvenRecord& first = gauges.front();
    const double spacing = 1 / (first.step * static_cast<double>(first.rows.size()));
    found.low = lowest * peak;
    found.high = std::min(highest * peak, 1 / (least_rows * first.step));
    std::vector<Trains> all;
    for (double j = std::ceil(found.low / spacing); j * spacing <= found.high; j += 1) {
        const double omega = 2 * std::numbers::pi * j * spacing;
        std::vector<Complex> amplitudes;
        for (const EvenRecord& gauge : gauges) {
            amplitudes.push_back(amplitude_of(gauge, omega));
        }
        all.push_back(split(place, amplitudes, omega, wave_number(omega, record.depth, record.gravity)));
    }
    found.blind = blind_bands(all, spacing);
    for (BlindBand& band : found.blind) {
        const double middle = std::numbers::pi * (band.low + band.high);
        band.length = 2 * std::numbers::pi / wave_number(middle, record.depth, record.gravity);
        found.blind_share += band.share;
    }
    const double waves = peak * (record.time.back() - record.time.front());
    set_spectra(all, std::max<std::size_t>(1, static_cast<std::size_t>(waves) / waves_in_band), spacing, weight, found);
    if (!found.is_empty()) {
        set_sums(all, weight, 2 * std::numbers::pi * bound_from * peak, found);
        found.incident_record = incident_at(all, first, place.front());
    }
    return found;
}

}  // namespace riprap::wave
