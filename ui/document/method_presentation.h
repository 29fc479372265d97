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

/// What a person points at in an image to say what is to be followed.
enum class Pointing { Color, Box, Nothing };

/// The pages on which plots, table and export show a run.
enum class RunPages { Positions, Boxes };

/// What the window does for a method: one row per kind of targets, and the only place of the window
/// that asks for the kind.
struct MethodPresentation {
  Pointing pointing = Pointing::Color;
  RunPages pages = RunPages::Positions;
  bool showsRoom = true;         ///< has a bird's-eye view
  bool hasOverlays = true;       ///< masks and likelihood maps over the images
  bool marksBest = true;         ///< can mark the particle of highest weight
  bool countsPeople = false;     ///< lists people, and says how many there are
  bool tracksBoxesAgain = false; ///< at once when one is changed
};

/// Of the project's method. The row lives for ever.
const MethodPresentation& presentationOf(const Project& project);
/// Of the method that a snapshot is of.
const MethodPresentation& presentationOf(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
