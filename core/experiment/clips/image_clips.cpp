// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/clips/clip_sources.h"

#include <algorithm>
#include <utility>

namespace dewpoint::experiment {

Result<BoxClip> recordedBoxClip(const ClipFolders& folders, const std::string& name) {
  auto clips = recordedBoxClips(folders.recordings);
  if (!clips) {
    return tl::make_unexpected(clips.error());
  }
  const auto found = std::ranges::find(*clips, name, &BoxClip::name);
  if (found == clips->end()) {
    return failure(ErrorCode::NotFound, folders.recordings.string(), name, "no such clip");
  }
  return std::move(*found);
}

} // namespace dewpoint::experiment
