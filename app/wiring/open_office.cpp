// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wiring/open_office.h"

#include "core/capture/recording.h"
#include "core/simulation/people/office_day.h"
#include "core/simulation/room/view_cache.h"
#include "core/tracking/catalog/method_catalog.h"

#include <memory>
#include <utility>

namespace dewpoint::app {

namespace {

constexpr const char* kOfficeMethod = "people";

} // namespace

Project makeOfficeProject() {
  const OfficeScene scene = builtInOfficeScene();
  Project project;
  project.name = kOfficeSceneName;
  project.scene = kOfficeSceneName;
  project.method = kOfficeMethod;
  project.parameters = ParameterValues(methodParameters(project.method));
  project.framesPerSecond = scene.framesPerSecond;
  for (const Camera& camera : scene.cameras) {
    project.cameras.push_back({camera, SourceKind::Simulation, "", 0});
  }
  return project;
}

Trajectory officeGroundTruth(const OfficeRenderer& renderer) {
  Trajectory truth;
  const OfficeScene& scene = renderer.scene();
  for (const Camera& camera : scene.cameras) {
    truth.header.cameras.push_back({camera.name, camera.center(), camera.opticalAxis()});
  }
  for (std::int64_t frame = 0; frame < scene.frameCount; ++frame) {
    for (std::size_t k = 0; k < scene.people.size(); ++k) {
      TrajectorySample sample;
      sample.frame = frame;
      sample.time = scene.timeOf(frame);
      sample.target = scene.people[k].name;
      sample.position = renderer.bodyCenter(k, sample.time);
      sample.isValid = renderer.isInsideOffice(k, sample.time);
      truth.samples.push_back(std::move(sample));
    }
  }
  return truth;
}

Result<SessionInputs> openOfficeInputs(Project project) {
  simulation::ViewCache views;
  const auto renderer = std::make_shared<const OfficeRenderer>(builtInOfficeScene(), views);
  std::vector<RecordedCamera> cameras;
  for (std::size_t k = 0; k < renderer->scene().cameras.size(); ++k) {
    RecordedCamera& camera = cameras.emplace_back();
    camera.name = renderer->scene().cameras[k].name;
    camera.kind = RecordedCamera::Kind::Generated;
    camera.width = renderer->scene().cameras[k].intrinsics.width;
    camera.height = renderer->scene().cameras[k].intrinsics.height;
    camera.generate = [renderer, k](std::int64_t frame) { return renderer->render(k, frame); };
    camera.generatedFrameCount = renderer->scene().frameCount;
  }
  auto source = openRecording(cameras, renderer->scene().framesPerSecond);
  if (!source) {
    return tl::make_unexpected(source.error());
  }
  SessionInputs inputs;
  inputs.project = std::move(project);
  inputs.source = std::move(*source);
  inputs.truth = officeGroundTruth(*renderer);
  return inputs;
}

} // namespace dewpoint::app
