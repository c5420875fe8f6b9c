#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "wristwise/mesh.hpp"

namespace wristwise {

/// The pieces of a mesh as they were found before, in a file named by the content of the mesh's
/// file and by everything else that they depend on. A cache: where anything is wrong with it, there
/// is nothing in it.
class MeshCache {
 public:
  MeshCache(const std::filesystem::path& file, const Eigen::Vector3d& scale,
            const MeshOptions& options);

  std::optional<MeshBody> find() const;
  void keep(const MeshBody& body) const;

 private:
  std::filesystem::path place() const;

  std::filesystem::path folder_;  ///< empty: no cache
  std::string where_;             ///< of the mesh; warnings begin with it
  std::array<std::uint64_t, 2> key_{};
};

}  // namespace wristwise
