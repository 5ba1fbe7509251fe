// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/ensemble/ensemble.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/run/ensemble/members.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/study/sweep_plan.hpp"
#include "riprap/run/study/sweep_processes.hpp"

namespace riprap::run {

namespace {

/// An ensemble that is about to run.
struct Ensemble {
    SweepOptions study;
    Members members;
    bool has_expects;
};

/// Tells why a member is not run, on the line where it would have been announced.
void tell_refusal(const EnsembleOptions& options, std::int64_t member, const std::string& text) {
    if (!options.run.silent) {
        fmt::print(stderr, "riprap: member {} of {} is refused: {}\n", member, options.members, printable(text));
    }
}

/// Draws the members and takes the folder. Those whose keys refuse them are told before the first one runs.
Ensemble begin(const EnsembleOptions& options) {
    const scene::LoadedCase loaded = scene::read_case(options.run.case_path, options.run.overrides);
    Ensemble ensemble{
        {options.run.case_path, {}, options.run.overrides, options.run.out}, {}, !loaded.model.expects.empty()};
    ensemble.study.jobs = options.jobs;
    ensemble.study.threads = options.run.threads;
    ensemble.study.quiet = options.run.quiet;
    for (const RefusedMember& refused : draw_members(loaded, options.members, ensemble.study, ensemble.members)) {
        tell_refusal(options, refused.number, to_string(refused.problem));
    }
    claim_ensemble(ensemble.study, ensemble.members, options.run.force);
    write_plan(ensemble.study);
    return ensemble;
}

/// Runs one member in this process. A refusal is told and becomes its exit code.
int run_member(const EnsembleOptions& options, std::int64_t member, const RunOptions& run) {
    try {
        return run_case(run);
    } catch (const CaseError& error) {
        for (const Diagnostic& problem : error.problems()) {
            tell_refusal(options, member, to_string(problem));
        }
        return static_cast<int>(ExitCode::bad_case);
    } catch (const CheckpointError& error) {
        tell_refusal(options, member, error.what());
        return static_cast<int>(ExitCode::bad_checkpoint);
    } catch (const FileError& error) {
        tell_refusal(options, member, error.what());
        return static_cast<int>(ExitCode::file_system);
    }
}

bool is_signal(double code) { return code > static_cast<double>(ExitCode::signal_base); }

/// Runs the members one after another. Stops after one that a signal ends.
void run_here(const EnsembleOptions& options, Ensemble& ensemble) {
    for (std::int64_t k = 1; k <= options.members; ++k) {
        Member& member = ensemble.members.list[at(k - 1)];
        const SweepPoint& point = ensemble.study.points[at(k - 1)];
        RunOptions run = options.run;
        run.overrides.insert(run.overrides.end(), point.overrides.begin(), point.overrides.end());
        run.out = options.run.out / point.name;
        run.resume = !run.force;
        run.quiet = true;
        if (std::isnan(member.code)) {
            if (!options.run.quiet || ensemble.has_expects) {  // above its verdicts
                fmt::print("member {} of {}: {}\n", k, options.members, run.out.string());
            }
            member.code = run_member(options, k, run);
        }
        write_members(ensemble.study, ensemble.members);
        if (is_signal(member.code)) {
            return;
        }
    }
}

/// Runs the members as processes, several at a time. @returns the signal that stopped them, 0 = none
int run_beside(const EnsembleOptions& options, Ensemble& ensemble) {
    SweepOptions allowed = ensemble.study;
    allowed.points.clear();
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < ensemble.study.points.size(); ++k) {
        if (std::isnan(ensemble.members.list[k].code)) {
            allowed.points.push_back(ensemble.study.points[k]);
            numbers.push_back(k);
        }
    }
    const int code = run_processes(allowed, options.jobs, options.run.force, [&](const SweepPoint& point, int ended) {
        const auto index = static_cast<std::size_t>(&point - allowed.points.data());
        ensemble.members.list[numbers[index]].code = ended;
        write_members(ensemble.study, ensemble.members);
    });
    for (std::size_t k = 0; k < ensemble.study.points.size(); ++k) {
        if (double& known = ensemble.members.list[k].code; std::isnan(known)) {  // finished before
            known = ended_code(RunFolder{ensemble.study.out / ensemble.study.points[k].name});
        }
    }
    return is_signal(code) ? code : 0;
}

/// Writes the bands of all members that ran, and tells of those that cannot be read.
int finish(const SweepOptions& study, bool is_silent) {
    std::vector<std::filesystem::path> folders;
    for (const SweepPoint& point : study.points) {
        folders.push_back(study.out / point.name);
    }
    const Bands bands = gather_bands(folders);
    write_bands(study.out / "bands.csv", bands);
    for (const std::string& text : bands.left_out) {
        if (!is_silent) {
            fmt::print(stderr, "riprap: {}\n", printable(text));
        }
    }
    return static_cast<int>(bands.left_out.empty() ? ExitCode::success : ExitCode::file_system);
}

/// The first exit code that is not zero; a signal comes before all.
int worst_of(const Members& members) {
    int worst = 0;
    for (const Member& member : members.list) {
        if (is_signal(member.code)) {
            return static_cast<int>(member.code);
        }
        worst = worst == 0 && !std::isnan(member.code) ? static_cast<int>(member.code) : worst;
    }
    return worst;
}

}  // namespace

int run_ensemble(const EnsembleOptions& options) {
    Ensemble ensemble = begin(options);
    int signal = 0;
    if (options.jobs > 1) {
        signal = run_beside(options, ensemble);
        write_members(ensemble.study, ensemble.members);
    } else {
        run_here(options, ensemble);
    }
    const int worst = signal != 0 ? signal : worst_of(ensemble.members);
    if (is_signal(worst)) {
        return worst;
    }
    const int finished = finish(ensemble.study, options.run.silent);
    return worst != 0 ? worst : finished;
}

SlurmScripts write_ensemble_scripts(const EnsembleOptions& options, const SlurmOptions& slurm) {
    return write_slurm_scripts(begin(options).study, slurm);
}

int gather_ensemble(const std::filesystem::path& out, bool is_quiet) {
    SweepOptions study = read_plan(out);
    study.quiet = is_quiet;
    const Members members = read_members(study);
    write_members(study, members);
    const int unread = finish(study, false), unfinished = tell_unfinished(study, sweep_json(study));
    return unread != 0 ? unread : unfinished;
}

}  // namespace riprap::run
