// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/box_perturbation_study.h"

#include "core/experiment/boxes/box_follower.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace dewpoint::experiment {
namespace {

/// Sizes of first boxes against the true one; chosen: a box drawn by hand.
constexpr double kScales[] = {0.8, 1.0, 1.2, 1.4};
/// Shift of first boxes, share of the true size; chosen, as above.
constexpr double kShift = 0.15;
/// Particles of the methods compared: those of the better result of Sugandi et al. (2009).
constexpr int kParticles = 300;
/// Similarity from which on a method claims to be on the target; chosen.
constexpr double kSure = 0.9;

bool isOpenCvs(const std::string& method) {
  return std::ranges::find(openCvFollowerNames(), method) != openCvFollowerNames().end();
}

Result<std::unique_ptr<BoxFollower>> make(const std::string& method, std::uint64_t seed) {
  if (isOpenCvs(method)) {
    return makeOpenCvFollower(method);
  }
  return makeDewpointFollower(method, kParticles, seed);
}

/// What was claimed on and off the target, over all runs of a row.
struct Claims {
  double on = 0.0;
  double off = 0.0;
  int framesOn = 0;
  int framesOff = 0;
  int wrong = 0;

  void add(const BoxConfidence& claim, bool isOn) {
    const double similarity = claim.isVisible ? claim.similarity : 0.0;
    (isOn ? on : off) += similarity;
    ++(isOn ? framesOn : framesOff);
    wrong += !isOn && similarity > kSure ? 1 : 0;
  }
};

Status follow(const BoxClip& clip, const std::vector<cv::Mat>& images, const ImageBox& first,
              BoxFollower& follower, Claims& claims, BoxPerturbationRow& row) {
  if (const auto started = follower.start(images.front(), first); !started) {
    return started;
  }
  std::vector<std::optional<ImageBox>> found{first};
  for (std::size_t frame = 1; frame < images.size(); ++frame) {
    found.push_back(follower.step(images[frame]));
    if (const auto claim = follower.confidence(); claim && found.back()) {
      const double away = (found.back()->center() - clip.truth[frame].center()).norm();
      claims.add(*claim, away <= clip.hitRadiusPx);
    }
  }
  const BoxMetrics metrics = measureBoxes(found, clip.truth, clip.hitRadiusPx);
  row.metrics.rmse += metrics.rmse;
  row.metrics.success += metrics.success;
  row.metrics.precision += metrics.precision;
  row.worstPrecision = std::min(row.worstPrecision, metrics.precision);
  ++row.runCount;
  return {};
}

void conclude(const Claims& claims, BoxPerturbationRow& row) {
  row.metrics.rmse /= row.runCount;
  row.metrics.success /= row.runCount;
  row.metrics.precision /= row.runCount;
  const int frames = claims.framesOn + claims.framesOff;
  row.reportsConfidence = frames > 0;
  row.similarityOnTarget = claims.on / std::max(1, claims.framesOn);
  row.similarityOffTarget = claims.off / std::max(1, claims.framesOff);
  row.confidentlyWrongShare = double(claims.wrong) / std::max(1, frames);
}

Result<BoxPerturbationRow> measure(const BoxClip& clip, const std::vector<cv::Mat>& images,
                                   const std::string& method, double scale, int seeds,
                                   std::uint64_t firstSeed) {
  BoxPerturbationRow row;
  row.clip = clip.name;
  row.method = method;
  row.scale = scale;
  Claims claims;
  for (const BoxPerturbation& perturbation : boxPerturbations()) {
    if (perturbation.scale != scale) {
      continue;
    }
    for (int k = 0; k < (isOpenCvs(method) ? 1 : seeds); ++k) {
      auto follower = make(method, firstSeed + static_cast<std::uint64_t>(k));
      if (!follower) {
        return tl::make_unexpected(follower.error());
      }
      const auto done =
          follow(clip, images, perturbation.appliedTo(clip.truth.front()), **follower, claims, row);
      if (!done) {
        return tl::make_unexpected(done.error());
      }
    }
  }
  conclude(claims, row);
  return row;
}

} // namespace

std::vector<BoxPerturbation> boxPerturbations() {
  std::vector<BoxPerturbation> perturbations;
  for (const double scale : kScales) {
    perturbations.push_back({scale, 0.0, 0.0});
    for (const double shift : {-kShift, kShift}) {
      perturbations.push_back({scale, shift, 0.0});
      perturbations.push_back({scale, 0.0, shift});
    }
  }
  return perturbations;
}

std::vector<std::string> perturbationMethods() {
  return {"histogram", "sugandi", "csrt", "camshift"};
}

Result<std::vector<BoxPerturbationRow>>
studyPerturbedBoxes(const std::vector<BoxClip>& clips, int seeds,
                    const std::function<bool(const BoxPerturbationRow&)>& report,
                    const std::vector<std::string>& methods, std::uint64_t firstSeed) {
  std::vector<BoxPerturbationRow> rows;
  for (const BoxClip& clip : clips) {
    const auto images = imagesOf(clip);
    if (!images) {
      return tl::make_unexpected(images.error());
    }
    for (const std::string& method : methods) {
      for (const double scale : kScales) {
        auto row = measure(clip, *images, method, scale, seeds, firstSeed);
        if (!row) {
          return tl::make_unexpected(row.error());
        }
        rows.push_back(std::move(*row));
        if (!report(rows.back())) {
          return failure(ErrorCode::Canceled, "", "", "");
        }
      }
    }
  }
  return rows;
}

} // namespace dewpoint::experiment
