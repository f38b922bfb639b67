// SPDX-License-Identifier: BSD-3-Clause
// vtkContactDeflection: the choice of tip and body, and its messages on invalid input.
#include "FilterChecks.h"
#include "ProbedTips.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

namespace
{
using namespace palpate::testing;

void checkTips()
{
  const Body body = planeBody(8.0, 16);
  const auto tips = makeTips({ { 0, 0.5, { -8.0, -8.0, 0.0 }, { 0.0, 0.0, 1.0 } },
    { 0, 0.25, { -8.0, -8.0, 0.0 }, { 0.0, 0.0, 1.0 } }, { -1, 0.0, {}, {} } });
  auto filter = makeFilter(body, tips, makeTool("flat:2"));
  const std::pair<vtkIdType, double> expected[] = { { 0, 0.5 }, { 1, 0.25 }, { 2, 0.0 },
    { -1, 0.0 } };
  for (const auto& [index, depth] : expected)
  {
    filter->SetTipIndex(index);
    filter->Update();
    PALPATE_CHECK(displacement(filter, 0)[2] == -depth); // under a flat punch u_z is the depth
    PALPATE_CHECK(isZero(displacement(filter, 100)) == (depth == 0.0));
  }
  filter->SetTipData(Body::New()); // without tips there is no contact
  filter->Update();
  PALPATE_CHECK(isZero(displacement(filter, 0)));
  PALPATE_CHECK(filter->GetOutput()->GetPoints() == body->GetPoints());
}

/// Bodies that have the same triangles but different points, used in turn.
void checkSharedTriangles()
{
  const Body first = planeBody(8.0, 16);
  const Body second = planeBody(4.0, 16);
  second->SetPolys(first->GetPolys());
  first->GetPolys()->Modified(); // makes the triangles newer than both bodies
  const auto tool = makeTool("flat:1");
  auto filter =
    makeFilter(first, makeTips({ { 0, 0.5, { -4.0, -4.0, 0.0 }, { 0.0, 0.0, 1.0 } } }), tool);
  filter->Update();
  PALPATE_CHECK(displacement(filter, 0)[2] > -0.5);
  filter->SetInputData(second);
  filter->Update();
  PALPATE_CHECK(displacement(filter, 0)[2] == -0.5);
}

void checkErrors()
{
  const Body body = planeBody(8.0, 2);
  const GivenContact good = { 0, 0.5, { -8.0, -8.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  auto filter = makeFilter(body, makeTips({ good }), makeTool("flat:2"));
  Messages messages(filter.Get());
  const auto fails = [&](std::initializer_list<const char*> words)
  {
    filter->Update();
    checkText(messages.takeErrors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  filter->SetPoissonRatio(0.6);
  fails({ "Poisson's Ratio", "0.6" });
  filter->SetPoissonRatio(0.5);
  filter->SetTipIndex(3);
  fails({ "Tip Index 3", "1 tips" });
  filter->SetTipIndex(-1);
  for (const vtkIdType cell : { 8, 100 })
  {
    filter->SetTipData(makeTips({ { cell, 0.5, {}, { 0.0, 0.0, 1.0 } } }));
    fails({ "ContactCell", std::to_string(cell).c_str() });
  }
  for (const char* name : { "ContactCell", "Deflection", "ContactPoint", "Normal" })
  {
    const Body tips = makeTips({ good });
    tips->GetPointData()->RemoveArray(name);
    filter->SetTipData(tips);
    fails({ "vtkToolContactProbe", name });
  }
  filter->SetTipData(makeTips({ good }));
  filter->SetTool(nullptr);
  fails({ "No Tool", "'ResponseTool'" });
  const auto tool = makeTool("flat:2");
  Messages fromTool(tool.Get());
  tool->SetRadius(-2.0);
  filter->SetTool(tool);
  filter->Update();
  PALPATE_CHECK_TEXT(fromTool.errors(), "-2");
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  messages.clear();
  tool->SetRadius(2.0); // the filter must notice the change without another call
  filter->Update();
  PALPATE_CHECK(messages.none() && displacement(filter, 0)[2] == -0.5);
}

void checkComplianceWarning()
{
  const Body body = withResponse(planeBody(8.0, 2), "flat:2");
  // A body as in an older file has only the text.
  body->GetFieldData()->RemoveArray("ResponseModelParts");
  vtkStringArray::SafeDownCast(body->GetFieldData()->GetAbstractArray("ResponseModel"))
    ->SetValue(0, "half-space in series with global compliance");
  auto filter =
    makeFilter(body, makeTips({ { 0, 0.5, { -8.0, -8.0, 0.0 }, { 0.0, 0.0, 1.0 } } }), nullptr);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.errors().empty());
  PALPATE_CHECK_TEXT(messages.warnings(), "global compliance", "local");
  messages.clear(); // reported once, not for each frame of a live display
  filter->Modified();
  filter->Update();
  PALPATE_CHECK(messages.none() && displacement(filter, 0)[2] == -0.5);
}
} // namespace

int TestDeflectionTips(int, char*[])
{
  checkTips();
  checkSharedTriangles();
  checkErrors();
  checkComplianceWarning();
  return palpate::testing::result();
}
