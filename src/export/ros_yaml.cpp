#include "export/ros_yaml.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace wristwise {

namespace {

constexpr int kLeastFixed = -4, kMostFixed = 16;  // powers of ten that Python's repr writes out

/// The shortest digits that give the same double back, and the power of ten of the first.
struct Digits {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

Digits shortest_digits(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value),
                                 std::chars_format::scientific);
  const std::string text(buffer.data(), end.ptr);
  const std::size_t e = text.find('e');
  Digits result;
  result.negative = std::signbit(value);
  for (const char c : text.substr(0, e))
    if (c != '.') result.digits += c;
  result.exponent = std::stoi(text.substr(e + 1));
  return result;
}

std::string written_out(const Digits& number) {
  const auto zeros = [](int count) { return std::string(static_cast<std::size_t>(count), '0'); };
  const auto count = static_cast<int>(number.digits.size());
  const int whole = number.exponent + 1;  // digits before the point
  if (whole <= 0) return "0." + zeros(-whole) + number.digits;
  if (whole >= count) return number.digits + zeros(whole - count) + ".0";
  const auto point = static_cast<std::size_t>(whole);
  return number.digits.substr(0, point) + "." + number.digits.substr(point);
}

std::string with_exponent(const Digits& number) {
  const std::string rest = number.digits.substr(1);
  const int size = std::abs(number.exponent);
  return number.digits.substr(0, 1) + "." + (rest.empty() ? "0" : rest) +
         (number.exponent < 0 ? "e-" : "e+") + (size < 10 ? "0" : "") + std::to_string(size);
}

bool is_plain(const std::string& word) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (word.empty() || !is_letter(word[0])) return false;
  const bool simple = std::all_of(word.begin(), word.end(), [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '/' || c == '.';
  });
  std::string lower = word;
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  const std::array<const char*, 9> special = {"y",   "n",    "yes",   "no",  "on",
                                              "off", "true", "false", "null"};
  return simple && std::find(special.begin(), special.end(), lower) == special.end();
}

}  // namespace

std::string yaml_number(double value) {
  const Digits number = shortest_digits(value);
  const bool fixed = number.exponent >= kLeastFixed && number.exponent < kMostFixed;
  return (number.negative ? "-" : "") + (fixed ? written_out(number) : with_exponent(number));
}

std::string yaml_word(const std::string& word) {
  if (is_plain(word)) return word;
  std::string quoted = "'";
  for (const char c : word) {
    quoted += c;
    if (c == '\'') quoted += c;
  }
  return quoted + "'";
}

void RosYaml::key(int indent, const std::string& name, bool dash) {
  const auto spaces = static_cast<std::size_t>(dash ? indent - 2 : indent);
  text_ += std::string(spaces, ' ') + (dash ? "- " : "") + name + ":\n";
}

void RosYaml::value(int indent, const std::string& name, const std::string& text, bool dash) {
  key(indent, name, dash);
  text_.back() = ' ';
  text_ += text + "\n";
}

void RosYaml::empty_list(int indent, const std::string& name) { value(indent, name, "[]"); }

void RosYaml::numbers(int indent, const std::string& name, const double* values, std::size_t count,
                      bool dash) {
  key(indent, name, dash);
  for (std::size_t i = 0; i < count; ++i)
    text_ +=
        std::string(static_cast<std::size_t>(indent), ' ') + "- " + yaml_number(values[i]) + "\n";
}

void RosYaml::words(int indent, const std::string& name, const std::vector<std::string>& words) {
  key(indent, name);
  for (const std::string& word : words)
    text_ += std::string(static_cast<std::size_t>(indent), ' ') + "- " + yaml_word(word) + "\n";
}

}  // namespace wristwise
