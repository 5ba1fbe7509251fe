// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/bound_methods.hpp"

#include "riprap/sim/method_scratch.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::sim {

namespace {

template <class Method>
class BoundSolid final : public Solid {
 public:
    BoundSolid(const Model& model, const typename Method::Settings& settings, State& state, ScratchData& scratch)
        : scene_(solid_scene(model)),
          fluid_leads_(fluid_leads(model)),
          method_(scene_, settings, {state.bodies, state.contacts, state.previous_dt},
                  Solids::matching<Method>(model.solid, state.solid_fields),
                  Solids::matching<Method>(model.solid, scratch.methods->solid)) {}

    StepLimit limit() const override {
        if constexpr (requires { method_.lasting_limit(); }) {  // the step of the fluid is shared out at its beginning
            return fluid_leads_ ? method_.lasting_limit() : method_.limit();
        } else {
            return method_.limit();
        }
    }
    bool takes_back() const override {
        return requires { requires Method::takes_back; };
    }
    Outcome advance(const TimeSpan& span, const body::LoadView& loads, solid::Measure measure,
                    solid::SolidReport& report) override {
        return method_.advance(span, loads, measure, report);
    }

 private:
    solid::SolidScene scene_;
    bool fluid_leads_;
    Method method_;
};

template <class Method>
class BoundFluid final : public Fluid {
 public:
    BoundFluid(const Model& model, const typename Method::Settings& settings, State& state, ScratchData& scratch)
        : scene_{model.shapes, model.bodies, model.gravity},
          method_(scene_, settings, {state.fluid, state.open, state.coupling, state.bodies},
                  Fluids::matching<Method>(model.fluid, state.fluid_fields),
                  Fluids::matching<Method>(model.fluid, scratch.methods->fluid)) {}

    bool is_there() const override { return Method::is_there; }
    bool leads() const override { return Method::leads; }
    StepLimit limit() const override { return method_.limit(); }
    void start() override {
        if constexpr (requires { method_.start(); }) {
            method_.start();
        }
    }
    void tidy(std::int64_t step) override { method_.tidy(step); }
    void drive(const TimeSpan& span, std::vector<Vec3>& correction) override { method_.drive(span, correction); }
    Outcome begin(const TimeSpan& span, const body::Motion& now, const body::Motion& middle,
                  coupling::FluidStep& report) override {
        return method_.begin(span, now, middle, report);
    }
    void load(const TimeSpan& span, const body::Motion& middle, coupling::FluidLoads& loads) override {
        method_.load(span, middle, loads);
    }
    Outcome kick(const TimeSpan& span, coupling::FluidStep& report) override { return method_.kick(span, report); }
    Outcome end(const TimeSpan& span, coupling::FluidStep& report) override { return method_.end(span, report); }
    std::span<const double> feedback() const override { return method_.feedback(); }
    bool corrects() const override {
        if constexpr (has_correction) {
            return method_.corrects();
        } else {
            return false;
        }
    }
    bool correct(const body::BodySet& bodies, const body::BodyKinematics& kinematics,
                 std::span<const std::uint8_t> is_sought, std::span<const body::Acceleration> residual,
                 std::vector<body::Acceleration>& guess) override {
        if constexpr (has_correction) {
            return method_.correct(bodies, kinematics, is_sought, residual, guess);
        } else {
            return false;
        }
    }

 private:
    static constexpr bool has_correction =
        requires(Method method, const body::BodySet& bodies, const body::BodyKinematics& kinematics,
                 std::span<const std::uint8_t> is_sought, std::span<const body::Acceleration> residual,
                 std::vector<body::Acceleration>& guess) {
        method.correct(bodies, kinematics, is_sought, residual, guess);
    };

    coupling::FluidScene scene_;
    Method method_;
};

}  // namespace

ScratchData::ScratchData() : methods(std::make_unique<MethodScratch>()) {}
ScratchData::~ScratchData() = default;

BoundMethods bind_methods(const Model& model, State& state, ScratchData& scratch) {
    BoundMethods bound;
    Solids::visit(model.solid, [&]<class Method>(const typename Method::Settings& settings) {
        bound.solid = std::make_unique<BoundSolid<Method>>(model, settings, state, scratch);
    });
    Fluids::visit(model.fluid, [&]<class Method>(const typename Method::Settings& settings) {
        bound.fluid = std::make_unique<BoundFluid<Method>>(model, settings, state, scratch);
    });
    return bound;
}

const body::Loads& contact_loads(const ScratchData& scratch) {
    return Solids::visit(scratch.methods->solid,
                         []<class Method>(const typename Method::Scratch& own) -> const body::Loads& {
                             return Method::contact_loads(own);
                         });
}

const solid::SolidTimes& solid_times(const ScratchData& scratch) {
    return Solids::visit(scratch.methods->solid,
                         []<class Method>(const typename Method::Scratch& own) -> const solid::SolidTimes& {
                             return Method::times(own);
                         });
}

std::size_t method_bytes(const ScratchData& scratch) {
    const auto bytes_of_own = [](const auto& own) { return own.bytes(); };
    return std::visit(bytes_of_own, scratch.methods->solid) + std::visit(bytes_of_own, scratch.methods->fluid);
}

}  // namespace riprap::sim
