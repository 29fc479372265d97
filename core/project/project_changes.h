// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace dewpoint::project {

/// What differs between two states of a project, as far as someone has to act on it.
struct ProjectChanges {
  bool name = false;
  bool method = false;
  bool seed = false;
  bool parameters = false;  ///< values under the same method
  bool targets = false;     ///< their number, order, names, colors or radii
  bool boxes = false;       ///< of them, those that are followed by methods that follow boxes
  bool calibration = false; ///< of cameras that are otherwise the same
  bool markers = false;
  bool grid = false;        ///< the reference grid
  bool volume = false;      ///< the volume of interest
  bool points = false;      ///< measured points and their clicks
  bool people = false;      ///< corrections of who is there
  bool corrections = false; ///< of where targets are
  bool emptyRooms = false;  ///< of cameras with the same sources
  bool sources = false;     ///< which cameras there are, and where images and truth come from

  bool any() const {
    return name || method || seed || parameters || targets || calibration || sources || markers ||
           grid || points || people || corrections || emptyRooms || volume;
  }
};

/// Neither the file nor the layout of the window counts: they are no edits.
ProjectChanges changesBetween(const Project& before, const Project& after);

} // namespace dewpoint::project
