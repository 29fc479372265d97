// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Guides the user in showing a board to several cameras simultaneously, to determine their poses.
/// It captures views at a number of instants. At each instant, it captures one view for every
/// camera that sees the board at that time.
class RigGuidance {
public:
  struct Settings {
    /// Speed below which the board counts as still, in image widths per second.
    double maxStillWidthsPerSecond = 0.05;
    double holdSeconds = 0.5; ///< time for which the board must be still before it is captured
    /// Required number of instants at which both cameras see the board, for each pair in the chain
    /// that connects the cameras.
    int instantsPerPair = 8;
    /// Minimum distance between captured positions of the board, as a fraction of the image width.
    double minDistanceWidths = 0.1;
  };
  /// State of the guidance after the latest detections were processed.
  struct State {
    int instantCount = 0;     ///< number of instants captured so far
    bool wasCaptured = false; ///< true if the latest detections were captured
    bool isFinished = false;  ///< true if all cameras are connected by enough captured instants
    /// Elapsed fraction of the time for which the board must be still, 0 to 1.
    double holdProgress = 0.0;
    /// Indices of the cameras to which the board should be shown together next; -1 when finished.
    int firstCamera = -1;
    int secondCamera = -1;
  };

  RigGuidance(std::vector<int> imageWidths, const Settings& settings);

  /// Processes the current detections of all cameras. `seconds` is their time by any clock. Views
  /// that are captured together get the same BoardView::instant.
  State update(double seconds, const std::vector<std::optional<BoardDetection>>& detections);
  /// Captures the latest detections at the user's request, even if the board is not still. Does
  /// nothing if fewer than two cameras saw the board.
  State captureNow();
  /// Asks for more views: increases Settings::instantsPerPair, the required number for each pair of
  /// cameras, by `instants`.
  void requireMoreInstants(int instants);
  /// Returns the current state without new detections.
  State state() const;
  /// Returns the captured views per camera, in the form used by calibrateExtrinsics().
  const std::vector<std::vector<BoardView>>& views() const { return views_; }
  /// Returns the number of instants at which both cameras saw the board.
  int sharedInstantCount(int one, int other) const;

private:
  bool isStill(double seconds, const std::vector<std::optional<BoardDetection>>& detections);
  bool isNew(const std::vector<std::optional<BoardDetection>>& detections) const;
  bool areSeenByTwo() const;
  void capture(State& state);
  void suggest(State& state) const;

  std::vector<int> widths_;
  Settings settings_;
  std::vector<std::vector<BoardView>> views_;
  std::vector<int> sharedInstants_;
  std::vector<std::optional<BoardDetection>> last_;
  double lastSeconds_ = 0.0;
  double stillSince_ = 0.0;
  int instants_ = 0;
};

} // namespace dewpoint::calibration
