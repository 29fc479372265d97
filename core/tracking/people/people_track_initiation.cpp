// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_track_initiation.h"

#include "core/observation/people/person_score.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::tracking {
namespace {

constexpr double kStep = 0.2;            ///< meters between positions of the grid
constexpr std::size_t kMostCells = 4000; ///< a larger floor gets a coarser grid
constexpr double kSeen = 0.2;            ///< score from which a camera sees somebody
constexpr double kNotSeen = 0.0;         ///< score below which it sees nobody
constexpr double kUpperShare = 0.7;      ///< what the upper body counts by itself
constexpr double kPeopleApart = 0.5;     ///< meters to people who are there already
constexpr double kSame = 0.5;            ///< meters a candidate may move between frames
constexpr double kPatience = 0.15;       ///< seconds that a candidate may be out of sight
constexpr double kInImage = 0.6; ///< share of a body in the image from which its camera counts

/// Share of a silhouette that lies in the image.
double shareInImage(const BodySilhouette& silhouette, const Intrinsics& size) {
  if (!silhouette.isVisible) {
    return 0.0;
  }
  const cv::Rect image(0, 0, size.width, size.height);
  double inside = 0.0;
  double all = 0.0;
  for (const cv::Rect& piece : silhouette.partRects) {
    inside += (piece & image).area();
    all += piece.area();
  }
  return inside / std::max(1.0, all);
}

} // namespace

void drawSilhouette(const BodySilhouette& silhouette, unsigned char value, cv::Mat& mask) {
  if (silhouette.isVisible) {
    const cv::Rect image(0, 0, mask.cols, mask.rows);
    for (const cv::Rect& piece : silhouette.partRects) {
      mask(piece & image).setTo(value);
    }
  }
}

void PeopleTrackInitiation::setCameras(const PeopleCameras& cameras, const PeopleArea& area,
                                       double height) {
  cells_.clear();
  const double wanted = 4.0 * area.halfSize.prod() / static_cast<double>(kMostCells);
  const double step = std::max(kStep, std::sqrt(wanted));
  const int columns = static_cast<int>(std::floor(area.halfSize.x() / step));
  const int rows = static_cast<int>(std::floor(area.halfSize.y() / step));
  std::vector<SilhouetteProjector> makers;
  for (std::size_t k = 0; k < cameras.cameraCount(); ++k) {
    makers.emplace_back(cameras.camera(k));
  }
  for (int j = -rows; j <= rows; ++j) {
    for (int i = -columns; i <= columns; ++i) {
      Cell cell{area.center + step * Eigen::Vector2d(i, j), {}};
      int useful = 0;
      for (std::size_t k = 0; k < cameras.cameraCount(); ++k) {
        auto silhouette = makers[k].project(cell.position, area.floorHeight, height);
        silhouette.isVisible = shareInImage(silhouette, cameras.camera(k).intrinsics) >= kInImage;
        useful += silhouette.isVisible ? 1 : 0;
        cell.silhouettes.push_back(silhouette);
      }
      if (useful >= 2) {
        cells_.push_back(std::move(cell));
      }
    }
  }
}

double PeopleTrackInitiation::scoreOf(const Cell& cell, const PeopleCameras& cameras,
                                      const std::vector<ScoreSums>& scores) const {
  int seeing = 0;
  int notSeeing = 0;
  double sum = 0.0;
  for (std::size_t k = 0; k < scores.size(); ++k) {
    const BodySilhouette& silhouette = cell.silhouettes[k];
    if (!silhouette.isVisible || !cameras.isUsable(k)) {
      continue;
    }
    // The chest first: where that is not seen, nothing more is scored.
    const double chest = scores[k].mean(silhouette.partRects[3]);
    // Every piece counts as it is, and not kPieceFloor at least.
    const double score =
        chest < kNotSeen
            ? std::min(chest, kNotSeen - 0.01)
            : std::max(bodyScore(scores[k], silhouette, kStillPixel),
                       kUpperShare * upperBodyScore(scores[k], silhouette, kStillPixel));
    seeing += score >= kSeen ? 1 : 0;
    notSeeing += score < kNotSeen ? 1 : 0;
    sum += score;
    if (notSeeing > 1) {
      return 0.0;
    }
  }
  return seeing >= 2 ? sum : 0.0;
}

void PeopleTrackInitiation::updateCandidates(const std::vector<Candidate>& peaks, double interval) {
  for (Candidate& candidate : candidates_) {
    candidate.isVisible = false;
  }
  for (const Candidate& peak : peaks) {
    const auto same = std::ranges::find_if(candidates_, [&](const Candidate& one) {
      return !one.isVisible && (one.position - peak.position).norm() < kSame;
    });
    if (same == candidates_.end()) {
      candidates_.push_back({peak.position, peak.silhouetteScore, 0.0, true});
    } else {
      *same = {peak.position, peak.silhouetteScore, std::max(0.0, same->visibleSeconds) + interval,
               true};
    }
  }
  std::erase_if(candidates_, [&](Candidate& one) {
    if (!one.isVisible) {
      one.visibleSeconds -= interval; // it loses what it had gained
    }
    return !one.isVisible && one.visibleSeconds < -kPatience;
  });
}

std::vector<Eigen::Vector2d>
PeopleTrackInitiation::update(const PeopleCameras& cameras, const std::vector<cv::Mat>& explained,
                              const std::vector<Eigen::Vector2d>& taken,
                              double confirmationSeconds) {
  std::vector<ScoreSums> scores(cameras.cameraCount());
  int usable = 0;
  for (std::size_t k = 0; k < cameras.cameraCount(); ++k) {
    if (cameras.isUsable(k)) {
      ++usable;
      scores[k].build(
          maskScores(cameras.foregroundMask(k), k < explained.size() ? explained[k] : cv::Mat()));
    }
  }
  std::vector<Candidate> found;
  for (const Cell& cell : cells_) {
    const auto near = [&](const Eigen::Vector2d& position) {
      return (position - cell.position).norm() < kPeopleApart;
    };
    if (usable < 2 || std::ranges::any_of(taken, near)) {
      continue;
    }
    if (const double score = scoreOf(cell, cameras, scores); score > 0.0) {
      found.push_back({cell.position, score, 0.0, true});
    }
  }
  // The best of each neighborhood.
  std::ranges::stable_sort(found, std::greater<>{}, &Candidate::silhouetteScore);
  std::vector<Candidate> peaks;
  for (const Candidate& one : found) {
    if (std::ranges::none_of(peaks, [&](const Candidate& peak) {
          return (peak.position - one.position).norm() < 2.0 * kPeopleApart;
        })) {
      peaks.push_back(one);
    }
  }
  updateCandidates(peaks, cameras.secondsBetweenFrames());
  const auto ready = std::ranges::find_if(candidates_, [&](const Candidate& one) {
    return one.isVisible && one.visibleSeconds >= confirmationSeconds - 1e-9;
  });
  if (ready == candidates_.end()) {
    return {};
  }
  const Eigen::Vector2d position = ready->position;
  candidates_.erase(ready);
  return {position};
}

} // namespace dewpoint::tracking
