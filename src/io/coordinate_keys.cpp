#include "io/coordinate_keys.hpp"

#include <array>

#include "wristwise/tolerance.hpp"

namespace wristwise {

namespace {

constexpr std::array<const char*, 6> kWelderNames = {nullptr,        nullptr,      "stick_out",
                                                     "travel_angle", "work_angle", "spin"};

}  // namespace

std::vector<std::string> coordinate_keys() {
  std::vector<std::string> keys(kCoordinateNames.begin(), kCoordinateNames.end());
  for (const char* name : kWelderNames)
    if (name != nullptr) keys.emplace_back(name);
  return keys;
}

std::optional<ConfigReader> find_coordinate(const ConfigReader& reader, int coordinate) {
  const auto index = static_cast<std::size_t>(coordinate);
  std::optional<ConfigReader> value = reader.find(kCoordinateNames[index]);
  if (kWelderNames[index] == nullptr) return value;
  std::optional<ConfigReader> alias = reader.find(kWelderNames[index]);
  if (value && alias)
    alias->fail(std::string("the same as ") + kCoordinateNames[index] + ", which is given too",
                "one of them");
  return alias ? alias : value;
}

Quantity coordinate_quantity(int coordinate) {
  return coordinate < 3 ? Quantity::length : Quantity::angle;
}

}  // namespace wristwise
