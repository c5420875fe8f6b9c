#pragma once

#include "app/paint.hpp"
#include "wristwise/problem.hpp"

namespace wristwise::app {

/// The options that every command takes.
struct Settings {
  bool quiet = false;
  int threads = 0;        ///< 0: one per core
  bool no_cache = false;  ///< of meshes
  ColourChoice colour = ColourChoice::automatic;
};

inline LoadOptions load_options(const Settings& settings) { return {!settings.no_cache}; }

}  // namespace wristwise::app
