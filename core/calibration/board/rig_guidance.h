// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Leads through showing a board to several cameras at once, for their poses.
class RigGuidance {
public:
  struct Settings {
    double stillPerSecond = 0.05;
    double holdSeconds = 0.5;
    int instantsPerPair = 8; ///< of each pair that joins the cameras
    double apartPart = 0.1;  ///< positions differ by at least this part of the image's width
  };
  struct State {
    int instants = 0;
    bool captured = false;
    bool finished = false;
    double held = 0.0;
    /// Cameras, by number, to which the board should be shown together next; -1 when finished.
    int showTo = -1;
    int andTo = -1;
  };

  RigGuidance(std::vector<int> imageWidths, const Settings& settings);

  /// What all cameras see now; views are kept under one instant number per capture.
  State step(double seconds, const std::vector<std::optional<BoardDetection>>& detections);
  /// Takes what was given last as it is, if two cameras saw the board: on the user's request.
  State captureNow();
  /// Each pair that joins the cameras is to be seen so much more often than it was so far.
  void wantMore(int instants);
  /// Where it stands, nothing new being seen.
  State state() const;
  /// Per camera, as calibrateExtrinsics() takes them.
  const std::vector<std::vector<BoardView>>& views() const { return views_; }
  /// How often each pair of cameras saw the board together, camera times camera.
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
