#pragma once

#include <string_view>

namespace wristwise {

/// src/report/template.html, which is made from src/report/page.
std::string_view page_template();

}  // namespace wristwise
