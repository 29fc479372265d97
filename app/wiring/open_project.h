// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/live_camera.h"
#include "core/project/project.h"
#include "core/session/session.h"
#include "core/simulation/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::app {

/// Returns a project that tracks the balls of a simulated scene. All parameters have their
/// defaults; none is derived from the cameras. The scenes "converge" and "one-camera" have their
/// own methods.
Project projectOfScene(const Scene& scene, const std::string& sceneName);

/// Returns the true positions of all balls of a scene in every frame (meters), named like the
/// targets in the project.
Trajectory truthOfScene(const Scene& scene);

/// Loads a project file or a built-in scene by its name ("demo" if empty). Cameras of a simulated
/// project are filled in from its scene. `moved`: as in `loadProject()`.
Result<Project> resolveProject(const std::string& nameOrFile, const MovedFiles& moved = {});

/// Completes a resolved project for tracking and checks it. If no calibration gives the size of a
/// camera's images, it is read from the source, which is closed again.
Result<Project> completedProject(Project project);

/// Opens the sources of a resolved project, and its ground truth if that is known.
Result<SessionInputs> openInputs(Project project);

/// Returns the live cameras of a project, in its order.
std::vector<LiveCamera> liveCamerasOf(const Project& project);

/// Resolves a project and opens its inputs, as "Open" in the window does.
Result<SessionInputs> openProject(const SessionRequest& request);

} // namespace dewpoint::app
