// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// What a person who shows the board should do now.
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
  double stillPerSecond =
      0.05;                 ///< held still: slower than this part of the image's width per second
  double holdSeconds = 0.5; ///< for so long before the view is taken
  double softEdgePart = 0.008; ///< edges wider than this part of the image's width are soft
  double nearPart = 0.25;      ///< of the image's area that one view at least should fill
  int leastViews = 10;
  int mostViews = 60;                 ///< then it ends whatever the accuracy
  double requestedProjectionPx = 0.3; ///< IntrinsicsResult::worstProjectionPx at which it ends
};

struct GuidanceState {
  GuidanceAdvice advice = GuidanceAdvice::ShowBoard;
  int region = -1;                    ///< of BoardCoverage; -1: none
  BoardTilt tilt = BoardTilt::Flat;   ///< that TiltTo asks for
  BoardCoverage coverage;             ///< of the views taken
  int views = 0;                      ///< taken so far
  double held = 0.0;                  ///< part of the time to hold still that has passed, 0 to 1
  bool captured = false;              ///< this very picture was taken
  std::optional<double> projectionPx; ///< of the newest calibration
};

/// Leads a person through showing a board to one camera: no pictures, no threads, no clock of its
/// own. Fed with the detections of a live stream it says what to show next, takes a view by itself
/// when the board is held still, sharp, and adds something, and ends when the calibration from the
/// views (computed elsewhere, given to learn()) is accurate enough.
class BoardGuidance {
public:
  BoardGuidance(const BoardDescription& board, int width, int height,
                GuidanceSettings settings = GuidanceSettings());

  /// The next picture, `seconds` after any fixed instant (rising).
  GuidanceState step(double seconds, const std::optional<BoardDetection>& detection);
  /// Takes the picture given last as it is, if it shows the board: the person asked for it.
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
  /// Takes what was given last as it is, if two cameras saw the board: the person asked for it.
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
