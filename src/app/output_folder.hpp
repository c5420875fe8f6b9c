#pragma once

#include <filesystem>

namespace wristwise::app {

/// Where results go: `given`, or out/<stem of the problem file> where that is empty.
/// Nothing is made yet. @throws InvalidInput where it could not be written to.
std::filesystem::path output_folder(const std::filesystem::path& given,
                                    const std::filesystem::path& problem);

}  // namespace wristwise::app
