#pragma once

#include <string>

namespace wristwise {

/// A share for people: "0.48%", "120%", "<0.01%".
std::string percent(double share);

}  // namespace wristwise
