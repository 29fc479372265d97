// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/session/session.h"
#include "core/simulation/scene/scene.h"

#include <filesystem>
#include <string>

namespace dewpoint::app {

/// A project that tracks the balls of a simulated scene, with the paper's parameters: none comes
/// from the cameras. The scenes "converge" and "one-camera" have a method of their own.
Project projectOfScene(const Scene& scene, const std::string& sceneName);

/// True positions of all balls of a scene at every frame, named as the project's targets.
Trajectory truthOfScene(const Scene& scene);

/// A project file, or the name of a built-in scene ("demo", the default when empty). Cameras of a
/// simulated project are filled in from its scene. `moved` as of loadProject().
Result<Project> resolveProject(const std::string& nameOrFile, const MovedFiles& moved = {});

/// A resolved project as it is tracked, before any source of it is opened to stay: sizes of images
/// that no calibration says are read from the sources, and all is checked.
Result<Project> settledProject(Project project);

/// Opens the sources of a resolved project, and its truth where it is known.
Result<SessionInputs> openInputs(Project project);

/// Both in one: what the window's "Open" does.
Result<SessionInputs> openProject(const SessionRequest& request);

} // namespace dewpoint::app
