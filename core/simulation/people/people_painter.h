// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/walker.h"
#include "core/simulation/room/illumination.h"
#include "core/simulation/room/room_view.h"

#include <opencv2/core.hpp>

#include <vector>

namespace dewpoint::simulation {

/// Draws people into `image` (CV_32FC3), which shows the room at rest as seen by `view`. People are
/// occluded by other people and by objects in front of them. They cast soft shadows on the floor (z
/// = 0) in the light of `lamp`. `people` contains the parts of each person. Furniture is drawn like
/// a person, with parts that do not belong to a body. `who`, unless null, is set to a CV_8UC1
/// image: 0 for the room, loads and furniture, otherwise 1 + the index of the person whose body is
/// visible.
void paintPeople(const RoomView& view, const std::vector<std::vector<BodyPart>>& people,
                 const Vector3f& lamp, cv::Mat& image, cv::Mat* who = nullptr);

/// Light on the people, if it is more than the room lamp.
struct PeopleLight {
  LightField field;
  /// Direct light of the room lamp on the room at rest, for the pixels of the view. A shadow
  /// removes this light and leaves the light of the other lamps.
  const RelitBackground* background = nullptr;
};

/// Draws people with all lights: additional lamps also illuminate people and their shadows, and the
/// moving shadow falls on them. `image` must come from backgroundAt() with the same light and time.
void paintPeople(const RoomView& view, const std::vector<std::vector<BodyPart>>& people,
                 const PeopleLight& light, cv::Mat& image);

/// Returns the complete silhouette of a body as seen by `view`, as if nothing occluded it: CV_8UC1,
/// 255 on the body, otherwise 0. Loads and furniture are omitted.
cv::Mat wholeSilhouette(const RoomView& view, const std::vector<BodyPart>& parts);

} // namespace dewpoint::simulation
