// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/footage_learning.h"

#include "core/project/project_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <map>
#include <utility>

namespace dewpoint::setup {
namespace {

/// The images of all cameras at one frame; empty where a camera has none.
using FrameImages = std::map<std::int64_t, std::vector<cv::Mat>>;

Status readImages(FrameSetSource& source, std::int64_t frame, FrameImages& images) {
  if (images.contains(frame)) {
    return {};
  }
  const auto total = source.frameCount();
  const auto tooLate = [&] {
    const std::string detail = fmt::format("frame {} was requested, but the last frame is {}",
                                           frame, total.value_or(0) - 1);
    return failure(ErrorCode::BadValue, "", "frame", detail);
  };
  if (total && frame >= *total) {
    return tooLate();
  }
  if (const auto sought = source.seek(frame); !sought) {
    return sought;
  }
  const auto frames = source.next();
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  if (!*frames) {
    return tooLate();
  }
  for (const FramePtr& one : (*frames)->frames) {
    images[frame].push_back(one ? one->image : cv::Mat());
  }
  return {};
}

/// Reads the frames of all clicks and takes the colors there.
Result<FrameImages> takeSamples(FrameSetSource& source, std::vector<ColorSample>& samples) {
  FrameImages images;
  if (source.isLive()) {
    return failure(ErrorCode::BadValue, "", "camera",
                   "the cameras are live, but a recording is needed to learn a color");
  }
  for (ColorSample& marked : samples) {
    if (const auto read = readImages(source, marked.frame, images); !read) {
      return tl::make_unexpected(read.error());
    }
    auto sample =
        takeSample(images[marked.frame].at(static_cast<std::size_t>(marked.camera)), marked);
    if (!sample) {
      return tl::make_unexpected(sample.error());
    }
    marked = std::move(*sample);
  }
  return images;
}

/// The index of the target that is taught, with its radius and shape: the one named, the only one,
/// or a new one.
Result<std::size_t> targetToLearn(Project& project, const FootageClicks& clicks) {
  auto& targets = project.targets;
  const auto& name = clicks.targetName;
  if (!name && targets.size() > 1) {
    return failure(ErrorCode::MissingKey, "", "target",
                   fmt::format("the project has {} targets", targets.size()));
  }
  auto found = name ? std::ranges::find(targets, *name, &Target::name) : targets.begin();
  if (found == targets.end()) {
    Target added;
    added.name = name.value_or("target 1");
    found = targets.insert(targets.end(), added);
  }
  found->radius = clicks.radius.value_or(found->radius);
  found->shape = clicks.shape.value_or(found->shape);
  return static_cast<std::size_t>(found - targets.begin());
}

} // namespace

Result<FootageLearningResult> learnFromFootage(Project project, FrameSetSource& source,
                                               const std::vector<cv::Mat>& backgroundImages,
                                               FootageClicks clicks) {
  assert(!clicks.samples.empty());
  const auto images = takeSamples(source, clicks.samples);
  if (!images) {
    return tl::make_unexpected(images.error());
  }
  const auto target = targetToLearn(project, clicks);
  if (!target) {
    return tl::make_unexpected(target.error());
  }
  const ColorSample& click = clicks.samples.front();
  const auto& shown = images->at(click.frame);
  auto result = learnFromClicks(project, static_cast<int>(*target),
                                {shown, backgroundImages, click.frame}, clicks.samples);
  if (!result) {
    return tl::make_unexpected(result.error());
  }
  applyLearningResult(*result, *target, project);
  return checkProject(project).map([&] {
    return FootageLearningResult{std::move(project), *target, std::move(*result),
                                 shown.at(static_cast<std::size_t>(click.camera))};
  });
}

} // namespace dewpoint::setup
