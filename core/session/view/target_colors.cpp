// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/view/target_colors.h"

#include "core/session/people/people_overlay.h"
#include "core/session/snapshot/snapshot.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/people_state.h"

namespace dewpoint::session {

namespace {

DisplayColorSource colorSource(const Target& target, const MethodFamily& family) {
  DisplayColorSource source;
  if (family.hasColorMasks()) {
    source.learnedColors = target.colors();
  }
  if (const auto identity = identityFromName(target.name)) {
    const cv::Scalar color = identityColor(*identity); // blue, green, red
    source.fixedColor = DisplayColor(color[2], color[1], color[0]) / 255.0;
  }
  return source;
}

} // namespace

std::vector<DisplayColorSource> displayColorSources(const std::vector<Target>& targets,
                                                    const MethodFamily& family) {
  std::vector<DisplayColorSource> sources;
  sources.reserve(targets.size());
  for (const Target& target : targets) {
    sources.push_back(colorSource(target, family));
  }
  return sources;
}

std::vector<DisplayColorSource> displayColorSources(const TrackSnapshot& snapshot) {
  std::vector<DisplayColorSource> sources;
  sources.reserve(snapshot.targets.size());
  for (const TargetSnapshot& target : snapshot.targets) {
    sources.push_back(colorSource(target.target, snapshot.family));
  }
  return sources;
}

} // namespace dewpoint::session
