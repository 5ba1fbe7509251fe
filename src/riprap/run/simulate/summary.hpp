// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "riprap/run/figures/expects.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/simulate/step_watch.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// Record of a run when it is over.
struct Summary {
    std::string status;  ///< "finished", "interrupted" or "failed"
    std::string reason;  ///< why it is not finished, empty else
    std::string title;
    std::string source;  ///< publication that the case is taken from; empty where it names none
    std::uint64_t state_hash{0};
    std::int64_t steps{0};
    double time{0};           ///< [s]
    double dt{0};             ///< of the last step [s]
    std::int64_t retries{0};  ///< steps refused and taken again with half the length
    StepCounts counts;
    double wall_seconds{0};       ///< of all processes that ran it [s]
    double predicted_seconds{0};  ///< of the run to its end [s]
    double seconds_per_step{0};   ///< of this process [s]
    double cost{0};               ///< of this process [ns per body and step]
    std::int64_t body_count{0};
    std::int64_t particle_count{0};
    std::size_t memory_bytes{0};  ///< State and Scratch
    int threads{1};
    std::int64_t resumes{0};
    sim::Ledger ledger;
    struct Account {
        std::string name;  ///< "solid.friction"
        double value;      ///< [J]
    };
    std::vector<Account> accounts;  ///< of the methods of the case, at the last kick
    bool has_fluid{false};
    sim::StageTimes stages;
    std::vector<ExpectResult> expects;
    std::vector<std::string> warnings;   ///< of the case and of its steps
    std::vector<std::string> overrides;  ///< "key=value", as --set gave them
};

/// The text of summary.json.
std::string summary_json(const Summary& summary);

/// Writes summary.json (docs/howto/output-files.md). @throws FileError
void write_summary(const RunFolder& folder, const Summary& summary);

}  // namespace riprap::run
