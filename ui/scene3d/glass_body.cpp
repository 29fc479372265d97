// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/glass_body.h"

#include "ui/scene3d/ellipsoid_axes.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>
#include <vtkUniforms.h>

#include <array>

namespace dewpoint::ui {
namespace {

constexpr int kResolution = 40; ///< faces around

constexpr const char* kLightTag = "//VTK::Light::Impl";
/// After the light: `facing` is 1 where the surface faces the eye, 0 at the rim.
constexpr const char* kFillShader =
    "//VTK::Light::Impl\n"
    "float facing = clamp(dot(normalVCVSOutput, eyeSide), 0.0, 1.0);\n"
    "float rim = pow(1.0 - facing, 2.0);\n"
    "float gleam = pow(max(dot(normalVCVSOutput, vec3(-0.38, 0.52, 0.765)), 0.0), 60.0);\n"
    "vec3 tint = mix(mix(diffuseColor, rimColor, 0.5 * rim), vec3(1.0), 0.8 * gleam);\n"
    "fragOutput0 = vec4(tint, clamp(mix(middleAlpha, rimAlpha, rim) + 0.45 * gleam, 0.0, 1.0));\n";
constexpr const char* kRimShader =
    "//VTK::Light::Impl\n"
    "float facing = clamp(dot(normalVCVSOutput, eyeSide), 0.0, 1.0);\n"
    "float rim = smoothstep(0.55, 0.8, 1.0 - facing);\n"
    "fragOutput0 = vec4(mix(diffuseColor, rimColor, 0.6), rimAlpha * rim);\n";

/// One for all bodies, in memory and in that of the graphics as well.
vtkPolyData* unitBall() {
  static const vtkSmartPointer<vtkPolyData> kBall = [] {
    vtkNew<vtkSphereSource> source;
    source->SetRadius(1.0);
    source->SetThetaResolution(kResolution);
    source->SetPhiResolution(kResolution / 2 + 2);
    source->Update();
    return vtkSmartPointer<vtkPolyData>(source->GetOutput());
  }();
  return kBall;
}

vtkUniforms* uniformsOf(vtkActor* actor) {
  return actor->GetShaderProperty()->GetFragmentCustomUniforms();
}

} // namespace

GlassBody::GlassBody(vtkRenderer* renderer, Layer layer)
    : renderer_(renderer), actor_(vtkSmartPointer<vtkActor>::New()) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(unitBall());
  actor_->SetMapper(mapper);
  actor_->GetProperty()->BackfaceCullingOn(); // one layer of color, not two
  actor_->ForceTranslucentOn();
  actor_->PickableOff();
  actor_->VisibilityOff();
  actor_->GetShaderProperty()->AddFragmentShaderReplacement(
      kLightTag, true, layer == Layer::Fill ? kFillShader : kRimShader, false);
  setAppearance(SceneColor::Zero(), SceneColor::Zero(), 0.0, 0.0);
  const std::array<float, 3> towardsEye{0.0F, 0.0F, 1.0F};
  uniformsOf(actor_)->SetUniform3f("eyeSide", towardsEye.data());
  addNewProp(renderer_, actor_);
}

GlassBody::~GlassBody() {
  renderer_->RemoveActor(actor_);
}

void GlassBody::setAppearance(const SceneColor& color, const SceneColor& rim, double middle,
                              double atRim) {
  setActorColor(actor_, color);
  const Eigen::Vector3f edge = rim.cast<float>();
  uniformsOf(actor_)->SetUniform3f("rimColor", edge.data());
  uniformsOf(actor_)->SetUniformf("middleAlpha", static_cast<float>(middle));
  uniformsOf(actor_)->SetUniformf("rimAlpha", static_cast<float>(atRim));
}

void GlassBody::setPose(const Eigen::Vector3d& center, const Eigen::Matrix3d& directions,
                        const Eigen::Vector3d& semiAxes, const ScreenScale& scale) {
  actor_->SetPosition(center.x(), center.y(), center.z());
  actor_->SetScale(semiAxes.x(), semiAxes.y(), semiAxes.z());
  setOrientation(actor_, directions);
  // The eye is far away compared with the body: one direction for all of it.
  const Eigen::Vector3d toEye = scale.isParallel
                                    ? Eigen::Vector3d(-scale.direction)
                                    : Eigen::Vector3d((scale.eye - center).normalized());
  const Eigen::Vector3f inView =
      Eigen::Vector3d(toEye.dot(scale.right), toEye.dot(scale.up), -toEye.dot(scale.direction))
          .cast<float>();
  uniformsOf(actor_)->SetUniform3f("eyeSide", inView.data());
}

} // namespace dewpoint::ui
