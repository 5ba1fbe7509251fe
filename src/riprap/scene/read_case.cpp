// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/read_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "riprap/core/fields.hpp"
#include "riprap/io/output/output_kinds.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/check_spreads.hpp"
#include "riprap/scene/assemble/choose_contact.hpp"
#include "riprap/scene/assemble/complete_solid.hpp"
#include "riprap/scene/assemble/expand_records.hpp"
#include "riprap/scene/assemble/variations.hpp"
#include "riprap/scene/keys/check_counts.hpp"
#include "riprap/scene/keys/check_keys.hpp"
#include "riprap/scene/keys/renamed.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/toml_reader.hpp"
#include "riprap/scene/warnings/density_warnings.hpp"
#include "riprap/scene/warnings/distant_bodies.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"
#include "riprap/scene/warnings/hard_impacts.hpp"
#include "riprap/scene/warnings/late_starts.hpp"
#include "riprap/scene/warnings/narrow_gaps.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::scene {

namespace {

/// @param unseen  names what was not checked, as it needs what is wrong here
void throw_if_any(std::vector<Diagnostic>& problems, std::string unseen) {
    if (problems.empty()) {
        return;
    }
    const std::size_t count = problems.size();
    if (count > limits::problems) {
        problems.resize(limits::problems);
        problems.push_back({problems.back().place, fmt::format("{} more problems", count - limits::problems), ""});
    }
    throw PartlySeenCaseError(std::move(problems), std::move(unseen));
}

/// `dimension` decides how vectors are read, so it is looked at before everything else.
bool is_planar_case(const Value& root) {
    const Value* dimension = root.find("dimension");
    return dimension != nullptr && dimension->kind == ValueKind::integer && dimension->integer == 2;
}

/// The end of the run as the file has it [s]; nothing where that cannot be read.
std::optional<double> end_of(const Value& root) {
    const Value* end = root.find("end");
    if (end == nullptr) {
        return std::nullopt;
    }
    Value alone = Value::table();
    alone.set("end", *end);
    std::vector<Diagnostic> ignored;
    const Value checked = check_keys(alone, case_table(), false, ignored);
    const Value* read = checked.find("end");
    return read != nullptr && read->is_number() ? std::optional(read->as_number()) : std::nullopt;
}

/// Tells whether a [[vary]] runs the case to the end that it has now, with the answers that are expected there.
bool is_end_of_variation(const Value& root) {
    const std::string end = fmt::format("end={}", number_text(get_number(root, "end")));
    const std::vector<Variation> runs = variations_of(root);
    return std::any_of(runs.begin(), runs.end(), [&end](const Variation& run) {
        return std::find(run.overrides.begin(), run.overrides.end(), end) != run.overrides.end();
    });
}

/// Where the run was cut, expected answers whose window goes on to its end belong to the end that the file has: they
/// are not judged before it. Those of a time of their own say when it is.
Value with_ends(Value root, const std::optional<double>& written) {
    Value* expects = root.find("expect");
    if (!written || expects == nullptr || !(get_number(root, "end") < *written) || is_end_of_variation(root)) {
        return root;
    }
    for (Value& expect : expects->items) {
        if (expect.find("at") == nullptr && expect.find("to") == nullptr) {
            Value end = Value::of(*written);
            end.place = expect.place;
            expect.set("to", std::move(end), expect.place);
        }
    }
    return root;
}

/// Hashes all that decides the motion: the other files and the resolved case, without the length of the run and its
/// outputs. A checkpoint belongs to all cases that agree in this.
std::uint64_t hash_of(Value root, const std::vector<InputFile>& inputs) {
    constexpr std::array<std::string_view, 8> bystanders{"format",    "title",  "source", "end",
                                                         "max_steps", "output", "expect", "vary"};
    std::erase_if(root.entries, [&](const Entry& entry) {
        return std::find(bystanders.begin(), bystanders.end(), entry.key) != bystanders.end();
    });
    Hasher hasher;
    const std::string text = write_toml(root);
    hasher.add(text.data(), text.size());
    for (const InputFile& input : inputs) {
        hasher.add(input.path.data(), input.path.size());
        hasher.add(&input.hash, sizeof input.hash);
    }
    return hasher.value();
}

void warn_of_hard_impacts(const CaseBuild& build) {
    constexpr std::size_t most = 3;
    const std::vector<HardImpact> impacts = find_hard_impacts(build.model, build.state);
    for (std::size_t i = 0; i < std::min(impacts.size(), most); ++i) {
        build.warnings.push_back(text_of(impacts[i], build.model));
    }
    if (impacts.size() > most) {
        build.warnings.push_back(
            fmt::format("{} more bodies come to something that their contact cannot hold", impacts.size() - most));
    }
}

void warn_of_held_joints(CaseBuild& build) {
    constexpr std::size_t most = 3;
    const Value* fluid = build.root.find("fluid");
    const Value* is_wanted = fluid == nullptr ? nullptr : fluid->find("joint_pressure");
    if (is_wanted != nullptr && !is_wanted->boolean) {
        return;  // joints are watertight
    }
    const std::vector<HeldJoint> joints = find_held_joints(build.model, build.state);
    const body::BodySet& bodies = build.model.bodies;
    for (std::size_t i = 0; i < std::min(joints.size(), most); ++i) {
        const std::string name = bodies.name(joints[i].body);
        warn_at(build, bodies.name_id[static_cast<std::size_t>(joints[i].body.value)],
                fmt::format(
                    "'{}' touches '{}', and no force moves either: there is no water in the joint between them, and "
                    "the load of the water on '{}' lacks its uplift; fluid.method = \"grid\" and \"hydrostatic\" "
                    "have it, and so has a body that is free",
                    name, bodies.name(joints[i].other), name));
    }
    if (joints.size() > most) {
        build.warnings.push_back(fmt::format("{} more bodies lack water in such joints", joints.size() - most));
    }
}

/// A fixed step above its limit is a problem of the place where it stands. @throws CaseError
void check_time_step(const Value& root, const sim::Model& model, sim::State& state) {
    if (model.time.is_automatic()) {
        return;
    }
    std::int64_t steps = 0;
    try {
        sim::Scratch scratch;
        steps = sim::choose_time_step(model, state, scratch).steps_left;
    } catch (const CaseError& error) {
        std::vector<Diagnostic> problems = error.problems();
        for (Diagnostic& problem : problems) {
            problem.place = get(root, "time_step").place;
        }
        throw CaseError(std::move(problems));
    }
    if (steps == 0) {
        throw CaseError(Diagnostic{get(root, "end").place,
                                   fmt::format("a run to {:.3g} s takes no step of time_step = {:.3g} s",
                                               model.time.end, model.time.time_step),
                                   "an end of at least time_step, or time_step = \"auto\""});
    }
}

std::string read_case_file(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        throw FileError(fmt::format("{} is a folder; give the case file in it, such as {}", path.string(),
                                    (path / "case.toml").string()));
    }
    // Opening a pipe waits for a writer, and a device need not end.
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) {
        throw FileError(fmt::format("{} is not a regular file; a case is read from a file", path.string()));
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw FileError(
            fmt::format("{} cannot be read: {}", path.string(),
                        std::filesystem::exists(path, error) ? "check its permissions" : "there is no such file"));
    }
    std::string text(limits::case_bytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return text;
}

}  // namespace

LoadedCase read_case_text(std::string_view text, const std::string& name, const std::string& folder,
                          std::span<const std::string> overrides) {
    std::vector<Diagnostic> problems;
    Value root = parse_toml(text, name, problems);
    check_format(root, problems);
    throw_if_any(problems, "keys and what they make");
    const std::optional<double> written_end = end_of(root);
    for (const std::string& assignment : overrides) {
        apply_override(root, assignment, problems);
    }
    const bool is_planar = is_planar_case(root);
    for (const OldName& old : rename_old(root, case_table())) {
        problems.push_back(problem_of(old));
    }
    const Value checked = check_keys(root, case_table(), is_planar, problems);
    check_counts(checked, problems);
    if (problems.empty()) {  // numbers that are tried in keys that are right
        check_spreads(checked, root, is_planar, problems);
        check_variations(checked, root, is_planar, problems);
    }
    throw_if_any(problems, "bodies, water, records and the time step");
    const Value resolved = expand_records(with_ends(checked, written_end), problems);

    LoadedCase loaded;
    loaded.outputs = std::make_shared<io::OutputChoices>();
    loaded.folder = folder;
    loaded.source_text = std::string(text);
    loaded.overrides.assign(overrides.begin(), overrides.end());
    CaseFiles files(folder);
    ShapeLibrary shapes(loaded.model.shapes, files, is_planar, problems, loaded.warnings, loaded.notes);
    CaseBuild build{resolved, is_planar, loaded.model, loaded.state,    *loaded.outputs,
                    files,    shapes,    problems,     loaded.warnings, loaded.notes};
    build_settings(build);
    build_materials(build);
    build_bodies(build);
    build_packs(build);
    build_rock_masses(build);
    build_sections(build);
    build_contact(build);
    build_strength(build);
    build_supports(build);
    choose_contact(build);
    build.has_all_bodies = problems.empty();
    if (build.has_sound_bodies) {
        build_fluid(build);
        warn_of_densities(build);
        warn_of_late_starts(build);
        warn_of_steep_friction(build);
    }
    if (loaded.model.bodies.size() == 0 && !loaded.model.has_fluid() && problems.empty()) {
        build.problem(resolved.place, "the case has no bodies and no water",
                      "at least one [[body]], [[pack]], [[rock_mass]], [[section]] or [fluid]");
    }
    build_output(build);
    if (build.has_sound_bodies) {
        check_overlaps(build);
        check_materials(build);
        if (build.has_all_bodies) {
            complete_solid(build);
            check_solid_method(build);
        }
    }
    if (problems.empty()) {
        warn_of_distant_bodies(build);
        warn_of_hard_impacts(build);
        warn_of_held_joints(build);
    }
    throw_if_any(problems, build.has_all_bodies ? "the time step" : "the bodies of these problems and the time step");

    check_time_step(resolved, loaded.model, loaded.state);

    loaded.model.shapes.shrink_to_fit();
    body::shrink_to_fit(loaded.model.bodies, loaded.state.bodies);
    loaded.inputs = files.inputs();
    for (WavePaddle& paddle : build.paddles) {
        loaded.waves.push_back(std::move(paddle.wave));
    }
    loaded.model.case_hash = hash_of(resolved, loaded.inputs);
    loaded.resolved_toml = write_toml(resolved);
    loaded.resolved_json = write_json(resolved);
    return loaded;
}

LoadedCase read_case(const std::string& path, std::span<const std::string> overrides) {
    const std::filesystem::path file(path);
    const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
    return read_case_text(read_case_file(file), path, folder, overrides);
}

}  // namespace riprap::scene
