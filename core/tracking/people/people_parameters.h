// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/background/foreground_model.h"
#include "core/observation/boxes/motion_likelihood.h"
#include "core/tracking/parameters.h"

#include <Eigen/Core>

#include <span>

namespace dewpoint::tracking {

/// Floor on which people walk: a rectangle, meters, world frame.
struct PeopleArea {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d halfSize{3.5, 3.5};
  double floorHeight = 0.0; ///< z coordinate of the floor

  bool contains(const Eigen::Vector2d& position) const {
    return ((position - center).cwiseAbs() - halfSize).maxCoeff() <= 0.0;
  }
};

/// Lower limit for the mean score of each piece of a body when particles of a person are weighted,
/// because furniture may hide a piece (`floor` of bodyScore()). Chosen by judgment.
inline constexpr double kPieceFloor = -0.25;

/// Settings shared by all methods for people.
struct PeopleSettings {
  PeopleArea area;
  /// Settings of the foreground detection. They count frames of 1/30 s until the frame rate is
  /// known.
  ForegroundSettings foreground;
  /// Time at the start during which only the background is learned, seconds.
  double learningSeconds = 1.0;
  /// Time after which a new object counts as background, seconds.
  double backgroundMemorySeconds = 40.0;
  /// Maximum image width in pixels. Wider images are reduced to this width. 0: images keep their
  /// size.
  int maxImageWidth = 0;
  /// Time for which a new person must be visible before a track begins, seconds.
  double confirmationSeconds = 0.2;
  /// Time for which a track is kept while fewer than two cameras see the person, seconds.
  double survivalSeconds = 0.6;
  bool createsTracks = true; ///< false: only the user adds people
};

/// Returns the common settings from the parameters of a method for people.
PeopleSettings peopleSettings(const ParameterValues& parameters);

/// Return the declarations of the parameters of the `mohedano-ms`, `mohedano-msc` and `people`
/// methods.
std::span<const ParameterDeclaration> mohedanoMsParameters();
std::span<const ParameterDeclaration> mohedanoMscParameters();
std::span<const ParameterDeclaration> peopleParameters();

} // namespace dewpoint::tracking
