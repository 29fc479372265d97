// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace dewpoint::project {

/// Differences between two states of a project. A field is true if that part of the project
/// differs.
struct ProjectChanges {
  bool nameChanged = false;
  bool methodChanged = false;
  bool seedChanged = false;
  bool parametersChanged = false;  ///< parameter values; never true if the method differs
  bool targetsChanged = false;     ///< number of targets, their order, names, colors or radii
  bool boxesChanged = false;       ///< image targets, for methods that track bounding boxes
  bool calibrationChanged = false; ///< camera calibration; never true if `sourcesChanged` is true
  bool markersChanged = false;
  bool gridChanged = false;              ///< the reference grid
  bool volumeChanged = false;            ///< the volume of interest
  bool pointsChanged = false;            ///< measured points and their clicks
  bool personCorrectionsChanged = false; ///< corrections for people
  bool correctionsChanged = false;       ///< corrections of target positions
  /// Background images; never true if `sourcesChanged` is true.
  bool backgroundImagesChanged = false;
  bool controlsChanged = false; ///< controls of devices; never true if `sourcesChanged` is true
  bool recordsChanged = false;  ///< records of how the calibration was obtained
  bool outputChanged = false;   ///< settings of the outputs to other programs
  bool sourcesChanged = false;  ///< the set of cameras, and the sources of images and ground truth

  /// Returns whether any field is true. `boxesChanged` is not tested, because `targetsChanged` is
  /// also true if `boxesChanged` is.
  bool hasAny() const {
    return nameChanged || methodChanged || seedChanged || parametersChanged || targetsChanged ||
           calibrationChanged || sourcesChanged || markersChanged || gridChanged || pointsChanged ||
           personCorrectionsChanged || correctionsChanged || backgroundImagesChanged ||
           volumeChanged || recordsChanged || outputChanged || controlsChanged;
  }
};

/// Returns the differences between two project states. A different file path or window layout does
/// not count as a difference.
ProjectChanges changesBetween(const Project& before, const Project& after);

} // namespace dewpoint::project
