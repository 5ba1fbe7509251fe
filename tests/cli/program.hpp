// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace riprap {

/// Exit code and output of a program.
struct Ending {
    int code{-1};  ///< exit code, or -signal when a signal killed it
    std::string out, err;
};

inline std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The riprap program as a user starts it, with its output in files.
class Program {
 public:
    /// Starts it. `scratch` is an existing folder for what it prints.
    /// `prepare` is called in the new process before the program begins.
    Program(const std::filesystem::path& scratch, const std::vector<std::string>& arguments,
            const std::function<void()>& prepare = {})
        : out_(scratch / "stdout"), err_(scratch / "stderr") {
        std::vector<std::string> words{RIPRAP_PROGRAM};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> pointers;
        for (std::string& word : words) {
            pointers.push_back(word.data());
        }
        pointers.push_back(nullptr);
        child_ = fork();
        if (child_ == 0) {
            dup2(open(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), 1);
            dup2(open(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), 2);
            for (const int number : {SIGINT, SIGTERM, SIGHUP}) {  // who runs the tests may ignore them
                signal(number, SIG_DFL);
            }
            if (prepare) {
                prepare();
            }
            execv(pointers[0], pointers.data());
            _exit(127);
        }
    }
    void send(int signal) const { kill(child_, signal); }
    pid_t number() const { return child_; }
    Ending wait() const {
        int status = 0;
        waitpid(child_, &status, 0);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), text_of(out_), text_of(err_)};
    }
    bool is_running() const {
        siginfo_t info{};
        waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT);
        return info.si_pid == 0;
    }

 private:
    std::filesystem::path out_, err_;
    pid_t child_{-1};
};

inline Ending run_program(const std::filesystem::path& scratch, const std::vector<std::string>& arguments) {
    return Program(scratch, arguments).wait();
}

}  // namespace riprap
