// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/study/sweep_slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <optional>

#include "riprap/core/child_process.hpp"
#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/study/sweep_plan.hpp"

namespace riprap::run {

namespace {

/// Quotes a text as one word of the shell.
std::string word(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return result + '\'';
}

std::string whole_path(const std::filesystem::path& path) {
    return std::filesystem::absolute(path).lexically_normal().string();
}

/// Refuses what would leave its line of #SBATCH.
void require_plain(const std::string& text) {
    const auto is_plain = [](unsigned char c) { return std::isalnum(c) != 0 || std::strchr("_.,:+-@/", c) != nullptr; };
    if (!std::all_of(text.begin(), text.end(), is_plain)) {
        throw FileError(fmt::format("'{}' is no word for Slurm; allowed: letters, digits and _.,:+-@/", text));
    }
}

/// Writes the lines of #SBATCH that both jobs share.
std::string heading_of(const SlurmOptions& slurm, const std::string& name, const std::string& log) {
    std::string text = fmt::format("#!/bin/bash\n#SBATCH --job-name={}\n#SBATCH --output={}\n", name, log);
    const std::array<std::pair<const char*, std::string>, 2> asked{
        {{"partition", slurm.partition}, {"account", slurm.account}}};
    for (const auto& [key, value] : asked) {
        text += value.empty() ? "" : fmt::format("#SBATCH --{}={}\n", key, value);
    }
    return text;
}

/// Writes the job of one run. Before its time is up Slurm sends USR1: the run is asked to stop, writes a checkpoint,
/// and the task goes back into the queue. A cancelled job gets TERM and stays stopped.
std::string task_script(const SweepOptions& options, const SlurmOptions& slurm) {
    std::string text = heading_of(slurm, "riprap-study", "slurm_%A_%a.log");
    text += fmt::format("#SBATCH --cpus-per-task={}\n", std::max(1, options.threads));
    text += slurm.time.empty() ? "" : fmt::format("#SBATCH --time={}\n", slurm.time);
    text += slurm.memory.empty() ? "" : fmt::format("#SBATCH --mem={}\n", slurm.memory);
    text +=
        "#SBATCH --requeue\n"
        "#SBATCH --open-mode=append\n"
        "#SBATCH --signal=B:USR1@120\n"
        "# One run of the study: number RIPRAP_FIRST + the index of the task. Two minutes before the time is up the "
        "run\n"
        "# writes a checkpoint, and the task is queued again; it goes on from there. A task that is cancelled stays "
        "stopped.\n"
        "run= queue_again= stopped=\n"
        "stop() {\n"
        "    if [ -n \"$run\" ] && [ -z \"$stopped\" ]; then\n"
        "        stopped=yes\n"
        "        kill -TERM \"$run\" 2>/dev/null\n"
        "    fi\n"
        "}\n"
        "trap 'queue_again=yes; stop' USR1\n"
        "trap 'queue_again=; cancelled=yes; stop' TERM\n";
    text += fmt::format("{} sweep --out {} --threads {} --point $((${{RIPRAP_FIRST:-0}} + SLURM_ARRAY_TASK_ID)) &\n",
                        word(slurm.program.string()), word(whole_path(options.out)), std::max(1, options.threads));
    text +=
        "run=$!\n"
        "[ -z \"$queue_again${cancelled:-}\" ] || stop  # told before there was a run\n"
        "while kill -0 \"$run\" 2>/dev/null; do  # a signal ends `wait`, not the run\n"
        "    wait \"$run\"\n"
        "done\n"
        "wait \"$run\"\n"
        "code=$?\n"
        "if [ -n \"$queue_again\" ] && [ $code -gt 128 ]; then\n"
        "    scontrol requeue \"$SLURM_JOB_ID\"\n"
        "fi\n"
        "exit $code\n";
    return text;
}

std::string gather_script(const SweepOptions& options, const SlurmOptions& slurm) {
    return heading_of(slurm, "riprap-gather", "slurm_gather.log") +
           "# Makes sweep.csv, sweep.json and index.html of all runs.\n" +
           fmt::format("exec {} sweep --out {} --gather\n", word(slurm.program.string()),
                       word(whole_path(options.out)));
}

/// Sorts unfinished runs by the array that they go into: first number of the array less one, and indices in it.
std::map<std::size_t, std::vector<std::size_t>> arrays_of(const SweepOptions& options, std::int64_t largest_index) {
    const auto most = static_cast<std::size_t>(std::max<std::int64_t>(1, largest_index));
    std::map<std::size_t, std::vector<std::size_t>> arrays;
    for (std::size_t k = 0; k < options.points.size(); ++k) {
        if (!is_finished(options, options.points[k])) {
            arrays[k / most * most].push_back(k % most + 1);
        }
    }
    return arrays;
}

std::string submit_script(const SweepOptions& options, const SlurmOptions& slurm) {
    std::string text =
        "#!/bin/bash\n"
        "# Hands the study in: runs that are not finished as job arrays, then the job that makes the tables.\n"
        "set -eu\n"
        "cd \"$(dirname \"$0\")\"\n"
        "if [ -s slurm_jobs ]; then  # a controller that is away has not forgotten its jobs\n"
        "    if ! queue=$(squeue --noheader --user \"$(id -u)\" --format=%F); then\n"
        "        echo \"Slurm does not answer; jobs $(paste -sd, slurm_jobs) may be under way\" >&2\n"
        "        exit 1\n"
        "    fi\n"
        "    if grep -qxFf slurm_jobs <<<\"$queue\"; then\n"
        "        echo \"the study is under way: jobs $(paste -sd, slurm_jobs); scancel ends them\" >&2\n"
        "        exit 1\n"
        "    fi\n"
        "fi\n"
        ": >slurm_jobs\n"
        "hand_in() {  # with several clusters Slurm answers id;cluster\n"
        "    local answer\n"
        "    answer=$(sbatch --parsable \"$@\")\n"
        "    echo \"${answer%%;*}\" >>slurm_jobs\n"
        "}\n";
    const std::string limit = slurm.jobs > 0 ? fmt::format("%{}", slurm.jobs) : "";
    for (const auto& [first, numbers] : arrays_of(options, slurm.largest_index)) {
        text += fmt::format("hand_in --array={}{} --export=ALL,RIPRAP_FIRST={} slurm_task.sh\n", array_of(numbers),
                            limit, first);
    }
    text +=
        "if [ -s slurm_jobs ]; then\n"
        "    hand_in --dependency=\"afterany:$(paste -sd: slurm_jobs)\" slurm_gather.sh\n"
        "else\n"
        "    hand_in slurm_gather.sh\n"
        "fi\n"
        "echo \"jobs $(paste -sd, slurm_jobs); the last makes the tables\"\n";
    return text;
}

void write_program(const std::filesystem::path& file, const std::string& text) {
    using std::filesystem::perms;
    io::write_file(file, text);
    std::filesystem::permissions(file, perms::owner_exec, std::filesystem::perm_options::add);
}

}  // namespace

std::string array_of(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (std::size_t begin = 0, end = 0; begin < numbers.size(); begin = end) {
        for (end = begin + 1; end < numbers.size() && numbers[end] == numbers[end - 1] + 1;) {
            ++end;
        }
        text += text.empty() ? "" : ",";
        text += end - begin == 1 ? fmt::format("{}", numbers[begin])
                                 : fmt::format("{}-{}", numbers[begin], numbers[end - 1]);
    }
    return text;
}

SlurmScripts write_slurm_scripts(const SweepOptions& options, const SlurmOptions& slurm) {
    for (const std::string* text : {&slurm.partition, &slurm.account, &slurm.time, &slurm.memory}) {
        require_plain(*text);
    }
    const SlurmScripts scripts{options.out / "slurm_task.sh", options.out / "slurm_gather.sh",
                               options.out / "slurm_submit.sh"};
    write_program(scripts.task, task_script(options, slurm));
    write_program(scripts.gather, gather_script(options, slurm));
    write_program(scripts.submit, submit_script(options, slurm));
    return scripts;
}

std::int64_t largest_array_index() {
    constexpr std::int64_t usual = 1000;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> answer(
        ::popen("scontrol show config 2>/dev/null | sed -n 's/^MaxArraySize *= *//p'", "r"), ::pclose);
    std::array<char, 32> line{};
    if (answer == nullptr || std::fgets(line.data(), static_cast<int>(line.size()), answer.get()) == nullptr) {
        return usual;
    }
    const long long size = std::strtoll(line.data(), nullptr, 10);
    return size > 1 ? size - 1 : usual;
}

int submit(const SlurmScripts& scripts) {
    const std::optional<int> code = run_to_end({whole_path(scripts.submit)});
    constexpr int not_found = 127;  // as the shell tells it of sbatch
    if (code != 0) {
        throw FileError(fmt::format(
            "{}: the scripts are in '{}'; run slurm_submit.sh there where Slurm answers",
            code == not_found ? "there is no sbatch on this machine" : "the study was not handed in, see above",
            scripts.submit.parent_path().string()));
    }
    return 0;
}

}  // namespace riprap::run
