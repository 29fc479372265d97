// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/map_actor.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {
namespace {

constexpr double kSliceOpacity = 0.72;
constexpr double kSurfaceOpacity = 0.30;
constexpr double kWorst = 1e3; ///< of what counts as seen by nobody: meters of a sigma

/// What surfaces are drawn through: even steps between values, falling from good to bad.
double level(const MapOptions& look, double value) {
  if (look.quantity == MapQuantity::CameraCount) {
    return value;
  }
  return -std::log10(std::isnan(value) ? kWorst : std::clamp(value, 1e-6, kWorst));
}

/// Between the values of a class and those that are worse.
double surfaceLevel(const MapOptions& look, const MapClass& one) {
  return look.quantity == MapQuantity::CameraCount ? one.upperBound - 0.5
                                                   : level(look, one.upperBound);
}

} // namespace

MapActor::MapActor(vtkRenderer* renderer)
    : renderer_(renderer), box_(makeFlatActor(boxData_)), slice_(makeFlatActor(sliceData_)) {
  slice_->GetProperty()->SetOpacity(kSliceOpacity);
  renderer_->AddActor(slice_);
  renderer_->AddActor(box_);
  for (Surface& surface : surfaces_) {
    surface.actor = makeFlatActor(surface.data);
    surface.actor->GetProperty()->LightingOn();
    surface.actor->GetProperty()->SetAmbient(0.45);
    surface.actor->GetProperty()->SetDiffuse(0.6);
    renderer_->AddActor(surface.actor);
  }
  show(nullptr, {});
}

MapActor::~MapActor() {
  renderer_->RemoveActor(slice_);
  renderer_->RemoveActor(box_);
  for (const Surface& surface : surfaces_) {
    renderer_->RemoveActor(surface.actor);
  }
}

void MapActor::show(std::shared_ptr<const RigMap> map, const MapOptions& look) {
  map_ = std::move(map);
  options_ = look;
  drawBox();
  drawSlice();
  drawSurfaces();
}

Eigen::AlignedBox3d MapActor::volume() const {
  return map_ ? Eigen::AlignedBox3d(map_->grid.low, map_->grid.high) : Eigen::AlignedBox3d();
}

double MapActor::valueAt(std::size_t cell) const {
  return options_.quantity == MapQuantity::CameraCount ? double(map_->cameraCounts[cell])
                                                       : double(map_->sigmas[cell]);
}

void MapActor::drawBox() {
  LinesAndFaces strokes;
  if (map_) {
    const Eigen::AlignedBox3d box = volume();
    const auto corner = [&](int k) {
      return box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
    };
    for (int k = 0; k < 8; ++k) {
      for (const int bit : {1, 2, 4}) {
        if ((k & bit) == 0) {
          strokes.addLine(corner(k), corner(k | bit));
        }
      }
    }
  }
  strokes.writeTo(boxData_);
  box_->SetVisibility(map_ != nullptr);
}

void MapActor::drawSlice() {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  const auto layer =
      map_ && options_.showsLayer
          ? cellAt(map_->grid, {map_->grid.low.x(), map_->grid.low.y(), options_.layerHeight})
          : std::nullopt;
  if (layer) {
    const VolumeGrid& grid = map_->grid;
    const std::vector<MapClass> classes = mapClasses(options_);
    const Eigen::Vector3d size = grid.high - grid.low;
    // A little above the floor, which would flicker through it.
    const double z = options_.layerHeight + 2e-3 * size.maxCoeff();
    const int columns = grid.cellsPerAxis[0], rows = grid.cellsPerAxis[1];
    for (int y = 0; y <= rows; ++y) {
      for (int x = 0; x <= columns; ++x) {
        points->InsertNextPoint(grid.low.x() + size.x() * x / columns,
                                grid.low.y() + size.y() * y / rows, z);
      }
    }
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        const std::size_t one = mapClassOf(classes, valueAt(*layer + grid.index(x, y, 0)));
        if (one == classes.size()) {
          continue;
        }
        const vtkIdType first = vtkIdType(y) * (columns + 1) + x;
        cells->InsertNextCell({first, first + 1, first + columns + 2, first + columns + 1});
        for (int c = 0; c < 3; ++c) {
          colors->InsertNextValue(
              static_cast<unsigned char>(std::lround(255.0 * classes[one].color[c])));
        }
      }
    }
  }
  sliceData_->Initialize();
  sliceData_->SetPoints(points);
  sliceData_->SetPolys(cells);
  sliceData_->GetCellData()->SetScalars(colors);
  slice_->SetVisibility(cells->GetNumberOfCells() > 0);
}

/// A margin that counts as bad closes the surfaces at the border of the volume.
void MapActor::fill(vtkImageData& image) const {
  const VolumeGrid& grid = map_->grid;
  const Eigen::Array3d cells(grid.cellsPerAxis[0], grid.cellsPerAxis[1], grid.cellsPerAxis[2]);
  const Eigen::Vector3d step = (grid.high - grid.low).array() / cells;
  const Eigen::Vector3d origin = grid.low - 0.5 * step;
  image.SetDimensions(grid.cellsPerAxis[0] + 2, grid.cellsPerAxis[1] + 2, grid.cellsPerAxis[2] + 2);
  image.SetSpacing(step.x(), step.y(), step.z());
  image.SetOrigin(origin.x(), origin.y(), origin.z());
  image.AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image.GetScalarPointer());
  const double outside =
      options_.quantity == MapQuantity::CameraCount ? 0.0 : level(options_, kWorst);
  for (int z = -1; z <= grid.cellsPerAxis[2]; ++z) {
    for (int y = -1; y <= grid.cellsPerAxis[1]; ++y) {
      for (int x = -1; x <= grid.cellsPerAxis[0]; ++x) {
        const bool in = x >= 0 && y >= 0 && z >= 0 && x < grid.cellsPerAxis[0] &&
                        y < grid.cellsPerAxis[1] && z < grid.cellsPerAxis[2];
        *values++ = float(in ? level(options_, valueAt(grid.index(x, y, z))) : outside);
      }
    }
  }
}

void MapActor::drawSurfaces() {
  for (const Surface& surface : surfaces_) {
    surface.actor->VisibilityOff();
  }
  if (!map_ || !options_.showsVolume) {
    return;
  }
  vtkNew<vtkImageData> image;
  fill(*image);
  std::size_t next = 0;
  for (const MapClass& one : mapClasses(options_)) {
    if (!one.hasSurface || next == surfaces_.size()) {
      continue;
    }
    Surface& surface = surfaces_[next++];
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(image);
    edges->SetValue(0, surfaceLevel(options_, one));
    edges->ComputeScalarsOff();
    edges->Update();
    surface.data->ShallowCopy(edges->GetOutput());
    setActorColor(surface.actor, one.color, kSurfaceOpacity);
    surface.actor->SetVisibility(surface.data->GetNumberOfCells() > 0);
  }
}

void MapActor::setPalette(const ScenePalette& palette) {
  setActorColor(box_, palette.gridMajor);
}

void MapActor::prepareRendering(const ScreenScale& scale) {
  box_->GetProperty()->SetLineWidth(static_cast<float>(1.2 * scale.pixelRatio));
}

} // namespace dewpoint::ui
