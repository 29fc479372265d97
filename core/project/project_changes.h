// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace dewpoint::project {

/// Differences between two states of a project. A field is true if that part of the project
/// differs.
struct ProjectChanges {
  bool name = false;
  bool method = false;
  bool seed = false;
  bool parameters = false;  ///< parameter values; never true if the method differs
  bool targets = false;     ///< number of targets, their order, names, colors or radii
  bool boxes = false;       ///< image targets, for methods that track bounding boxes
  bool calibration = false; ///< camera calibration; never true if `sources` is true
  bool markers = false;
  bool grid = false;             ///< the reference grid
  bool volume = false;           ///< the volume of interest
  bool points = false;           ///< measured points and their clicks
  bool people = false;           ///< corrections for people
  bool corrections = false;      ///< corrections of target positions
  bool backgroundImages = false; ///< background images; never true if `sources` is true
  bool controls = false;         ///< controls of devices; never true if `sources` is true
  bool records = false;          ///< records of how the calibration was obtained
  bool output = false;           ///< settings of the outputs to other programs
  bool sources = false;          ///< the set of cameras, and the sources of images and ground truth

  /// Returns whether any field is true. `boxes` is not tested, because `targets` is also true if
  /// `boxes` is.
  bool any() const {
    return name || method || seed || parameters || targets || calibration || sources || markers ||
           grid || points || people || corrections || backgroundImages || volume || records ||
           output || controls;
  }
};

/// Returns the differences between two project states. A different file path or window layout does
/// not count as a difference.
ProjectChanges changesBetween(const Project& before, const Project& after);

} // namespace dewpoint::project
