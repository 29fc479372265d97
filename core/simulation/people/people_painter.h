// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/walker.h"
#include "core/simulation/room/illumination.h"
#include "core/simulation/room/room_view.h"

#include <opencv2/core.hpp>

#include <vector>

namespace dewpoint::simulation {

/// Draws people into `image` (CV_32FC3), which shows the room at rest as `view` sees it: what
/// stands before them hides them, they hide each other, and they cast soft shadows of `lamp` on the
/// floor (z = 0). `people`: the parts of each of them; furniture is drawn like a person, of parts
/// that are of no body. `who`, unless null, becomes CV_8UC1: 0 for the room, loads and furniture,
/// else 1 + the index of the person whose body is seen.
void paintPeople(const RoomView& view, const std::vector<std::vector<BodyPart>>& people,
                 const Vector3f& lamp, cv::Mat& image, cv::Mat* who = nullptr);

/// The light that people walk in where it is more than that of the room's lamp.
struct PeopleLight {
  LightField field;
  /// What the lamp gives the room at rest directly, in the pixels of the view; what takes it away
  /// leaves the light of the others.
  const RelitBackground* background = nullptr;
};

/// The same in all of the light: further lamps light people, too, and reach into their shadows; the
/// moving shadow falls on them. `image`: from backgroundAt() with the same light and time.
void paintPeople(const RoomView& view, const std::vector<std::vector<BodyPart>>& people,
                 const PeopleLight& light, cv::Mat& image);

/// The whole silhouette of a body as `view` sees it when nothing stands before it: CV_8UC1, 255 on
/// the body, else 0. Loads and furniture are left out.
cv::Mat wholeSilhouette(const RoomView& view, const std::vector<BodyPart>& parts);

} // namespace dewpoint::simulation
