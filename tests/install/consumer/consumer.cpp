// SPDX-License-Identifier: GPL-3.0-or-later
#include <core/simulation/scene/scene_catalog.h>

#include <fmt/format.h>

int main() {
  const auto scene = dewpoint::simulation::loadScene("still").value();
  const Eigen::Vector3d ball = dewpoint::simulation::ballPosition(scene, 0, 0.0);
  fmt::print("{}: {} cameras\n", scene.name, scene.cameras.size());
  fmt::print("ball at {},{},{}\n", ball.x(), ball.y(), ball.z());
}
