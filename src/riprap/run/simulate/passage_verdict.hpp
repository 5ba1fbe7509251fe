// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/run/remedy/deep_pairs.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// Returns how water has come through a solid: more than one in two hundred of its particles, and three at least, lie
/// more than a spacing deep in a body. Empty where it has not.
std::string water_passage(const sim::Model& model, const sim::State& state);

/// Share of the particles of water that may go through bodies, one after another, before the run is ended [-].
inline constexpr double share_through_walls = 0.005;

/// Returns how water has gone through walls too thin to be found in: where more particles of it have than are allowed,
/// and more than two. @param count  of them since time 0; @param last  those of the last step
sim::StepStatus passed_walls(const sim::Model& model, const sim::State& state, std::int64_t count,
                             const coupling::WallPassages& last);

/// Returns how much water has left through the top of the domain and was let go; empty where none has.
std::string splash_text(const sim::Model& model, const sim::State& state);

/// Looks for bodies that pass through each other; a member per run.
///
/// With the distance potential each step says how deep its contacts are; which way they have come is remembered of the
/// deep ones (DeepPairs). Other methods say less, so all shapes are looked at, where they are, before any two bodies
/// can have approached each other by solid::most_approach of the thinnest since the last look; so is the end of every
/// run. Shapes are taken as rigid: a block that has lost a quarter of its thickness has long left what its method is
/// for. Bodies that meet by one sphere each (solid::SphereSampling::one) are let pass: their shapes do not meet.
/// Spheres are held by solid.max_overlap.
class PassageWatch {
 public:
    /// Returns which two bodies are so deep in each other that the centre of one nears the surface of the other: from
    /// there on their contact would push them on (solid::most_overlap). Empty where none are.
    std::string look(const sim::Model& model, const sim::State& state, const sim::Scratch& scratch,
                     const sim::StepReport& report, bool is_last);
    /// Looks at the shapes as they are, for a run that stops here and goes on later: what is remembered stays.
    static std::string look_now(const sim::Model& model, const sim::State& state);
    /// To be called where the State is put back. Where deep pairs met stays known: they are deep again, or not there.
    void reset() { approached_ = infinite; }

    /// By how much two bodies have approached each other since the last look, at most [m]. When the next look comes
    /// follows from it: part of a checkpoint.
    double approached() const { return approached_; }
    const DeepPairs& deep() const { return deep_; }  ///< part of a checkpoint too
    void restore(double approached, const DeepPairs& deep) {
        approached_ = approached;
        deep_ = deep;
    }
    static constexpr double infinite = 1e300;

 private:
    std::string look_at_contacts(const sim::Model& model, const sim::State& state, const sim::Scratch& scratch,
                                 const sim::StepReport& report);

    double approached_{infinite};
    DeepPairs deep_;
};

}  // namespace riprap::run
