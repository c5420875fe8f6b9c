#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wristwise/geometry.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// What a mesh stands for, and how closely its pieces follow it.
struct MeshOptions {
  /// Concave parts are cut into convex pieces that reach at most so far (m) beyond the part.
  /// nullopt: the convex hull of each connected part.
  std::optional<double> convex_error;
  /// Only the surface is material, though the mesh be open: a sheet. Otherwise the inside of a
  /// closed surface is solid, and an open one counts as what its convex hull holds.
  bool sheet = false;
  /// COLLADA: turn the file's up axis to z. Robot descriptions go by the numbers as they are.
  bool turn_up_axis = false;
  /// Folder for results of earlier runs, keyed by the file's content; empty: none. What cannot be
  /// read or written there is passed over.
  std::filesystem::path cache;
};

/// A mesh as convex pieces. Together they contain it, so a colliding posture never looks clear.
struct MeshBody {
  std::vector<ConvexHull> pieces;  ///< in the mesh's frame, m
  /// m, no point of a piece is farther from the part; nullopt where nobody asked (convex_error).
  std::optional<double> error;
  std::vector<std::string> warnings;  ///< one line each, with the name of the file
};

/// Reads a mesh (STL, OBJ, DAE, ... whatever assimp reads), scaled (m per unit of the file, per
/// axis; a COLLADA file's own unit comes on top), as convex pieces (F40).
/// @throws InvalidInput naming the file where it is missing, unreadable, empty or not finite.
MeshBody load_mesh(const std::filesystem::path& file, const Eigen::Vector3d& scale,
                   const MeshOptions& options = {});

/// The convex hull of points (m).
/// @throws InvalidInput where they have no volume; `where` names the input in the message.
ConvexHull convex_hull(const std::vector<Eigen::Vector3d>& points, const std::string& where);

}  // namespace wristwise
