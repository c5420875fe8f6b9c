#include "collision/mesh_body.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "collision/convex_cut.hpp"
#include "collision/cut_piece.hpp"
#include "collision/hull_reduction.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kFarTooLarge = 100;  // m
constexpr double kWeld = 1e-6;        // of the extent
constexpr double kThickness = 1e-5;   // of the extent
constexpr std::size_t kManyVertices = 200;
constexpr double kReduction = 2e-3;      // of the size of a hull of many vertices
constexpr double kShareForHulls = 0.25;  // of convex_error
constexpr std::size_t kMostParts = 64;
constexpr std::size_t kMostPieces = 128;
constexpr std::size_t kMostTrianglesToCut = 50000;

std::string in_mm(double length) { return fmt::format("{:.3g} mm", 1000 * length); }

std::size_t not_closed(std::vector<TriangleMesh>& parts) {
  std::size_t count = 0;
  for (TriangleMesh& part : parts) count += close_outward(part) ? 0 : 1;
  return count;
}

/// Makes the pieces of the parts of one mesh, one after the other.
class MeshBodyMaker {
 public:
  MeshBodyMaker(const TriangleMesh& mesh, const MeshOptions& options, const std::string& where)
      : mesh_(mesh), options_(options), where_(where), extent_(mesh.box().sizes().maxCoeff()) {}

  MeshBody make() {
    if (!(extent_ > 0)) throw InvalidInput(where_, "all points are one", "a mesh with a surface");
    const bool too_large = extent_ > kFarTooLarge;
    if (too_large) {
      warn(fmt::format("it is {:.4g} m across; in mm it needs the scale 0.001", extent_));
    }
    std::vector<TriangleMesh> parts = connected_parts(mesh_);
    if (parts.empty()) throw InvalidInput(where_, "no triangle has an area", "a surface");
    if (options_.convex_error && !too_large) {
      cut_all(std::move(parts));
    } else {
      hull_of_each(parts);
    }
    reduce_hulls();
    return std::move(body_);
  }

 private:
  /// Distances from hulls take time in proportion to their vertices.
  void reduce_hulls() {
    double added = 0;
    for (ConvexHull& piece : body_.pieces) {
      if (piece.vertices.size() <= kManyVertices) continue;
      Eigen::AlignedBox3d box;
      for (const Eigen::Vector3d& vertex : piece.vertices) box.extend(vertex);
      double error = kReduction * box.sizes().maxCoeff();
      if (options_.convex_error) error = std::min(error, kShareForHulls * *options_.convex_error);
      piece = reduced_hull(piece, error);
      added = std::max(added, error);
    }
    if (body_.error) *body_.error += added;
  }

  void warn(const std::string& text) { body_.warnings.push_back(where_ + ": " + text); }

  /// Without measuring what the hulls add.
  void hull_of_each(const std::vector<TriangleMesh>& parts) {
    if (parts.size() > kMostParts) return one_hull(parts.size());
    for (const TriangleMesh& part : parts) {
      body_.pieces.push_back(thick_hull(part.vertices, kThickness * extent_));
    }
  }

  void one_hull(std::size_t parts) {
    warn(fmt::format("{} separate parts, more than {}: one convex hull holds them all", parts,
                     kMostParts));
    body_.pieces.push_back(thick_hull(mesh_.vertices, kThickness * extent_));
  }

  void cut_all(std::vector<TriangleMesh> parts) {
    body_.error = 0;
    if (not_closed(parts) > 0 && mesh_.triangles.size() <= kMostTrianglesToCut) {
      parts = connected_parts(welded(mesh_, kWeld * extent_));
      not_closed(parts);
    }
    if (parts.size() > kMostParts) {
      body_.error.reset();
      return one_hull(parts.size());
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::size_t others = parts.size() - i - 1;
      add(std::move(parts[i]), kMostPieces - std::min(kMostPieces, body_.pieces.size() + others));
    }
  }

  void add(TriangleMesh mesh, std::size_t most_pieces) {
    const double asked = (1 - kShareForHulls) * *options_.convex_error;
    const std::size_t triangles = mesh.triangles.size();
    const bool closed = !options_.sheet && close_outward(mesh);
    const Part part(std::move(mesh), closed);
    if (triangles > kMostTrianglesToCut) {
      take(hull_of(part, asked),
           fmt::format("a part of {} triangles, more than {}, is not cut but filled: its convex "
                       "hull reaches up to {{}} beyond it",
                       triangles, kMostTrianglesToCut));
    } else if (closed || options_.sheet) {
      ConvexCut cut = convex_cut(part, asked, std::max<std::size_t>(most_pieces, 1));
      const std::string text =
          fmt::format("cut into {} pieces, which reach up to {{}} beyond it; convex_error is {}",
                      cut.pieces.size(), in_mm(*options_.convex_error));
      take(std::move(cut), text);
    } else {
      take(hull_of(part, asked),
           fmt::format("a part of {} triangles is not closed, so its convex hull counts as solid, "
                       "up to {{}} from its surface; sheet: true if it is a sheet",
                       triangles));
    }
  }

  /// @param text of the warning where the error is larger than asked for
  void take(ConvexCut cut, const std::string& text) {
    if (cut.error > (1 - kShareForHulls) * *options_.convex_error + kWeld * extent_ * 10) {
      warn(fmt::format(fmt::runtime(text), in_mm(cut.error)));
    }
    body_.error = std::max(*body_.error, cut.error);
    std::move(cut.pieces.begin(), cut.pieces.end(), std::back_inserter(body_.pieces));
  }

  const TriangleMesh& mesh_;
  const MeshOptions& options_;
  const std::string& where_;
  double extent_;
  MeshBody body_;
};

}  // namespace

MeshBody mesh_body(const TriangleMesh& mesh, const MeshOptions& options, const std::string& where) {
  return MeshBodyMaker(mesh, options, where).make();
}

}  // namespace wristwise
