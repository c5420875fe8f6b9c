#pragma once

#include <string>

namespace wristwise {

/// The SHA-256 digest (FIPS 180-4) of bytes, as 64 hexadecimal digits: what `sha256sum` prints.
std::string sha256(const std::string& bytes);

}  // namespace wristwise
