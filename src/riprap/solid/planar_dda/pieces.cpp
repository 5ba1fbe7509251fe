// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace riprap::solid::planar_dda {

Outcome advance_in_pieces(const Model& model, const Settings& settings, const Step& step, State& state,
                          Scratch& scratch, StepReport& report, int& piece_count) {
    StepReport all;
    double left = step.dt, length = step.dt;
    std::vector<Unknowns> driven;
    piece_count = 0;
    while (left > 1e-12 * step.dt) {
        Step piece = step;
        piece.dt = left - length < 1e-9 * step.dt ? left : length;
        if (!step.driven.empty() && piece.dt < step.dt) {
            driven.assign(step.driven.begin(), step.driven.end());
            for (Unknowns& motion : driven) {
                for (double& u : motion) {
                    u *= piece.dt / step.dt;
                }
            }
            piece.driven = driven;
        }
        const Outcome outcome = advance(model, settings, piece, state, scratch, report);
        all.iterations += report.iterations;
        all.factorizations += report.factorizations;
        if (outcome.ok()) {
            all.closed_contacts = report.closed_contacts;
            all.touching_pairs = report.touching_pairs;
            all.largest_displacement = std::max(all.largest_displacement, report.largest_displacement);
            all.largest_overlap = std::max(all.largest_overlap, report.largest_overlap);
            ++piece_count;
            left -= piece.dt;
            length = std::min(left, 1.3 * piece.dt);
            continue;
        }
        length = piece.dt * outcome.shorten;
        if (length < step.dt / 1024) {
            report = all;
            return {fmt::format("{}; {:.3g} s of the step are left", outcome.problem, left), 0};
        }
    }
    report = all;
    return {};
}

}  // namespace riprap::solid::planar_dda
