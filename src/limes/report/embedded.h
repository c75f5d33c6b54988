#pragma once

#include <string_view>

/// Files of this folder that travel inside the library (see embed.cmake).
namespace limes::embedded {

extern const std::string_view report_css;
extern const std::string_view viewer_js;

}  // namespace limes::embedded
