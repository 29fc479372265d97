// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/scene/scene_file.h"
#include "tests/fuzz/expectation.h"
#include "tests/fuzz/fuzzed_readers.h"

#include <string>

namespace dewpoint::tests {

void fuzzScene(std::string_view bytes) {
  const auto scene = simulation::parseScene(std::string(bytes), "scene.toml");
  if (!scene) {
    expectPlain(scene.error());
    return;
  }
  const auto again = simulation::parseScene(simulation::sceneToml(*scene), "scene.toml");
  if (!again) {
    expectPlain(again.error());
  }
  expect(again && again->cameras.size() == scene->cameras.size() &&
             again->balls.size() == scene->balls.size(),
         "a scene that was read cannot be written and read again");
}

} // namespace dewpoint::tests
