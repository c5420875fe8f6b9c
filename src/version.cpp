#include "wristwise/version.hpp"

namespace wristwise {

const char* library_version() { return WRISTWISE_VERSION; }

}  // namespace wristwise
