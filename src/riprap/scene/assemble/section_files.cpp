// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/section_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "riprap/scene/text/limits.hpp"
#include "riprap/sim/method_traits.hpp"

namespace riprap::scene {

namespace {

/// Reads a file by `read`, which throws its problems. Nothing, with problems, when that fails.
template <class Read>
auto read_file(CaseBuild& build, const Value& path, Read&& read)
    -> std::optional<decltype(read(std::string_view{}, path.text))> {
    const auto bytes = build.files.read(path.text, limits::table_bytes, path.place, build.problems);
    if (!bytes) {
        return std::nullopt;
    }
    try {
        auto content = read(*bytes, path.text);
        for (const std::string& note : content.notes) {
            build.notes.push_back(fmt::format("{}: {}", path.text, note));
        }
        return content;
    } catch (const CaseError& error) {
        build.problems.insert(build.problems.end(), error.problems().begin(), error.problems().end());
        return std::nullopt;
    }
}

/// Compares values of an analysis file with those of the case.
struct Comparison {
    CaseBuild& build;
    const std::string& file;

    void operator()(const char* what, double in_file, double in_case, const char* unit) const {
        const double tolerance = 1e-3 * std::max(std::abs(in_file), std::abs(in_case));
        if (std::abs(in_file - in_case) > tolerance) {
            build.warnings.push_back(
                fmt::format("{}: {} is {:.6g} {}, the case has {:.6g}", file, what, in_file, unit, in_case));
        }
    }
};

void compare_material(const Comparison& compare, const geometry::DdaAnalysis& analysis, MaterialId id) {
    const material::Material& rock = compare.build.model.materials[id];
    if (!analysis.materials.empty()) {
        const geometry::DdaMaterial& block = analysis.materials.front();
        compare("unit mass", block.density, rock.density, "kg/m^3");
        compare("unit weight", block.unit_weight, rock.density * norm(compare.build.model.gravity.value), "N/m^3");
    }
    if (!analysis.joints.empty()) {
        const geometry::DdaJointProperties& joint = analysis.joints.front();
        constexpr double degree = M_PI / 180;
        compare("friction angle", joint.friction_angle / degree, std::atan(rock.friction) / degree, "degrees");
        compare("cohesion", joint.cohesion, rock.cohesion, "Pa");
    }
    compare("shear ratio", 1 / analysis.shear_ratio, rock.shear_ratio, "(shear over normal stiffness)");
}

void compare_method(const Comparison& compare, const geometry::DdaAnalysis& analysis) {
    const sim::SolidSettings& solid = compare.build.model.solid;
    if (const auto* elasticity = sim::elasticity_of(solid); elasticity != nullptr && !analysis.materials.empty()) {
        const geometry::DdaMaterial& block = analysis.materials.front();
        compare("Young's modulus", block.youngs_modulus, elasticity->youngs_modulus, "Pa");
        compare("Poisson's ratio", block.poisson_ratio, elasticity->poisson_ratio, "");
    }
    if (const auto* planar = std::get_if<solid::PlanarDdaSettings>(&solid)) {
        compare("plane strain", analysis.is_plane_strain ? 1 : 0,
                planar->plane == solid::planar_dda::PlaneState::strain ? 1 : 0, "");
        compare("dynamic factor", analysis.is_dynamic ? 1 : 0, planar->engine.dynamic_factor, "");
    }
}

/// Contents of the file that are ignored.
void note_unused(CaseBuild& build, const std::string& file, const geometry::DdaAnalysis& analysis) {
    const auto note = [&](const std::string& text) { build.notes.push_back(fmt::format("{}: {}", file, text)); };
    if (analysis.materials.size() > 1 || analysis.joints.size() > 1) {
        note(fmt::format("{} block and {} joint materials: the blocks of a section are of one; compared with the first",
                         analysis.materials.size(), analysis.joints.size()));
    }
    for (const geometry::DdaMaterial& block : analysis.materials) {
        if (block.stress != std::array<double, 3>{} || block.velocity != std::array<double, 3>{}) {
            note("initial stress and velocity of blocks are not used");
            break;
        }
    }
    for (const geometry::DdaJointProperties& joint : analysis.joints) {
        if (joint.tension > 0) {
            note(fmt::format("the tensile strength of {:.6g} Pa is not used", joint.tension));
        }
    }
    note(
        fmt::format("the step of {:.6g} s and the penalty of {:.6g} times Young's modulus are not used: the case has "
                    "'step' and 'contact_stiffness'",
                    analysis.time_step, analysis.penalty_factor));
}

}  // namespace

std::optional<geometry::DdaGeometry> read_geometry_file(CaseBuild& build, const Value& path) {
    auto geometry = read_file(build, path, geometry::read_dda_geometry);
    if (geometry &&
        !(geometry->material_lines.empty() && geometry->bolts.empty() && geometry->seismic_points.empty())) {
        build.notes.push_back(fmt::format("{}: {} material lines, {} bolts and {} seismic points are not used",
                                          path.text, geometry->material_lines.size(), geometry->bolts.size(),
                                          geometry->seismic_points.size()));
    }
    return geometry;
}

std::optional<geometry::DdaAnalysis> read_analysis_file(CaseBuild& build, const Value& path, MaterialId material) {
    auto analysis = read_file(build, path, geometry::read_dda_analysis);
    if (analysis) {
        const Comparison compare{build, path.text};
        compare_material(compare, *analysis, material);
        compare_method(compare, *analysis);
        note_unused(build, path.text, *analysis);
    }
    return analysis;
}

}  // namespace riprap::scene
