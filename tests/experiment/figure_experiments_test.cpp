// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/experiment/figure_experiments.h"

#include <gtest/gtest.h>

#include <string>
#include <unistd.h>

namespace dewpoint {
namespace {

class FigureExperiments : public testing::TestWithParam<FigureExperiment> {
protected:
  FigureExperiments()
      : folder_(std::filesystem::path(testing::TempDir()) /
                (std::string(GetParam().name) + std::to_string(getpid()))) {}
  ~FigureExperiments() override { std::filesystem::remove_all(folder_); }
  const std::filesystem::path folder_;
};

TEST_P(FigureExperiments, WritesAPageThatSaysWhatReproduces) {
  double last = 0.0;
  const auto made = GetParam().run({folder_, 1, [&](double part) {
                                      EXPECT_GE(part, last);
                                      last = part;
                                      return true;
                                    }});
  ASSERT_TRUE(made) << sentence(made.error());
  const auto page = readTextFile(folder_ / "report.html");
  ASSERT_TRUE(page);
  EXPECT_NE(page->find("What the paper says"), std::string::npos);
  EXPECT_EQ(page->find("nan"), std::string::npos);
}

TEST_P(FigureExperiments, AnUnwritableFolderIsSaid) {
  std::filesystem::create_directories(folder_);
  ASSERT_TRUE(writeTextFile(folder_ / "taken", "a file"));
  const auto made = GetParam().run({folder_ / "taken", 1, nullptr});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::FileUnwritable);
}

INSTANTIATE_TEST_SUITE_P(All, FigureExperiments,
                         testing::ValuesIn(figureExperiments().begin(), figureExperiments().end()),
                         [](const auto& test) {
                           std::string name(test.param.name);
                           std::erase(name, '-');
                           return name;
                         });

} // namespace
} // namespace dewpoint
