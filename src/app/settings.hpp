#pragma once

namespace wristwise::app {

/// The options that every command takes.
struct Settings {
  bool quiet = false;
  int threads = 0;  ///< 0: one per core
};

}  // namespace wristwise::app
