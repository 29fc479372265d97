// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/office_day.h"

namespace dewpoint::simulation {
namespace {

using simulation::rgb;
using simulation::Walker;

Walker walker(const char* name, double height, const simulation::Vector3f& shirt,
              const simulation::Vector3f& trousers, std::vector<simulation::Waypoint> way) {
  Walker result;
  result.name = name;
  result.height = height;
  result.clothes.shirt = shirt;
  result.clothes.trousers = trousers;
  result.presentFrom = way.front().time;
  result.presentUntil = way.back().time;
  result.waypoints = std::move(way);
  return result;
}

} // namespace

OfficeScene builtInOfficeScene() {
  OfficeScene scene;
  scene.frameCount = 450;
  // Doors: (-3.5, 1.3), (3.5, -1.3), (0.05, 3.5), (0.6, -3.5); people begin and end outside.
  scene.people.push_back(walker("first", 1.80, rgb(66, 92, 178), rgb(58, 62, 84),
                                {{1.5, {-4.2, 1.3}},
                                 {3.8, {-2.0, 0.8}},
                                 {6.0, {-0.4, 0.2}},
                                 {9.0, {-0.4, 0.2}},
                                 {11.5, {0.4, 1.8}},
                                 {14.5, {0.4, -1.6}},
                                 {17.5, {-0.4, 0.9}},
                                 {20.0, {0.0, 2.4}},
                                 {21.8, {0.05, 4.2}}}));
  scene.people.push_back(walker("second", 1.66, rgb(196, 84, 70), rgb(70, 66, 62),
                                {{2.6, {4.2, -1.3}},
                                 {5.0, {2.0, -0.8}},
                                 {7.0, {0.25, 0.0}},
                                 {9.4, {0.25, 0.0}},
                                 {12.0, {0.2, -1.8}},
                                 {15.0, {0.9, 1.7}},
                                 {18.0, {-0.2, -0.6}},
                                 {21.0, {0.5, -2.2}},
                                 {23.0, {0.6, -4.2}}}));
  scene.people.push_back(walker("third", 1.73, rgb(92, 150, 84), rgb(104, 92, 74),
                                {{8.0, {0.05, 4.2}},
                                 {10.0, {0.1, 2.3}},
                                 {12.5, {-0.9, 1.0}},
                                 {17.0, {-0.6, -0.7}},
                                 {20.0, {0.8, 0.4}},
                                 {24.0, {2.1, -0.8}},
                                 {26.5, {4.2, -1.3}}}));
  return scene;
}

} // namespace dewpoint::simulation
