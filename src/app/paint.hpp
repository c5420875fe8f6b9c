#pragma once

#include <string>

namespace wristwise::app {

enum class ColourChoice { automatic, always, never };

/// Puts text into colours, or leaves it as it is.
class Paint {
 public:
  /// Plain text.
  Paint() = default;

  /// For what is written to a file descriptor. Automatic: colours where that is a terminal and the
  /// environment has no NO_COLOR (no-color.org).
  Paint(ColourChoice choice, int descriptor);

  std::string bold(const std::string& text) const { return in("1", text); }
  std::string good(const std::string& text) const { return in("1;32", text); }
  std::string bad(const std::string& text) const { return in("1;31", text); }
  std::string warning(const std::string& text) const { return in("33", text); }

 private:
  std::string in(const char* code, const std::string& text) const;

  bool colours_ = false;
};

}  // namespace wristwise::app
