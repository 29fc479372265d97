// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/people/body_silhouette.h"
#include "core/tracking/people/people_cameras.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::tracking {

/// Draws a standing body into a mask (CV_8UC1): sets its pixels to `value`.
void drawSilhouette(const BodySilhouette& silhouette, unsigned char value, cv::Mat& mask);

/// Finds new people where several cameras show foreground that no tracked person explains. A
/// standing body is tried at every point of a grid on the floor, as in the occupancy map of Fleuret
/// et al. 2008 (but without the inference of that paper). A position must persist for some time to
/// become a person.
class PeopleTrackInitiation {
public:
  /// Prepares the grid of positions on the floor `area` for people of `height` meters. Candidates
  /// found in earlier frames are kept.
  void setCameras(const PeopleCameras& cameras, const PeopleArea& area, double height);
  void restart() { candidates_.clear(); }
  /// Returns the approximate size of a copy in bytes.
  std::size_t memoryBytes() const {
    return cells_.empty() ? 0
                          : cells_.size() * (sizeof(Cell) + cells_.front().silhouettes.size() *
                                                                sizeof(BodySilhouette));
  }

  /// Processes the masks of a frame. Returns at most one position (world x, y, meters) at which to
  /// create a track. `explained` has one mask per camera (CV_8UC1) that is nonzero at pixels of
  /// people who are already tracked, or is empty. `taken` has the positions of the tracked people.
  /// A new person must be visible for `confirmationSeconds` seconds.
  std::vector<Eigen::Vector2d> update(const PeopleCameras& cameras,
                                      const std::vector<cv::Mat>& explained,
                                      const std::vector<Eigen::Vector2d>& taken,
                                      double confirmationSeconds);

private:
  struct Cell {
    Eigen::Vector2d position;
    std::vector<BodySilhouette> silhouettes; ///< per camera
  };
  struct Candidate {
    Eigen::Vector2d position;
    double silhouetteScore = 0.0;
    /// Seconds for which the person was visible; decreases while not visible.
    double visibleSeconds = 0.0;
    bool isVisible = true; ///< true if the person is visible in this frame
  };

  double scoreOf(const Cell& cell, const PeopleCameras& cameras,
                 const std::vector<ScoreSums>& scores) const;
  void updateCandidates(const std::vector<Candidate>& peaks, double interval);

  std::vector<Cell> cells_;
  std::vector<Candidate> candidates_;
};

} // namespace dewpoint::tracking
