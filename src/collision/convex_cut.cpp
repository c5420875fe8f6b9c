#include "collision/convex_cut.hpp"

#include <algorithm>
#include <limits>

#include "collision/cut_planes.hpp"
#include "collision/hull_gap.hpp"

namespace wristwise {

namespace {

constexpr long kMostMeasurements = 3000000;

struct MeasuredPiece {
  CutPiece piece;
  HullGap gap;
};

/// Cuts the worst piece, again and again.
class ConvexCutter {
 public:
  ConvexCutter(const Part& part, double error)
      : cutter_(part), edges_(concave_edges(part)), error_(error) {}

  ConvexCut run(std::size_t most_pieces) {
    add(cutter_.whole());
    while (pieces_.size() < most_pieces && budget_ > 0) {
      const auto worst =
          std::max_element(pieces_.begin(), pieces_.end(),
                           [](const auto& a, const auto& b) { return a.gap.upper < b.gap.upper; });
      if (worst->gap.upper <= error_) break;
      auto children = best_cut(*worst);
      if (!children) break;
      *worst = measured(std::move((*children)[0]));
      add(std::move((*children)[1]));
    }
    return result();
  }

 private:
  MeasuredPiece measured(CutPiece piece) {
    HullGap gap;
    if (!cutter_.is_convex(piece)) gap = hull_gap(piece.hull, cutter_.part(), error_, budget_);
    gap.upper += cutter_.slack();
    return {std::move(piece), gap};
  }

  void add(CutPiece piece) { pieces_.push_back(measured(std::move(piece))); }

  /// The cut after which the hulls hold least.
  std::optional<std::array<CutPiece, 2>> best_cut(const MeasuredPiece& worst) const {
    std::optional<std::array<CutPiece, 2>> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Plane& plane : cut_candidates(worst.piece, edges_, worst.gap.at, cutter_.slack())) {
      auto children = cutter_.cut(worst.piece, plane);
      if (!children) continue;
      const double volume = hull_volume((*children)[0].hull) + hull_volume((*children)[1].hull);
      if (volume >= least * (1 - 1e-9)) continue;
      least = volume;
      best = std::move(children);
    }
    return best;
  }

  ConvexCut result() {
    ConvexCut cut;
    for (MeasuredPiece& piece : pieces_) {
      cut.error = std::max(cut.error, piece.gap.upper);
      cut.pieces.push_back(std::move(piece.piece.hull));
    }
    return cut;
  }

  PartCutter cutter_;
  std::vector<ConcaveEdge> edges_;
  double error_;
  long budget_ = kMostMeasurements;
  std::vector<MeasuredPiece> pieces_;
};

}  // namespace

ConvexCut convex_cut(const Part& part, double error, std::size_t most_pieces) {
  return ConvexCutter(part, error).run(most_pieces);
}

ConvexCut hull_of(const Part& part, double enough) {
  const PartCutter cutter(part);
  const CutPiece whole = cutter.whole();
  long budget = kMostMeasurements;
  double error = cutter.slack();
  if (!cutter.is_convex(whole)) error += hull_gap(whole.hull, part, enough, budget).upper;
  return {{whole.hull}, error};
}

}  // namespace wristwise
