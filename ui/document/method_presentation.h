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

/// Options of the window for a method, beyond those of its family (`tracking::MethodFamily`). There
/// is one row per kind of target; only this part of the window depends on the kind.
struct MethodPresentation {
  /// A click or a drag in an image sets the box of a target; otherwise its color.
  bool takesBoxes = false;
  bool showsBoxes = false; ///< plots, table and export use boxes in images; otherwise positions
  bool showsRoom = true;   ///< has a bird's-eye view
  bool hasOverlays = true; ///< masks and likelihood maps can be drawn over the images
  /// Searches the volume of interest of the project, if it has one, and continues from a position
  /// that the user sets for a target.
  bool searchesRoom = true;
  bool countsPeople = false; ///< lists people and shows how many are present
};

/// Returns the options for the method of a project. The reference stays valid until the program
/// ends.
const MethodPresentation& presentationOf(const Project& project);
/// Returns the options for the method of a snapshot.
const MethodPresentation& presentationOf(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
