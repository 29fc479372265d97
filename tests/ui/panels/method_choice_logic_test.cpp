// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/camera.h"
#include "core/project/project.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/panels/method_choice.h"

#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <gtest/gtest.h>

#include <set>

namespace dewpoint::tests {
namespace {

Project withCameras(int count) {
  Project project;
  for (int k = 0; k < count; ++k) {
    ProjectCamera camera;
    camera.camera.name = std::to_string(k);
    camera.camera.intrinsics = {640, 480, 500.0, 500.0, 320.0, 240.0};
    camera.camera.cameraFromWorld.translation().x() = 0.3 * k;
    project.cameras.push_back(camera);
  }
  return project;
}

bool canBeChosen(const MethodChoice& choice, const char* method) {
  const int row = choice.findData(QLatin1String(method));
  return choice.model()->flags(choice.model()->index(row, 0)).testFlag(Qt::ItemIsEnabled);
}

QString sentenceOf(const MethodChoice& choice, const char* method) {
  return choice.itemData(choice.findData(QLatin1String(method)), MethodChoice::DescriptionRole)
      .toString();
}

TEST(MethodChoice, ListsAllMethodsUnderHeadings) {
  MethodChoice choice;
  choice.showMethods(withCameras(2));
  EXPECT_EQ(choice.currentData().toString(), QStringLiteral("dewpoint"));
  std::set<QString> names;
  int headings = 0;
  for (int row = 0; row < choice.count(); ++row) {
    const bool isHeading = !choice.itemData(row).isValid();
    const auto flags = choice.model()->flags(choice.model()->index(row, 0));
    EXPECT_EQ(flags.testFlag(Qt::ItemIsEnabled), !isHeading) << choice.itemText(row).toStdString();
    headings += isHeading ? 1 : 0;
    if (!isHeading) {
      names.insert(choice.itemData(row).toString());
      EXPECT_NE(choice.itemText(row), choice.itemData(row).toString()); // by its use
      EXPECT_FALSE(choice.itemData(row, MethodChoice::DescriptionRole).toString().isEmpty());
    }
  }
  EXPECT_EQ(names.size(), methods().size());
  EXPECT_EQ(headings, 4);
  EXPECT_FALSE(choice.itemData(0).isValid()); // the list begins with one
  EXPECT_GT(choice.findData(QStringLiteral("barrera")), choice.findData(QStringLiteral("people")));
  EXPECT_TRUE(choice.itemData(choice.findData(QStringLiteral("barrera")), MethodChoice::PaperRole)
                  .toString()
                  .contains(QStringLiteral("2005")));
}

TEST(MethodChoice, TheOpenListIsWideEnoughForAllTexts) {
  MethodChoice choice;
  choice.showMethods(withCameras(2));
  choice.show();
  choice.showPopup();
  EXPECT_GE(choice.view()->minimumWidth(), choice.view()->sizeHintForColumn(0));
  EXPECT_GE(choice.view()->viewport()->width(), choice.view()->sizeHintForColumn(0));
  choice.hidePopup();
}

TEST(MethodChoice, WhatCannotWorkIsDisabledAndSaysWhy) {
  MethodChoice choice;
  choice.showMethods(withCameras(1));
  EXPECT_TRUE(canBeChosen(choice, "dewpoint"));
  EXPECT_FALSE(canBeChosen(choice, "people"));
  EXPECT_EQ(sentenceOf(choice, "people"), QStringLiteral("Needs at least two cameras."));
  choice.showMethods(withCameras(2));
  EXPECT_TRUE(canBeChosen(choice, "people"));
  EXPECT_NE(sentenceOf(choice, "people"), QStringLiteral("Needs at least two cameras."));
  Project bare = withCameras(2);
  bare.method = "histogram";
  bare.cameras[0].camera.intrinsics = {};
  choice.showMethods(bare);
  EXPECT_FALSE(canBeChosen(choice, "dewpoint"));
  EXPECT_EQ(sentenceOf(choice, "dewpoint"), QStringLiteral("Needs calibrated cameras."));
  EXPECT_EQ(choice.currentData().toString(), QStringLiteral("histogram"));
}

// A project that has such a method all the same shows it as the chosen one.
TEST(MethodChoice, TheChosenMethodIsNeverDisabled) {
  MethodChoice choice;
  Project project = withCameras(1);
  project.method = "people";
  choice.showMethods(project);
  EXPECT_TRUE(canBeChosen(choice, "people"));
  EXPECT_EQ(choice.currentData().toString(), QStringLiteral("people"));
}

} // namespace
} // namespace dewpoint::tests
