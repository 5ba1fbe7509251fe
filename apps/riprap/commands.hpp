// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "built_in.hpp"
#include "riprap/run/study/matrix.hpp"

namespace riprap::run {
struct EnsembleOptions;
}
namespace riprap::view {
struct RenderOptions;
struct DamageRequest;
struct SeaRequest;
}  // namespace riprap::view

namespace riprap {

// One function per subcommand that is more than a call into riprap::run. All return the exit code.

int print_version(bool as_json);

/// Prints the cases and suites that `riprap run` and `riprap validate` find by name.
/// `published` are those of the validation, or null where this program does not know them all: those with a case file
/// are listed then, and how to see the others.
int print_list(const std::function<std::vector<ListedCase>()>& published, bool as_json);
/// Prints the cases and the cost of their runs on this machine, estimated from some steps of each.
int print_costs(bool as_json);
/// Prints the published cases that all words are about, each with its source; with words also the commands that run and
/// copy it. @throws FileError where there is none
int print_published(const std::vector<std::string>& words, bool as_json);
/// Prints the names of all cases, one a line, for the completion of shells.
int print_case_names();

/// Prints all that is known of a case before its first step. With `as_json` a bad case is an answer as well: its
/// problems, and the exit code for a bad case.
int print_check(const std::string& case_text, const std::vector<std::string>& overrides, bool as_json);

/// A case with every solid method and every fluid: result, cost, residual of the ledger, and why a combination is
/// illegal.
int print_matrix(run::MatrixOptions options, bool as_json);

struct ViewOptions {
    std::vector<std::filesystem::path> folders;  ///< of the runs; several are shown side by side
    std::filesystem::path out;  ///< empty: index.html in the folder of the run, compare.html for several
    double budget_mb{60};       ///< bytes of the page [MB]
    bool is_served{false};      ///< to browsers on this machine, instead of written
    int port{0};                ///< 0 = a free one
};

/// One page with everything that a run left, or with several runs side by side.
int view_run(const ViewOptions& options);

struct SlurmWords;

/// Runs an ensemble and plots its bands, in the unit of the first; or hands it in to Slurm.
int run_ensemble(const run::EnsembleOptions& options, const SlurmWords& slurm);

/// Makes tables, bands and page of an ensemble whose members other processes ran.
int gather_ensemble(const std::filesystem::path& out, bool is_quiet);

/// A picture or a movie of a run.
int print_render(const view::RenderOptions& options);

struct PlotOptions {
    std::filesystem::path folder;         ///< of the run
    std::vector<std::string> columns;     ///< of its tables; empty: gauges and bodies, else energies
    std::filesystem::path out;            ///< SVG, PNG or PDF by its name; empty: plot.svg in the folder of the run
    double width{0}, height{0};           ///< of each chart [mm]; 0: as it is usual
    double dpi{192};                      ///< of a PNG
    std::string title, x_label, y_label;  ///< in place of what the run and its columns say
};

/// Curves over time from the tables of a run.
int plot_run(const PlotOptions& options);

/// The waves that the gauges of a run recorded, and how much of them was reflected; of a sea, or where it `is_asked`,
/// its numbers with bands over all runs, written into the folder `out` too where that is not empty.
int print_waves(const std::vector<std::filesystem::path>& folders, const view::SeaRequest& request, bool is_asked,
                const std::filesystem::path& out, bool as_json);

/// Damage of an armour layer between two frames, written into the folder `out` too where that is not empty.
int print_damage(const std::filesystem::path& folder, const view::DamageRequest& request,
                 const std::filesystem::path& out, bool as_json);

}  // namespace riprap
