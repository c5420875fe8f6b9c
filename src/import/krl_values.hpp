#pragma once

#include <map>
#include <string>

#include "import/tokens.hpp"

namespace wristwise {

/// The numbers of an aggregate such as {X 100, Y 0, ...}; words among its values are left out.
using KrlAggregate = std::map<std::string, double>;

/// From the brace on. @throws InvalidInput where it is malformed or names a component twice
KrlAggregate read_aggregate(TokenReader& reader);

}  // namespace wristwise
