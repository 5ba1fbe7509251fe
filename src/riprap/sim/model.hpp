// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/body/gravity.hpp"
#include "riprap/body/multisphere.hpp"
#include "riprap/body/point_loads.hpp"
#include "riprap/body/supports.hpp"
#include "riprap/coupling/face_gauge.hpp"
#include "riprap/fluid/gauge/gauge.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/material/material_set.hpp"
#include "riprap/material/strength_reduction.hpp"
#include "riprap/sim/settings.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::sim {

/// Time axis.
struct TimeSettings {
    double end{0};                ///< [s]
    double time_step{0};          ///< fixed step asked for [s]; 0 = from the bound
    double factor{0.15};          ///< s: share of the stability limit 2/omega_max used by the automatic step [-]
    bool force_time_step{false};  ///< accept a time_step above the bound
    double settle{0};             ///< free bodies come to rest for so long without water before time 0 [s]
    std::int64_t max_steps{-1};   ///< stop after so many steps; -1 = no limit
    bool is_automatic() const { return time_step <= 0; }
};

/// A time history of one quantity of one body, or of the whole scene.
struct Probe {
    std::string name;  ///< column name
    BodyId body;       ///< invalid: whole scene
    std::string
        quantity;  ///< position, velocity, angular_velocity, displacement, rotation, contact_force, kinetic_energy, ...
    std::optional<Vec3> point{};  ///< of the body, in its frame from its centre of mass; empty = that centre [m]
};

/// Damage of a group of armour units: how many of them have moved farther than a distance since time 0.
struct Damage {
    std::string name;            ///< columns NAME.displaced and NAME.n_od
    std::vector<BodyId> bodies;  ///< the units
    double distance{0};          ///< a unit is displaced beyond this [m]
    double strips{1};            ///< width of the group over the nominal diameter: N_od = displaced/strips [-]
};

/// Watched quantities, and how often files are written. Files have settings of their own (io/output/output_kinds.hpp).
struct OutputSettings {
    double interval{0};              ///< between frames [s]; 0 = end/100
    double probe_interval{0};        ///< between rows of probes.csv and ledger.csv [s]; 0 = end/1000
    double checkpoint_interval{60};  ///< wall-clock seconds between checkpoints [s]
    double ledger_tolerance{0.05};   ///< share of the turnover that the energy residual may reach [-]
    std::vector<Probe> probes;
    std::vector<fluid::Gauge> gauges;
    std::vector<Damage> damage;
    std::vector<coupling::FaceGauge> faces;  ///< of the gauges in faces, see Gauge::face
};

/// Points of another source, beside which the values of an expected answer are held.
struct ExpectCurve {
    std::vector<double> along, value;  ///< empty: none
    std::string quantity{"time"};      ///< whose values `along` are
    double shift{0};                   ///< largest constant that the source allows all values to differ by
};

/// An expected answer: a case is also a test.
struct Expect {
    std::string name;
    std::string quantity;        ///< probe column or ledger/summary quantity
    std::string reduce{"last"};  ///< one of sim::reductions
    double at{0};                ///< time for reduce = at [s]
    double value{0};
    double low{0}, high{0};  ///< accepted band
    std::string citation;
    std::string place;   ///< file:line:column, for messages
    std::string when{};  ///< for reduce = when: the value at the moment at which this quantity first
    double reaches{0};   ///< ... reaches this level, from above or below
    double from{0}, to{std::numeric_limits<double>::infinity()};  ///< steps looked at, not for at and when [s]
    std::string relative_to{};  ///< a quantity that is taken off at every moment; empty = none
    std::int32_t minus{-1};     ///< an earlier answer of the list that is taken off the reduced value; -1 = none
    std::int32_t over{-1};      ///< an earlier answer by which that is divided; -1 = none
    bool is_reported{false};    ///< has no band
    ExpectCurve curve{};        ///< for reduce = rms and worst
    double wave_period{0}, wave_length{0};  ///< for reduce = incident and reflection [s], [m]
};

/// Model: the content of the case. Built once by scene/, then const.
struct Model {
    std::string title;
    std::uint64_t case_hash{0};  ///< of the resolved case: a checkpoint belongs to one case
    std::uint64_t seed{1};
    geometry::ShapeSet shapes;
    material::MaterialSet materials;  ///< at full strength
    material::StrengthReduction strength;
    body::BodySet bodies;
    body::Gravity gravity;
    std::vector<body::PointLoad> loads;
    std::vector<body::FixedPoint> fixed_points;
    std::vector<body::Bolt> bolts;
    std::vector<body::GivenSpheres> spheres;  ///< of bodies that have a list of their own
    SolidSettings solid;
    FluidSettings fluid;
    TimeSettings time;
    OutputSettings output;
    std::vector<Expect> expects;

    /// Settings of the polyhedral DEM, of the particle fluid. nullptr where the case chose another method.
    solid::DemSettings* dem() { return std::get_if<solid::DemSettings>(&solid); }
    const solid::DemSettings* dem() const { return std::get_if<solid::DemSettings>(&solid); }
    coupling::ParticleFluid* particles() { return std::get_if<coupling::ParticleFluid>(&fluid); }
    const coupling::ParticleFluid* particles() const { return std::get_if<coupling::ParticleFluid>(&fluid); }
    bool has_fluid() const { return !std::holds_alternative<coupling::NoFluidSettings>(fluid); }
};

/// Returns the parts of the Model that every solid method reads.
/// @param materials  with their strengths divided by `strength_divisor`
inline solid::SolidScene solid_scene(const Model& model, const material::MaterialSet& materials,
                                     double strength_divisor) {
    return {model.shapes,       materials,   model.bodies,  model.gravity,  model.loads,
            model.fixed_points, model.bolts, model.spheres, model.time.end, strength_divisor};
}
inline solid::SolidScene solid_scene(const Model& model) { return solid_scene(model, model.materials, 1); }

}  // namespace riprap::sim
