// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/simulation/scene/scene.h"

#include <string>
#include <vector>

namespace dewpoint::simulation {

/// Names of the built-in scenes: demo, converge (the demo, slowly: a filter can be watched),
/// one-camera (the demo's first camera alone), still, smooth, fast, jump, look-alikes, occluder.
const std::vector<std::string>& sceneNames();

/// A built-in scene by name, else a scene TOML file by path.
Result<Scene> sceneNamed(const std::string& nameOrTomlFile);

} // namespace dewpoint::simulation
