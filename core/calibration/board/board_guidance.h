// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// What the user who shows the board should do now.
enum class GuidanceAdvice {
  ShowBoard,  ///< no board is seen
  MoveTo,     ///< to GuidanceState::region of the image
  TiltTo,     ///< so that GuidanceState::tilt is nearer, best in that region
  ComeNearer, ///< the board is small in the image
  HoldStill,  ///< this view is wanted
  Sharpen,    ///< held still, but the edges are soft: focus, or more light
  Finished    ///< the requested accuracy is reached
};

struct GuidanceSettings {
  /// Held still: slower than this part of the image's width per second.
  double stillPerSecond = 0.05;
  double holdSeconds = 0.5;    ///< for so long before the view is taken
  double softEdgePart = 0.008; ///< edges wider than this part of the image's width are soft
  double nearPart = 0.25;      ///< of the image's area that one view at least should fill
  int leastViews = 10;
  int mostViews = 60;                 ///< then it ends whatever the accuracy
  double requestedProjectionPx = 0.3; ///< IntrinsicsResult::worstProjectionPx at which it ends
};

struct GuidanceState {
  GuidanceAdvice advice = GuidanceAdvice::ShowBoard;
  int region = -1;                    ///< of BoardCoverage; -1: none
  BoardTilt tilt = BoardTilt::Flat;   ///< that TiltTo requests
  BoardCoverage coverage;             ///< of the views taken
  int views = 0;                      ///< taken so far
  double held = 0.0;                  ///< part of the time to hold still that has passed, 0 to 1
  bool captured = false;              ///< this very picture was taken
  std::optional<double> projectionPx; ///< of the newest calibration
};

/// Leads the user through showing a board to one camera: no pictures, no threads, no clock of its
/// own. Fed with the detections of a live stream it returns what to show next, takes a view by
/// itself when the board is held still, sharp, and adds something, and ends when the calibration
/// from the views (computed elsewhere, given to learn()) is accurate enough.
class BoardGuidance {
public:
  BoardGuidance(const BoardDescription& board, int width, int height,
                GuidanceSettings settings = GuidanceSettings());

  /// The next picture, `seconds` after any fixed instant (rising).
  GuidanceState step(double seconds, const std::optional<BoardDetection>& detection);
  /// Takes the picture given last as it is, if it shows the board: on the user's request.
  GuidanceState captureNow();
  /// What the views so far give: better poses, and whether it is enough.
  void learn(const IntrinsicsResult& result);
  /// Whether views came since learn() that are worth a calibration.
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
  Camera camera_; ///< the best guess so far
  std::vector<BoardView> views_;
  std::vector<BoardTilt> tilts_; ///< of the views
  BoardCoverage coverage_;
  double largestPart_ = 0.0;
  std::optional<GuidanceState> wanted_; ///< the advice that stands until a view is taken
  std::optional<BoardDetection> last_;
  double lastSeconds_ = 0.0;
  double stillSince_ = 0.0;
  std::size_t learned_ = 0; ///< views known to the newest calibration
  std::optional<double> projectionPx_;
};

} // namespace dewpoint::calibration
