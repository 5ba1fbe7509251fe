// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "riprap/run/drive/signals.hpp"

namespace riprap::view {

/// Serves one page to browsers on this machine until SIGINT or SIGTERM, made anew for every visit so that a run that
/// goes on can be looked at again. Listens on the loopback interface only and answers only requests that name it
/// (a page elsewhere cannot reach in by giving its own name this address). `port` 0 takes a free one. `page` may leave
/// by an exception when it is told to stop.
/// @throws FileError when it cannot listen
void serve(const std::function<std::string(const run::StopRequest&)>& page, int port);

/// The whole answer to one HTTP request.
std::string answer_to(const std::string& request, const std::function<std::string()>& page);

}  // namespace riprap::view
