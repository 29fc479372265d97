// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/fault_bodies.h"

#include "core/base/statistics.h"
#include "core/calibration/formats/calibration_plausibility.h"
#include "core/calibration/wand/wand_gauge.h"
#include "core/geometry/small_matrices.h"

#include <array>
#include <cmath>
#include <set>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr std::size_t kFewest = 5;       ///< instants
constexpr std::size_t kFewestPoints = 6; ///< of a board at an instant
/// Relative standard deviation of a rig's size, at least.
constexpr double kLeastSizeSigma = 0.005;
/// Standard deviations of the size beyond which a length is wrong.
constexpr double kClearFaultSigmas = 4.0;
constexpr double kSameSize = 0.1; ///< relative scatter of the length over the instants
constexpr double kGoodMisfit =
    0.1; ///< of a square: a board's points lie so near to where they should
/// Of a square: beyond it a board does not fit.
constexpr double kBadMisfit = 0.4;
/// Columns of corners that are tried.
constexpr double kMostColumns = 24;

/// A board as seen at an instant.
struct SeenBoard {
  std::size_t state = 0;
  std::vector<std::size_t> ids;
  std::vector<Eigen::Vector3d> positions;
};

std::vector<SeenBoard> seenBoards(const BundleProblem& problem, const PointPositions& positions) {
  std::vector<SeenBoard> boards;
  for (std::size_t s = 0; s < problem.states.size(); ++s) {
    SeenBoard board{s, {}, {}};
    for (std::size_t id = 0; id < positions[s].size(); ++id) {
      if (positions[s][id]) {
        board.ids.push_back(id);
        board.positions.push_back(*positions[s][id]);
      }
    }
    if (problem.bodies[problem.states[s].body].kind == BundleBody::Kind::Board &&
        board.ids.size() >= kFewestPoints) {
      boards.push_back(std::move(board));
    }
  }
  return boards;
}

/// Where a body's points come to lie, and how well.
struct BodyFit {
  Similarity worldFromBody;
  double rms = 0.0; ///< meters, in the world of the cameras
};

std::optional<BodyFit> fitBody(const SeenBoard& board, const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> from;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const std::size_t id : board.ids) {
    if (id >= points.size()) {
      return std::nullopt;
    }
    from.push_back(points[id]);
    middle += points[id] / static_cast<double>(board.ids.size());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : from) {
    spread += (point - middle) * (point - middle).transpose();
  }
  const Eigen::Vector3d axes = geometry::symmetricEigen3(spread).values;
  if (axes[1] < 1e-3 * axes[2]) {
    return std::nullopt; // one row says nothing
  }
  BodyFit found{fitSimilarity(from, board.positions, true), 0.0};
  for (std::size_t i = 0; i < from.size(); ++i) {
    found.rms += (found.worldFromBody * from[i] - board.positions[i]).squaredNorm();
  }
  found.rms = std::sqrt(found.rms / static_cast<double>(from.size()));
  return found;
}

/// The median misfit in squares of a board with so many corners in a row; nothing without any.
std::optional<double> misfit(const std::vector<SeenBoard>& boards, double square, int columns) {
  std::vector<double> misfits;
  for (const SeenBoard& board : boards) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t id = 0; id <= board.ids.back(); ++id) {
      const auto number = static_cast<int>(id);
      const int column = number % columns;
      const int row = number / columns;
      points.emplace_back(square * column, square * row, 0.0);
    }
    if (const auto found = fitBody(board, points)) {
      misfits.push_back(found->rms / (found->worldFromBody.scale * square));
    }
  }
  return misfits.size() < kFewest ? std::nullopt : std::optional(upperMedian(misfits));
}

std::optional<DetectedFault> squareCount(const FaultSearchInput& input,
                                         const std::vector<SeenBoard>& boards) {
  const int given = input.board->cornerColumns();
  const auto asGiven = misfit(boards, input.board->squareSize, given);
  if (!asGiven || *asGiven < kBadMisfit) {
    return std::nullopt;
  }
  std::optional<DetectedFault> best;
  double least = kGoodMisfit;
  for (int columns = 2; columns <= kMostColumns; ++columns) {
    const auto now = misfit(boards, input.board->squareSize, columns);
    if (columns != given && now && *now < least) {
      least = *now;
      best = DetectedFault{CalibrationFault::WrongSquareCount, {}, double(columns)};
    }
  }
  return best;
}

/// Whether the cameras see the wrong side: of a board (its z goes into it), or of the floor.
std::optional<DetectedFault> mirrored(const FaultSearchInput& input,
                                      const std::vector<SeenBoard>& boards, const CameraRig& rig) {
  std::vector<std::set<std::size_t>> seeing(input.problem.states.size());
  for (const BundleObservation& seen : input.problem.observations) {
    seeing[seen.state].insert(seen.camera);
  }
  std::size_t front = 0;
  std::size_t back = 0;
  for (const SeenBoard& board : boards) {
    const BundleState& state = input.problem.states[board.state];
    const auto found = fitBody(board, input.problem.bodies[state.body].points);
    if (!found) {
      continue;
    }
    for (const std::size_t c : seeing[board.state]) {
      const Camera& camera = rig[c];
      const Eigen::Vector3d inBody = found->worldFromBody.rotation.transpose() *
                                     (camera.center() - found->worldFromBody.translation);
      const bool above =
          state.isFixed ? (state.worldFromBoard.linear() * inBody).z() > 0.0 : inBody.z() < 0.0;
      ++(above ? front : back);
    }
  }
  if (back + front >= 3 && back > 9 * front) {
    return DetectedFault{CalibrationFault::MirroredBoard};
  }
  return std::nullopt;
}

/// Given lengths over those that the cameras show.
std::vector<double> lengthRatios(const BundleProblem& problem, const PointPositions& positions,
                                 const std::vector<SeenBoard>& boards) {
  std::vector<double> ratios;
  for (const SeenBoard& board : boards) {
    const auto& points = problem.bodies[problem.states[board.state].body].points;
    if (const auto found = fitBody(board, points)) {
      ratios.push_back(1.0 / found->worldFromBody.scale);
    }
  }
  for (std::size_t s = 0; s < problem.states.size(); ++s) {
    const BundleBody& body = problem.bodies[problem.states[s].body];
    if (body.kind == BundleBody::Kind::Stick && positions[s].size() > 1 && positions[s][0] &&
        positions[s][1]) {
      ratios.push_back(body.length / (*positions[s][0] - *positions[s][1]).norm());
    }
  }
  return ratios;
}

std::optional<DetectedFault> lengths(const FaultSearchInput& input, const PointPositions& positions,
                                     const std::vector<SeenBoard>& boards, double sigma) {
  auto ratios = lengthRatios(input.problem, positions, boards);
  const double ratio = upperMedian(ratios);
  for (double& value : ratios) {
    value = std::abs(std::log(value / ratio));
  }
  if (ratios.size() < kFewest && !(boards.size() == ratios.size() && !boards.empty())) {
    return std::nullopt;
  }
  const double clear = kClearFaultSigmas * sigma;
  if (upperMedian(ratios) > kSameSize || std::abs(std::log(ratio)) < clear) {
    return std::nullopt;
  }
  const auto near = [&](double expected) {
    return std::min(std::abs(std::log(ratio / expected)), std::abs(std::log(ratio * expected))) <
           clear;
  };
  if (near(1000.0)) {
    return DetectedFault{CalibrationFault::WrongUnitMillimeters, {}, ratio};
  }
  for (const double inches : {1.0 / 0.0254, 25.4, 2.54}) {
    if (near(inches)) {
      return DetectedFault{CalibrationFault::WrongUnitInches, {}, ratio};
    }
  }
  return boards.empty()
             ? std::nullopt
             : std::optional(DetectedFault{CalibrationFault::WrongSquareSize, {}, ratio});
}

} // namespace

double sizeSigma(const CameraRig& rig, const InitialRigSigma& sigma) {
  const double spread = 0.5 * cameraSpread(rig);
  const double cameras = std::sqrt(static_cast<double>(std::max<std::size_t>(rig.size(), 1)));
  return std::max(kLeastSizeSigma, sigma.position / std::max(spread, 1e-6) / cameras);
}

std::vector<DetectedFault> findBodyFaults(const FaultSearchInput& input,
                                          const PointPositions& positions, const CameraRig& rig) {
  const auto boards = seenBoards(input.problem, positions);
  if (input.board) {
    if (auto count = squareCount(input, boards)) {
      return {*count};
    }
  }
  std::vector<DetectedFault> faults;
  if (auto side = mirrored(input, boards, rig)) {
    faults.push_back(*side);
  }
  if (auto length = lengths(input, positions, boards, sizeSigma(rig, input.initialSigma))) {
    faults.push_back(*length);
  }
  return faults;
}

} // namespace dewpoint::calibration
