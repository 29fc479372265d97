// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/clips/clip_frames.h"

#include "core/capture/image_reader.h"
#include "core/capture/video_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dewpoint::experiment {
namespace {

/// The largest frame number that a camera needs, -1 for no instants.
std::int64_t lastFrameOf(const std::vector<ClipInstant>& instants, std::size_t camera) {
  std::int64_t last = -1;
  for (const ClipInstant& instant : instants) {
    last = std::max(last, instant.frames[camera]);
  }
  return last;
}

} // namespace

std::vector<ClipInstant> simultaneousInstants(std::int64_t first, std::int64_t end,
                                              std::size_t cameras, double framesPerSecond) {
  std::vector<ClipInstant> instants;
  for (std::int64_t frame = first; frame < end; ++frame) {
    const double time = static_cast<double>(frame) / framesPerSecond;
    instants.push_back(
        {time, std::vector<std::int64_t>(cameras, frame), std::vector<double>(cameras, time)});
  }
  return instants;
}

Result<std::shared_ptr<ClipFrames>>
ClipFrames::open(const std::vector<std::filesystem::path>& cameras,
                 std::vector<ClipInstant> instants) {
  const std::shared_ptr<ClipFrames> frames(new ClipFrames());
  for (std::size_t camera = 0; camera < cameras.size(); ++camera) {
    const std::string path = cameras[camera].string();
    const std::string field = fmt::format("camera {}", camera + 1);
    auto reader = std::filesystem::is_directory(cameras[camera])
                      ? openImageFolderReader(path, field)
                      : openVideoReader(path, field);
    if (!reader) {
      return tl::make_unexpected(reader.error());
    }
    const std::int64_t last = lastFrameOf(instants, camera);
    if (last >= (*reader)->frameCount()) {
      return failure(ErrorCode::EndedEarly, path, field,
                     fmt::format("{} frames; {} are needed", (*reader)->frameCount(), last + 1));
    }
    frames->readers_.push_back(std::move(*reader));
  }
  frames->instants_ = std::move(instants);
  return frames;
}

FrameSetPtr ClipFrames::at(std::int64_t instant) {
  const ClipInstant& source = instants_[static_cast<std::size_t>(instant)];
  const double zero = instants_.front().time;
  FrameSet set;
  set.index = instant;
  set.time = timeStamp(source.time - zero);
  for (std::size_t camera = 0; camera < readers_.size(); ++camera) {
    auto image = readers_[camera]->read(source.frames[camera]);
    const bool usable = image && !image->empty();
    set.frames.push_back(usable ? std::make_shared<const Frame>(Frame{
                                      instant, timeStamp(source.times[camera] - zero), *image})
                                : nullptr);
  }
  return std::make_shared<const FrameSet>(std::move(set));
}

} // namespace dewpoint::experiment
