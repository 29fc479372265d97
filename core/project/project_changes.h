// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace dewpoint::project {

/// Differences between two states of a project that require an action.
struct ProjectChanges {
  bool name = false;
  bool method = false;
  bool seed = false;
  bool parameters = false;  ///< values of parameters, with the same method
  bool targets = false;     ///< number, order, names, colors or radii of targets
  bool boxes = false;       ///< image targets, for methods that track bounding boxes
  bool calibration = false; ///< calibration of cameras with the same sources
  bool markers = false;
  bool grid = false;             ///< the reference grid
  bool volume = false;           ///< the volume of interest
  bool points = false;           ///< measured points and their clicks
  bool people = false;           ///< corrections of who is there
  bool corrections = false;      ///< of where targets are
  bool backgroundImages = false; ///< of cameras with the same sources
  bool sources = false;          ///< which cameras there are, and where images and truth come from

  /// Returns whether any edit was made; `boxes` implies `targets`.
  bool any() const {
    return name || method || seed || parameters || targets || calibration || sources || markers ||
           grid || points || people || corrections || backgroundImages || volume;
  }
};

/// Returns what differs between two states. Differences in the project's file path or the window
/// layout do not count as edits.
ProjectChanges changesBetween(const Project& before, const Project& after);

} // namespace dewpoint::project
