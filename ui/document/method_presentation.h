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

/// What the window does for a method, beyond what its family answers (tracking::MethodFamily): one
/// row for each kind of targets, and the only part of the window that asks for the kind.
struct MethodPresentation {
  bool takesBoxes = false; ///< a click or a drag in an image gives a target its box, else a color
  bool showsBoxes = false; ///< plots, table and export have boxes in images, else positions
  bool showsRoom = true;   ///< has a bird's-eye view
  bool hasOverlays = true; ///< masks and likelihood maps over the images
  /// Searches for targets in the project's volume of interest, if it has one, and goes on from
  /// where the user says that a target is.
  bool searchesRoom = true;
  bool countsPeople = false; ///< lists people and shows how many are there
};

/// Of the project's method. The row lives for ever.
const MethodPresentation& presentationOf(const Project& project);
/// Of the method that a snapshot is of.
const MethodPresentation& presentationOf(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
