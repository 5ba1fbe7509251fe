// SPDX-License-Identifier: Apache-2.0
#pragma once

// A Chromium without a window that draws one page, driven over two pipes with its DevTools protocol: no port is
// opened, and no other program can talk to it.

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "riprap/io/atomic_file.hpp"

namespace riprap::view {

/// A program on PATH. @returns nothing when there is none
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Returns $RIPRAP_CHROMIUM, else Debian's chromium or a Chrome on PATH. @throws FileError with what to install
std::filesystem::path find_browser();

/// A folder that goes with the object.
class ScratchFolder {
 public:
    ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();
    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
};

/// A process that we started, and wait for: it is given a while to leave by itself.
class ChildProcess {
 public:
    ChildProcess() = default;
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ~ChildProcess() { leave(); }
    void hold(pid_t child) { child_ = child; }
    /// Waits for it, ends it where it stays. @returns how it ended: "with exit code 1", "by signal 11"
    std::string leave();

 private:
    pid_t child_{-1};
    std::string end_{"unknown"};
};

class Browser {
 public:
    /// Starts it with a window of this size [pixels of the page], each `scale` pixels of a picture wide.
    /// @throws FileError when it does not start
    Browser(const std::filesystem::path& program, int width, int height, double scale = 1);
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;
    ~Browser() = default;  // its pipes close first: it leaves when it hears nothing more

    /// Loads a page and waits until its root element has data-opened. @throws FileError with what the page says
    void open(const std::filesystem::path& page);

    /// The value of an expression of JavaScript; a promise is waited for. @throws FileError when it throws
    nlohmann::json evaluate(const std::string& expression);

    /// The window as PNG.
    std::string picture();

    /// The page as PDF on one sheet of this size [inches], without margins: lines stay lines, and text stays text.
    std::string print(double width, double height);

 private:
    void start(const std::filesystem::path& program, int width, int height, bool has_sandbox);
    nlohmann::json call(const std::string& method, nlohmann::json parameters);
    void send(const nlohmann::json& message);
    nlohmann::json receive();
    [[noreturn]] static void fail(const std::string& why);
    [[noreturn]] void fail_as_it_ended();

    ScratchFolder scratch_;
    ChildProcess child_;
    io::FileDescriptor to_, from_;
    std::string session_, received_;
    int last_id_{0};
};

}  // namespace riprap::view
