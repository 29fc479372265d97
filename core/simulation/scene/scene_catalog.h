// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/simulation/scene/scene.h"

#include <string>
#include <vector>

namespace dewpoint::simulation {

/// Returns the names of the built-in scenes: `demo`, `converge` (the demo in slow motion, to watch
/// the filter converge), `one-camera` (only the demo's first camera), `still`, `smooth`, `fast`,
/// `jump`, `look-alikes`, `occluder`.
const std::vector<std::string>& sceneNames();

/// Returns the built-in scene with this name. If there is no such scene, reads the scene from the
/// TOML file with this name. Errors: FileMissing, FileUnreadable, and those of parseScene().
Result<Scene> loadScene(const std::string& nameOrTomlFile);

} // namespace dewpoint::simulation
