#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wristwise {

/// What a number in a file measures; decides the units it may carry.
enum class Quantity { number, length, angle, time, speed, turn_rate };

/// "a length (m; also mm, cm)", for messages.
std::string describe(Quantity quantity);

/// The whole text as a number: locale-free, with an optional sign. NaN and infinities, in C's and
/// YAML's spelling, are numbers here.
std::optional<double> parse_number(std::string_view text);

/// A number with an optional unit ("10 deg", "0.5mm") in SI units.
/// @throws InvalidInput at `where`: no number, not finite, an unknown unit or one of another
/// quantity.
double parse_quantity(const std::string& text, Quantity quantity, const std::string& where);

}  // namespace wristwise
