// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/trajectory/export_examples.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cmath>
#include <regex>

namespace dewpoint::tests {
namespace {

vtkSmartPointer<vtkPolyData> readPolyData(const std::filesystem::path& file) {
  vtkNew<vtkXMLPolyDataReader> reader;
  EXPECT_TRUE(reader->CanReadFile(file.c_str()));
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

std::vector<vtkIdType> lineOf(vtkPolyData& data, vtkIdType line) {
  vtkNew<vtkIdList> ids;
  data.GetLines()->GetCellAtId(line, ids);
  return {ids->begin(), ids->end()};
}

TEST(ExportVtp, IsReadByVtk) {
  const ExportFolder folder;
  ASSERT_TRUE(exportTrajectory(exportExample(), exportAs("vtp"), folder / "a.vtp"));
  const auto data = readPolyData(folder / "a.vtp");
  // The ball at frames 0, 1, 3, the cap at all four.
  ASSERT_EQ(data->GetNumberOfPoints(), 7);
  ASSERT_EQ(data->GetNumberOfLines(), 2);
  EXPECT_EQ(lineOf(*data, 0), (std::vector<vtkIdType>{0, 1}));
  EXPECT_EQ(lineOf(*data, 1), (std::vector<vtkIdType>{3, 4, 5, 6}));
  ASSERT_EQ(data->GetNumberOfVerts(), 1) << "behind the gap the ball has one place only";
  std::array<double, 3> place{};
  data->GetPoint(1, place.data());
  EXPECT_EQ(place, (std::array<double, 3>{0.1, 0.25, 2.0}));
  vtkPointData* values = data->GetPointData();
  EXPECT_EQ(values->GetArray("time_s")->GetTuple1(2), 0.3);
  EXPECT_EQ(values->GetArray("frame")->GetTuple1(2), 3.0);
  EXPECT_EQ(values->GetArray("target")->GetTuple1(3), 1.0);
  EXPECT_EQ(values->GetArray("cameras")->GetTuple1(3), 2.0);
  EXPECT_EQ(values->GetArray("ess")->GetTuple1(3), 120.0);
  // From (0, 0.25, 1) to (0.1, 0.25, 2) in 0.1 s.
  EXPECT_NEAR(values->GetArray("speed")->GetTuple1(0), std::sqrt(0.01 + 1.0) / 0.1, 1e-4);
  EXPECT_TRUE(std::isnan(values->GetArray("speed")->GetTuple1(2)));
  std::array<double, 6> tensor{};
  values->GetArray("covariance")->GetTuple(0, tensor.data());
  EXPECT_EQ(tensor, (std::array<double, 6>{1e-6, 4e-6, 9e-6, 5e-7, 0.0, 0.0}));
  const auto text = [&](const char* name, vtkIdType k) {
    auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
    return array != nullptr ? std::string(array->GetValue(k)) : std::string("missing");
  };
  EXPECT_EQ(text("targets", 0), "ball");
  EXPECT_EQ(text("targets", 1), "cap, red");
  EXPECT_EQ(text("seed", 0), "7");
}

TEST(ExportPvd, ItsFilesAreReadByVtk) {
  const ExportFolder folder;
  ASSERT_TRUE(exportTrajectory(exportExample(), exportAs("pvd"), folder / "a.pvd"));
  const std::string collection = bytesOf(folder / "a.pvd");
  const std::regex entry("<DataSet timestep=\"([^\"]*)\" part=\"0\" file=\"([^\"]*)\"/>");
  std::vector<std::pair<double, std::string>> found;
  for (std::sregex_iterator it(collection.begin(), collection.end(), entry), end; it != end; ++it) {
    found.emplace_back(std::stod((*it)[1]), (*it)[2]);
  }
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[3].first, 0.3);
  const auto second = readPolyData(folder / found[1].second);
  ASSERT_EQ(second->GetNumberOfPoints(), 2);
  EXPECT_EQ(second->GetNumberOfVerts(), 2);
  EXPECT_EQ(readPolyData(folder / found[2].second)->GetNumberOfPoints(), 1) << "a gap";
}

} // namespace
} // namespace dewpoint::tests
