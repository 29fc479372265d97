// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/method_presentation.h"

#include "core/project/project.h"
#include "core/session/run/snapshot.h"
#include "core/tracking/catalog/method_catalog.h"

namespace dewpoint::ui {

namespace {

constexpr MethodPresentation kColors{};
constexpr MethodPresentation kBoxes{.pointing = Pointing::Box,
                                    .pages = RunPages::Boxes,
                                    .showsRoom = false,
                                    .hasOverlays = false,
                                    .marksBest = false,
                                    .tracksBoxesAgain = true};
constexpr MethodPresentation kPeople{
    .pointing = Pointing::Nothing, .marksBest = false, .countsPeople = true};

const MethodPresentation& presentationOf(TargetsFrom targets) {
  switch (targets) {
  case TargetsFrom::Color:
    break;
  case TargetsFrom::Box:
    return kBoxes;
  case TargetsFrom::Images:
    return kPeople;
  }
  return kColors;
}

} // namespace

const MethodPresentation& presentationOf(const Project& project) {
  return presentationOf(methodFamily(project.method).targets);
}

const MethodPresentation& presentationOf(const TrackSnapshot& snapshot) {
  return presentationOf(snapshot.targetsFrom);
}

} // namespace dewpoint::ui
