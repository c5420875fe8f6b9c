#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/config_reader.hpp"

namespace wristwise {

/// The keys of the six coordinates of a tolerance box, with a welder's names for some of them.
std::vector<std::string> coordinate_keys();

/// The value of coordinate 0 to 5 under either name; @throws InvalidInput where both are given.
std::optional<ConfigReader> find_coordinate(const ConfigReader& reader, int coordinate);

Quantity coordinate_quantity(int coordinate);

}  // namespace wristwise
