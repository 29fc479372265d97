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
  Eigen::Vector2d half{3.5, 3.5};
  double floor = 0.0; ///< height z of the floor

  bool contains(const Eigen::Vector2d& position) const {
    return ((position - center).cwiseAbs() - half).maxCoeff() <= 0.0;
  }
};

/// Lower limit of the mean score of a piece of a body (see bodyScore()) when the position of a
/// person is weighted. Chosen by judgment.
inline constexpr double kPieceFloor = -0.25;

/// Settings shared by all methods for people.
struct PeopleSettings {
  PeopleArea area;
  ForegroundSettings foreground; ///< in frames of 1/30 s until the frame rate is known
  /// time at the start for which only the background is learned, seconds
  double learningTime = 1.0;
  double memory = 40.0; ///< time after which a new object counts as background, seconds
  /// Maximum image width in pixels; larger images are reduced to it; 0: unchanged.
  int imageWidth = 0;
  /// time for which a new person must be visible before a track begins, seconds
  double birthTime = 0.2;
  /// time for which a person seen by fewer than two cameras stays, seconds
  double survivalTime = 0.6;
  bool births = true;
};

/// Returns the common settings from the parameters of a method for people.
PeopleSettings peopleSettings(const ParameterValues& parameters);

/// Return the parameters of the `mohedano-ms`, `mohedano-msc` and `people` methods.
std::span<const ParameterDeclaration> mohedanoMsParameters();
std::span<const ParameterDeclaration> mohedanoMscParameters();
std::span<const ParameterDeclaration> peopleParameters();

} // namespace dewpoint::tracking
