// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Advice to the user who shows the board.
enum class GuidanceAdvice {
  ShowBoard,  ///< no board is detected
  MoveTo,     ///< move the board to GuidanceState::region of the image
  TiltTo,     ///< tilt the board so that the side GuidanceState::tilt is nearer, preferably in that
              ///< region
  ComeNearer, ///< come nearer: the board is small in the image
  HoldStill,  ///< hold still: this view is wanted
  Sharpen,    ///< the board is held still, but its edges are soft: focus, or add light
  Finished    ///< the requested accuracy is reached
};

/// Settings of a BoardGuidance.
struct GuidanceSettings {
  /// The board counts as still below this speed, as a share of the image's width per second.
  double stillPerSecond = 0.05;
  double holdSeconds = 0.5;    ///< time the board must be still before the view is captured
  double softEdgePart = 0.008; ///< edges wider than this share of the image's width count as soft
  double nearPart =
      0.25; ///< share of the image's area that the board should fill in at least one view
  int leastViews = 10;
  int mostViews = 60; ///< the guidance ends then, whatever the accuracy
  double requestedProjectionPx =
      0.3; ///< the guidance ends when IntrinsicsResult::worstProjectionPx reaches it
};

/// State of the guidance after an image.
struct GuidanceState {
  GuidanceAdvice advice = GuidanceAdvice::ShowBoard;
  int region = -1;                    ///< of BoardCoverage; -1: none
  BoardTilt tilt = BoardTilt::Flat;   ///< requested by TiltTo
  BoardCoverage coverage;             ///< of the captured views
  int views = 0;                      ///< number of views captured so far
  double held = 0.0;                  ///< share of the hold time that has passed, 0 to 1
  bool captured = false;              ///< whether the current image was captured
  std::optional<double> projectionPx; ///< worstProjectionPx of the latest calibration
};

/// Guides the user in showing a board to one camera. It handles no images, has no threads and no
/// clock: from the detections of a live stream it computes what to show next, captures a view
/// automatically when the board is held still, is sharp and adds information, and ends when the
/// calibration from the views (computed elsewhere and passed to learn()) is accurate enough.
class BoardGuidance {
public:
  BoardGuidance(const BoardDescription& board, int width, int height,
                GuidanceSettings settings = GuidanceSettings());

  /// Processes the next detection, `seconds` after any fixed time (ascending).
  GuidanceState step(double seconds, const std::optional<BoardDetection>& detection);
  /// Captures the latest image as it is if it shows the board, on the user's request.
  GuidanceState captureNow();
  /// Takes the calibration from the views so far: it improves the estimated poses and shows whether
  /// the accuracy is sufficient.
  void learn(const IntrinsicsResult& result);
  /// Returns whether enough views were captured since learn() for a new calibration.
  bool wantsCalibration() const;

  const std::vector<BoardView>& views() const { return views_; }

private:
  void follow(double seconds, const BoardDetection& detection);
  bool addsSomething(const BoardDetection& detection) const;
  int emptiestRegion(const Eigen::Vector2d& middle) const;
  void advise(const BoardDetection& detection, GuidanceState& state);
  GuidanceAdvice lacking(const BoardDetection& detection, GuidanceState& state) const;
  void capture(GuidanceState& state);
  GuidanceState summary() const;
  BoardTilt tiltNow(const BoardDetection& detection) const;

  BoardDescription board_;
  GuidanceSettings settings_;
  Camera camera_; ///< best estimate so far
  std::vector<BoardView> views_;
  std::vector<BoardTilt> tilts_; ///< tilt of each view
  BoardCoverage coverage_;
  double largestPart_ = 0.0;
  std::optional<GuidanceState> wanted_; ///< current advice, kept until a view is captured
  std::optional<BoardDetection> last_;
  double lastSeconds_ = 0.0;
  double stillSince_ = 0.0;
  std::size_t learned_ = 0; ///< number of views in the latest calibration
  std::optional<double> projectionPx_;
};

} // namespace dewpoint::calibration
