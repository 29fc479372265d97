// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/background/foreground_model.h"
#include "core/observation/boxes/motion_likelihood.h"
#include "core/tracking/parameters.h"

#include <Eigen/Core>

#include <span>

namespace dewpoint::tracking {

/// The floor that people walk on: a rectangle, meters, world.
struct PeopleArea {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d half{3.5, 3.5};
  double floor = 0.0; ///< its z

  bool contains(const Eigen::Vector2d& position) const {
    return ((position - center).cwiseAbs() - half).maxCoeff() <= 0.0;
  }
};

/// What all methods for people have in common.
struct PeopleSettings {
  PeopleArea area;
  ForegroundSettings foreground; ///< in frames of 1/30 s until a rate is known
  double learningTime = 1.0;     ///< seconds
  double memory = 40.0;          ///< seconds
  int imageWidth = 0;            ///< images are made no wider than this; 0: taken as they are
  double birthTime = 0.2;        ///< seconds
  double survivalTime = 0.6;     ///< seconds
  bool births = true;
};

PeopleSettings peopleSettings(const ParameterValues& parameters);

std::span<const ParameterDeclaration> mohedanoMsParameters();
std::span<const ParameterDeclaration> mohedanoMscParameters();
std::span<const ParameterDeclaration> peopleParameters();

} // namespace dewpoint::tracking
