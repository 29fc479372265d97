// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/simulation/scene/scene.h"

#include <string>

namespace dewpoint::simulation {

/// Parses the TOML text of a scene. Missing keys keep the values of demoScene(); unknown keys,
/// wrong types and invalid values are errors that name `file` and the key.
Result<Scene> parseScene(const std::string& text, const std::string& file);

/// Returns the scene as TOML text with every key. parseScene() converts this text back to the same
/// scene.
std::string sceneToml(const Scene& scene);

} // namespace dewpoint::simulation
