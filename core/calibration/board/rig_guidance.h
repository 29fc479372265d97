// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Guides the user in showing a board to several cameras at once, to find their poses.
class RigGuidance {
public:
  struct Settings {
    double stillPerSecond = 0.05; ///< still below this share of the image's width per second
    double holdSeconds = 0.5;     ///< time the board must be still before an instant is captured
    int instantsPerPair = 8;      ///< wanted for each pair in the chain that connects the cameras
    double apartPart =
        0.1; ///< captured positions differ by at least this share of the image's width
  };
  struct State {
    int instants = 0;
    bool captured = false;
    bool finished = false;
    double held = 0.0;
    /// Indices of the cameras to which the board should be shown together next; -1 when finished.
    int showTo = -1;
    int andTo = -1;
  };

  RigGuidance(std::vector<int> imageWidths, const Settings& settings);

  /// Processes the current detections of all cameras. Views captured together get the same instant
  /// number.
  State step(double seconds, const std::vector<std::optional<BoardDetection>>& detections);
  /// Captures the latest detections as they are if two cameras saw the board, on the user's
  /// request.
  State captureNow();
  /// Requests this many more instants for each pair that connects the cameras.
  void wantMore(int instants);
  /// Current state, without new detections.
  State state() const;
  /// Captured views per camera, as calibrateExtrinsics() takes them.
  const std::vector<std::vector<BoardView>>& views() const { return views_; }
  /// Number of instants at which two cameras saw the board together.
  int together(int one, int other) const;

private:
  bool isStill(double seconds, const std::vector<std::optional<BoardDetection>>& detections);
  bool isNew(const std::vector<std::optional<BoardDetection>>& detections) const;
  bool areSeenByTwo() const;
  void take(State& state);
  void suggest(State& state) const;

  std::vector<int> widths_;
  Settings settings_;
  std::vector<std::vector<BoardView>> views_;
  std::vector<int> together_;
  std::vector<std::optional<BoardDetection>> last_;
  double lastSeconds_ = 0.0;
  double stillSince_ = 0.0;
  int instants_ = 0;
};

} // namespace dewpoint::calibration
