#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace wristwise {

/// 128 bits that tell texts apart by their content: two runs of FNV-1a, each over words mixed
/// another way. Not meant to withstand somebody who looks for two texts with the same ones.
inline std::array<std::uint64_t, 2> content_hash(const std::string& text) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  std::uint64_t forward = 0xcbf29ce484222325, mixed = 0x9e3779b97f4a7c15;
  for (const char c : text) {
    const auto byte = static_cast<std::uint64_t>(static_cast<unsigned char>(c));
    forward = (forward ^ byte) * kPrime;
    mixed = (mixed + byte + 1) * 0xff51afd7ed558ccd;
    mixed ^= mixed >> 29U;
  }
  return {forward ^ text.size(), mixed};
}

}  // namespace wristwise
