// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/render.hpp"

#include <fmt/format.h>

#include "commands.hpp"

namespace riprap {

int print_render(const view::RenderOptions& options) {
    fmt::print("{}\n", view::render_run(options));
    return 0;
}

}  // namespace riprap
