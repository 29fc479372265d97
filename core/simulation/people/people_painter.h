// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/walker.h"
#include "core/simulation/room/illumination.h"
#include "core/simulation/room/room_view.h"

#include <opencv2/core.hpp>

#include <vector>

namespace dewpoint::simulation {

/// Draws people into `image` (CV_32FC3), which shows the room at rest as seen by `view`. Nearer
/// people and objects hide people behind them. People cast soft shadows on the floor (z = 0).
/// `lamp` is the position of the lamp (world, meters). `people` contains the parts of each person.
/// Furniture is drawn like a person, with parts that do not belong to a body. If `who` is not null,
/// `who` is set to a CV_8UC1 image that shows which person is visible. A pixel of `who` is 0 where
/// the room, furniture or a carried object is visible, and 1 + the index of the person where a body
/// is visible.
void paintPeople(const RoomView& view, const std::vector<std::vector<BodyPart>>& people,
                 const Vector3f& lamp, cv::Mat& image, cv::Mat* who = nullptr);

/// Light on the people, if the room lamp is not the only light.
struct PeopleLight {
  LightField lightField;
  /// Image of the room at rest, split into the direct light of the room lamp and all other light.
  /// In the shadow of a person, the direct light of the room lamp is missing.
  const RelitBackground* background = nullptr;
};

/// Draws people in the light of the room lamp and of the additional lamps. The additional lamps
/// also illuminate the shadows that people cast. The moving shadow of the illumination
/// (Illumination::shadow) falls on people too. `image` must show the room at rest in the same light
/// and at the same time, as backgroundAt() returns it.
void paintPeople(const RoomView& view, const std::vector<std::vector<BodyPart>>& people,
                 const PeopleLight& light, cv::Mat& image);

/// Returns the complete silhouette of a body as seen by `view`, as if nothing hid the body:
/// CV_8UC1, 255 on the body, 0 elsewhere. Carried objects and furniture are left out.
cv::Mat wholeSilhouette(const RoomView& view, const std::vector<BodyPart>& parts);

} // namespace dewpoint::simulation
