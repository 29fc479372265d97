// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project
namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Options that determine how the window presents a method, in addition to the properties of its
/// family (`tracking::MethodFamily`). There is one set of options per kind of target. No other part
/// of the window depends on the kind of target.
struct MethodPresentation {
  /// True if a click or a drag in an image sets a target's box; otherwise it sets the color.
  bool targetsAreBoxes = false;
  bool resultsAreBoxes = false; ///< plots, table and export use image boxes; otherwise positions
  bool hasBirdsEyeView = true;  ///< positions can be shown in a bird's-eye view
  bool hasOverlays = true;      ///< masks and likelihood maps can be drawn over the images
  /// True if the method limits its search to the project's volume of interest, if there is one, and
  /// also continues from a position that the user sets for a target.
  bool limitsSearchToVolume = true;
  bool listsPeople = false; ///< lists people and shows how many are present
};

/// Returns how the window presents the project's method. The reference stays valid until the
/// program ends.
const MethodPresentation& presentationOf(const Project& project);
/// Returns how the window presents the method of a snapshot.
const MethodPresentation& presentationOf(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
