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
#include <utility>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"

namespace riprap::view {

namespace {

constexpr std::size_t longest_request = 16384;  // bytes; a browser sends a few hundred
constexpr int look_at_signals = 200;            // [ms]
constexpr std::size_t most_visitors = 64;       // at a time; others wait until one is through or too late

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

/// Who asks for the page: first its request is read, then the answer sent, as far as it is ready for either. None waits
/// for another.
class Visitor {
 public:
    explicit Visitor(io::FileDescriptor socket) : socket_(std::move(socket)), deadline_(Clock::now() + time_to_ask) {}
    pollfd entry() const { return {socket_.number(), static_cast<short>(has_asked_ ? POLLOUT : POLLIN), 0}; }
    bool is_late() const { return Clock::now() >= deadline_; }
    /// One that leaves is let go.
    bool is_gone() const { return is_gone_ || (has_asked_ && sent_ == answer_.size()); }

    void go_on(const std::function<std::string()>& page) {
        if (has_asked_) {
            send();
        } else if (read()) {
            answer_ = answer_to(request_, page);
            has_asked_ = true;
            deadline_ = Clock::now() + time_to_read;
        }
    }

 private:
    /// @returns whether the request is there
    bool read() {
        char buffer[4096];
        const ssize_t count = ::recv(socket_.number(), buffer, sizeof buffer, MSG_DONTWAIT);
        if (count <= 0) {
            is_gone_ = count == 0 || (errno != EINTR && errno != EAGAIN);
            return false;
        }
        request_.append(buffer, static_cast<std::size_t>(count));
        return request_.find("\r\n\r\n") != std::string::npos || request_.size() >= longest_request;
    }
    void send() {
        const ssize_t count =
            ::send(socket_.number(), answer_.data() + sent_, answer_.size() - sent_, MSG_DONTWAIT | MSG_NOSIGNAL);
        if (count >= 0) {
            sent_ += static_cast<std::size_t>(count);
        } else {
            is_gone_ = errno != EINTR && errno != EAGAIN;
        }
    }

    io::FileDescriptor socket_;
    Clock::time_point deadline_;
    std::string request_, answer_;
    std::size_t sent_{0};
    bool has_asked_{false}, is_gone_{false};
};

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
    std::vector<Visitor> visitors;
    while (stop.signal() == 0) {
        std::vector<pollfd> entries{
            {socket.number(), static_cast<short>(visitors.size() < most_visitors ? POLLIN : 0), 0}};
        for (const Visitor& visitor : visitors) {
            entries.push_back(visitor.entry());
        }
        if (::poll(entries.data(), entries.size(), look_at_signals) > 0) {
            for (std::size_t i = 0; i < visitors.size() && stop.signal() == 0; ++i) {
                if (entries[i + 1].revents != 0) {
                    visitors[i].go_on([&] { return page(stop); });
                }
            }
            if ((entries.front().revents & POLLIN) != 0) {
                io::FileDescriptor caller(::accept4(socket.number(), nullptr, nullptr, SOCK_CLOEXEC));
                if (caller.is_open()) {
                    visitors.emplace_back(std::move(caller));
                }
            }
        }
        std::erase_if(visitors, [](const Visitor& visitor) { return visitor.is_gone() || visitor.is_late(); });
    }
}

}  // namespace riprap::view
