// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/result_settings.h"

#include <algorithm>
#include <utility>

namespace dewpoint::session {
namespace {

/// But for their names, for what their colors were learned from, and for what the views show.
bool areTrackedAlike(Target a, const Target& b) {
  a.name = b.name;
  a.samples = b.samples;
  return areSameExceptShown(std::move(a), b);
}

/// The values in use: whether somebody gave them or the cameras did decides nothing.
bool haveSameValues(const ParameterValues& a, const ParameterValues& b) {
  return std::ranges::all_of(a.declarations(), [&](const ParameterDeclaration& declaration) {
    return a.at(declaration.key) == b.at(declaration.key);
  });
}

bool haveSameTargets(const RunDefinition& a, const RunDefinition& b) {
  return a.family().retracksAfterEdit || a.family().findsTargets() ||
         std::ranges::equal(a.targets, b.targets, areTrackedAlike);
}

} // namespace

bool giveSameResults(const RunDefinition& a, const RunDefinition& b) {
  return &a == &b || (a.method == b.method && haveSameValues(a.parameters, b.parameters) &&
                      haveSameTargets(a, b) && (a.rig == b.rig || *a.rig == *b.rig) &&
                      areImagesEqual(a.backgroundImages, b.backgroundImages) &&
                      a.volumeOfInterest == b.volumeOfInterest && a.seed == b.seed);
}

void ResultSettings::goBack(std::int64_t frame) {
  while (!sections_.empty() && sections_.back().frames.firstFrame >= frame) {
    sections_.pop_back();
  }
  if (!sections_.empty()) {
    sections_.back().frames.lastFrame = std::min(sections_.back().frames.lastFrame, frame - 1);
  }
}

void ResultSettings::recordTrackedFrame(std::int64_t frame, const RunDefinitionPtr& definition) {
  goBack(frame);
  const bool continues = !sections_.empty() && sections_.back().frames.lastFrame == frame - 1 &&
                         (sections_.back().definition == definition ||
                          giveSameResults(*sections_.back().definition, *definition));
  if (continues) {
    sections_.back().frames.lastFrame = frame;
  } else {
    sections_.push_back({{frame, frame}, definition});
  }
}

std::vector<ResultRange> ResultSettings::framesDifferingFrom(const RunDefinition& now) const {
  std::vector<ResultRange> different;
  for (const Section& section : sections_) {
    if (giveSameResults(*section.definition, now)) {
      continue;
    }
    if (!different.empty() && different.back().lastFrame == section.frames.firstFrame - 1) {
      different.back().lastFrame = section.frames.lastFrame;
    } else {
      different.push_back(section.frames);
    }
  }
  return different;
}

} // namespace dewpoint::session
