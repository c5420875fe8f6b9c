#include <algorithm>
#include <array>
#include <cctype>

#include "wristwise/robot_program.hpp"

namespace wristwise {

namespace {

constexpr std::size_t kLongestKrl = 24;  // KSS: name of a module
constexpr std::size_t kLongestRapid =
    28;                                 // RAPID: 32 for an identifier, of which "_mod" takes four
constexpr std::size_t kLongestLs = 36;  // R-30iB; earlier controllers: 8
constexpr std::size_t kLongestFile = 100;

/// Words of KRL and RAPID that a routine cannot be called.
constexpr std::array<const char*, 68> kReserved = {
    "alias",     "and",     "backward",  "break",   "case",     "circ",   "connect", "const",
    "continue",  "decl",    "def",       "defdat",  "default",  "deffct", "div",     "do",
    "else",      "elseif",  "end",       "enddat",  "endfct",   "endfor", "endfunc", "endif",
    "endmodule", "endproc", "endswitch", "endtest", "endwhile", "enum",   "error",   "exit",
    "false",     "for",     "from",      "func",    "global",   "goto",   "if",      "lin",
    "local",     "loop",    "main",      "mod",     "module",   "not",    "or",      "pers",
    "proc",      "ptp",     "public",    "raise",   "readonly", "record", "repeat",  "retry",
    "return",    "step",    "switch",    "test",    "then",     "to",     "trap",    "true",
    "until",     "var",     "while",     "with"};

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string upper_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Letters, digits and single underscores, a letter first.
std::string identifier(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (is_letter(c) || is_digit(c))
      text += c;
    else if (!text.empty() && text.back() != '_')
      text += '_';
  }
  if (text.empty()) return "WELD";
  const std::string word = lower_case(text);
  const bool reserved = std::find(kReserved.begin(), kReserved.end(), word) != kReserved.end();
  return is_letter(text[0]) && !reserved ? text : "P_" + text;
}

}  // namespace

std::string program_name(ProgramFormat format, const std::string& name) {
  const std::string text = identifier(name);
  switch (format) {
    case ProgramFormat::krl:
      return text.substr(0, kLongestKrl);
    case ProgramFormat::rapid:
      return text.substr(0, kLongestRapid);
    case ProgramFormat::ls:
      return upper_case(text).substr(0, kLongestLs);
    case ProgramFormat::trajectory_msgs:
    case ProgramFormat::moveit:
      break;
  }
  return text.substr(0, kLongestFile);
}

}  // namespace wristwise
