#pragma once

namespace wristwise::app {

/// Whether what is written to this file descriptor is seen on a terminal that understands escape
/// sequences: TERM is set, and not to "dumb".
bool is_terminal(int descriptor);

/// Columns of the terminal; 80 where that cannot be told.
int terminal_width(int descriptor);

}  // namespace wristwise::app
