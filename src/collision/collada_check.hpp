#pragma once

#include <filesystem>

namespace wristwise {

/// Refuses COLLADA files on which assimp 5.2 would crash, or read on for ever: no XML, numbers that
/// are none, references and counts that are missing.
/// @throws InvalidInput with the line
void check_collada(const std::filesystem::path& file);

}  // namespace wristwise
