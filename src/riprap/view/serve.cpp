// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/serve.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string_view>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"

namespace riprap::view {

namespace {

constexpr std::size_t longest_request = 16384;  // bytes; a browser sends a few hundred
constexpr int look_at_signals = 200;            // [ms]

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds time_to_ask{2};    // for a whole request
constexpr std::chrono::seconds time_to_read{60};  // for a whole answer: a long run is tens of megabytes

io::FileDescriptor listen_on(int port, int& chosen) {
    io::FileDescriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const int yes = 1;
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    socklen_t size = sizeof address;
    if (!socket.is_open() || ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0 ||
        ::bind(socket.number(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 ||
        ::listen(socket.number(), 8) != 0 ||
        ::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&address), &size) != 0) {
        throw FileError(fmt::format("cannot listen on 127.0.0.1:{}: {}; choose another --port, or none", port,
                                    std::strerror(errno)));
    }
    chosen = ntohs(address.sin_port);
    return socket;
}

bool is_ready(const io::FileDescriptor& file, short event, int milliseconds) {
    pollfd entry{file.number(), event, 0};
    return ::poll(&entry, 1, milliseconds) == 1;
}

/// Whether the visitor is ready before the deadline, and before the user stops the program.
bool await(const io::FileDescriptor& visitor, short event, Clock::time_point deadline, const run::StopRequest& stop) {
    while (stop.signal() == 0 && Clock::now() < deadline) {
        if (is_ready(visitor, event, look_at_signals)) {
            return true;
        }
    }
    return false;
}

std::string read_request(const io::FileDescriptor& visitor, const run::StopRequest& stop) {
    const Clock::time_point deadline = Clock::now() + time_to_ask;
    std::string request;
    char buffer[4096];
    while (request.find("\r\n\r\n") == std::string::npos && request.size() < longest_request &&
           await(visitor, POLLIN, deadline, stop)) {
        const ssize_t count = ::read(visitor.number(), buffer, sizeof buffer);
        if (count <= 0) {
            break;
        }
        request.append(buffer, static_cast<std::size_t>(count));
    }
    return request;
}

/// A visitor that leaves, or does not read, is let go.
void send(const io::FileDescriptor& visitor, std::string_view answer, const run::StopRequest& stop) {
    const Clock::time_point deadline = Clock::now() + time_to_read;
    while (!answer.empty() && await(visitor, POLLOUT, deadline, stop)) {
        const ssize_t count = ::send(visitor.number(), answer.data(), answer.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
        if (count >= 0) {
            answer.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EINTR && errno != EAGAIN) {
            return;
        }
    }
}

std::string response(const std::string& status, const std::string& type, const std::string& body) {
    return fmt::format(
        "HTTP/1.1 {}\r\nContent-Type: {}; charset=utf-8\r\nContent-Length: {}\r\nConnection: close\r\n"
        "Cache-Control: no-store\r\n\r\n{}",
        status, type, body.size(), body);
}

/// The value of a header line, without its port; empty when there is none.
std::string host_of(const std::string& request) {
    for (const char* key : {"\r\nHost: ", "\r\nhost: "}) {
        if (const std::size_t at = request.find(key); at != std::string::npos) {
            const std::size_t begin = at + 8;
            return request.substr(begin, request.find_first_of(":\r", begin) - begin);
        }
    }
    return "";
}

}  // namespace

std::string answer_to(const std::string& request, const std::function<std::string()>& page) {
    const std::string host = host_of(request);
    if (host != "127.0.0.1" && host != "localhost") {
        return response("403 Forbidden", "text/plain", "only for visitors of this machine\n");
    }
    if (!request.starts_with("GET / ")) {
        return response("404 Not Found", "text/plain", "there is one page, at /\n");
    }
    try {
        return response("200 OK", "text/html", page());
    } catch (const std::exception& error) {  // one bad frame or full memory is no reason to leave the others
        return response("500 Internal Server Error", "text/plain", std::string(error.what()) + '\n');
    }
}

void serve(const std::function<std::string(const run::StopRequest&)>& page, int port) {
    int chosen = 0;
    const io::FileDescriptor socket = listen_on(port, chosen);
    fmt::print("http://127.0.0.1:{}/ shows the run to browsers on this machine; Ctrl-C ends it\n", chosen);
    std::fflush(stdout);
    const run::StopRequest stop;
    while (stop.signal() == 0) {
        if (!is_ready(socket, POLLIN, look_at_signals)) {
            continue;
        }
        const io::FileDescriptor visitor(::accept4(socket.number(), nullptr, nullptr, SOCK_CLOEXEC));
        if (!visitor.is_open()) {
            continue;
        }
        const std::string request = read_request(visitor, stop);
        send(visitor, answer_to(request, [&] { return page(stop); }), stop);
    }
}

}  // namespace riprap::view
