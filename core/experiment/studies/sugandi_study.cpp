// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/sugandi_study.h"

#include "core/base/units.h"
#include "core/experiment/boxes/box_follower.h"
#include "core/experiment/studies/sugandi_pictures.h"
#include "core/observation/boxes/box_histogram.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

namespace dewpoint::experiment {
namespace {

struct Contender {
  std::string method;
  int particles = 0; ///< 0: OpenCV's

  std::string shown() const {
    return particles > 0 ? fmt::format("{}, {} particles", method, particles) : method;
  }
};

std::vector<Contender> contenders() {
  std::vector<Contender> all{{"sugandi", 100}, {"sugandi", 300}, {"histogram", 300}};
  for (const std::string& name : openCvFollowerNames()) {
    all.push_back({name, 0});
  }
  return all;
}

Result<std::unique_ptr<BoxFollower>> make(const Contender& contender, std::uint64_t seed) {
  if (contender.particles > 0) {
    return makeDewpointFollower(contender.method, contender.particles, seed);
  }
  return makeOpenCvFollower(contender.method);
}

/// One run; adds its figures and times, divided by `runs`, to the row.
Status follow(const BoxClip& clip, const std::vector<cv::Mat>& images, BoxFollower& follower,
              int runs, BoxStudyRow& row) {
  if (const auto started = follower.start(images.front(), clip.truth.front()); !started) {
    return started;
  }
  std::vector<std::optional<ImageBox>> found{clip.truth.front()};
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t frame = 1; frame < images.size(); ++frame) {
    found.push_back(follower.step(images[frame]));
  }
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  const BoxMetrics metrics = measureBoxes(found, clip.truth, clip.hitRadiusPx);
  row.millisecondsPerFrame += took.count() / (double(images.size() - 1) * runs);
  row.metrics.rmse += metrics.rmse / runs;
  row.metrics.success += metrics.success / runs;
  row.metrics.precision += metrics.precision / runs;
  row.worstPrecision = std::min(row.worstPrecision, metrics.precision);
  if (row.boxes.empty()) {
    row.boxes = std::move(found);
  }
  return {};
}

Result<BoxStudyRow> measure(const BoxClip& clip, const std::vector<cv::Mat>& images,
                            const Contender& contender, int seeds, std::uint64_t firstSeed) {
  BoxStudyRow row;
  row.clip = clip.name;
  row.method = contender.shown();
  row.isDewpointMethod = contender.particles > 0;
  row.hasExactBoxes = clip.hasExactBoxes;
  row.seedCount = row.isDewpointMethod ? seeds : 1;
  row.worstPrecision = 1.0;
  for (int k = 0; k < row.seedCount; ++k) {
    auto follower = make(contender, firstSeed + static_cast<std::uint64_t>(k));
    if (!follower) {
      return tl::make_unexpected(follower.error());
    }
    if (const auto done = follow(clip, images, **follower, row.seedCount, row); !done) {
      return tl::make_unexpected(done.error());
    }
  }
  return row;
}

constexpr double kJuggleBar = 0.85; // share of frames within a ball's radius; chosen

const BoxStudyRow* rowOf(const std::vector<BoxStudyRow>& rows, const std::string& clip,
                         const std::string& method) {
  const auto found = std::ranges::find_if(
      rows, [&](const BoxStudyRow& row) { return row.clip == clip && row.method == method; });
  return found == rows.end() ? nullptr : &*found;
}

BoxRequirement trendBar(const BoxStudyRow& few, const BoxStudyRow& many) {
  return {
      fmt::format("{}: sugandi's RMSE falls from 100 to 300 particles ({:.2f} to {:.2f} px; the "
                  "paper 6.48 to 2.28 px on its own clip)",
                  few.clip, few.metrics.rmse, many.metrics.rmse),
      many.metrics.rmse < few.metrics.rmse};
}

BoxRequirement peerBar(const std::vector<BoxStudyRow>& rows, const BoxStudyRow& ours) {
  const BoxStudyRow* best = nullptr;
  for (const BoxStudyRow& row : rows) {
    const bool isBetter = best == nullptr || row.metrics.success > best->metrics.success;
    best = row.clip == ours.clip && !row.isDewpointMethod && isBetter ? &row : best;
  }
  const double peer = best != nullptr ? best->metrics.success : 0.0;
  return {fmt::format("{}: histogram's success {:.3f} is at least the best peer's ({} {:.3f})",
                      ours.clip, ours.metrics.success, best != nullptr ? best->method : "", peer),
          ours.metrics.success >= peer};
}

std::vector<BoxRequirement> barsOf(const std::vector<BoxStudyRow>& rows) {
  std::vector<BoxRequirement> bars;
  for (const BoxStudyRow& row : rows) {
    const BoxStudyRow* few = rowOf(rows, row.clip, kSugandiFew);
    if (row.clip.starts_with("simulated") && row.method == kSugandiMany && few != nullptr) {
      bars.push_back(trendBar(*few, row));
    }
    if (row.method != kHistogram) {
      continue;
    }
    if (row.clip.starts_with("juggle1")) {
      bars.push_back(
          {fmt::format("{}: histogram stays within a ball's radius on at least 85 % of "
                       "the frames ({:.1f} %, worst seed {:.1f} %)",
                       row.clip, inPercent(row.metrics.precision), inPercent(row.worstPrecision)),
           row.worstPrecision >= kJuggleBar});
    }
    if (row.clip.starts_with("otb")) {
      bars.push_back(peerBar(rows, row));
    }
  }
  return bars;
}

BoxClipFigures clipFiguresOf(const BoxClip& clip, const std::vector<cv::Mat>& images,
                             const BoxStudyRow& few, const BoxStudyRow& many) {
  BoxClipFigures figures;
  figures.clip = clip.name;
  figures.truth = clip.truth;
  figures.framesImage = drawBoxFrames(images, clip.truth, few, many);
  figures.referenceHistogram = boxHistogram(images.front(), clip.truth.front());
  figures.candidateFrame = images.size() / 2;
  if (const auto& found = many.boxes[figures.candidateFrame]) {
    figures.candidateHistogram = boxHistogram(images[figures.candidateFrame], *found);
  }
  return figures;
}

} // namespace

Result<BoxStudy> studyBoxes(const std::vector<BoxClip>& clips, int seeds,
                            const std::function<bool(const BoxStudyRow&)>& report,
                            std::uint64_t firstSeed) {
  BoxStudy study;
  study.firstSeed = firstSeed;
  study.seedCount = seeds;
  for (const BoxClip& clip : clips) {
    const auto images = imagesOf(clip);
    if (!images) {
      return tl::make_unexpected(images.error());
    }
    for (const Contender& contender : contenders()) {
      auto row = measure(clip, *images, contender, seeds, firstSeed);
      if (!row) {
        return tl::make_unexpected(row.error());
      }
      study.rows.push_back(std::move(*row));
      if (!report(study.rows.back())) {
        return failure(ErrorCode::Canceled, "", "", "");
      }
    }
    study.figures.push_back(clipFiguresOf(clip, *images, *rowOf(study.rows, clip.name, kSugandiFew),
                                          *rowOf(study.rows, clip.name, kSugandiMany)));
  }
  study.requirements = barsOf(study.rows);
  return study;
}

} // namespace dewpoint::experiment
