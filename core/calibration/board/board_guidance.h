// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Instruction for the user who shows the board.
enum class GuidanceAdvice {
  ShowCalibrationBoard, ///< no board is detected
  MoveTo,               ///< move the board to the image region GuidanceState::requestedRegion
  /// Tilt the board so that the side GuidanceState::tilt is nearer, preferably with the board in
  /// GuidanceState::requestedRegion.
  TiltTo,
  ComeNearer, ///< bring the board closer: it is small in the image
  HoldStill,  ///< hold still: this view is useful
  Sharpen,    ///< the board is held still, but its edges are soft: focus, or add light
  Finished    ///< the requested accuracy, or the maximum number of views, is reached
};

/// Settings of a BoardGuidance, which tells the user how to show a board to a camera.
struct GuidanceSettings {
  /// Speed below which the board counts as still, as a fraction of the image width per second.
  double maxStillWidthsPerSecond = 0.05;
  double holdSeconds = 0.5; ///< time for which the board must be still before the view is captured
  /// Edges wider than this fraction of the image width count as soft.
  double softEdgeWidthFraction = 0.008;
  /// Fraction of the image area that the board should fill in at least one view.
  double requiredAreaFraction = 0.25;
  int minViews = 10; ///< minimum number of captured views before the guidance can end
  /// Maximum number of captured views; the guidance then ends, whatever the accuracy.
  int maxViews = 60;
  /// The guidance ends when the standard deviation of the projection of a ray
  /// (IntrinsicsResult::independentProjectionSigmaPx) is at most this value, pixels.
  double requiredProjectionSigmaPx = 0.3;
};

/// State of the guidance after processing an image.
struct GuidanceState {
  GuidanceAdvice advice = GuidanceAdvice::ShowCalibrationBoard;
  /// Index (in BoardCoverage) of the region in which to show the board; -1 if none is requested.
  int requestedRegion = -1;
  BoardTilt tilt = BoardTilt::Flat; ///< tilt to show if the advice is TiltTo
  BoardCoverage coverage;           ///< coverage of the captured views
  int viewCount = 0;                ///< number of views captured so far
  /// Elapsed fraction of the time for which the board must be still, 0 to 1.
  double holdProgress = 0.0;
  bool wasCaptured = false; ///< true if this image was captured as a view
  /// Standard deviation of the projection of a ray in the latest calibration
  /// (IntrinsicsResult::independentProjectionSigmaPx), pixels. Empty before the first calibration.
  std::optional<double> projectionSigmaPx;
};

/// Guides the user in showing a board to one camera. From the detections in a live stream, it
/// determines what the user should show next. It handles no images itself, and has neither threads
/// nor a clock. It captures a view automatically when the board is still and sharp, and has a new
/// position or tilt. It ends when a calibration from the captured views is accurate enough. The
/// caller computes this calibration and passes it to acceptCalibration().
class BoardGuidance {
public:
  BoardGuidance(const BoardDescription& board, int width, int height,
                GuidanceSettings settings = GuidanceSettings());

  /// Processes the detection in the next image; `detection` is empty if no board was found.
  /// `seconds` is the time of the image by any clock, later than in the previous call.
  GuidanceState update(double seconds, const std::optional<BoardDetection>& detection);
  /// Captures the latest view at the user's request, even if the board is not still or sharp. Does
  /// nothing if the latest image does not show the board.
  GuidanceState captureNow();
  /// Accepts a calibration that the caller computed from the views captured so far. From now on,
  /// the guidance estimates board poses with this calibration, and it ends if the accuracy of the
  /// calibration is sufficient.
  void acceptCalibration(const IntrinsicsResult& result);
  /// Returns whether enough views were captured since the last acceptCalibration() to compute
  /// another calibration.
  bool isCalibrationDue() const;

  const std::vector<BoardView>& views() const { return views_; }

private:
  void updateMotion(double seconds, const BoardDetection& detection);
  bool addsInformation(const BoardDetection& detection) const;
  int emptiestRegion(const Eigen::Vector2d& middle) const;
  void advise(const BoardDetection& detection, GuidanceState& state);
  GuidanceAdvice nextAdvice(const BoardDetection& detection, GuidanceState& state) const;
  void capture(GuidanceState& state);
  GuidanceState summary() const;
  BoardTilt currentTilt(const BoardDetection& detection) const;

  BoardDescription board_;
  GuidanceSettings settings_;
  Camera camera_; ///< intrinsics of the latest calibration, or a first guess
  std::vector<BoardView> views_;
  std::vector<BoardTilt> tilts_; ///< tilt of the board in each view
  BoardCoverage coverage_;
  double largestAreaFraction_ = 0.0;
  std::optional<GuidanceState> instruction_; ///< current instruction, kept until a view is captured
  std::optional<BoardDetection> last_;
  double lastSeconds_ = 0.0;
  double stillSince_ = 0.0;
  std::size_t calibratedViews_ = 0; ///< number of views in the latest calibration
  std::optional<double> projectionPx_;
};

} // namespace dewpoint::calibration
