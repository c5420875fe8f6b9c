#pragma once

#include <string_view>

namespace wristwise::app {

/// Columns that UTF-8 text takes on a terminal: none for escape sequences and marks that combine
/// with the character before them, two for East Asian wide characters and pictographs, one for a
/// byte that is no UTF-8.
int display_width(std::string_view text);

}  // namespace wristwise::app
