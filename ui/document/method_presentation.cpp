// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/method_presentation.h"

#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "core/tracking/catalog/method_catalog.h"

namespace dewpoint::ui {

namespace {

constexpr MethodPresentation kColors{};
constexpr MethodPresentation kBoxes{.targetsAreBoxes = true,
                                    .resultsAreBoxes = true,
                                    .hasBirdsEyeView = false,
                                    .hasOverlays = false,
                                    .limitsSearchToVolume = false};
constexpr MethodPresentation kPeople{.limitsSearchToVolume = false, .listsPeople = true};

const MethodPresentation& presentationOf(TargetSource targets) {
  switch (targets) {
  case TargetSource::Color:
    break;
  case TargetSource::Box:
    return kBoxes;
  case TargetSource::Images:
    return kPeople;
  }
  return kColors;
}

} // namespace

const MethodPresentation& presentationOf(const Project& project) {
  return presentationOf(methodFamily(project.method).targetSource);
}

const MethodPresentation& presentationOf(const TrackSnapshot& snapshot) {
  return presentationOf(snapshot.family.targetSource);
}

} // namespace dewpoint::ui
