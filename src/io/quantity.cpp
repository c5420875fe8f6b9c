#include "io/quantity.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kPi = 3.14159265358979323846;

struct Unit {
  std::string_view name;
  Quantity quantity;
  double numerator, denominator;  // two, so that 10 mm is exactly the double nearest to 0.01
};

constexpr std::array<Unit, 17> kUnits = {{
    {"m", Quantity::length, 1, 1},
    {"cm", Quantity::length, 1, 100},
    {"mm", Quantity::length, 1, 1000},
    {"um", Quantity::length, 1, 1e6},
    {"rad", Quantity::angle, 1, 1},
    {"deg", Quantity::angle, kPi, 180},
    {"s", Quantity::time, 1, 1},
    {"ms", Quantity::time, 1, 1000},
    {"min", Quantity::time, 60, 1},
    {"m/s", Quantity::speed, 1, 1},
    {"cm/s", Quantity::speed, 1, 100},
    {"mm/s", Quantity::speed, 1, 1000},
    {"m/min", Quantity::speed, 1, 60},
    {"cm/min", Quantity::speed, 1, 6000},
    {"mm/min", Quantity::speed, 1, 60000},
    {"rad/s", Quantity::turn_rate, 1, 1},
    {"deg/s", Quantity::turn_rate, kPi, 180},
}};

constexpr std::string_view kind_name(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return "a length";
    case Quantity::angle:
      return "an angle";
    case Quantity::time:
      return "a time";
    case Quantity::speed:
      return "a speed";
    case Quantity::turn_rate:
      return "a rate of turn";
    case Quantity::number:
      break;
  }
  return "a number";
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view without_sign(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  return text;
}

std::optional<double> parse_special(std::string_view text) {
  const std::string_view word = without_sign(text);
  if (word == ".nan" || word == ".NaN" || word == ".NAN")
    return std::numeric_limits<double>::quiet_NaN();
  if (word == ".inf" || word == ".Inf" || word == ".INF")
    return (text[0] == '-' ? -1 : 1) * std::numeric_limits<double>::infinity();
  return std::nullopt;
}

/// Where the number ends and the unit begins: at the first letter that is no part of "1e-3".
std::size_t unit_start(std::string_view text) {
  double value = 0;
  const std::size_t sign = !text.empty() && text[0] == '+' ? 1 : 0;
  const auto parsed = std::from_chars(text.data() + sign, text.data() + text.size(), value);
  return parsed.ec == std::errc::invalid_argument
             ? text.size()
             : static_cast<std::size_t>(parsed.ptr - text.data());
}

double in_si_units(double value, std::string_view unit, Quantity quantity,
                   const std::string& quoted, const std::string& where) {
  for (const Unit& known : kUnits) {
    if (known.name != unit) continue;
    if (known.quantity == quantity) return value * known.numerator / known.denominator;
    throw InvalidInput(where, quoted + " has the unit of " + std::string(kind_name(known.quantity)),
                       describe(quantity));
  }
  throw InvalidInput(where, quoted + " has an unknown unit", describe(quantity));
}

}  // namespace

std::string describe(Quantity quantity) {
  if (quantity == Quantity::number) return "a number without unit";
  std::string text(kind_name(quantity));
  const char* separator = " (";
  for (const Unit& unit : kUnits) {
    if (unit.quantity != quantity) continue;
    text += separator + std::string(unit.name);
    separator = unit.numerator == 1 && unit.denominator == 1 ? "; also " : ", ";
  }
  return text + ")";
}

std::optional<double> parse_number(std::string_view text) {
  text = trimmed(text);
  if (const auto special = parse_special(text)) return special;
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  if (text.empty() || text[0] == '+') return std::nullopt;
  double value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ptr != text.data() + text.size()) return std::nullopt;
  if (parsed.ec == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
  if (parsed.ec != std::errc()) return std::nullopt;
  return value;
}

double parse_quantity(const std::string& text, Quantity quantity, const std::string& where) {
  const std::string_view all = trimmed(text);
  const std::string quoted = "'" + std::string(all) + "'";
  std::string_view unit;
  std::optional<double> value = parse_number(all);
  if (!value) {
    const std::size_t split = unit_start(all);
    value = parse_number(all.substr(0, split));
    unit = trimmed(all.substr(split));
  }
  if (!value) throw InvalidInput(where, quoted + " is not a number", describe(quantity));
  const double result = unit.empty() ? *value : in_si_units(*value, unit, quantity, quoted, where);
  if (!std::isfinite(result))
    throw InvalidInput(where, quoted + " is not finite", describe(quantity));
  return result;
}

}  // namespace wristwise
