// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/browser.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "riprap/io/vtk_data.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int longest_wait = 180'000;                           // [ms] for one answer; software drawing is slow
constexpr std::size_t longest_message = std::size_t{1} << 30U;  // bytes
constexpr auto moment = std::chrono::milliseconds(50);
constexpr int moments_to_leave = 60;
constexpr const char* words_of_browser = "stderr";  // the file, in its folder
constexpr std::size_t told_words = 1000;            // bytes, the last ones

/// File descriptors at which Chromium expects its pipes.
constexpr int read_end = 3, write_end = 4, beyond = 10;

struct Pipe {
    io::FileDescriptor read, write;
};

Pipe make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw FileError(fmt::format("cannot make a pipe to the browser: {}", std::strerror(errno)));
    }
    return {io::FileDescriptor(ends[0]), io::FileDescriptor(ends[1])};
}

std::vector<std::string> command_of(const fs::path& program, const fs::path& profile, int width, int height,
                                    bool has_sandbox) {
    std::vector<std::string> words{
        program.string(), "--headless", "--remote-debugging-pipe", "--user-data-dir=" + profile.string(),
        fmt::format("--window-size={},{}", width, height),
        // Drawn by the processor: the same picture on every machine.
        "--disable-gpu", "--enable-unsafe-swiftshader", "--hide-scrollbars",
        // Nothing but the page.
        "--no-first-run", "--no-default-browser-check", "--disable-background-networking", "--disable-component-update",
        "--disable-extensions", "--disable-sync", "--disable-dev-shm-usage", "about:blank"};
    if (!has_sandbox) {
        words.insert(words.begin() + 1, "--no-sandbox");
    }
    return words;
}

/// In the new process: takes the pipes as 3 and 4, keeps what it says in a file, and becomes the browser.
[[noreturn]] void become(const std::vector<std::string>& words, int read, int write, const fs::path& said) {
    const int high_read = ::fcntl(read, F_DUPFD, beyond), high_write = ::fcntl(write, F_DUPFD, beyond);
    ::dup2(high_read, read_end);
    ::dup2(high_write, write_end);
    ::close(high_read);
    ::close(high_write);
    const int nowhere = ::open("/dev/null", O_RDWR);
    const int file = ::open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(nowhere, 0);
    ::dup2(nowhere, 1);
    ::dup2(file < 0 ? nowhere : file, 2);
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (const std::string& word : words) {
        pointers.push_back(const_cast<char*>(word.c_str()));
    }
    pointers.push_back(nullptr);
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
}

std::string url_of(const fs::path& file) {
    std::string url = "file://";
    for (const char c : fs::absolute(file).string()) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                              std::string_view("/-_.~").find(c) != std::string_view::npos;
        url += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return url;
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
    const char* list = std::getenv("PATH");
    const std::string all = list == nullptr ? "" : list;
    for (std::size_t at = 0; at <= all.size();) {
        const std::size_t end = std::min(all.find(':', at), all.size());
        const fs::path candidate = fs::path(all.substr(at, end - at)) / name;
        if (::access(candidate.c_str(), X_OK) == 0 && fs::is_regular_file(candidate)) {
            return candidate;
        }
        at = end + 1;
    }
    return std::nullopt;
}

fs::path find_browser() {
    if (const char* named = std::getenv("RIPRAP_CHROMIUM"); named != nullptr && *named != '\0') {
        if (::access(named, X_OK) != 0) {
            throw FileError(fmt::format("RIPRAP_CHROMIUM names '{}', which cannot be run", named));
        }
        return named;
    }
    for (const char* name : {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"}) {
        if (const auto program = find_program(name)) {
            return *program;
        }
    }
    throw FileError(
        "there is no Chromium to draw pictures with; install Debian's package chromium, or name one with the "
        "environment variable RIPRAP_CHROMIUM; `riprap view` needs none");
}

ScratchFolder::ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "riprap-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        throw io::file_error("make folder", name, errno);
    }
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

Browser::Browser(const fs::path& program, int width, int height, double scale) {
    // The sandbox refuses root, and needs what containers forbid. Without it the page is as safe: it is ours.
    const bool is_root = ::geteuid() == 0;
    try {
        start(program, width, height, !is_root);
    } catch (const FileError& error) {
        if (is_root || std::string_view(error.what()).find("sandbox") == std::string_view::npos) {
            throw;
        }
        start(program, width, height, false);
    }
    call("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", scale}, {"mobile", false}});
}

void Browser::start(const fs::path& program, int width, int height, bool has_sandbox) {
    received_.clear();
    Pipe to = make_pipe(), from = make_pipe();
    const std::vector<std::string> words = command_of(program, scratch_.path() / "profile", width, height, has_sandbox);
    const fs::path said = scratch_.path() / words_of_browser;
    const pid_t child = ::fork();
    if (child < 0) {
        throw FileError(fmt::format("cannot start '{}': {}", program.string(), std::strerror(errno)));
    }
    if (child == 0) {
        become(words, to.read.number(), from.write.number(), said);
    }
    child_.hold(child);
    to_ = std::move(to.write);
    from_ = std::move(from.read);
    to.read.close();  // the browser alone holds these, so that we hear when it ends
    from.write.close();
    const Json target = call("Target.createTarget", Json::object({{"url", "about:blank"}}));
    session_ = call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}})
                   .at("sessionId")
                   .get<std::string>();
}

std::string ChildProcess::leave() {
    if (child_ <= 0) {
        return end_;
    }
    int status = 0;
    pid_t ended = ::waitpid(child_, &status, WNOHANG);
    for (int i = 0; i < moments_to_leave && ended == 0; ++i) {
        std::this_thread::sleep_for(moment);
        ended = ::waitpid(child_, &status, WNOHANG);
    }
    if (ended == 0) {
        ::kill(child_, SIGKILL);
        ::waitpid(child_, &status, 0);
    }
    child_ = -1;
    end_ = WIFSIGNALED(status) ? fmt::format("by signal {}", WTERMSIG(status))
                               : fmt::format("with exit code {}", WEXITSTATUS(status));
    return end_;
}

void Browser::fail(const std::string& why) {
    throw FileError(fmt::format("the browser that draws the picture {}; RIPRAP_CHROMIUM chooses another one", why));
}

void Browser::fail_as_it_ended() {
    to_.close();
    from_.close();
    const std::string how = child_.leave();
    std::string said = io::read_file(scratch_.path() / words_of_browser, longest_message);
    said.erase(said.find_last_not_of(" \n") + 1);
    if (said.size() > told_words) {
        said = "... " + said.substr(said.size() - told_words);
    }
    fail(fmt::format("ended {}, saying {}", how, said.empty() ? "nothing" : '\'' + said + '\''));
}

void Browser::send(const Json& message) {
    std::string text = message.dump();
    text += '\0';
    try {
        io::write_all(to_, text.data(), text.size(), "the pipe to the browser");
    } catch (const FileError&) {  // nobody reads it any more
        fail_as_it_ended();
    }
}

Json Browser::receive() {
    while (true) {
        if (const std::size_t end = received_.find('\0'); end != std::string::npos) {
            Json message = Json::parse(received_.substr(0, end), nullptr, false);
            received_.erase(0, end + 1);
            if (message.is_object()) {
                return message;
            }
            fail("sent what is no JSON");
        }
        pollfd entry{from_.number(), POLLIN, 0};
        if (::poll(&entry, 1, longest_wait) <= 0) {
            fail(fmt::format("gave no answer within {} s", longest_wait / 1000));
        }
        std::array<char, 1 << 16> buffer;
        const ssize_t count = ::read(from_.number(), buffer.data(), buffer.size());
        if (count <= 0) {
            fail_as_it_ended();
        }
        if (received_.size() > longest_message) {
            fail("sent more than a picture can hold");
        }
        received_.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

Json Browser::call(const std::string& method, Json parameters) {
    Json message{{"id", ++last_id_}, {"method", method}, {"params", std::move(parameters)}};
    if (!session_.empty()) {
        message["sessionId"] = session_;
    }
    send(message);
    while (true) {
        Json answer = receive();
        if (answer.value("id", 0) != last_id_) {
            continue;  // an event
        }
        if (answer.contains("error")) {
            fail(fmt::format("refused {}: {}", method, answer["error"].value("message", "")));
        }
        return answer["result"];
    }
}

Json Browser::evaluate(const std::string& expression) {
    const Json answer =
        call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
    if (answer.contains("exceptionDetails")) {
        const Json& details = answer["exceptionDetails"];
        throw FileError("the page failed: " + (details.contains("exception")
                                                   ? details["exception"].value("description", std::string("unknown"))
                                                   : details.value("text", std::string("unknown"))));
    }
    return answer["result"].value("value", Json());
}

void Browser::open(const fs::path& page) {
    const std::string url = url_of(page);
    call("Page.navigate", Json::object({{"url", url}}));
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(longest_wait);
    while (std::chrono::steady_clock::now() < deadline) {
        const Json state = evaluate(
            "(d => [d.opened ?? '', d.failed ?? '', location.protocol])(document.documentElement?.dataset ?? {})");
        if (state.is_array() && state[2] == "file:") {
            if (!state[1].get<std::string>().empty()) {
                throw FileError("the page failed: " + state[1].get<std::string>());
            }
            if (!state[0].get<std::string>().empty()) {
                return;
            }
        }
        std::this_thread::sleep_for(moment);
    }
    fail("did not open the page in time");
}

std::string Browser::picture() {
    const Json answer = call("Page.captureScreenshot", Json::object({{"format", "png"}}));
    return io::decode_base64(answer.at("data").get<std::string>());
}

std::string Browser::print(double width, double height) {
    const Json answer = call("Page.printToPDF", Json::object({{"paperWidth", width},
                                                              {"paperHeight", height},
                                                              {"marginTop", 0},
                                                              {"marginBottom", 0},
                                                              {"marginLeft", 0},
                                                              {"marginRight", 0},
                                                              {"printBackground", true},
                                                              {"pageRanges", "1"}}));
    return io::decode_base64(answer.at("data").get<std::string>());
}

}  // namespace riprap::view
